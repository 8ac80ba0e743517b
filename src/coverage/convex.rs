//! Convex shapes of any size, row by row: a left and a right side, each a chain of pieces downwards.
//!
//! The columns that either side crosses in a row are added up in cells, so many at a time, and what lies between the sides is
//! sent as it is. A side is asked for its pieces once for each window of cells: this is for shapes that leave the narrow
//! zone, or are very large; what is usually drawn has walkers of its own.

use core::ops::Range;

use crate::{
    coverage::{
        Cell, Cells, CoverageSink, Extent, Ramp, Runs, Steepness,
        ramp::{column_of, coverage_of},
    },
    span::clip_range,
};

/// A chain of edges, at the top of a row of pixels or at its own upper end.
pub(crate) trait Side: Clone {
    /// The positions at the upper and at the lower end of each piece in `row`, the piece's height and steepness. The side is
    /// taken to the next row.
    fn pieces(&mut self, row: i32, piece: impl FnMut(i64, i64, u32, Steepness));
}

/// Columns of a row that has several pieces on a side are added up in so many cells at a time; 256 bytes of stack.
const WINDOW: usize = 64;

/// Sends what lies between two sides, in `rows`, on the first of which they are.
#[inline(always)]
pub(crate) fn send<S: CoverageSink>(
    mut left: impl Side,
    mut right: impl Side,
    mut rows: Range<i32>,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut runs = Runs::new(sink);
    rows.try_for_each(|row| send_pieces(&mut left, &mut right, row, columns, &mut runs))
}

/// The columns that a side's pieces in a row cross.
fn columns_of(mut side: impl Side, row: i32) -> Range<i32> {
    let (mut start, mut end) = (i32::MAX, i32::MIN);
    side.pieces(row, |from, to, _, _| {
        start = start.min(column_of(from.min(to)));
        end = end.max(column_of(from.max(to)) + 1);
    });
    start..end
}

/// Sends a row with any number of pieces on either side.
#[inline(never)]
fn send_pieces<L: Side, R: Side, S: CoverageSink>(
    left: &mut L,
    right: &mut R,
    row: i32,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (of_left, of_right) = (columns_of(left.clone(), row), columns_of(right.clone(), row));
    runs.start(row);
    let mut zone = of_left.start.min(of_right.start)..of_left.end.max(of_right.end);
    let gap = of_left.end..of_right.start;
    let mut cells = [Cell::EMPTY; WINDOW];
    zone = clip_range(&zone, columns);
    while zone.start < zone.end {
        if gap.contains(&zone.start) {
            let end = gap.end.min(zone.end);
            let mut height = 0;
            left.clone().pieces(row, |_, _, piece, _| height += piece);
            runs.alike(zone.start, end, coverage_of(height))?;
            zone.start = end;
            continue;
        }
        let mut end = zone.start.saturating_add(64).min(zone.end);
        if zone.start < gap.start && gap.start + 8 < gap.end {
            end = end.min(gap.start);
        }
        let mut window = Cells::new(&mut cells, zone.start..end);
        left.clone().pieces(row, |from, to, height, steepness| {
            window.add_ramp(&Ramp::new(Extent::between(from, to), height, steepness), 1);
        });
        right.clone().pieces(row, |from, to, height, steepness| {
            window.add_ramp(&Ramp::new(Extent::between(from, to), height, steepness), -1);
        });
        window.sweep(row, runs)?;
        zone.start = end;
    }
    left.pieces(row, |_, _, _, _| ());
    right.pieces(row, |_, _, _, _| ());
    runs.finish()
}
