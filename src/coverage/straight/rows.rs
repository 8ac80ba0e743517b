//! Rows that one edge on either side crosses from top to bottom.

use core::ops::Range;

use crate::coverage::{
    CoverageSink,
    few::{Changes, send_few},
    ramp::{Extent, FULL, Ramp, Steep},
    runs::Runs,
    sides::send_between,
    straight::{
        far::send_far,
        side::{Rise, Straight, lower, upper},
    },
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

/// Rows that both edges cross from top to bottom. `is_cut`: the clip cuts some of them, perhaps.
///
/// An edge on the right border of what its shape touches counts to the column after that, and leaves nothing there. A run ends before
/// it; eights, which would go as far, are kept within.
#[inline(always)]
pub(super) fn send_rows<const BITS: u32, S: CoverageSink>(
    left_edge: &mut Straight<BITS>,
    right_edge: &mut Straight<BITS>,
    rows: Range<i32>,
    columns: &Range<i32>,
    is_cut: bool,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut left, mut right) = (Stepper::new(left_edge), Stepper::new(right_edge));
    let (start, end) = (columns.start, columns.end);
    let is_checked = is_cut || S::EIGHTS;
    let end_row = rows.end;
    for row in rows {
        let (of_left, of_right) = (left.step(), right.step());
        if of_left.last < of_right.first && (!is_checked || (of_left.first >= start && of_right.last < end)) {
            send_between(row, (of_left, left.rise), (of_right, right.rise), runs)?;
        } else {
            send_cut(row, (of_left, left.rise), (of_right, right.rise), columns, changes, runs)?;
        }
    }
    left.put_back(left_edge, end_row);
    right.put_back(right_edge, end_row);
    Ok(())
}

/// A row of which the edges share columns, or that the clip cuts.
#[inline(never)]
pub(crate) fn send_cut<S: CoverageSink>(
    row: i32,
    left: (Extent, impl Steep),
    right: (Extent, impl Steep),
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut of_left, mut of_right) = changes.sides();
    of_left.add(&Ramp::new(left.0, FULL, left.1));
    of_right.add(&Ramp::new(right.0, FULL, right.1));
    if send_few::<false, S>(row, of_left, of_right, columns, runs)? {
        return Ok(());
    }
    send_far_cut(row, left, right, columns, runs)
}

#[cold]
#[inline(never)]
fn send_far_cut<S: CoverageSink>(
    row: i32,
    left: (Extent, impl Steep),
    right: (Extent, impl Steep),
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let ramps = [(Ramp::new(left.0, FULL, left.1), 1), (Ramp::new(right.0, FULL, right.1), u32::MAX)];
    send_far(row, &ramps, columns, runs)
}
