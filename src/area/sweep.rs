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

use core::ops::Range;

use crate::area::{
    chain::Place,
    division::part_of,
    fill::Fill,
    line::{Line, nearest},
    lines::Row,
    piece::Piece,
    pixel::Pieces,
    source::{FINE_BITS, FINE_ONE},
    winding::Winding,
};

/// What the rounding of columns to 2^-16 pixel may make of two that are equal.
const TOLERANCE: i32 = 1;

/// How often a band is made shorter at the most.
const TRIES: usize = 64;

/// All columns.
const ALL: Range<i64> = i64::MIN..i64::MAX;

/// Adds chains that are joined, column by column; `false` where there are too many levels for what comes behind them.
///
/// In the last case, which takes the rest of the row, all columns at once.
#[inline(never)]
pub(super) fn sweep(fill: &mut Fill<'_, '_>, place: usize, end: usize, is_last: bool) -> bool {
    if is_last {
        fill.sweep_columns(place, end, 0, &ALL);
        return fill.pass_columns(place, end, &ALL) || is_last;
    }
    let (mut low, mut high) = (i32::MAX, i32::MIN);
    for at in place..end {
        low = low.min(fill.table.place(at).low);
        high = high.max(fill.table.chain(at).map_or(i32::MIN, |chain| chain.high));
    }
    let mut pieces = Pieces::new();
    (low >> FINE_BITS..=high >> FINE_BITS).all(|column| {
        let columns = i64::from(column) << 32..(i64::from(column) + 1) << 32;
        // Those that have a part in the column come first.
        let mut among = place;
        for at in place..end {
            let here = fill.table.place(at);
            let is_right = here.low >> FINE_BITS > column;
            if !is_right && fill.table.chain(at).is_some_and(|chain| chain.high >> FINE_BITS >= column) {
                let other = fill.table.place(among);
                fill.table.set_place(among, here);
                fill.table.set_place(at, other);
                among += 1;
            }
        }
        fill.sweep_pixel((place, among), column, &columns, &mut pieces)
    })
}

impl Fill<'_, '_> {
    /// Adds the pieces of a column, in parts of its height if there is not room for all of them; `false` where there are too
    /// many levels behind them.
    fn sweep_pixel(
        &mut self,
        (place, end): (usize, usize),
        column: i32,
        columns: &Range<i64>,
        pieces: &mut Pieces,
    ) -> bool {
        let mut right = Winding::empty();
        let (mut y, mut to, mut is_known) = (0, FINE_ONE, true);
        while y < FINE_ONE {
            if !self.gather((place, end), columns, y..to, pieces) {
                if to - y > 1 {
                    to = y + (to - y) / 2;
                    continue;
                }
                self.sweep_columns(place, end, y, columns);
                return self.pass_columns(place, end, columns);
            }
            let winding = (self.winding.levels(), &mut right);
            let is_added = pieces.add((column, y..to), winding, self.inside, &mut self.accumulator);
            is_known = is_known && is_added;
            // Where there was too little room, there may be again.
            (y, to) = (to, FINE_ONE.min(to + 2 * (to - y)));
        }
        self.winding = right;
        is_known
    }

    /// The pieces between two heights; `false` where there is no room for all.
    fn gather(
        &self,
        (place, end): (usize, usize),
        columns: &Range<i64>,
        heights: Range<i32>,
        pieces: &mut Pieces,
    ) -> bool {
        pieces.clear();
        self.each_line((place, end), columns, heights.clone(), &mut |line, direction| {
            let (top, bottom) = (line.y0.max(heights.start), line.y1.min(heights.end));
            top >= bottom || pieces.push(Piece::new(&line.between(top, bottom), direction, columns.start))
        })
    }

    /// What chains have between two columns and two heights, with their directions, until `found` has had enough.
    #[inline(never)]
    fn each_line(
        &self,
        (place, end): (usize, usize),
        columns: &Range<i64>,
        heights: Range<i32>,
        found: &mut dyn FnMut(&Line, i8) -> bool,
    ) -> bool {
        let row = self.row();
        for at in place..end {
            let Some(chain) = self.table.chain(at) else { break };
            if chain.top >= heights.end || chain.bottom <= heights.start {
                continue;
            }
            for line in chain.lines_from(&row, heights.start) {
                if line.y0 >= heights.end {
                    break;
                }
                if line.y1 > heights.start
                    && let Some(line) = line.within(columns)
                    && !found(&line, chain.direction)
                {
                    return false;
                }
            }
        }
        true
    }

    fn sweep_columns(&mut self, place: usize, end: usize, mut y: i32, columns: &Range<i64>) {
        while y < FINE_ONE {
            y = self.sweep_band(place, end, y, columns);
        }
    }

    /// The winding behind the columns; the extents, which were in use for something else, are found out again.
    fn pass_columns(&mut self, place: usize, end: usize, columns: &Range<i64>) -> bool {
        let (mut winding, mut is_known) = (self.winding, true);
        self.each_line((place, end), columns, 0..FINE_ONE, &mut |line, direction| {
            is_known = is_known && winding.pass(line.y0, line.y1, direction.into(), &mut |_, _, _| {}).is_ok();
            true
        });
        self.winding = winding;
        for at in place..end {
            let row = Row { source: self.table.source, top: self.row_top(), kept: self.kept.lines() };
            if let Some(chain) = self.table.chain_mut(at) {
                let low = chain.measure(&row);
                let place = Place { low, ..self.table.place(at) };
                self.table.set_place(at, place);
            }
        }
        is_known
    }

    /// Adds what lies between `y` and the next height at which anything changes, which is returned.
    fn sweep_band(&mut self, place: usize, end: usize, y: i32, columns: &Range<i64>) -> i32 {
        // The winding to the left.
        let level = self.winding.levels().iter().find(|level| level.end > y);
        let (mut to, mut winding) = level.map_or((FINE_ONE, 0), |level| (level.end, level.winding));
        // Those that are there come first.
        let mut live = place;
        for at in place..end {
            let here = self.table.place(at);
            let Some(chain) = self.table.chain(at) else { continue };
            if chain.top > y {
                to = to.min(chain.top);
            } else if chain.bottom > y
                && let Some(line) = self.line_at(here.slot, y, columns)
            {
                if line.y0 > y {
                    to = to.min(line.y0);
                    continue;
                }
                to = to.min(line.y1);
                let other = self.table.place(live);
                self.table.set_place(live, here);
                self.table.set_place(at, other);
                live += 1;
            }
        }
        if live == place {
            return to;
        }
        to = self.sort_band(place, live, y, to, columns);
        for at in place..live {
            let slot = self.table.place(at).slot;
            let Some(chain) = self.table.chain(at) else { break };
            let weight = self.inside.weight(winding, chain.direction);
            winding += i32::from(chain.direction);
            if weight != 0
                && let Some(line) = self.line_at(slot, y, columns)
            {
                line.between(y, to).add(weight, &mut self.accumulator);
            }
        }
        to
    }

    /// The line of a chain that goes on below a height.
    fn line_at(&self, slot: u32, y: i32, columns: &Range<i64>) -> Option<Line> {
        let chain = self.table.slots.get(slot as usize)?;
        chain.lines(&self.row()).filter_map(|line| line.within(columns)).find(|line| line.y1 > y)
    }

    /// Orders what is there between two heights, or down to the first crossing; `low` and `high` become the columns at both.
    fn sort_band(&mut self, place: usize, live: usize, y: i32, mut to: i32, columns: &Range<i64>) -> i32 {
        // A crossing that is found may hide an earlier one; rounded ones could go on without an end.
        for _ in 0..TRIES {
            for at in place..live {
                let slot = self.table.place(at).slot;
                let Some(line) = self.line_at(slot, y, columns) else { continue };
                let (low, high) = (nearest(line.x_at(y)), nearest(line.x_at(to)));
                if let Some(chain) = self.table.chain_mut(at) {
                    chain.high = high;
                }
                // By the column in the middle.
                let middle = i64::from(low) + i64::from(high);
                let mut free = at;
                while free > place {
                    let left = self.table.place(free - 1);
                    let left_high = self.table.chain(free - 1).map_or(0, |left| left.high);
                    if i64::from(left.low) + i64::from(left_high) <= middle {
                        break;
                    }
                    self.table.set_place(free, left);
                    free -= 1;
                }
                self.table.set_place(free, Place { low, slot });
            }
            let mut cut = to;
            let mut left = (i32::MIN, i32::MIN);
            for at in place..live {
                let right = (self.table.place(at).low, self.table.chain(at).map_or(0, |chain| chain.high));
                let (above, below) = (right.0.saturating_sub(left.0), right.1.saturating_sub(left.1));
                if above < -TOLERANCE || below < -TOLERANCE {
                    let (above, below) = (u64::from(above.unsigned_abs()), u64::from(below.unsigned_abs()));
                    let crossing = y + part_of(above, (to - y).unsigned_abs(), above + below).cast_signed();
                    if crossing > y {
                        cut = cut.min(crossing);
                    }
                }
                left = right;
            }
            if cut == to {
                break;
            }
            to = cut;
        }
        to
    }
}
