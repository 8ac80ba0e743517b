//! The few ramps of a row, added up.

use core::{mem::take, ops::Range};

use crate::coverage::{
    CoverageSink, eights,
    ramp::{Ramp, coverage_of},
    runs::Runs,
};

/// So many columns, and one more, are added up at once.
pub(super) const NEAR: i32 = 15;

/// How the area changes from each column to the next; 0 between rows.
pub(super) type Changes = [u32; NEAR as usize + 1];

/// Adds up what is right of a few edges, each with its sign: 1 on the left, -1 on the right.
#[inline(always)]
pub(super) fn send_ramps<S: CoverageSink>(
    row: i32,
    ramps: &[(Ramp, u32)],
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    runs.start(row);
    let (mut start, mut end) = (i32::MAX, i32::MIN);
    for (ramp, _) in ramps {
        (start, end) = (start.min(ramp.first), end.max(ramp.last + 1));
    }
    if end.wrapping_sub(start) > NEAR || start < columns.start || end > columns.end {
        return send_far(ramps, start.max(columns.start)..end.min(columns.end), runs);
    }
    for (ramp, sign) in ramps {
        let mut before = 0;
        let mut index = ramp.first.wrapping_sub(start).cast_unsigned() as usize;
        let mut change = |area: u32| {
            if let Some(change) = changes.get_mut(index) {
                *change = change.wrapping_add(area.wrapping_sub(before).wrapping_mul(*sign));
            }
            before = area;
            index += 1;
        };
        change(ramp.first_area);
        if ramp.last != ramp.first {
            let mut area = ramp.second_area;
            for _ in ramp.first + 1..ramp.last {
                change(area);
                area = area.wrapping_add(ramp.step);
            }
            change(ramp.last_area);
        }
        change(ramp.height);
    }
    if S::EIGHTS {
        return eights::send_changes(row, start..end, changes, runs.sink);
    }
    let mut area = 0_u32;
    let length = (end - start).cast_unsigned() as usize;
    for (coverage, change) in runs.coverage.iter_mut().zip(changes.iter_mut()).take(length) {
        area = area.wrapping_add(take(change));
        *coverage = coverage_of(area);
    }
    if let Some(last) = changes.get_mut(length) {
        *last = 0;
    }
    runs.send_all(start, length)
}

/// Column by column, but for what is between the sides.
#[inline(never)]
pub(super) fn send_far<S: CoverageSink>(
    ramps: &[(Ramp, u32)],
    columns: Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut left_end, mut right_start) = (i32::MIN, i32::MAX);
    for (ramp, sign) in ramps {
        if *sign == 1 {
            left_end = left_end.max(ramp.last + 1);
        } else {
            right_start = right_start.min(ramp.first);
        }
    }
    let mut column = columns.start;
    while column < columns.end {
        let add = |area: u32, (ramp, sign): &(Ramp, u32)| area.wrapping_add(ramp.at(column).wrapping_mul(*sign));
        let coverage = coverage_of(ramps.iter().fold(0, add));
        if column >= left_end && column < right_start {
            let until = right_start.min(columns.end);
            runs.alike(column, until, coverage)?;
            column = until;
        } else {
            runs.pixel(column, coverage)?;
            column += 1;
        }
    }
    runs.finish()
}
