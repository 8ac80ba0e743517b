//! Thin line: the run of pixels in each cell of the minor axis, found by dividing once and stepping.

use core::{mem::replace, ops::Range};

use crate::{
    PixelRect, Vertex,
    edge::{Descent, Edge, divide_product},
    limits::{HALF, ONE, SUBPIXEL_BITS},
    shape::Shape,
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
        let start = (self.start.x.to_bits(), self.start.y.to_bits());
        let end = (self.end.x.to_bits(), self.end.y.to_bits());
        if self.is_x_major() {
            let (upper, lower) = if start.1 <= end.1 { (start, end) } else { (end, start) };
            Runs::new(upper, lower, &clip.columns, &clip.rows).each(|columns, row| sink.block(row..row + 1, columns))
        } else {
            let transposed = |(x, y): (i32, i32)| (y, x);
            let (upper, lower) = if start.1 <= end.1 { (start, end) } else { (end, start) };
            let (upper, lower) = (transposed(upper), transposed(lower));
            Runs::new(upper, lower, &clip.rows, &clip.columns).each(|rows, column| sink.block(rows, column..column + 1))
        }
    }
}

#[inline]
fn sorted(a: i32, b: i32) -> (i32, i32) {
    (a.min(b), a.max(b))
}

/// The line in its own axes: `major` advances a pixel a step, `minor` by at most one.
///
/// The line leaves a cell of the minor axis where it crosses the cell's far boundary. The major pixels up to there are
/// the cell's run, so the boundaries, `256` apart, are to a line what the rows are to an edge, and an [`Edge`] steps
/// from each to the next. `progress` is the distance along the minor axis from the first end.
///
/// ```text
///      cell 0   - - - # #|                 boundary 0 at progress `to_boundary`
///      cell 1            |# # # #|         boundary 1 at progress `to_boundary + 256`
/// ```
#[derive(Debug)]
struct Runs {
    /// The major axis takes the edge's x, the minor its y.
    descent: Descent,
    /// The first end's minor coordinate.
    minor: i32,
    /// The cell being emitted; at first the one that the line may start in: the first end's own or the one before it.
    cell: i32,
    /// 1 or -1: the next cell.
    direction: i32,
    /// The major pixels the line has, inside the clip.
    pixels: Range<i32>,
    /// The cells inside the clip.
    cells: Range<i32>,
    /// The whole line is inside the clip and far from the ends of the range.
    is_narrow: bool,
}

impl Runs {
    /// Between two ends given as (major, minor), in the order of drawing.
    #[inline(always)]
    fn new(first: (i32, i32), last: (i32, i32), clip: &Range<i32>, cells: &Range<i32>) -> Self {
        // The first pixel's centre is at most half a pixel behind the first end, and the slope at most one.
        let is_past_middle = i32::from(first.1 & (ONE - 1) >= HALF);
        let holding = pixel_holding(first.1);
        let (direction, cell) =
            if first.1 <= last.1 { (1, holding - 1 + is_past_middle) } else { (-1, holding + is_past_middle) };
        let (low, high) = sorted(first.0, last.0);
        let (low_px, high_px) = (pixel_holding(low), pixel_holding(high));
        let pixels = low_px.max(clip.start)..(high_px + 1).min(clip.end);
        let descent = Descent { x0: first.0, x1: last.0, dy: first.1.abs_diff(last.1) };
        let is_whole = pixels.start == low_px && pixels.end == high_px + 1 && cells.contains(&cell);
        Self {
            descent,
            minor: first.1,
            cell,
            direction,
            pixels,
            cells: cells.clone(),
            is_narrow: is_whole && descent.is_narrow(),
        }
    }

    /// The major axis runs against its numbers.
    #[inline]
    fn is_backward(&self) -> bool {
        self.descent.x1 < self.descent.x0
    }

    /// A crossing exactly at a pixel's centre leaves that pixel in the greater cell, whichever way the line goes.
    #[inline]
    fn is_nudged(&self) -> bool {
        self.is_backward() != (self.direction < 0)
    }

    /// Emits (major pixels, cell) for every run, in order.
    #[inline(always)]
    fn each<E>(mut self, mut emit: impl FnMut(Range<i32>, i32) -> Result<(), E>) -> Result<(), E> {
        if self.pixels.is_empty() || self.cells.is_empty() {
            return Ok(());
        }
        if self.descent.dy == 0 {
            let cell = pixel_holding(self.minor);
            return if self.cells.contains(&cell) { emit(self.pixels, cell) } else { Ok(()) };
        }
        let mut boundary = if self.is_narrow {
            let boundary = self.descent.near_top(self.progress_narrow());
            if self.is_nudged() { boundary.nudged() } else { boundary }
        } else {
            match self.skip_to_clip() {
                Some(boundary) => boundary,
                None => return Ok(()),
            }
        };
        let (is_backward, is_nudged) = (self.is_backward(), self.is_nudged());
        let mut cells_left = if self.direction > 0 {
            self.cells.end.saturating_sub(self.cell)
        } else {
            self.cell.saturating_sub(self.cells.start).saturating_add(1)
        };
        while cells_left > 0 {
            let column = boundary.column.clamp(self.pixels.start, self.pixels.end);
            let run = if is_backward {
                column..replace(&mut self.pixels.end, column)
            } else {
                replace(&mut self.pixels.start, column)..column
            };
            if !run.is_empty() {
                emit(run, self.cell)?;
                if self.pixels.is_empty() {
                    break;
                }
            }
            self.cell += self.direction;
            cells_left -= 1;
            boundary.step_or(|| self.descent.at_nudged(self.progress(self.cell), is_nudged));
        }
        Ok(())
    }

    /// From the first end to the boundary where the line leaves `cell`.
    #[inline]
    fn progress(&self, cell: i32) -> i64 {
        let (minor, cell) = (i64::from(self.minor), i64::from(cell));
        if self.direction > 0 { ((cell + 1) << SUBPIXEL_BITS) - minor } else { minor - (cell << SUBPIXEL_BITS) }
    }

    /// The same for the first cell: at most half a pixel behind or ahead.
    #[inline]
    fn progress_narrow(&self) -> i32 {
        let boundary = self.cell.wrapping_add(i32::from(self.direction > 0)).wrapping_shl(SUBPIXEL_BITS);
        boundary.wrapping_sub(self.minor).wrapping_mul(self.direction)
    }

    /// Moves to the first cell with a visible pixel, and gives its boundary; `None` where there is none.
    #[inline(never)]
    fn skip_to_clip(&mut self) -> Option<Edge> {
        let Descent { x0, x1, dy } = self.descent;
        let cell = self.first_visible_cell(x1.abs_diff(x0));
        let target =
            if self.direction > 0 { cell.max(self.cells.start) } else { cell.min(self.cells.end.saturating_sub(1)) };
        self.cell = target;
        let progress = self.progress(target);
        if target != cell {
            let before = progress - i64::from(ONE);
            // Beyond the last end by more than the line is ever extended.
            if before > i64::from(dy) + i64::from(HALF) {
                return None;
            }
            let entry = self.descent.at_nudged(before, self.is_nudged());
            let column = entry.column.clamp(self.pixels.start, self.pixels.end);
            if self.is_backward() {
                self.pixels.end = column;
            } else {
                self.pixels.start = column;
            }
            if self.pixels.is_empty() {
                return None;
            }
        }
        Some(self.descent.at_nudged(progress, self.is_nudged()))
    }

    /// The cell at the centre of the first visible pixel, whose distance along the major axis gives the progress.
    #[inline]
    fn first_visible_cell(&self, length: u32) -> i32 {
        let pixel = if self.is_backward() { self.pixels.end - 1 } else { self.pixels.start };
        let from_start = (i64::from(pixel) << SUBPIXEL_BITS) + i64::from(HALF) - i64::from(self.descent.x0);
        let distance = if self.is_backward() { -from_start } else { from_start };
        let (base, offset) = if distance > i64::from(length) {
            (i64::from(self.descent.dy), distance - i64::from(length))
        } else {
            (0, distance)
        };
        let (whole, part) = divide_product(offset.unsigned_abs(), self.descent.dy, length);
        let (whole, part) = (whole.cast_signed(), i64::from(part > 0));
        let (floor, ceil) = if offset < 0 { (-whole - part, -whole) } else { (whole, whole + part) };
        // Towards greater cells a boundary is passed when it is reached, towards smaller ones only beyond it.
        let reached = base + if self.direction > 0 { floor } else { ceil - 1 };
        let passed = ((reached - self.progress(self.cell)) >> SUBPIXEL_BITS) + 1;
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^24 cells between two coordinates")]
        let passed = passed.max(0) as i32;
        self.cell + self.direction * passed
    }
}
