//! The active edge table: the chains of the current row of pixels, from left to right, in slots that the caller owns.
//!
//! Every slot holds a chain that is active, a top that waits for its row, or nothing. Tops wait in lists, one for each row
//! (with fewer slots than rows, several rows share one): the edge table of the scan line method, without a sort. The
//! vertices are looked over once where there is a slot for each top and another for its second chain; where there is not,
//! the latest tops are dropped, and looked for again when their row comes.

use crate::area::{
    chain::{CoverageEdge, Place, State},
    source::{FINE_BITS, Source},
};

/// No slot.
const NONE: u32 = u32::MAX;

/// See the module.
pub(super) struct Table<'a, 's> {
    pub(super) source: Source<'a>,
    pub(super) slots: &'s mut [CoverageEdge],
    /// How many lists of tops there are.
    lists: usize,
    /// Slots from here on have not been used yet.
    used: u32,
    /// The first of those that have been, and hold nothing, in a list.
    free: u32,
    waiting: usize,
    pub(super) active: usize,
    /// From this row on, tops are missing.
    horizon: i32,
    rows: i32,
}

impl<'a, 's> Table<'a, 's> {
    pub(super) fn new(source: Source<'a>, slots: &'s mut [CoverageEdge], rows: i32) -> Self {
        // A list for each row, as far as there are slots; a slot is looked at when it is first used.
        let lists = slots.len().min(rows.unsigned_abs() as usize);
        for slot in slots.iter_mut().take(lists) {
            slot.starting = NONE;
        }
        Self { source, slots, lists, used: 0, free: NONE, waiting: 0, active: 0, horizon: 0, rows }
    }

    #[inline]
    fn release(&mut self, index: u32) {
        if let Some(slot) = self.slots.get_mut(index as usize) {
            (slot.next, slot.state) = (self.free, State::Free);
            self.free = index;
        }
    }

    #[inline]
    fn take_free(&mut self) -> Option<u32> {
        let index = self.free;
        if let Some(slot) = self.slots.get(index as usize) {
            self.free = slot.next;
            return Some(index);
        }
        let index = self.used;
        self.slots.get(index as usize)?;
        self.used += 1;
        Some(index)
    }

    /// The slot whose list has the tops of a row.
    #[inline]
    fn list_of(&self, row: i32) -> usize {
        let row = row.unsigned_abs() as usize;
        if row < self.lists { row } else { row % self.lists.max(1) }
    }

    /// Puts a top into its list.
    fn wait(&mut self, contour: u32, index: u32, row: i32) {
        let Some(place) = self.take_free().or_else(|| self.drop_latest(row)) else {
            self.horizon = self.horizon.min(row);
            return;
        };
        let list = self.list_of(row);
        let next = self.slots.get_mut(list).map_or(NONE, |slot| core::mem::replace(&mut slot.starting, place));
        if let Some(slot) = self.slots.get_mut(place as usize) {
            slot.wait(contour, index, row, next);
        }
        self.waiting += 1;
    }

    /// Makes room by forgetting the top with the latest row, if that is after `row`.
    #[cold]
    fn drop_latest(&mut self, row: i32) -> Option<u32> {
        let waiting = self.slots.iter().zip(0..self.used).filter(|(slot, _)| slot.state == State::Waits);
        let (latest, place) = waiting.map(|(slot, place)| (slot.end, place)).max()?;
        if latest <= row {
            return None;
        }
        self.unlink(place, latest);
        self.horizon = self.horizon.min(latest);
        Some(place)
    }

    /// Takes a top out of its list.
    fn unlink(&mut self, place: u32, row: i32) {
        let list = self.list_of(row);
        let next = self.slots.get(place as usize).map_or(NONE, |slot| slot.next);
        self.waiting -= 1;
        let Some(first) = self.slots.get_mut(list) else { return };
        if first.starting == place {
            first.starting = next;
            return;
        }
        let mut at = first.starting;
        while let Some(slot) = self.slots.get_mut(at as usize) {
            if slot.next == place {
                slot.next = next;
                return;
            }
            at = slot.next;
        }
    }

    /// Looks for the tops from `row` on.
    #[inline(never)]
    fn look_ahead(&mut self, row: i32) {
        self.forget_waiting();
        self.horizon = i32::MAX;
        let (source, rows) = (self.source, self.rows);
        source.for_each_top(|contour, index, y| {
            let start = (y >> FINE_BITS).max(0);
            // Chains that end above the first row have no slots.
            let is_there = || {
                let reaches = |way| {
                    let mut chain = CoverageEdge::EMPTY;
                    chain.begin(&source, (contour, index), way, 0)
                };
                y >= 0 || reaches(1) || reaches(-1)
            };
            if start >= row && start < rows && is_there() {
                self.wait(contour, index, start);
            }
        });
    }

    /// The next row, from `row` on, in which there is anything.
    pub(super) fn next_row(&mut self, row: i32) -> i32 {
        if self.active > 0 {
            return row;
        }
        if row >= self.horizon {
            self.look_ahead(row);
        }
        if self.waiting == 0 {
            return self.horizon;
        }
        let waiting = self.slots.iter().take(self.used as usize).filter(|slot| slot.state == State::Waits);
        waiting.map(|slot| slot.end).min().unwrap_or(i32::MAX).min(self.horizon).max(row)
    }

    /// Those that are found again.
    fn forget_waiting(&mut self) {
        if self.waiting == 0 {
            return;
        }
        for slot in self.slots.iter_mut().take(self.lists) {
            slot.starting = NONE;
        }
        for index in 0..self.used {
            let Some(slot) = self.slots.get_mut(index as usize) else { break };
            if slot.state == State::Waits {
                self.release(index);
            }
        }
        self.waiting = 0;
    }

    /// Makes the chains that start in a row active, behind the others.
    #[inline]
    pub(super) fn start(&mut self, row: i32) {
        if row >= self.horizon {
            self.look_ahead(row);
        }
        if self.waiting > 0 {
            self.start_waiting(row);
        }
    }

    #[inline(never)]
    fn start_waiting(&mut self, row: i32) {
        let list = self.list_of(row);
        let mut at = self.slots.get(list).map_or(NONE, |slot| slot.starting);
        while let Some(slot) = self.slots.get(at as usize) {
            let (next, is_due, vertex) = (slot.next, slot.end == row, slot.vertex());
            if !is_due {
                at = next;
                continue;
            }
            self.unlink(at, row);
            self.start_chain(at, vertex, 1, row);
            if let Some(other) = self.take_free().or_else(|| self.drop_latest(row)) {
                self.start_chain(other, vertex, -1, row);
            }
            // What was dropped may have been the next.
            at = self.slots.get(list).map_or(NONE, |slot| slot.starting);
        }
    }

    fn start_chain(&mut self, slot: u32, vertex: (u32, u32), direction: i8, row: i32) {
        let Some(chain) = self.slots.get_mut(slot as usize) else { return };
        if !chain.begin(&self.source, vertex, direction, row << FINE_BITS) {
            self.release(slot);
            return;
        }
        self.set_place(self.active, Place { low: i32::MIN, slot });
        self.active += 1;
    }

    #[inline]
    pub(super) fn place(&self, place: usize) -> Place {
        self.slots.get(place).map_or(Place { low: 0, slot: NONE }, |slot| slot.place)
    }

    #[inline]
    pub(super) fn set_place(&mut self, place: usize, to: Place) {
        if let Some(slot) = self.slots.get_mut(place) {
            slot.place = to;
        }
    }

    #[inline]
    pub(super) fn chain(&self, place: usize) -> Option<&CoverageEdge> {
        self.slots.get(self.place(place).slot as usize)
    }

    #[inline]
    pub(super) fn chain_mut(&mut self, place: usize) -> Option<&mut CoverageEdge> {
        let slot = self.place(place).slot;
        self.slots.get_mut(slot as usize)
    }

    /// Takes all chains over a row, and brings them in order from left to right. The last `new` have just started.
    #[inline]
    pub(super) fn advance(&mut self, row: i32, old: usize) {
        let (source, row_top) = (self.source, row << FINE_BITS);
        let mut last = i32::MIN;
        for at in 0..self.active {
            let mut place = self.place(at);
            let Some(chain) = self.slots.get_mut(place.slot as usize) else { break };
            place.low = chain.advance(&source, row_top);
            self.set_place(at, place);
            if place.low < last {
                self.sink(if at < old { 0 } else { old }, at);
            } else {
                last = place.low;
            }
            if at + 1 == old {
                last = i32::MIN;
            }
        }
        if old < self.active && old > 0 {
            self.merge(old);
        }
    }

    /// Moves a chain to the left, behind those that do not begin to the right of it.
    #[inline(never)]
    pub(super) fn sink(&mut self, first: usize, mut at: usize) {
        let place = self.place(at);
        while at > first {
            let left = self.place(at - 1);
            if left.low <= place.low {
                break;
            }
            self.set_place(at, left);
            at -= 1;
        }
        self.set_place(at, place);
    }

    /// Merges two parts that are in order.
    #[inline(never)]
    fn merge(&mut self, mut old: usize) {
        let mut end = self.active;
        while old > 0 && old < end {
            // The last of the old ones goes where it belongs, with all that do not belong before it.
            let last = self.place(end - 1);
            let behind = self.place(old - 1);
            if behind.low <= last.low {
                end -= 1;
                continue;
            }
            let mut from = old - 1;
            while from > 0 && self.place(from - 1).low > last.low {
                from -= 1;
            }
            // `from..old` belongs behind all of `old..end`: they change places.
            self.rotate(from, old, end);
            end -= old - from;
            old = from;
        }
    }

    /// `from..middle` and `middle..to` change places.
    fn rotate(&mut self, from: usize, middle: usize, to: usize) {
        self.reverse(from, middle);
        self.reverse(middle, to);
        self.reverse(from, to);
    }

    fn reverse(&mut self, mut from: usize, mut to: usize) {
        while from + 1 < to {
            to -= 1;
            let (a, b) = (self.place(from), self.place(to));
            self.set_place(from, b);
            self.set_place(to, a);
            from += 1;
        }
    }

    /// Goes to the next row: chains that have ended leave.
    #[inline]
    pub(super) fn leave_row(&mut self) {
        let mut kept = 0;
        for at in 0..self.active {
            let place = self.place(at);
            let Some(chain) = self.slots.get_mut(place.slot as usize) else { break };
            if chain.ends {
                self.release(place.slot);
                continue;
            }
            chain.leave_row();
            if kept != at {
                self.set_place(kept, place);
            }
            kept += 1;
        }
        self.active = kept;
    }
}
