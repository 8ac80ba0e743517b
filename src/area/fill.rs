//! Exact areas of an outline, row by row of pixels: what of each pixel is inside by the fill rule.
//!
//! A chain has a weight in a row: what the fill rule says of the winding to its right, less what it says of the winding to
//! its left, so 1, 0 or -1. Each chain's signed areas are added with its weight, in whatever order. The sum is the exact
//! area by either rule, under any overlap, as long as the winding to the left is known: chains are in order from left to
//! right, by their least columns. Chains whose extents overlap are compared where they share heights ([`order`]); those
//! that cross within the row are swept from height to height ([`sweep`]).
//!
//! ```text
//!      0   \ 1   / 0        extents of one row:    |--|    |---|         apart: the order is known
//!           \   /                                  |----|                overlapping: compared
//!            \ /                                      |----|
//! ```

use crate::{
    area::{
        AreaSink,
        accumulator::{Accumulator, WINDOW_COLUMNS},
        cell::FULL,
        chain::{CoverageEdge, State},
        emission::Emission,
        lines::{Kept, Row},
        order,
        pair::send_pair,
        row::GAP,
        source::{FINE_BITS, Source},
        sweep,
        table::Table,
        winding::Winding,
    },
    outline::WindingRule,
};

/// The most columns of an edge of a pair.
const EDGE_COLUMNS: i32 = 6;

/// What a pair sends at once.
const PAIR_COLUMNS: usize = 2 * EDGE_COLUMNS.unsigned_abs() as usize + GAP;

/// Sends the areas of an outline within `width` columns and `height` rows; too few slots leave chains out.
pub(crate) fn fill(
    source: Source<'_>,
    inside: WindingRule,
    (width, height): (i32, i32),
    slots: &mut [CoverageEdge],
    sink: &mut dyn AreaSink,
) -> bool {
    let mut fill = Fill {
        table: Table::new(source, slots, height),
        inside,
        width,
        row: 0,
        winding: Winding::new(0),
        accumulator: Accumulator::new(),
        pair_areas: [0; 2 * PAIR_COLUMNS],
        kept: Kept::new(),
        swept_from: usize::MAX,
    };
    while fill.row < height {
        fill.row = fill.table.next_row(fill.row);
        if fill.row >= height {
            break;
        }
        let old = fill.table.active;
        fill.table.start(fill.row);
        fill.table.advance(fill.row, old);
        let goes_on = if fill.has_pairs() { fill.send_pairs(sink) } else { fill.send_row(sink) };
        if !goes_on {
            return false;
        }
        fill.table.leave_row();
        fill.row += 1;
    }
    true
}

/// The state of a walk.
pub(super) struct Fill<'a, 's> {
    pub(super) table: Table<'a, 's>,
    pub(super) inside: WindingRule,
    width: i32,
    row: i32,
    pub(super) winding: Winding,
    pub(super) accumulator: Accumulator,
    /// Of both edges of a pair.
    pair_areas: [i32; 2 * PAIR_COLUMNS],
    pub(super) kept: Kept,
    /// From this place on, the row has more levels than there is room for.
    swept_from: usize,
}

impl Fill<'_, '_> {
    #[inline]
    pub(super) fn row_top(&self) -> i32 {
        self.row << FINE_BITS
    }

    #[inline]
    pub(super) fn row(&self) -> Row<'_> {
        Row { source: self.table.source, top: self.row_top(), kept: self.kept.lines() }
    }

    /// Whether the row consists of pairs of edges that share no column, with nothing inside between two pairs.
    #[inline]
    fn has_pairs(&self) -> bool {
        let (mut winding, mut next_column) = (0_i32, 0);
        for at in 0..self.table.active {
            let place = self.table.place(at);
            let Some(chain) = self.table.slots.get(place.slot as usize) else { return false };
            let (low, high) = (place.low >> FINE_BITS, chain.high >> FINE_BITS);
            if !chain.is_single || low < next_column || high - low >= EDGE_COLUMNS {
                return false;
            }
            winding += i32::from(chain.direction);
            if self.inside.of(winding) != i32::from(at & 1 == 0) {
                return false;
            }
            next_column = high + 1;
        }
        self.table.active & 1 == 0 && next_column <= self.width && self.inside.of(0) == 0
    }

    fn send_pairs(&mut self, sink: &mut dyn AreaSink) -> bool {
        let mut at = 0;
        while at < self.table.active {
            let (left, right) = (self.table.place(at), self.table.place(at + 1));
            let slots = self.table.slots.get_disjoint_mut([left.slot as usize, right.slot as usize]);
            let Ok([left, right]) = slots else { return true };
            let sides = [&left.side(), &right.side()];
            if send_pair(self.row, self.width, sides, &mut self.pair_areas, sink) == Some(false) {
                return false;
            }
            at += 2;
        }
        true
    }

    /// One window of columns after the other.
    fn send_row(&mut self, sink: &mut dyn AreaSink) -> bool {
        let columns = WINDOW_COLUMNS;
        let active = self.table.active;
        self.swept_from = usize::MAX;
        // The first chain that has to do with the window, and the winding to its left.
        let (mut first, mut winding) = (0, 0);
        if active == 0 {
            return true;
        }
        let mut start = (self.table.place(0).low >> FINE_BITS).max(0);
        while start < self.width {
            let end = start + columns;
            self.accumulator.begin(start, self.inside.of(winding) * FULL);
            self.winding.set_flat(winding);
            // Where the next window may begin: no chain before that place reaches beyond this one.
            let (mut resume, mut resume_winding) = (first, winding);
            let mut flat_place = first;
            let mut high = i32::MIN;
            let mut place = first;
            let mut next_start = self.width;
            while place < active {
                let column = self.table.place(place).low >> FINE_BITS;
                if column >= end {
                    next_start = column.min(self.width);
                    break;
                }
                let (group_end, group_high) = self.group(place);
                high = high.max(group_high >> FINE_BITS);
                if !self.add_group(place, group_end) {
                    // The window once more, and at once from where the winding was flat to the right end.
                    self.swept_from = flat_place;
                    self.sort_again(first, active);
                    self.accumulator.clear();
                    self.accumulator.begin(start, self.inside.of(winding) * FULL);
                    self.winding.set_flat(winding);
                    (resume, resume_winding, flat_place, place) = (first, winding, first, first);
                    high = i32::MIN;
                    continue;
                }
                if group_end - place > 1 && high >= end {
                    self.sort_again(place, group_end);
                }
                place = group_end;
                if let Some(winding) = self.winding.flat() {
                    flat_place = place;
                    if high < end {
                        (resume, resume_winding) = (place, winding);
                    }
                }
            }
            let is_complete = resume == place;
            let until = if is_complete { next_start } else { end.min(self.width) };
            // Beyond the last change there is nothing, or all.
            let gap = is_complete.then(|| self.inside.of(resume_winding) * FULL);
            let emission = Emission { row: self.row, start, until, is_complete, gap };
            if !self.accumulator.emit(emission, sink) {
                return false;
            }
            (first, winding, start) = (resume, resume_winding, until);
            if is_complete && place >= active {
                break;
            }
        }
        true
    }

    /// The chains from `place` on whose extents overlap: the place behind the last, and how far they reach.
    #[inline]
    fn group(&self, place: usize) -> (usize, i32) {
        let mut high = self.table.chain(place).map_or(i32::MIN, |chain| chain.high);
        let mut end = place + 1;
        while end < self.table.active && (self.table.place(end).low < high || place == self.swept_from) {
            high = high.max(self.table.chain(end).map_or(i32::MIN, |chain| chain.high));
            end += 1;
        }
        (end, high)
    }

    /// Adds a group; `false` where there are too many levels.
    #[inline]
    fn add_group(&mut self, place: usize, end: usize) -> bool {
        if end - place == 1 {
            return self.add_chain(place);
        }
        if place == self.swept_from {
            sweep::sweep(self, place, end, true);
            // The right end of the row.
            self.winding.set_flat(0);
            return true;
        }
        self.keep_lines(place, end);
        let is_known = self.add_in_order(place, end);
        self.forget_lines(place, end);
        is_known
    }

    fn keep_lines(&mut self, place: usize, end: usize) {
        let (source, row_top) = (self.table.source, self.row_top());
        for at in place..end {
            if let Some(chain) = self.table.chain_mut(at) {
                chain.keep(source, row_top, &mut self.kept);
            }
        }
    }

    fn forget_lines(&mut self, place: usize, end: usize) {
        for at in place..end {
            if let Some(chain) = self.table.chain_mut(at) {
                chain.forget_lines();
            }
        }
        self.kept.clear();
    }

    fn add_in_order(&mut self, place: usize, end: usize) -> bool {
        let row_top = self.row_top();
        order::put_in_order(&mut self.table, place, end, (row_top, self.kept.lines()));
        let mut at = place;
        while at < end {
            let mut joined_end = at + 1;
            while joined_end < end && self.table.chain(joined_end).is_some_and(|chain| chain.state == State::Joined) {
                joined_end += 1;
            }
            let is_known =
                if joined_end - at == 1 { self.add_chain(at) } else { sweep::sweep(self, at, joined_end, false) };
            if !is_known {
                return false;
            }
            at = joined_end;
        }
        true
    }

    /// The next window begins with these chains, too, and knows groups by their least columns.
    fn sort_again(&mut self, place: usize, end: usize) {
        for at in place + 1..end {
            self.table.sink(place, at);
        }
    }

    #[inline]
    fn add_chain(&mut self, place: usize) -> bool {
        let row = Row { source: self.table.source, top: self.row_top(), kept: self.kept.lines() };
        let inside = self.inside;
        let flat = self.winding.flat();
        let slot = self.table.place(place).slot;
        let Some(chain) = self.table.slots.get_mut(slot as usize) else { return true };
        if let (Some(winding), true) = (flat, chain.is_whole()) {
            let weight = inside.weight(winding, chain.direction);
            self.winding.set_flat(winding + i32::from(chain.direction));
            if weight != 0 {
                chain.add(&row, weight, &mut self.accumulator);
            }
            return true;
        }
        let accumulator = &mut self.accumulator;
        let chain = &*chain;
        self.winding
            .pass(chain.top, chain.bottom, i32::from(chain.direction), &mut |top, bottom, winding| {
                let weight = inside.weight(winding, chain.direction);
                if weight != 0 {
                    chain.add_between(&row, (top, bottom), weight, accumulator);
                }
            })
            .is_ok()
    }
}
