//! Thin line: the run of pixels in each cell of the minor axis, found by dividing once and stepping.

use core::{mem::replace, ops::Range};

use crate::{
    PixelRect, Vertex,
    edge::{Descent, Edge, divide_product},
    limits::{HALF, ONE, SUBPIXEL_BITS},
    shape::Shape,
    span::{BlockSink, SpanSink, SplitRows, clip_range},
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
        // From top to bottom.
        let (upper, lower) = if self.start.y <= self.end.y { (self.start, self.end) } else { (self.end, self.start) };
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

// The line in its own axes: from pixel to pixel it advances along the major axis, and by at most one along the minor.
//
// It leaves a cell of the minor axis where it crosses the cell's far boundary. The major pixels up to there are the
// cell's run. The boundaries, 256 apart, are to a line what the rows are to an edge, and an `Edge` steps from each to
// the next: the run-length form of Bresenham's line. Ends are given as (major, minor), in the order of drawing.
//
//      cell 0   - - - # #|                 boundary 0
//      cell 1            |# # # #|         boundary 1
//      cell 2                    |# - -

/// The cell that the line may start in, and whether cells go up (1) or down (-1) from there.
///
/// The first pixel's centre is at most half a pixel behind the first end, and the slope at most one.
#[inline(always)]
fn first_cell(first: (i32, i32), last: (i32, i32)) -> (i32, i32) {
    let holding = pixel_holding(first.1);
    let is_past_middle = i32::from(first.1 & (ONE - 1) >= HALF);
    if first.1 <= last.1 { (holding - 1 + is_past_middle, 1) } else { (holding + is_past_middle, -1) }
}

/// Emits (major pixels, cell) for every run of a line that is well inside.
#[inline(always)]
fn whole<const BACKWARD: bool, E>(
    first: (i32, i32),
    last: (i32, i32),
    mut emit: impl FnMut(Range<i32>, i32) -> Result<(), E>,
) -> Result<(), E> {
    let (low, high) = if BACKWARD { (last.0, first.0) } else { (first.0, last.0) };
    let mut pixels = pixel_holding(low)..pixel_holding(high) + 1;
    if first.1 == last.1 {
        return emit(pixels, pixel_holding(first.1));
    }
    let (mut cell, direction) = first_cell(first, last);
    // To the first cell's far boundary, from half a pixel behind the first end to half a pixel ahead.
    let progress = (((cell + i32::from(direction > 0)) << SUBPIXEL_BITS) - first.1) * direction;
    let descent = Descent { x0: first.0, x1: last.0, dy: first.1.abs_diff(last.1) };
    let mut boundary = descent.near_top(progress);
    // A crossing exactly at a pixel's centre leaves that pixel in the greater cell, whichever way the line goes.
    if BACKWARD != (direction < 0) {
        boundary = boundary.nudged();
    }
    let run_is_empty = if BACKWARD { boundary.column >= pixels.end } else { boundary.column <= pixels.start };
    if run_is_empty {
        cell += direction;
        boundary.step();
    }
    // Boundaries are a pixel or more apart: no other run is empty.
    if BACKWARD {
        while boundary.column > pixels.start {
            emit(boundary.column..pixels.end, cell)?;
            pixels.end = boundary.column;
            cell += direction;
            boundary.step();
        }
    } else {
        while boundary.column < pixels.end {
            emit(pixels.start..boundary.column, cell)?;
            pixels.start = boundary.column;
            cell += direction;
            boundary.step();
        }
    }
    emit(pixels, cell)
}

/// The runs of any line, in any clip. `progress` is the distance along the minor axis from the first end.
#[derive(Debug)]
struct CutRuns {
    /// The major axis takes the edge's x, the minor its y.
    descent: Descent,
    /// The first end's minor coordinate.
    minor: i32,
    cell: i32,
    direction: i32,
    /// The major pixels that the line has, inside the clip.
    pixels: Range<i32>,
    /// The cells inside the clip.
    cells: Range<i32>,
}

impl CutRuns {
    fn new(first: (i32, i32), last: (i32, i32), clip: &Range<i32>, cells: &Range<i32>) -> Self {
        let (cell, direction) = first_cell(first, last);
        let (low, high) = sorted(first.0, last.0);
        Self {
            descent: Descent { x0: first.0, x1: last.0, dy: first.1.abs_diff(last.1) },
            minor: first.1,
            cell,
            direction,
            pixels: clip_range(&(pixel_holding(low)..pixel_holding(high) + 1), clip),
            cells: cells.clone(),
        }
    }

    /// The major axis runs against its numbers.
    fn is_backward(&self) -> bool {
        self.descent.x1 < self.descent.x0
    }

    fn is_nudged(&self) -> bool {
        self.is_backward() != (self.direction < 0)
    }

    /// Emits (major pixels, cell) for every run, in order.
    fn each<E>(mut self, mut emit: impl FnMut(Range<i32>, i32) -> Result<(), E>) -> Result<(), E> {
        if self.pixels.is_empty() || self.cells.is_empty() {
            return Ok(());
        }
        if self.descent.dy == 0 {
            let cell = pixel_holding(self.minor);
            return if self.cells.contains(&cell) { emit(self.pixels, cell) } else { Ok(()) };
        }
        let Some(mut boundary) = self.skip_to_clip() else { return Ok(()) };
        let (is_backward, is_nudged) = (self.is_backward(), self.is_nudged());
        while self.cells.contains(&self.cell) {
            let run = self.take_up_to(boundary.column, is_backward);
            if !run.is_empty() {
                emit(run, self.cell)?;
            }
            if self.pixels.is_empty() {
                break;
            }
            self.cell += self.direction;
            boundary.step_or(|| self.descent.at_nudged(self.progress(self.cell), is_nudged));
        }
        Ok(())
    }

    /// Takes the pixels before a boundary off the front.
    fn take_up_to(&mut self, boundary: i32, is_backward: bool) -> Range<i32> {
        let column = boundary.max(self.pixels.start).min(self.pixels.end);
        if is_backward {
            column..replace(&mut self.pixels.end, column)
        } else {
            replace(&mut self.pixels.start, column)..column
        }
    }

    /// From the first end to the boundary where the line leaves `cell`.
    fn progress(&self, cell: i32) -> i64 {
        let (minor, cell) = (i64::from(self.minor), i64::from(cell));
        if self.direction > 0 { ((cell + 1) << SUBPIXEL_BITS) - minor } else { minor - (cell << SUBPIXEL_BITS) }
    }

    /// Moves to the first cell with a visible pixel, and gives its boundary; `None` where there is none.
    fn skip_to_clip(&mut self) -> Option<Edge> {
        let Descent { x0, x1, dy } = self.descent;
        let cell = self.first_visible_cell(x1.abs_diff(x0));
        self.cell =
            if self.direction > 0 { cell.max(self.cells.start) } else { cell.min(self.cells.end.saturating_sub(1)) };
        let progress = self.progress(self.cell);
        if self.cell != cell {
            let before = progress - i64::from(ONE);
            // Beyond the last end by more than the line is ever extended.
            if before > i64::from(dy) + i64::from(HALF) {
                return None;
            }
            let entry = self.descent.at_nudged(before, self.is_nudged());
            self.take_up_to(entry.column, self.is_backward());
            if self.pixels.is_empty() {
                return None;
            }
        }
        Some(self.descent.at_nudged(progress, self.is_nudged()))
    }

    /// The cell at the centre of the first visible pixel, whose distance along the major axis gives the progress.
    fn first_visible_cell(&self, length: u32) -> i32 {
        let pixel = if self.is_backward() { self.pixels.end - 1 } else { self.pixels.start };
        let from_start = (i64::from(pixel) << SUBPIXEL_BITS) + i64::from(HALF) - i64::from(self.descent.x0);
        let distance = if self.is_backward() { -from_start } else { from_start };
        // From the nearer end when outside, so that the product of magnitudes stays below 2^64.
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
