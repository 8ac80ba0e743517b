//! The active edge table: the edges that cross the current row, from left to right, in scratch that the caller owns.

use core::ops::Range;

use crate::{
    contours::Contours,
    edge::Edge,
    shape::polygon::{
        active::{ActiveEdge, Track, contour_of, remade},
        waiting::{Top, move_up, sift_down, sift_up},
    },
};

/// The table over the caller's slots.
///
/// ```text
///   | active, by column | free | waiting, by row |
/// ```
///
/// An edge that ends is replaced in its slot by the one that follows it along the contour, so the table is only ever
/// searched for the tops, where a contour turns down and two edges begin. Finding them takes a pass over the vertices;
/// the slots that are free at that time remember the next ones. Scratch for exactly the active edges is enough, more
/// saves passes, and with two slots a top there is just one.
#[derive(Debug)]
pub(crate) struct Table<'a, 's, T> {
    contours: Contours<'a>,
    rows: &'s Range<i32>,
    slots: &'s mut [ActiveEdge<T>],
    active: usize,
    waiting: usize,
    /// Every top above this row has started or waits. On this row the tops are looked up again.
    horizon: i32,
    is_sorted: bool,
}

impl<'a, 's, T: Track> Table<'a, 's, T> {
    #[inline]
    pub(crate) fn new(contours: Contours<'a>, rows: &'s Range<i32>, slots: &'s mut [ActiveEdge<T>]) -> Self {
        let waiting = slots.len();
        Self { contours, rows, slots, active: 0, waiting, horizon: rows.start, is_sorted: true }
    }

    /// Adds the edges that start on `row`.
    #[inline]
    pub(crate) fn start(&mut self, row: i32) {
        if row >= self.horizon {
            self.look_ahead(row);
        }
        if self.slots.get(self.waiting).is_some_and(|top| top.until == row) {
            self.start_waiting(row);
        }
    }

    /// The next row on which an edge may start.
    #[inline]
    pub(crate) fn next_start(&self) -> i32 {
        self.slots.get(self.waiting).map_or(self.horizon, |top| top.until)
    }

    #[inline]
    pub(crate) fn contours(&self) -> Contours<'a> {
        self.contours
    }

    #[inline]
    pub(crate) fn active_mut(&mut self) -> &mut [ActiveEdge<T>] {
        self.slots.get_mut(..self.active).unwrap_or_default()
    }

    #[inline]
    pub(crate) fn is_idle(&self) -> bool {
        self.active == 0
    }

    /// Brings the edges into the order of their columns again.
    #[inline(always)]
    pub(crate) fn sort(&mut self) {
        if !self.is_sorted {
            self.sort_active();
        }
    }

    #[inline(never)]
    pub(crate) fn sort_active(&mut self) {
        sort(self.slots.get_mut(..self.active).unwrap_or_default());
    }

    /// On `row`, replaces the edges that end by those that follow them along their contour.
    #[inline(never)]
    pub(crate) fn turn(&mut self, row: i32) {
        let Some(active) = self.slots.get_mut(..self.active) else { return };
        let mut kept = 0;
        for index in 0..active.len() {
            let Some(edge) = active.get_mut(index) else { break };
            if edge.until == row {
                let (vertex, contour) = (edge.vertex, edge.contour);
                if !edge.set_below(self.contours, vertex, contour, row, self.rows) {
                    continue;
                }
            } else if !edge.edge.can_step() {
                edge.edge = remade(contour_of(self.contours, edge.contour), edge.vertex, edge.contour >= 0, row);
            }
            if kept != index {
                let edge = *edge;
                if let Some(slot) = active.get_mut(kept) {
                    *slot = edge;
                }
            }
            kept += 1;
        }
        self.active = kept;
        self.sort_active();
    }

    /// The next row, at most `limit`, on which an edge starts or ends, or which some edge cannot be stepped to.
    #[inline]
    pub(crate) fn next_event(&self, row: i32, limit: i32) -> i32 {
        let active = self.slots.get(..self.active).unwrap_or_default();
        let mut event = self.next_start().min(limit);
        for edge in active {
            event = event.min(if edge.edge.can_step() { edge.until } else { row });
        }
        event.max(row)
    }

    #[inline(never)]
    fn start_waiting(&mut self, row: i32) {
        let tops = self.slots.get(self.waiting..).unwrap_or_default();
        let group = tops.iter().take_while(|top| top.until == row).count();
        // A top's slot and one more become its two edges. The last tops make room, and are looked up again when their row
        // comes.
        let lacking = (self.active + group).saturating_sub(self.waiting);
        if lacking > 0 {
            let kept = tops.len().saturating_sub(lacking);
            self.horizon = tops.get(kept).map_or(row, |first| first.until);
            let end = self.slots.len();
            move_up(self.slots, self.waiting, kept, end);
            self.waiting = end - kept;
        }
        for _ in 0..group {
            let Some(top) = self.slots.get(self.waiting).map(ActiveEdge::top) else { return };
            self.waiting += 1;
            for contour in [top.contour, !top.contour] {
                if let Some(slot) = self.slots.get_mut(self.active)
                    && slot.set_below(self.contours, top.vertex, contour, row, self.rows)
                {
                    sink_left(self.slots, self.active);
                    self.active += 1;
                }
            }
        }
    }

    /// Fills the free slots with the tops from `row` on, as many as fit.
    #[inline(never)]
    fn look_ahead(&mut self, row: i32) {
        let Some(free) = self.slots.get_mut(self.active..) else { return };
        let capacity = free.len();
        let mut queued = 0;
        let mut horizon = i32::MAX;
        // A heap of the earliest tops so far, the latest of them at the root.
        self.contours.for_each_top(T::ROWS, self.rows, |contour, vertex, start| {
            let top = Top { row: start, vertex, contour };
            if start < row {
            } else if queued < capacity {
                queued += 1;
                sift_up(free, queued - 1, top);
            } else if let Some(latest) = free.first().map(|latest| latest.until).filter(|&latest| start < latest) {
                horizon = horizon.min(latest);
                sift_down(free, top);
            } else {
                horizon = horizon.min(start);
            }
        });
        for end in (1..queued).rev() {
            if let Some([latest, .., last]) = free.get_mut(..=end) {
                let top = last.top();
                last.wait_for(latest.top());
                sift_down(free.get_mut(..end).unwrap_or_default(), top);
            }
        }
        move_up(free, 0, queued, capacity);
        self.waiting = self.slots.len() - queued;
        self.horizon = horizon;
    }
}

impl Table<'_, '_, Edge> {
    /// Hands over each active edge's column and winding, from left to right, and takes it one row down.
    ///
    /// On the row of the next event they must [`turn`](Self::turn) then, on the others be [`sorted`](Self::sort).
    #[inline(always)]
    pub(crate) fn cross_and_step<E>(&mut self, mut crossing: impl FnMut(i32, i32) -> Result<(), E>) -> Result<(), E> {
        let mut previous = i32::MIN;
        let mut is_sorted = true;
        for edge in self.slots.get_mut(..self.active).unwrap_or_default() {
            crossing(edge.edge.column, edge.winding())?;
            edge.edge.step();
            // Hardly ever true, so a jump is cheaper than keeping the answer.
            if edge.edge.column < previous {
                is_sorted = false;
            }
            previous = edge.edge.column;
        }
        self.is_sorted = is_sorted;
        Ok(())
    }
}

/// Sorts edges that are nearly in order from left to right.
#[inline(never)]
pub(in crate::shape) fn sort<T: Track>(edges: &mut [ActiveEdge<T>]) {
    (1..edges.len()).for_each(|place| sink_left(edges, place));
}

/// Moves the edge at `place` to the left until the slots up to there are sorted by column, as those before it were.
#[inline]
fn sink_left<T: Track>(slots: &mut [ActiveEdge<T>], mut place: usize) {
    let edge = match slots.get(..=place) {
        Some([.., left, edge]) if left.edge.is_right_of(&edge.edge) => *edge,
        _ => return,
    };
    while let Some([.., left, slot]) = slots.get_mut(..=place) {
        if !left.edge.is_right_of(&edge.edge) {
            break;
        }
        *slot = *left;
        place -= 1;
    }
    if let Some(slot) = slots.get_mut(place) {
        *slot = edge;
    }
}
