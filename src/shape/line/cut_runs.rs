//! The runs of a line that the clip cuts, or that leaves 32 bits: the first visible one is found by division, so that
//! no step is taken off the screen.
//!
//! Y. P. Kuzmin, "Bresenham's line generation algorithm with built-in clipping" (1995) has the idea for whole pixels.

use core::{mem::replace, ops::Range};

use crate::{
    edge::{Descent, Edge, divide_product},
    limits::{HALF, ONE, SUBPIXEL_BITS},
    shape::line::runs::first_cell,
    span::clip_range,
    subpixel::pixel_holding,
};

/// The runs of any line, in any clip. `progress` is the distance along the minor axis from the first end.
#[derive(Debug)]
pub(in crate::shape) struct CutRuns {
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
    pub(in crate::shape) fn new(first: (i32, i32), last: (i32, i32), clip: &Range<i32>, cells: &Range<i32>) -> Self {
        let (cell, direction) = first_cell(first, last);
        let (low, high) = (first.0.min(last.0), first.0.max(last.0));
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
    pub(in crate::shape) fn each<E>(mut self, mut emit: impl FnMut(Range<i32>, i32) -> Result<(), E>) -> Result<(), E> {
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
