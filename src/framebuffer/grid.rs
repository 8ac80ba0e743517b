//! Where the lines of a framebuffer lie.

use core::ops::Range;

use embedded_graphics_core::{geometry::Size, pixelcolor::PixelColor};

use crate::framebuffer::{error::FramebufferError, layout::Layout};

/// Width, height and stride, proved to fit the memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Grid {
    /// From a line to the next, in units.
    pub(super) stride: usize,
    pub(super) width: u32,
    pub(super) height: u32,
    /// How many pixels of the first unit are not part of it: columns where lines are rows, else rows.
    pub(super) skip: u32,
}

impl Grid {
    /// The units of a line.
    pub(super) const fn line_units<C: PixelColor, L: Layout<C>>(width: u32) -> usize {
        saturated((width as u64 * L::STEP as u64).div_ceil(8))
    }

    /// The units of all lines, of which the last need not be followed by the rest of a stride.
    pub(super) const fn units<C: PixelColor, L: Layout<C>>(size: Size, stride: usize) -> usize {
        let lines = size.height.div_ceil(L::LINE_ROWS);
        stride.saturating_mul(lines.saturating_sub(1) as usize).saturating_add(Self::line_units::<C, L>(size.width))
    }

    pub(super) const fn new<C: PixelColor, L: Layout<C>>(
        size: Size,
        stride: usize,
        available: usize,
    ) -> Result<Self, FramebufferError> {
        let Size { width, height } = size;
        if width == 0 || height == 0 {
            return Err(FramebufferError::Empty { width, height });
        }
        if width > i32::MAX.unsigned_abs() || height > i32::MAX.unsigned_abs() {
            return Err(FramebufferError::TooLarge { width, height });
        }
        if height % L::LINE_ROWS != 0 {
            return Err(FramebufferError::PartialPage { height, page_rows: L::LINE_ROWS });
        }
        let needed = Self::line_units::<C, L>(width);
        if stride < needed {
            return Err(FramebufferError::StrideTooShort { needed, stride });
        }
        let needed = Self::units::<C, L>(size, stride);
        if available < needed {
            return Err(FramebufferError::BufferTooSmall { needed, available });
        }
        Ok(Self { stride, width, height, skip: 0 })
    }

    /// A part of it, which is not empty: the unit that it starts with, and its own grid.
    pub(super) fn part<C: PixelColor, L: Layout<C>>(&self, rows: &Range<u32>, columns: &Range<u32>) -> (usize, Self) {
        let size = (columns.end - columns.start, rows.end - rows.start);
        let (column, row) = if L::LINE_ROWS == 1 {
            (columns.start + self.skip, rows.start)
        } else {
            (columns.start, rows.start + self.skip)
        };
        // Whole units before the first column, as all pixels of one have the same line.
        let eighths = u64::from(column) * u64::from(L::STEP);
        let start = (row / L::LINE_ROWS) as usize * self.stride + saturated(eighths / 8);
        let skip = if L::LINE_ROWS > 1 {
            row % L::LINE_ROWS
        } else if L::STEP < 8 {
            column % (8 / L::STEP)
        } else {
            0
        };
        (start, Self { stride: self.stride, width: size.0, height: size.1, skip })
    }

    #[inline(always)]
    pub(crate) const fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }

    /// Where a pixel's line starts, its column in it, and its row in it.
    #[inline(always)]
    pub(super) const fn place<C: PixelColor, L: Layout<C>>(&self, column: u32, row: u32) -> (usize, usize, u32) {
        if L::LINE_ROWS == 1 {
            (row as usize * self.stride, (column + self.skip) as usize, 0)
        } else {
            let row = row + self.skip;
            ((row / L::LINE_ROWS) as usize * self.stride, column as usize, row % L::LINE_ROWS)
        }
    }
}

/// Where `usize` has 32 bits, what is longer than it counts for no memory there is.
#[allow(clippy::cast_possible_truncation, reason = "compared before")]
const fn saturated(units: u64) -> usize {
    if units > usize::MAX as u64 { usize::MAX } else { units as usize }
}
