//! A line in its own axes: from pixel to pixel it advances along the major axis, and by at most one along the minor.
//!
//! It leaves a cell of the minor axis where it crosses the cell's far boundary. The major pixels up to there are the
//! cell's run. The boundaries, 256 apart, are to a line what the rows are to an edge, and an `Edge` steps from each to
//! the next: the run-length form of Bresenham's line. Ends are given as (major, minor), in the order of drawing.
//!
//! ```text
//!      cell 0   - - - # #|                 boundary 0
//!      cell 1            |# # # #|         boundary 1
//!      cell 2                    |# - -
//! ```

use core::ops::Range;

use crate::{
    edge::Descent,
    limits::{HALF, ONE, SUBPIXEL_BITS},
    subpixel::pixel_holding,
};

/// The cell that the line may start in, and whether cells go up (1) or down (-1) from there.
///
/// The first pixel's centre is at most half a pixel behind the first end, and the slope at most one.
#[inline(always)]
pub(in crate::shape) fn first_cell(first: (i32, i32), last: (i32, i32)) -> (i32, i32) {
    let holding = pixel_holding(first.1);
    let is_past_middle = i32::from(first.1 & (ONE - 1) >= HALF);
    if first.1 <= last.1 { (holding - 1 + is_past_middle, 1) } else { (holding + is_past_middle, -1) }
}

/// Emits (major pixels, cell) for every run of a line that is well inside.
#[inline(always)]
pub(in crate::shape) fn whole<const BACKWARD: bool, E>(
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
