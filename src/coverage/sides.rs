//! A row of pixels between two edges that cross it from top to bottom, and share none of its columns.
//!
//! ```text
//!        left          right
//!     |   /#|###|###|###\   |
//!     |  /##|###|###|####\  |        runs of one or two pixels, and a span between them
//!     | /###|###|###|#####\ |
//! ```
//!
//! A sink that takes eights gets the pixels of the inside, too, that fill them up.

use crate::{
    coverage::{
        CoverageSink, eights,
        ramp::{Extent, FULL, Ramp, Steep, coverage_beside},
        runs::{RUN, Runs},
    },
    span::Span,
};

/// Sends what lies between two edges, each with where it is in the row and how steep it is.
#[inline(always)]
pub(crate) fn send_between<S: CoverageSink>(
    row: i32,
    left: (Extent, impl Steep),
    right: (Extent, impl Steep),
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    if S::EIGHTS {
        let (left, right) = ((left.0, left.1.steepness()), (right.0, right.1.steepness()));
        return eights::send_between::<false, S>(row, left, right, runs.sink);
    }
    let inside = send_left(row, left, right.0.first, runs)?;
    send_right(row, right, inside, runs)
}

/// Sends what a left edge leaves of its pixels, and perhaps some of the inside after it, as far as `end`. Where what has not been
/// sent begins is returned.
#[inline(always)]
pub(crate) fn send_left<S: CoverageSink>(
    row: i32,
    left: (Extent, impl Steep),
    end: i32,
    runs: &mut Runs<'_, S>,
) -> Result<i32, S::Error> {
    if S::EIGHTS {
        return eights::send_left(row, left.0, left.1.steepness(), end, runs.sink);
    }
    send_side::<false, S>(row, &Ramp::new(left.0, FULL, left.1), runs)?;
    Ok(left.0.last + 1)
}

/// Sends the inside, from `inside` on, and what a right edge takes of its pixels.
#[inline(always)]
pub(crate) fn send_right<S: CoverageSink>(
    row: i32,
    right: (Extent, impl Steep),
    inside: i32,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    if S::EIGHTS {
        return eights::send_right(row, right.0, right.1.steepness(), inside, runs.sink);
    }
    let columns = inside..right.0.first;
    if columns.start < columns.end {
        runs.sink.span(Span { row, columns }, 255)?;
    }
    send_side::<true, S>(row, &Ramp::new(right.0, FULL, right.1), runs)
}

/// Sends what the left edge leaves of its pixels, or what the right one takes of its own.
#[inline(always)]
fn send_side<const IS_RIGHT: bool, S: CoverageSink>(
    row: i32,
    ramp: &Ramp,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let Runs { sink, coverage: run, .. } = runs;
    let coverage = coverage_beside::<IS_RIGHT>;
    let (first, last) = (ramp.first, ramp.last);
    let (first_coverage, last_coverage) = (coverage(ramp.first_area), coverage(ramp.last_area));
    if first == last {
        return send_run::<IS_RIGHT, S>(row, first, &[first_coverage], sink);
    }
    if first + 1 == last {
        return send_run::<IS_RIGHT, S>(row, first, &[first_coverage, last_coverage], sink);
    }
    let mut area = ramp.second_area;
    let mut start = first;
    run[0] = first_coverage;
    let mut length = 1;
    // Not unrolled, as a full run is sent from inside the loop: most have a column or two between the first and the last.
    for column in first + 1..last {
        if length >= RUN - 1 {
            send_run::<IS_RIGHT, S>(row, start, run.get(..length).unwrap_or_default(), sink)?;
            start = column;
            length = 0;
        }
        if let Some(slot) = run.get_mut(length) {
            *slot = coverage(area);
        }
        area = area.wrapping_add(ramp.step);
        length += 1;
    }
    if let Some(slot) = run.get_mut(length) {
        *slot = last_coverage;
    }
    send_run::<IS_RIGHT, S>(row, start, run.get(..=length).unwrap_or_default(), sink)
}

/// A run that may begin with zeros, on the left, or end with them, on the right.
#[inline(always)]
fn send_run<const IS_RIGHT: bool, S: CoverageSink>(
    row: i32,
    mut column: i32,
    mut run: &[u8],
    sink: &mut S,
) -> Result<(), S::Error> {
    if IS_RIGHT {
        while let [rest @ .., 0] = run {
            run = rest;
        }
    } else {
        while let [0, rest @ ..] = run {
            run = rest;
            column += 1;
        }
    }
    if run.is_empty() { Ok(()) } else { sink.run(row, column, run) }
}
