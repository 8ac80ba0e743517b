//! Thin line: the run of pixels in each cell of the minor axis, found by dividing once and stepping.

mod areas;
mod cut_runs;
mod runs;

use core::ops::Range;

use crate::{
    PixelRect, Vertex,
    geometry::by_height,
    limits::HALF,
    shape::{
        Shape,
        line::{cut_runs::CutRuns, runs::whole},
    },
    span::{BlockSink, SpanSink, SplitRows},
    subpixel::pixel_holding,
};

/// A line one pixel thin, with its ends in 1/256 pixel.
///
/// Every coordinate is legal. The line advances along its major axis (x where it is at least as wide as high) from the
/// column that holds one end to the column that holds the other, both included, and has one pixel in each: the one
/// that the true line crosses the centre of the column in. Where it passes exactly between two rows, that is the lower
/// one (between two columns, the right one). A line of no length is the pixel that holds it.
///
/// ```text
///    #-#_. . . .           from pixel centre to pixel centre:
///    . . #-#-#_.           Bresenham's line
///    . . . . . #-#
/// ```
///
/// Neither the direction of drawing nor the clip changes the pixels. The pixel that holds an end is the line's own
/// unless the line, extended to the centre of that column, has left it by then: to force it in would tear the line, as
/// from (0, 0.95) with slope 1 the next pixel is (1, 2).
///
/// [Anti-aliased](crate::AntiAlias::antialiased), it is the rectangle of width 1 around the segment, cut off square at
/// its ends: a pixel is covered by the exact area of that within it, rounded once to 255ths. A line of no length covers
/// nothing.
///
/// # Cost
///
/// One division, or two where an end is cut off, then an addition and a subtraction for each run: as many as the line
/// is pixels long along its minor axis. What lies outside the clip costs nothing. No scratch.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Line, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Line::new(Point::new(6, 2), Point::new(0, 0)).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["##     ", "  ###  ", "     ##"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// With anti-aliasing:
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// # use spanfill::{Over, Line, prelude::*};
/// # let line = Line::new(Point::new(6, 2), Point::new(0, 0));
/// # let mut display = MockDisplay::new();
/// line.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Line {
    /// One end.
    pub start: Vertex,
    /// The other end.
    pub end: Vertex,
}

impl Line {
    /// A line between two points.
    #[inline]
    pub fn new(start: impl Into<Vertex>, end: impl Into<Vertex>) -> Self {
        Self { start: start.into(), end: end.into() }
    }

    #[inline]
    fn is_x_major(&self) -> bool {
        let (start, end) = (self.start, self.end);
        start.x.to_bits().abs_diff(end.x.to_bits()) >= start.y.to_bits().abs_diff(end.y.to_bits())
    }
}

impl Shape for Line {
    #[inline]
    fn bounds(&self) -> PixelRect {
        let (x, y) = (
            sorted(self.start.x.to_bits(), self.end.x.to_bits()),
            sorted(self.start.y.to_bits(), self.end.y.to_bits()),
        );
        let held = |(low, high): (i32, i32), margin: i32| pixel_holding(low) - margin..pixel_holding(high) + 1 + margin;
        // Half a pixel beyond an end along the major axis, the line may be up to half a pixel further on the minor.
        if self.is_x_major() {
            PixelRect { rows: held(y, 1), columns: held(x, 0) }
        } else {
            PixelRect { rows: held(y, 0), columns: held(x, 1) }
        }
    }

    #[inline]
    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.blocks(clip, &mut SplitRows(sink))
    }

    #[inline]
    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        // From top to bottom.
        let (upper, lower) = by_height(self.start, self.end);
        let (upper, lower) = ((upper.x.to_bits(), upper.y.to_bits()), (lower.x.to_bits(), lower.y.to_bits()));
        if !is_well_inside(upper, lower, clip) {
            return self.cut(upper, lower, clip, sink);
        }
        if self.is_x_major() {
            let emit = |columns: Range<i32>, row: i32| sink.block(row..row + 1, columns);
            if upper.0 <= lower.0 {
                whole::<false, _>(upper, lower, emit)
            } else {
                whole::<true, _>(upper, lower, emit)
            }
        } else {
            let emit = |rows: Range<i32>, column: i32| sink.block(rows, column..column + 1);
            whole::<false, _>(transposed(upper), transposed(lower), emit)
        }
    }
}

impl Line {
    /// What the clip leaves of it, anywhere.
    #[inline(never)]
    fn cut<S: BlockSink>(
        &self,
        upper: (i32, i32),
        lower: (i32, i32),
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        if self.is_x_major() {
            CutRuns::new(upper, lower, &clip.columns, &clip.rows).each(|columns, row| sink.block(row..row + 1, columns))
        } else {
            let (upper, lower) = (transposed(upper), transposed(lower));
            CutRuns::new(upper, lower, &clip.rows, &clip.columns)
                .each(|rows, column| sink.block(rows, column..column + 1))
        }
    }
}

/// More than half a pixel inside the clip, as the line may leave the rectangle around its ends by that, and in the
/// narrow zone. On the sides where ranges start, half a pixel will do: a tie goes to the greater pixel.
#[inline(always)]
fn is_well_inside(upper: (i32, i32), lower: (i32, i32), clip: &PixelRect) -> bool {
    let (rows, columns) = clip.narrow();
    let (left, right) = sorted(upper.0, lower.0);
    upper.1 >= rows.start + HALF
        && lower.1 < rows.end - HALF
        && left >= columns.start + HALF
        && right < columns.end - HALF
}

#[inline(always)]
fn transposed((x, y): (i32, i32)) -> (i32, i32) {
    (y, x)
}

#[inline]
fn sorted(a: i32, b: i32) -> (i32, i32) {
    (a.min(b), a.max(b))
}
