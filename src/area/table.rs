//! The active edge table: the chains of the current row of pixels, from left to right, in slots that the caller owns.
//!
//! Every slot holds a chain that is active, a top that waits for its row, or nothing. Tops wait in lists, one for each row
//! (with fewer slots than rows, several rows share one): the edge table of the scan line method, without a sort. The
//! vertices are looked over once where there is a slot for each top and another for its second chain; where there is not,
//! the latest tops are dropped, and looked for again when their row comes.

use crate::area::{
    chain::CoverageEdge,
    source::{FINE_BITS, Source},
};

/// No slot.
const NONE: u32 = u32::MAX;

/// See the module.
pub(super) struct Table<'a, 's> {
    pub(super) source: Source<'a>,
    pub(super) slots: &'s mut [CoverageEdge],
    /// The first of the slots that hold nothing.
    free: u32,
    free_count: usize,
    waiting: usize,
    pub(super) active: usize,
    /// From this row on, tops are missing.
    horizon: i32,
    rows: i32,
}

impl<'a, 's> Table<'a, 's> {
    pub(super) fn new(source: Source<'a>, slots: &'s mut [CoverageEdge], rows: i32) -> Self {
        let mut table = Self { source, slots, free: NONE, free_count: 0, waiting: 0, active: 0, horizon: 0, rows };
        for index in (0..u32::try_from(table.slots.len()).unwrap_or(NONE)).rev() {
            if let Some(slot) = table.slots.get_mut(index as usize) {
                slot.starting = NONE;
            }
            table.release(index);
        }
        table
    }

    #[inline]
    fn release(&mut self, index: u32) {
        let free = core::mem::replace(&mut self.free, index);
        if let Some(slot) = self.slots.get_mut(index as usize) {
            slot.low = free.cast_signed();
            slot.direction = 0;
        }
        self.free_count += 1;
    }

    #[inline]
    fn take_free(&mut self) -> Option<u32> {
        let index = self.free;
        let slot = self.slots.get(index as usize)?;
        self.free = slot.low.cast_unsigned();
        self.free_count -= 1;
        Some(index)
    }

    /// The slot whose list has the tops of a row.
    #[inline]
    fn list_of(&self, row: i32) -> usize {
        (row.unsigned_abs() as usize) % self.slots.len().max(1)
    }

    /// Puts a top into its list. A waiting slot has its row in `high`, and no direction.
    fn wait(&mut self, contour: u32, index: u32, row: i32) {
        let Some(place) = self.take_free().or_else(|| self.drop_latest(row)) else {
            self.horizon = self.horizon.min(row);
            return;
        };
        let list = self.list_of(row);
        let next = self.slots.get_mut(list).map_or(NONE, |slot| core::mem::replace(&mut slot.starting, place));
        if let Some(slot) = self.slots.get_mut(place as usize) {
            slot.set_waiting(contour, index, row, next);
        }
        self.waiting += 1;
    }

    /// Makes room by forgetting the top with the latest row, if that is after `row`.
    #[cold]
    fn drop_latest(&mut self, row: i32) -> Option<u32> {
        let waiting = self.slots.iter().enumerate().filter(|(_, slot)| slot.is_waiting);
        let (place, latest) = waiting.map(|(place, slot)| (place, slot.high)).max_by_key(|&(_, row)| row)?;
        if latest <= row {
            return None;
        }
        let place = u32::try_from(place).ok()?;
        self.unlink(place, latest);
        self.horizon = self.horizon.min(latest);
        Some(place)
    }

    /// Takes a top out of its list.
    fn unlink(&mut self, place: u32, row: i32) {
        let list = self.list_of(row);
        let next = self.slots.get_mut(place as usize).map_or(NONE, |slot| {
            slot.is_waiting = false;
            slot.low.cast_unsigned()
        });
        self.waiting -= 1;
        let Some(first) = self.slots.get_mut(list) else { return };
        if first.starting == place {
            first.starting = next;
            return;
        }
        let mut at = first.starting;
        while let Some(slot) = self.slots.get_mut(at as usize) {
            if slot.low.cast_unsigned() == place {
                slot.low = next.cast_signed();
                return;
            }
            at = slot.low.cast_unsigned();
        }
    }

    /// Looks for the tops from `row` on.
    #[inline(never)]
    fn look_ahead(&mut self, row: i32) {
        self.horizon = i32::MAX;
        let (source, rows) = (self.source, self.rows);
        source.for_each_top(|contour, index, y| {
            let start = (y >> FINE_BITS).max(0);
            let is_there = || y >= 0 || [1, -1].iter().any(|&way| CoverageEdge::leaving(contour, index, way).begin(&source, 0));
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
            self.forget_waiting();
            self.look_ahead(row);
        }
        let first = self.slots.iter().filter(|slot| slot.is_waiting).map(|slot| slot.high).min();
        first.unwrap_or(i32::MAX).min(self.horizon).max(row)
    }

    /// Those that are found again.
    fn forget_waiting(&mut self) {
        if self.waiting == 0 {
            return;
        }
        for index in 0..u32::try_from(self.slots.len()).unwrap_or(NONE) {
            let Some(slot) = self.slots.get_mut(index as usize) else { break };
            slot.starting = NONE;
            if core::mem::take(&mut slot.is_waiting) {
                self.release(index);
            }
        }
        self.waiting = 0;
    }

    /// Makes the chains that start in a row active, behind the others.
    #[inline]
    pub(super) fn start(&mut self, row: i32) {
        if row >= self.horizon {
            self.forget_waiting();
            self.look_ahead(row);
        }
        if self.waiting > 0 {
            self.start_waiting(row);
        }
    }

    fn start_waiting(&mut self, row: i32) {
        let list = self.list_of(row);
        let mut at = self.slots.get(list).map_or(NONE, |slot| slot.starting);
        while let Some(&top) = self.slots.get(at as usize) {
            let next = top.low.cast_unsigned();
            if top.high == row {
                self.unlink(at, row);
                self.start_chain(at, &top, 1, row);
                // What is dropped waits for a later row: it may be the next of the list.
                if let Some(other) = self.take_free().or_else(|| self.drop_latest(row)) {
                    self.start_chain(other, &top, -1, row);
                    at = self.slots.get(list).map_or(NONE, |slot| slot.starting);
                    continue;
                }
            }
            at = next;
        }
    }

    fn start_chain(&mut self, place: u32, top: &CoverageEdge, direction: i8, row: i32) {
        let Some(slot) = self.slots.get_mut(place as usize) else { return };
        slot.leave(top, direction);
        if !slot.begin(&self.source, row << FINE_BITS) {
            self.release(place);
            return;
        }
        if let Some(last) = self.slots.get_mut(self.active) {
            last.order = place;
            self.active += 1;
        }
    }

    /// The slot of a place, from left to right.
    #[inline(always)]
    pub(super) fn slot_of(&self, place: usize) -> usize {
        self.slots.get(place).map_or(0, |slot| slot.order as usize)
    }

    #[inline(always)]
    pub(super) fn chain(&mut self, place: usize) -> Option<&mut CoverageEdge> {
        let slot = self.slot_of(place);
        self.slots.get_mut(slot)
    }

    #[inline(always)]
    pub(super) fn chain_ref(&self, place: usize) -> Option<&CoverageEdge> {
        self.slots.get(self.slot_of(place))
    }

    /// Takes all chains over a row; whether they are in order from left to right, and their extents apart.
    #[inline]
    pub(super) fn advance(&mut self, row: i32) {
        let source = self.source;
        let mut last = i32::MIN;
        for place in 0..self.active {
            let Some(chain) = self.chain(place) else { break };
            chain.advance(&source, row << FINE_BITS);
            let low = chain.low;
            if low < last {
                self.sink(0, place, low);
            } else {
                last = low;
            }
        }
    }

    /// Moves a chain to the left, behind those that do not begin to the right of it.
    #[inline(never)]
    pub(super) fn sink(&mut self, first: usize, mut place: usize, low: i32) {
        let slot = self.slot_of(place);
        while place > first {
            let left = self.slot_of(place - 1);
            if self.slots.get(left).is_none_or(|chain| chain.low <= low) {
                break;
            }
            self.set_order(place, left);
            place -= 1;
        }
        self.set_order(place, slot);
    }

    #[inline(always)]
    pub(super) fn set_order(&mut self, place: usize, slot: usize) {
        if let Some(at) = self.slots.get_mut(place) {
            at.order = u32::try_from(slot).unwrap_or(NONE);
        }
    }

    /// Goes to the next row: chains that have ended leave.
    #[inline]
    pub(super) fn leave_row(&mut self) {
        let mut kept = 0;
        for place in 0..self.active {
            let slot = self.slot_of(place);
            let Some(chain) = self.slots.get_mut(slot) else { break };
            if chain.ends {
                self.release(u32::try_from(slot).unwrap_or(NONE));
                continue;
            }
            chain.leave_row();
            if kept != place {
                self.set_order(kept, slot);
            }
            kept += 1;
        }
        self.active = kept;
    }
}
