//! The edges of a cluster, added up: how the area changes from one column to the next, from the cluster's first on.
//!
//! ```text
//!   column     29  30  31  32  33
//!   slot        0   1   2   3   4
//!   change      3  40 -17 -26   0      of an edge that leads inside, and one that leads outside
//! ```
//!
//! As in `few`, the column after the last, in which the area stops changing, has a slot, too.

use crate::{
    coverage::{
        CoverageSink,
        eights::EIGHT,
        few::{SLOTS, send_run},
        ramp::{FULL, Ramp, coverage_of},
        runs::Runs,
    },
    span::Span,
};

/// See the module.
#[derive(Debug)]
pub(crate) struct Sum {
    first: i32,
    last: i32,
    changes: [u32; SLOTS],
}

impl Sum {
    /// Of edges between two columns, which are less than [`NEAR`](super::NEAR) apart.
    #[inline(always)]
    pub(crate) fn new(first: i32, last: i32) -> Self {
        Self { first, last, changes: [0; SLOTS] }
    }

    /// Adds what is right of an edge, if it leads inside, or takes it away.
    #[inline(always)]
    pub(crate) fn add(&mut self, ramp: &Ramp, leads_inside: bool) {
        let sign = if leads_inside { 1 } else { u32::MAX };
        ramp.for_each_change(|column, by| {
            if let Some(change) = self.changes.get_mut((column - self.first).cast_unsigned() as usize % SLOTS) {
                *change = change.wrapping_add(by.wrapping_mul(sign));
            }
        });
    }

    /// Sends it. `inside`: what is before it is inside, and has been sent as far as there. After it, the inside may be sent as far
    /// as `limit`; where what has not been sent begins is returned.
    #[inline(always)]
    pub(crate) fn send<S: CoverageSink>(
        &self,
        row: i32,
        inside: Option<i32>,
        limit: i32,
        runs: &mut Runs<'_, S>,
    ) -> Result<i32, S::Error> {
        let mut area = 0;
        if let Some(inside) = inside {
            area = FULL;
            if inside < self.first {
                runs.sink.span(Span { row, columns: inside..self.first }, 255)?;
            }
        }
        let mut add = |change: u32| {
            area = area.wrapping_add(change);
            area
        };
        if !S::EIGHTS {
            let columns = self.first..self.last + 1;
            let mut changes = self.changes.iter();
            send_run(row, &columns, runs, |_| add(changes.next().copied().unwrap_or_default()))?;
            return Ok(columns.end);
        }
        let mut column = self.first;
        for eight in self.changes.as_chunks().0 {
            let eight: &[u32; EIGHT as usize] = eight;
            let mut coverage = [0; EIGHT as usize];
            for (coverage, change) in coverage.iter_mut().zip(eight) {
                *coverage = coverage_of(add(*change));
            }
            let excess = (column + EIGHT - limit).max(0).cast_unsigned();
            let word = u64::from_le_bytes(coverage) & (u64::MAX >> (8 * excess));
            runs.sink.eights(row, column, &[word.to_le_bytes()])?;
            column += EIGHT;
            if column > self.last {
                break;
            }
        }
        Ok(column.min(limit))
    }
}
