//! Chains that cross within a row of pixels: from height to height, so that between two of them nothing begins, ends or
//! crosses.
//!
//! ```text
//!     y   --\---/------      where the two cross, the band ends: above, one is to the left, below the other
//!            \ /
//!     to  ----X--------      rounded to 2^-16 pixel, which moves no area by more than that
//!            / \
//! ```
//!
//! J. L. Bentley and T. A. Ottmann, "Algorithms for reporting and counting geometric intersections", 1979, with the few
//! chains of a group in place of trees.

use crate::area::{
    chain::{Line, nearest},
    fill::Fill,
    source::FINE_ONE,
};

/// What the rounding of columns to 2^-16 pixel may make of two that are equal.
const TOLERANCE: i32 = 1;

/// How often a band is made shorter at the most.
const TRIES: usize = 64;

/// Adds the chains of a group; `false` where there are too many levels for what comes behind it.
#[inline(never)]
pub(super) fn sweep(fill: &mut Fill<'_, '_>, place: usize, end: usize) -> bool {
    let mut y = 0;
    while y < FINE_ONE {
        y = fill.sweep_band(place, end, y);
    }
    // The extents were in use for something else.
    let row_top = fill.row_top();
    let source = fill.table.source;
    let mut is_known = true;
    for at in place..end {
        let Some(chain) = fill.table.chain(at) else { break };
        chain.measure(&source, row_top);
        let (low, top, bottom, direction) = (chain.low, chain.top, chain.bottom, i32::from(chain.direction));
        is_known = is_known && fill.winding.pass(top, bottom, direction, &mut |_, _, _| {}).is_ok();
        fill.table.sink(place, at, low);
    }
    is_known
}

impl Fill<'_, '_> {
    /// Adds what lies between `y` and the next height at which anything changes, which is returned.
    fn sweep_band(&mut self, place: usize, end: usize, y: i32) -> i32 {
        // The winding to the left.
        let level = self.winding.levels().iter().find(|level| level.end > y);
        let (mut to, mut winding) = level.map_or((FINE_ONE, 0), |level| (level.end, level.winding));
        // Those that are there come first.
        let mut live = place;
        for at in place..end {
            let slot = self.table.slot_of(at);
            let Some(chain) = self.table.slots.get(slot) else { continue };
            if chain.top > y {
                to = to.min(chain.top);
            } else if let Some(line) = self.line_at(slot, y) {
                to = to.min(line.y1);
                let other = self.table.slot_of(live);
                self.table.set_order(live, slot);
                self.table.set_order(at, other);
                live += 1;
            }
        }
        if live == place {
            return to;
        }
        to = self.sort_band(place, live, y, to);
        for at in place..live {
            let slot = self.table.slot_of(at);
            let Some(chain) = self.table.slots.get(slot) else { break };
            let weight = self.inside.weight(winding, chain.direction);
            winding += i32::from(chain.direction);
            if weight != 0 && let Some(line) = self.line_at(slot, y) {
                line.between(y, to).add(weight, &mut self.accumulator);
            }
        }
        to
    }

    /// The line of a chain that goes on below a height.
    fn line_at(&self, slot: usize, y: i32) -> Option<Line> {
        let chain = self.table.slots.get(slot)?;
        chain.lines(&self.table.source, self.row_top()).find(|line| line.y1 > y)
    }

    /// Orders what is there between two heights, or down to the first crossing; `low` and `high` become the columns at both.
    fn sort_band(&mut self, place: usize, live: usize, y: i32, mut to: i32) -> i32 {
        // A crossing that is found may hide an earlier one; rounded ones could go on without an end.
        for _ in 0..TRIES {
            for at in place..live {
                let slot = self.table.slot_of(at);
                let Some(line) = self.line_at(slot, y) else { continue };
                let (low, high) = (nearest(line.x_at(y)), nearest(line.x_at(to)));
                if let Some(chain) = self.table.slots.get_mut(slot) {
                    (chain.low, chain.high) = (low, high);
                }
                // By the column in the middle.
                let mut to_place = at;
                while to_place > place
                    && self.table.chain_ref(to_place - 1).is_some_and(|left| {
                        i64::from(left.low) + i64::from(left.high) > i64::from(low) + i64::from(high)
                    })
                {
                    let left = self.table.slot_of(to_place - 1);
                    self.table.set_order(to_place, left);
                    to_place -= 1;
                }
                self.table.set_order(to_place, slot);
            }
            let mut cut = to;
            for at in place + 1..live {
                let (Some(left), Some(right)) = (self.table.chain_ref(at - 1), self.table.chain_ref(at)) else { break };
                let (above, below) = (right.low - left.low, right.high - left.high);
                if above < -TOLERANCE || below < -TOLERANCE {
                    let (above, below) = (i64::from(above.unsigned_abs()), i64::from(below.unsigned_abs()));
                    #[allow(clippy::cast_possible_truncation, reason = "at most the height of the band")]
                    let crossing = y + (i64::from(to - y) * above / (above + below).max(1)) as i32;
                    if crossing > y {
                        cut = cut.min(crossing);
                    }
                }
            }
            if cut == to {
                break;
            }
            to = cut;
        }
        to
    }
}
