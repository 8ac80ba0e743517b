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
    coverage::{Changes, CoverageSink, Runs, Slope, Stepper, send_cut, send_while_apart},
    limits::SUBPIXEL_BITS,
    shape::{
        active::CoverageEdge,
        bands::{SLACK, Winding},
        outline::FillRule,
    },
    subpixel::pixel_holding,
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

/// Sends a trapezoid, from the row that it has been sent up to.
#[inline(always)]
pub(super) fn send_up_to<S: CoverageSink>(
    row: i32,
    left: &mut CoverageEdge,
    right: &mut CoverageEdge,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let rows = left.edge.sent_to..row;
    if rows.is_empty() { Ok(()) } else { send_rows(rows, &mut left.edge, &mut right.edge, columns, changes, runs) }
}

#[inline(never)]
fn send_rows<S: CoverageSink>(
    mut rows: Range<i32>,
    left: &mut Slope,
    right: &mut Slope,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let end = rows.end;
    let (of_left, of_right) = (left.steepness, right.steepness);
    let mut sides = [&*left, &*right].map(|edge| Stepper::<SUBPIXEL_BITS>::new(edge.position(), edge.row_step()));
    while rows.start < rows.end {
        rows.start = send_while_apart(rows.clone(), &mut sides, [of_left, of_right], runs)?;
        if rows.start < rows.end {
            let [left, right] = sides.each_mut().map(Stepper::step);
            send_cut(rows.start, (left, of_left), (right, of_right), columns, changes, runs)?;
            rows.start += 1;
        }
    }
    for edge in [left, right] {
        edge.go_to_row(end, edge.at_row(end));
    }
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

/// Whether there is the inside to the right of every other edge, and only there. There is an even number of edges in each row.
#[inline(never)]
pub(super) fn alternate(edges: &[CoverageEdge], fill_rule: FillRule) -> bool {
    let mut winding = Winding::new(fill_rule);
    let mut sign = 1;
    edges.iter().all(|edge| {
        let is_next = winding.cross(edge.winding()) == sign;
        sign = -sign;
        is_next
    })
}

/// In how many of the rows, from the first on, trapezoids can be left alone: their two edges do not cross, they are a pixel or more
/// from each other, and none leaves the clip.
///
/// Edges may end in the last row, at its top or below, where they are taken to go on; those of one trapezoid may cross there. All cross
/// the rows above it, so going on by another row is not far.
#[inline(never)]
pub(super) fn rows_apart(rows: Range<i32>, edges: &[CoverageEdge], columns: &Range<i32>) -> i32 {
    let count = rows.end - rows.start;
    let mut apart = count;
    if count > 0 {
        let border = |column: i32| Line { from: i64::from(column.clamp(-FAR, FAR)) << 40, step: 0 };
        let mut before = border(columns.start);
        let mut width = 0;
        for pair in edges.as_chunks().0 {
            let [left, right] = pair.each_ref().map(|edge| Line::new(&edge.edge, rows.start));
            let (left_below, right_below) = (left.moved_by(left.step), right.moved_by(right.step));
            let [left_edge, right_edge] = pair;
            let is_ending = pixel_holding(left_edge.until.min(right_edge.until)) < rows.end;
            apart = apart
                .min(before.rows_to(left.moved_by(left.step.min(0)), width, count - 1))
                .min(left_below.rows_to(right_below, -SLACK, count - 1 - i32::from(is_ending)));
            if apart == 0 {
                break;
            }
            before = right.moved_by(right.step.max(0));
            width = PIXEL;
        }
        apart = apart.min(before.rows_to(border(columns.end), 1, count - 1));
    }
    apart
}

/// Where something is at the top of a row, or at one of its ends in the row, and how far on in the next.
#[derive(Clone, Copy)]
struct Line {
    from: i64,
    step: i64,
}

impl Line {
    #[inline(always)]
    fn new(edge: &Slope, row: i32) -> Self {
        Self { from: edge.at_row(row), step: edge.row_step() }
    }

    #[inline(always)]
    fn moved_by(self, distance: i64) -> Self {
        Self { from: self.from + distance, ..self }
    }

    /// After how many rows it is less than `width` from another; more than `rows` if it is not within those.
    #[inline(always)]
    fn rows_to(self, other: Self, width: i64, rows: i32) -> i32 {
        let gap = other.from - self.from - width;
        let opens = other.step - self.step;
        if gap < 0 {
            0
        } else if gap + opens * i64::from(rows) >= 0 {
            i32::MAX
        } else {
            rows_of(gap, opens)
        }
    }
}

/// How many rows a gap that closes is at least 0.
#[cold]
fn rows_of(gap: i64, opens: i64) -> i32 {
    i32::try_from(gap.unsigned_abs() / opens.unsigned_abs().max(1)).map_or(i32::MAX, |rows| rows.saturating_add(1))
}
