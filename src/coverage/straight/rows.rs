//! Rows that one edge on either side crosses from top to bottom.

use core::ops::Range;

use crate::{
    coverage::{
        CoverageSink,
        ramp::{FULL, Ramp, coverage_of},
        runs::{RUN, Runs},
        slope::high_word,
        straight::{
            few::{Changes, send_ramps},
            side::{Rise, Straight, lower, upper},
        },
    },
    span::Span,
};

/// An edge in whole rows: its left end in the current one, how far on that is in the next, and how far to the right end.
///
/// To the right or to the left, an edge takes up the same width in each row, so its ends need no comparing.
#[derive(Debug, Clone, Copy)]
struct Stepper {
    left: i64,
    step: i64,
    width: i64,
    rise: Rise,
}

impl Stepper {
    #[inline(always)]
    fn new<const BITS: u32>(edge: &Straight<BITS>) -> Self {
        Self { left: edge.position + edge.step.min(0), step: edge.step, width: edge.step.abs(), rise: edge.rise }
    }

    /// Takes the edge to the row that the stepper is on.
    #[inline(always)]
    fn put_back<const BITS: u32>(&self, edge: &mut Straight<BITS>, row: i32) {
        edge.position = self.left - self.step.min(0);
        edge.y = row << BITS;
    }

    /// Where it is in this row. It is taken to the next.
    #[inline(always)]
    fn step(&mut self) -> Extent {
        let (left, right) = (self.left, self.left + self.width);
        self.left += self.step;
        Extent { first: upper(left), last: upper(right), left: lower(left), right: lower(right) }
    }
}

/// The columns that an edge crosses in a row, and how far into the first and the last, in 2^-32.
#[derive(Debug, Clone, Copy)]
struct Extent {
    first: i32,
    last: i32,
    left: u32,
    right: u32,
}

/// Rows that both edges cross from top to bottom.
#[inline(always)]
pub(super) fn send_rows<const BITS: u32, S: CoverageSink>(
    left_edge: &mut Straight<BITS>,
    right_edge: &mut Straight<BITS>,
    rows: Range<i32>,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut left, mut right) = (Stepper::new(left_edge), Stepper::new(right_edge));
    let (start, end) = (columns.start, columns.end);
    let end_row = rows.end;
    for row in rows {
        let (of_left, of_right) = (left.step(), right.step());
        if of_left.last < of_right.first && of_left.first >= start && of_right.last < end {
            send_side::<false, S>(row, of_left, &left.rise, runs)?;
            let inside = of_left.last + 1..of_right.first;
            if inside.start < inside.end {
                runs.sink.span(Span { row, columns: inside }, 255)?;
            }
            send_side::<true, S>(row, of_right, &right.rise, runs)?;
        } else {
            send_cut(row, (&of_left, &left.rise), (&of_right, &right.rise), columns, changes, runs)?;
        }
    }
    left.put_back(left_edge, end_row);
    right.put_back(right_edge, end_row);
    Ok(())
}

/// What the left edge leaves of its pixels, or what the right one takes of its own.
#[inline(always)]
fn send_side<const IS_RIGHT: bool, S: CoverageSink>(
    row: i32,
    extent: Extent,
    rise: &Rise,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let Runs { sink, coverage: run, .. } = runs;
    let coverage = |area: u32| coverage_of(if IS_RIGHT { FULL.wrapping_sub(area) } else { area });
    let Extent { first, last, left, right } = extent;
    if first == last {
        return send_run::<IS_RIGHT, S>(
            row,
            first,
            &[coverage(FULL - high_word(FULL, (left >> 1) + (right >> 1)))],
            sink,
        );
    }
    let down = rise.of(!left).min(FULL);
    let first_coverage = coverage(high_word(!left, down) >> 1);
    let last_coverage = |rest: u32| coverage(FULL - (high_word(right, rest) >> 1));
    if first + 1 == last {
        return send_run::<IS_RIGHT, S>(row, first, &[first_coverage, last_coverage(FULL - down)], sink);
    }
    let step = rise.of_a_pixel();
    let mut area = down + (step >> 1);
    let mut column = first;
    // How many there are left between the first and the last.
    let mut between = last.wrapping_sub(first).wrapping_sub(1).cast_unsigned() as usize;
    let mut start = 1;
    run[0] = first_coverage;
    loop {
        let length = between.min(RUN - 1 - start);
        for slot in run.get_mut(start..start + length).unwrap_or_default() {
            *slot = coverage(area);
            area += step;
        }
        between -= length;
        let mut end = start + length;
        if between == 0 {
            if let Some(slot) = run.get_mut(end) {
                *slot = last_coverage(rise.of(right).min(FULL));
            }
            end += 1;
        }
        send_run::<IS_RIGHT, S>(row, column, run.get(..end).unwrap_or_default(), sink)?;
        if between == 0 {
            return Ok(());
        }
        column = column.wrapping_add_unsigned(u32::try_from(end).unwrap_or(0));
        start = 0;
    }
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

/// A row of which the edges share columns, or that the clip cuts.
#[inline(never)]
fn send_cut<S: CoverageSink>(
    row: i32,
    left: (&Extent, &Rise),
    right: (&Extent, &Rise),
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let ramps = [(left.0.ramp(left.1), 1), (right.0.ramp(right.1), u32::MAX)];
    send_ramps(row, &ramps, columns, changes, runs)
}

impl Extent {
    #[inline(always)]
    fn ramp(&self, rise: &Rise) -> Ramp {
        rise.ramp(self.first..=self.last, self.left, self.right, FULL)
    }
}
