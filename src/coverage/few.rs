//! The few ramps of a row, added up: where a side begins, ends or turns, and where both sides share columns.
//!
//! Each side adds up how the area changes from column to column, in 16 slots: a column's is its number modulo 16. Whatever the
//! first of them is, up to 15 columns, and the one after them, in which the area stops changing, have slots of their own:
//!
//! ```text
//!   column     29  30  31  32  33        slot    0   1   2  ...  13  14  15
//!   change      3  40  52  60   0               60   0   0  ...   3  40  52
//! ```
//!
//! So ramps are added as they are found, and nothing is known of the others.

use core::{hint::black_box, mem::take, ops::Range};

use crate::{
    coverage::{
        CoverageSink,
        eights::EIGHT,
        ramp::{Ramp, coverage_of},
        runs::{Runs, SPAN},
    },
    span::Span,
};

/// So many columns, and one more, have slots of their own.
pub(crate) const NEAR: i32 = 15;

pub(super) const SLOTS: usize = NEAR as usize + 1;

/// How the area changes, for both sides; all 0 between rows.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    left: [u32; SLOTS],
    right: [u32; SLOTS],
}

impl Changes {
    /// Nothing, on either side of a row.
    #[inline(always)]
    pub(crate) fn sides(&mut self) -> (Few<'_>, Few<'_>) {
        (Few::new(&mut self.left), Few::new(&mut self.right))
    }
}

/// The ramps of a side, added up.
#[derive(Debug)]
pub(crate) struct Few<'c> {
    changes: &'c mut [u32; SLOTS],
    /// The columns of all ramps.
    start: i32,
    end: i32,
}

impl Ramp {
    /// How the area changes in each of its columns, and in the one after them.
    #[inline(always)]
    pub(super) fn for_each_change(&self, mut change: impl FnMut(i32, u32)) {
        let Self { first, last, .. } = *self;
        change(first, self.first_area);
        if last != first {
            let mut area = self.first_area;
            if last - first > 1 {
                change(first + 1, self.second_area.wrapping_sub(area));
                area = self.second_area;
                for column in first + 2..last {
                    // As in `send_run`.
                    black_box(());
                    change(column, self.step);
                    area = area.wrapping_add(self.step);
                }
            }
            change(last, self.last_area.wrapping_sub(area));
        }
        change(last + 1, self.height.wrapping_sub(self.last_area));
    }
}

impl<'c> Few<'c> {
    #[inline(always)]
    fn new(changes: &'c mut [u32; SLOTS]) -> Self {
        Self { changes, start: i32::MAX, end: i32::MIN }
    }

    #[inline(always)]
    fn slot(&mut self, column: i32) -> Option<&mut u32> {
        self.changes.get_mut(column.cast_unsigned() as usize % SLOTS)
    }

    /// Adds what is right of an edge.
    #[inline(always)]
    pub(crate) fn add(&mut self, ramp: &Ramp) {
        let Ramp { first, last, .. } = *ramp;
        (self.start, self.end) = (self.start.min(first), self.end.max(last + 1));
        if last - first >= NEAR {
            return;
        }
        ramp.for_each_change(|column, by| {
            if let Some(change) = self.slot(column) {
                *change = change.wrapping_add(by);
            }
        });
    }

    /// Whether its columns have slots of their own.
    #[inline(always)]
    fn is_near(&self) -> bool {
        self.end.wrapping_sub(self.start) <= NEAR
    }

    /// How the area changes in a column. Runs leave 0 behind, column by column; eights clear all slots later.
    #[inline(always)]
    fn change_in<S: CoverageSink>(&mut self, column: i32) -> u32 {
        self.slot(column).map_or(0, |change| if S::EIGHTS { *change } else { take(change) })
    }

    #[inline(always)]
    fn clear(self) {
        *self.changes = [0; SLOTS];
    }
}

/// Sends what lies between two sides, if it can be told from the slots and the clip does not cut it.
///
/// `ROUND`: also where both sides are near each other there may be pixels inside, as in circles. In runs, they are sent as a span.
#[inline(always)]
pub(super) fn send_few<const ROUND: bool, S: CoverageSink>(
    row: i32,
    mut left: Few<'_>,
    mut right: Few<'_>,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<bool, S::Error> {
    let (start, end) = (left.start.min(right.start), left.end.max(right.end));
    let are_together =
        end.wrapping_sub(start) <= NEAR && (!ROUND || S::EIGHTS || right.start.wrapping_sub(left.end) < SPAN);
    let are_apart = left.end <= right.start && left.is_near() && right.is_near();
    let is_sent = (are_together || are_apart) && start >= columns.start && end <= columns.end;
    if is_sent {
        if are_together {
            send_together(row, start..end, &mut left, &mut right, runs)?;
        } else {
            send_separately(row, &mut left, &mut right, runs)?;
        }
    }
    if S::EIGHTS || !is_sent {
        left.clear();
        right.clear();
    }
    Ok(is_sent)
}

/// Sends both sides, added up.
#[inline(always)]
fn send_together<S: CoverageSink>(
    row: i32,
    columns: Range<i32>,
    left: &mut Few<'_>,
    right: &mut Few<'_>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let mut area = 0_u32;
    send_columns(row, columns, i32::MAX, runs, |column| {
        area = area.wrapping_add(left.change_in::<S>(column)).wrapping_sub(right.change_in::<S>(column));
        area
    })?;
    Ok(())
}

#[inline(always)]
fn send_separately<S: CoverageSink>(
    row: i32,
    left: &mut Few<'_>,
    right: &mut Few<'_>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (of_left, of_right) = (left.start..left.end, right.start..right.end);
    let mut area = 0_u32;
    let inside = send_columns(row, of_left, of_right.start, runs, |column| {
        area = area.wrapping_add(left.change_in::<S>(column));
        area
    })?;
    let columns = inside..of_right.start;
    let coverage = coverage_of(area);
    if !columns.is_empty() && coverage > 0 {
        runs.sink.span(Span { row, columns }, coverage)?;
    }
    send_columns(row, of_right, i32::MAX, runs, |column| {
        area = area.wrapping_sub(right.change_in::<S>(column));
        area
    })?;
    Ok(())
}

/// Sends columns, asking for the area in each of them and in the one after; in eights it may go on as far as `limit`. Where
/// what is not sent begins is returned.
#[inline(always)]
fn send_columns<S: CoverageSink>(
    row: i32,
    columns: Range<i32>,
    limit: i32,
    runs: &mut Runs<'_, S>,
    mut area: impl FnMut(i32) -> u32,
) -> Result<i32, S::Error> {
    if !S::EIGHTS {
        send_run(row, &columns, runs, area)?;
        return Ok(columns.end);
    }
    let mut column = columns.start;
    loop {
        // A word, as eight bytes that were stored one by one would have to be waited for when they are loaded together.
        let mut word = 0;
        for lane in 0..EIGHT {
            let area = area(column + lane);
            let coverage = if column + lane < limit { coverage_of(area) } else { 0 };
            word |= u64::from(coverage) << (8 * lane);
        }
        runs.sink.eights(row, column, &[word.to_le_bytes()])?;
        column += EIGHT;
        if column == columns.end {
            area(column);
        }
        if column >= columns.end {
            return Ok(column.min(limit));
        }
    }
}

#[inline(always)]
pub(super) fn send_run<S: CoverageSink>(
    row: i32,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
    mut area: impl FnMut(i32) -> u32,
) -> Result<(), S::Error> {
    let length = columns.end.wrapping_sub(columns.start).cast_unsigned() as usize;
    // Beyond a byte once there was a 0.
    let mut less_one = 0_u32;
    for (column, coverage) in columns.clone().zip(&mut runs.coverage) {
        // Unrolled, it is slower for the two or three columns that there mostly are.
        black_box(());
        *coverage = coverage_of(area(column));
        less_one |= u32::from(*coverage).wrapping_sub(1);
    }
    area(columns.end);
    runs.start(row);
    runs.send_all(columns.start, length, less_one > 255)
}
