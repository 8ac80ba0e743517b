//! Convex shapes, row by row: a left and a right side, each one chain of edges downwards.
//!
//! Most rows are crossed by one edge on either side, from top to bottom. Then there are no cells: where the two edges
//! share no column, what the left one leaves of its pixels and what the right one takes of its own are sent as they are, and
//! all between is inside.
//!
//! ```text
//!        left          right
//!     |   /#|###|###|###\   |
//!     |  /##|###|###|####\  |        runs of one or two pixels, and a span
//!     | /###|###|###|#####\ |
//! ```

use core::ops::Range;

use crate::{
    coverage::{
        Cell, Cells, CoverageSink, Ramp, Runs, Steepness,
        ramp::{column_of, coverage_of},
        runs::Crossings,
    },
    span::clip_range,
};

/// A chain of edges, at the top of a row of pixels or at its own upper end.
pub(crate) trait Side: Clone {
    /// How many rows from here on its current edge crosses from top to bottom.
    fn whole_rows(&self) -> i32;

    /// The current edge in a whole row. It is taken to the next.
    fn whole_row(&mut self) -> Ramp;

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
    while rows.start < rows.end {
        let whole = left.whole_rows().min(right.whole_rows()).min(rows.end - rows.start);
        for _ in 0..whole {
            runs.start(rows.start);
            send_between(&left.whole_row(), &right.whole_row(), columns, &mut runs)?;
            rows.start += 1;
        }
        if rows.start < rows.end {
            send_pieces(&mut left, &mut right, rows.start, columns, &mut runs)?;
            rows.start += 1;
        }
    }
    Ok(())
}

/// Sends a row between two edges that cross all of it.
#[inline(always)]
fn send_between<S: CoverageSink>(
    left: &Ramp,
    right: &Ramp,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    if left.last <= right.first && left.first >= columns.start && right.last < columns.end {
        let mut crossings = Crossings::new();
        crossings.edge(left, 1, runs)?;
        crossings.edge(right, -1, runs)?;
        crossings.finish(runs)
    } else {
        send_cut(left, right, columns, runs)
    }
}

/// The same where the two share columns, or the clip cuts them.
#[inline(never)]
fn send_cut<S: CoverageSink>(
    left: &Ramp,
    right: &Ramp,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let from = left.first.min(right.first).max(columns.start);
    let end = (left.last.max(right.last) + 1).min(columns.end);
    let inside = (left.last + 1).max(from)..right.first.min(end);
    let mut column = from;
    while column < end {
        if column == inside.start && inside.start < inside.end {
            runs.alike(inside.start, inside.end, 255)?;
            column = inside.end;
        } else {
            runs.pixel(column, coverage_of(left.at(column).wrapping_sub(right.at(column))))?;
            column += 1;
        }
    }
    runs.finish()
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
            window.add_ramp(&Ramp::between(from, to, height, steepness), 1);
        });
        right.clone().pieces(row, |from, to, height, steepness| {
            window.add_ramp(&Ramp::between(from, to, height, steepness), -1);
        });
        window.sweep(row, runs)?;
        zone.start = end;
    }
    left.pieces(row, |_, _, _, _| ());
    right.pieces(row, |_, _, _, _| ());
    runs.finish()
}
