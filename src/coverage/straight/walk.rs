//! From row to row: whole ones together, those with an end or a turn one by one.

use core::ops::Range;

use heapless::Vec;

use crate::coverage::{
    CoverageSink,
    few::{Changes, send_few},
    runs::Runs,
    straight::{far::send_far, rows::send_rows, side::Side},
};

/// Sends what lies between two sides, in some of the columns that they touch.
#[inline(always)]
pub(crate) fn send_straight<const BITS: u32, S: CoverageSink>(
    mut left: Side<BITS>,
    mut right: Side<BITS>,
    mut rows: Range<i32>,
    touched: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    left.skip_to(rows.start);
    right.skip_to(rows.start);
    let is_cut = touched != columns;
    let mut runs = Runs::new(sink);
    let mut changes = Changes::default();
    while rows.start < rows.end {
        let whole = left.whole_rows(rows.start).min(right.whole_rows(rows.start)).min(rows.end - rows.start);
        if whole > 0 {
            send_rows(
                &mut left.edge,
                &mut right.edge,
                rows.start..rows.start + whole,
                columns,
                is_cut,
                &mut changes,
                &mut runs,
            )?;
            rows.start += whole;
        } else {
            send_pieces(&mut left, &mut right, rows.start, columns, &mut changes, &mut runs)?;
            rows.start += 1;
        }
    }
    Ok(())
}

/// A row in which a side begins, ends or turns.
#[inline(never)]
fn send_pieces<const BITS: u32, S: CoverageSink>(
    left: &mut Side<BITS>,
    right: &mut Side<BITS>,
    row: i32,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut of_left, mut of_right) = changes.sides();
    let left_foot = left.pieces(row, |ramp| of_left.add(ramp));
    let right_foot = right.pieces(row, |ramp| of_right.add(ramp));
    if !send_few::<false, S>(row, of_left, of_right, columns, runs)? {
        send_far_pieces(left, right, row, columns, runs)?;
    }
    left.go_to(left_foot);
    right.go_to(right_foot);
    Ok(())
}

#[cold]
#[inline(never)]
fn send_far_pieces<const BITS: u32, S: CoverageSink>(
    left: &Side<BITS>,
    right: &Side<BITS>,
    row: i32,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    // Two a side; there are never more.
    let mut ramps = Vec::<_, 4>::new();
    left.pieces(row, |ramp| ramps.push((*ramp, 1)).unwrap_or_default());
    right.pieces(row, |ramp| ramps.push((*ramp, u32::MAX)).unwrap_or_default());
    send_far(row, &ramps, columns, runs)
}
