//! Boxes of whole pixels, as the primitives with a `top_left` have.

use core::ops::Range;

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{CoverageSink, PixelRect, Span, outline::Vector, shape::Cover};

/// A box of pixels that may reach out of `i32`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct PixelBox {
    pub(super) left: i64,
    pub(super) top: i64,
    pub(super) width: i64,
    pub(super) height: i64,
}

impl PixelBox {
    pub(super) fn new(top_left: Point, size: Size) -> Self {
        Self { left: top_left.x.into(), top: top_left.y.into(), width: size.width.into(), height: size.height.into() }
    }

    pub(super) const fn between(columns: Range<i64>, rows: Range<i64>) -> Self {
        let (width, height) = (columns.end - columns.start, rows.end - rows.start);
        Self { left: columns.start, top: rows.start, width, height }
    }

    /// With each side moved out by `pixels`, or in by less than none, for as long as there is something left.
    ///
    /// Nothing grows to the left of its place by a pixel less, as in embedded-graphics, where it is a pixel in the
    /// middle.
    pub(super) fn offset(&self, pixels: i64) -> Self {
        let axis = |start: i64, length: i64| {
            let moved = if length == 0 && pixels > 0 { pixels - 1 } else { pixels };
            (start - moved, (length + 2 * pixels).max(0))
        };
        let ((left, width), (top, height)) = (axis(self.left, self.width), axis(self.top, self.height));
        Self { left, top, width, height }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.width <= 0 || self.height <= 0
    }

    /// Twice its middle, in the coordinates in which pixels have their centres at even numbers.
    pub(super) fn center_2x(&self) -> (i64, i64) {
        (2 * self.left + self.width - 1, 2 * self.top + self.height - 1)
    }

    /// Its middle in 1/256 pixel.
    pub(super) fn center(&self) -> Vector {
        Vector::new(128 * (2 * self.left + self.width), 128 * (2 * self.top + self.height))
    }

    /// Whether all of it can be blended: outlines have coordinates of 24 bits, and here one to spare.
    pub(super) fn can_be_blended(&self) -> bool {
        const REACH: i64 = 1 << 22;
        let (columns, rows) = (self.columns(), self.rows());
        columns.start >= -REACH && rows.start >= -REACH && columns.end <= REACH && rows.end <= REACH
    }

    pub(super) const fn columns(&self) -> Range<i64> {
        self.left..self.left + self.width
    }

    pub(super) const fn rows(&self) -> Range<i64> {
        self.top..self.top + self.height
    }

    /// What the clip leaves of it.
    pub(super) fn visible(&self, clip: &PixelRect) -> PixelRect {
        PixelRect { rows: cut(&self.rows(), &clip.rows), columns: cut(&self.columns(), &clip.columns) }
    }

    /// Where it does not fit `i32`, what does.
    pub(super) fn rectangle(&self) -> Rectangle {
        let axis = |Range { start, end }: Range<i64>| {
            let clamped = start.clamp(i32::MIN.into(), i32::MAX.into());
            let end = end.min(i64::from(i32::MAX) + 1).max(clamped);
            (to_i32(clamped), u32::try_from(end - clamped).unwrap_or(u32::MAX))
        };
        let ((x, width), (y, height)) = (axis(self.columns()), axis(self.rows()));
        Rectangle::new(Point::new(x, y), Size::new(width, height))
    }
}

/// The nearest `i32`.
pub(super) fn to_i32(value: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "clamped")]
    let value = value.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
    value
}

/// What of `range` lies in `clip`; never a range that runs backwards.
pub(super) fn cut(range: &Range<i64>, clip: &Range<i32>) -> Range<i32> {
    let (low, high) = (i64::from(clip.start), i64::from(clip.end).max(clip.start.into()));
    // `clamp` has a panic in it.
    let start = range.start.max(low).min(high);
    to_i32(start)..to_i32(range.end.max(start).min(high))
}

impl Cover for PixelBox {
    fn touched(&self) -> PixelRect {
        self.rectangle().into()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let PixelRect { rows, columns } = self.visible(clip);
        if columns.is_empty() {
            return Ok(());
        }
        rows.into_iter().try_for_each(|row| sink.span(Span { row, columns: columns.clone() }, 255))
    }
}
