//! A depth buffer of 16 bits a pixel, in memory of the caller's.

use core::fmt;

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    span::{Span, clip_range},
};

/// When a pixel is drawn: by its depth, 0 in front, and the one that is kept; and whether it is then kept itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct DepthTest {
    /// What is in front passes.
    pub(crate) less: bool,
    /// What is as far passes.
    pub(crate) equal: bool,
    pub(crate) write: bool,
}

impl DepthTest {
    /// What is nearer than what was drawn before.
    pub const LESS: Self = Self { less: true, equal: false, write: true };
    /// What is nearer or as near.
    pub const LESS_OR_EQUAL: Self = Self { less: true, equal: true, write: true };
    /// Everything: to fill the buffer.
    pub const ALWAYS: Self = Self { less: false, equal: false, write: true };

    /// The same, without keeping the depth of what is drawn: for what is see-through.
    #[inline]
    pub const fn without_writing(self) -> Self {
        Self { write: false, ..self }
    }

    /// Whether a pixel of this depth is drawn; keeps its depth if so.
    #[inline(always)]
    pub fn passes(self, depth: u16, kept: &mut u16) -> bool {
        let Self { less, equal, write } = self;
        let passes = match (less, equal) {
            (true, false) => depth < *kept,
            (true, true) => depth <= *kept,
            (false, _) => true,
        };
        if passes && write {
            *kept = depth;
        }
        passes
    }
}

/// A depth buffer whose memory is too small for it, or whose rows overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DepthBufferError {
    /// A row does not fit between the starts of two.
    StrideTooSmall {
        /// The pixels of a row.
        width: u32,
        /// From the start of one row to that of the next.
        stride: usize,
    },
    /// There are too few values.
    TooShort {
        /// How many there must be.
        needed: usize,
        /// How many there are.
        available: usize,
    },
}

impl fmt::Display for DepthBufferError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StrideTooSmall { width, stride } => {
                write!(f, "rows of {width} depths do not fit a stride of {stride}")
            }
            Self::TooShort { needed, available } => {
                write!(f, "the depth buffer needs {needed} values, {available} available")
            }
        }
    }
}

impl core::error::Error for DepthBufferError {}

/// The depth of every pixel of a rectangle of the screen, 0 in front, 65535 behind.
///
/// ```text
///        origin     width
///          v <--------------->
///   row 0  [ . . . . . . . . ] - - - |   one row starts `stride` values after the one above
///   row 1  [ . . . . . . . . ] - - - |
/// ```
///
/// A band of a few rows has a buffer of its own, by the band's origin. Pixels outside of the rectangle are not drawn.
///
/// # Errors
///
/// Where rows overlap or the slice ends before the last row does, see [`DepthBufferError`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
/// use spanfill::{Affine, DepthBuffer, DepthTest, Triangle, prelude::*};
///
/// let mut memory = [0; 16 * 16];
/// let mut depths = DepthBuffer::new(Rectangle::new(Point::zero(), Size::new(16, 16)), 16, &mut memory)?;
/// depths.clear(u16::MAX);
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(15, 0), Point::new(0, 15));
/// let mut display = MockDisplay::new();
/// let on = Affine::new(triangle, [[], [], []]).shaded(|[]| BinaryColor::On);
/// on.depth_tested([100, 200, 300], DepthTest::LESS).draw(&mut display, &mut depths).unwrap();
/// assert_eq!(depths.get(Point::new(1, 1)), Some(120));
/// # Ok::<(), spanfill::DepthBufferError>(())
/// ```
#[derive(Debug)]
pub struct DepthBuffer<'a> {
    area: PixelRect,
    stride: usize,
    depths: &'a mut [u16],
}

impl<'a> DepthBuffer<'a> {
    /// A buffer for an area of the screen; depths are what the slice has.
    ///
    /// # Errors
    ///
    /// Too small a stride or a slice.
    pub fn new(area: Rectangle, stride: usize, depths: &'a mut [u16]) -> Result<Self, DepthBufferError> {
        let Size { width, height } = area.size;
        let row = usize::try_from(width).unwrap_or(usize::MAX);
        if row > stride {
            return Err(DepthBufferError::StrideTooSmall { width, stride });
        }
        let rows = usize::try_from(height).unwrap_or(usize::MAX);
        let above = rows.saturating_sub(1).checked_mul(stride);
        let needed = if rows == 0 { 0 } else { above.and_then(|above| above.checked_add(row)).unwrap_or(usize::MAX) };
        if needed > depths.len() {
            return Err(DepthBufferError::TooShort { needed, available: depths.len() });
        }
        Ok(Self { area: area.into(), stride, depths })
    }

    /// Gives all pixels a depth: 65535 before a frame.
    pub fn clear(&mut self, depth: u16) {
        self.depths.fill(depth);
    }

    /// The depth of a pixel; none outside.
    pub fn get(&self, point: Point) -> Option<u16> {
        if !self.area.rows.contains(&point.y) || !self.area.columns.contains(&point.x) {
            return None;
        }
        self.depths.get(self.index(point.y, point.x)).copied()
    }

    /// Of the pixels of a target, those that the buffer has.
    pub(crate) fn cut(&self, target: Rectangle) -> PixelRect {
        let target = PixelRect::from(target);
        PixelRect {
            rows: clip_range(&target.rows, &self.area.rows),
            columns: clip_range(&target.columns, &self.area.columns),
        }
    }

    /// The depths of a span inside.
    #[inline(always)]
    pub(crate) fn row_mut(&mut self, span: &Span) -> &mut [u16] {
        let start = self.index(span.row, span.columns.start);
        let width = usize::try_from(span.columns.end.abs_diff(span.columns.start)).unwrap_or(0);
        self.depths.get_mut(start..start.saturating_add(width)).unwrap_or_default()
    }

    /// Keeps a pixel's depth if it passes; what is outside does not.
    #[inline(always)]
    pub(crate) fn test(&mut self, x: i32, y: i32, depth: u16, test: DepthTest) -> bool {
        let index = self.index(y, x);
        let (rows, columns) = (&self.area.rows, &self.area.columns);
        let inside = rows.start <= y && y < rows.end && columns.start <= x && x < columns.end;
        inside && self.depths.get_mut(index).is_some_and(|kept| test.passes(depth, kept))
    }

    #[inline(always)]
    fn index(&self, row: i32, column: i32) -> usize {
        let below = usize::try_from(row.wrapping_sub(self.area.rows.start).cast_unsigned()).unwrap_or(usize::MAX);
        let right = usize::try_from(column.wrapping_sub(self.area.columns.start).cast_unsigned()).unwrap_or(usize::MAX);
        // Of a pixel inside, no more than the length that `new` has looked at.
        below.wrapping_mul(self.stride).wrapping_add(right)
    }
}
