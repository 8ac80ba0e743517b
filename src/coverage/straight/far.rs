//! Rows that take more columns than `few` has slots for, or that the clip cuts.

use core::ops::Range;

use crate::coverage::{
    CoverageSink,
    ramp::{Ramp, coverage_of},
    runs::Runs,
};

/// Column by column, but for what is between the sides.
#[inline(never)]
pub(super) fn send_far<S: CoverageSink>(
    row: i32,
    ramps: &[(Ramp, u32)],
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    runs.start(row);
    let (mut start, mut end) = (i32::MAX, i32::MIN);
    let (mut left_end, mut right_start) = (i32::MIN, i32::MAX);
    for (ramp, sign) in ramps {
        (start, end) = (start.min(ramp.first), end.max(ramp.last + 1));
        if *sign == 1 {
            left_end = left_end.max(ramp.last + 1);
        } else {
            right_start = right_start.min(ramp.first);
        }
    }
    let end = end.min(columns.end);
    let mut column = start.max(columns.start);
    while column < end {
        let add = |area: u32, (ramp, sign): &(Ramp, u32)| area.wrapping_add(ramp.at(column).wrapping_mul(*sign));
        let coverage = coverage_of(ramps.iter().fold(0, add));
        if column >= left_end && column < right_start {
            let until = right_start.min(end);
            runs.alike(column, until, coverage)?;
            column = until;
        } else {
            runs.pixel(column, coverage)?;
            column += 1;
        }
    }
    runs.finish()
}
