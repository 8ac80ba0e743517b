//! Trapezoids: rows of pixels between two neighbouring edges that share no column with another.
//!
//! They are not sent row by row but when something comes near one of the two edges: where it ends, where others start between
//! the two, or where columns are shared. Until then nothing looks at them:
//!
//! ```text
//!       \   . . /         \     /      each `.` stands for rows that have not been sent yet
//!        \ . . /\          \   /\
//!         \ . / .\    ->    \ /##\     the upper vertex on the right makes two trapezoids of one
//! ```

use core::ops::Range;

use crate::{
    coverage::{Changes, CoverageSink, Extent, Runs, Slope, column_of, part_of, send_between, send_cut},
    limits::SUBPIXEL_BITS,
    shape::{active::CoverageEdge, bands::{SLACK, Winding}, outline::FillRule},
};

/// A pixel, in positions.
const PIXEL: i64 = 1 << 40;

/// No edge of the narrow zone is in this column.
const FAR: i32 = 1 << 20;

impl Slope {
    /// Where it is at the top of a row of pixels.
    #[inline(always)]
    pub(super) fn at_row(&self, row: i32) -> i64 {
        self.position() + self.row_step() * i64::from(row - self.sent_to)
    }

    /// Its left end in the row, and its right one.
    #[inline(always)]
    pub(super) fn ends(&self, row: i32) -> (i64, i64) {
        let (position, step) = (self.at_row(row), self.row_step());
        (position + step.min(0), position + step.max(0))
    }

    /// It has been sent up to a row, and is at its top.
    #[inline(always)]
    pub(super) fn go_to_row(&mut self, row: i32, position: i64) {
        self.sent_to = row;
        self.move_to(position);
    }
}

/// An edge on its way down.
#[derive(Clone, Copy)]
struct Stepper {
    left: i64,
    step: i64,
    width: i64,
}

impl Stepper {
    #[inline(always)]
    fn new(edge: &Slope) -> Self {
        let step = edge.row_step();
        Self { left: edge.position() + step.min(0), step, width: step.abs() }
    }

    /// Where it is in this row. It is taken to the next.
    #[inline(always)]
    fn step(&mut self) -> Extent {
        let (left, right) = (self.left, self.left + self.width);
        self.left += self.step;
        Extent { first: column_of(left), last: column_of(right), left: part_of(left), right: part_of(right) }
    }

    #[inline(always)]
    fn put_back(self, edge: &mut Slope, row: i32) {
        edge.go_to_row(row, self.left - self.step.min(0));
    }
}

/// Sends a trapezoid, from the row that it has been sent up to.
#[inline(never)]
pub(super) fn send_up_to<S: CoverageSink>(
    row: i32,
    left_edge: &mut CoverageEdge,
    right_edge: &mut CoverageEdge,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let rows = left_edge.edge.sent_to..row;
    if rows.is_empty() {
        return Ok(());
    }
    let (mut left, mut right) = (Stepper::new(&left_edge.edge), Stepper::new(&right_edge.edge));
    let (of_left, of_right) = (left_edge.edge.steepness, right_edge.edge.steepness);
    for row in rows {
        let (left, right) = ((left.step(), of_left), (right.step(), of_right));
        if left.0.last < right.0.first {
            send_between(row, left, right, runs)?;
        } else {
            send_cut(row, left, right, columns, changes, runs)?;
        }
    }
    left.put_back(&mut left_edge.edge, row);
    right.put_back(&mut right_edge.edge, row);
    Ok(())
}

/// Sends all trapezoids up to a row.
#[inline(never)]
pub(super) fn send_all_up_to<S: CoverageSink>(
    row: i32,
    edges: &mut [CoverageEdge],
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    for pair in edges.as_chunks_mut().0 {
        let [left, right] = pair;
        send_up_to(row, left, right, columns, changes, runs)?;
    }
    Ok(())
}

/// All has been sent up to a row.
#[inline(always)]
pub(super) fn set_all_sent_to(row: i32, edges: &mut [CoverageEdge]) {
    for edge in edges {
        edge.edge.sent_to = row;
    }
}

/// Whether there is the inside to the right of every other edge, and only there, and all are in the narrow zone.
#[inline(never)]
pub(super) fn alternate(edges: &[CoverageEdge], fill_rule: FillRule) -> bool {
    let mut winding = Winding::new(fill_rule);
    let mut sign = 1;
    edges.iter().all(|edge| {
        let is_next = winding.cross(edge.winding()) == sign && !edge.edge.is_wide();
        sign = -sign;
        is_next
    }) && sign == 1
}

/// In how many of the rows, from the first on, trapezoids can be left alone: their two edges do not cross, they are a pixel or more
/// from each other, and none leaves the clip. Edges that end in the last row are not looked at there.
#[inline(never)]
pub(super) fn rows_apart(rows: Range<i32>, edges: &[CoverageEdge], columns: &Range<i32>) -> i32 {
    let mut apart = rows.end - rows.start;
    let border = |column: i32| i64::from(column.clamp(-FAR, FAR)) << 40;
    // Of the edge before: its right end in the first row, how far on that is in the next, and how many rows more it crosses.
    let mut before = Gap { from: border(columns.start) - PIXEL, step: 0, rows: apart - 1 };
    for pair in edges.as_chunks().0 {
        let [left, right] = pair.each_ref().map(|edge| Gap {
            from: edge.edge.at_row(rows.start),
            step: edge.edge.row_step(),
            rows: rows.end - rows.start - 1 - i32::from(edge.until < rows.end << SUBPIXEL_BITS),
        });
        let first = Gap { from: left.from + left.step.min(0), ..left };
        apart = apart.min(before.rows_to(first, PIXEL, 0)).min(left.rows_to(right, -SLACK, 1));
        before = Gap { from: right.from + right.step.max(0), ..right };
    }
    let end = Gap { from: border(columns.end), step: 0, rows: before.rows };
    apart.min(before.rows_to(end, 1, 0))
}

/// What is to the right of an edge.
#[derive(Clone, Copy)]
struct Gap {
    from: i64,
    step: i64,
    rows: i32,
}

impl Gap {
    /// How many rows there are up to where it is less than so wide up to another edge; many if it never is. `more` rows beyond those
    /// that both edges cross are looked at.
    #[inline(always)]
    fn rows_to(self, other: Self, width: i64, more: i32) -> i32 {
        let rows = self.rows.min(other.rows);
        let gap = other.from - self.from - width;
        let opens = other.step - self.step;
        if rows < 0 || (gap >= 0 && gap + opens * i64::from(rows + more) >= 0) { i32::MAX } else { rows_of(gap, opens, more) }
    }
}

#[cold]
fn rows_of(gap: i64, opens: i64, more: i32) -> i32 {
    if gap < 0 {
        return 0;
    }
    i32::try_from(gap.unsigned_abs() / opens.unsigned_abs().max(1)).map_or(i32::MAX, |rows| rows.saturating_add(1 - more))
}
