//! Rows that one edge on either side crosses from top to bottom.

use core::ops::Range;

use crate::coverage::{
    CoverageSink,
    few::{Changes, send_few},
    ramp::{Extent, FULL, Ramp, Steep},
    runs::Runs,
    sides::send_between,
    stepper::Stepper,
    straight::{far::send_far, side::Straight},
};

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
    let mut left = Stepper::<0>::new(left_edge.position, left_edge.step);
    let mut right = Stepper::<0>::new(right_edge.position, right_edge.step);
    let (left_rise, right_rise) = (left_edge.rise, right_edge.rise);
    let (start, end) = (columns.start, columns.end);
    let is_checked = is_cut || S::EIGHTS;
    let end_row = rows.end;
    for row in rows {
        let (of_left, of_right) = (left.step(), right.step());
        if of_left.last < of_right.first && (!is_checked || (of_left.first >= start && of_right.last < end)) {
            send_between(row, (of_left, left_rise), (of_right, right_rise), runs)?;
        } else {
            send_cut(row, (of_left, left_rise), (of_right, right_rise), columns, changes, runs)?;
        }
    }
    (left_edge.position, left_edge.y) = (left.position(), end_row << BITS);
    (right_edge.position, right_edge.y) = (right.position(), end_row << BITS);
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
