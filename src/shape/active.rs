//! The active edge table: the edges that cross the current row, from left to right, in scratch that the caller owns.

use core::ops::Range;

use crate::{
    edge::Edge,
    shape::outline::{Contours, Way, edge_below},
};

/// Scratch for one active edge of a polygon; see [`Polygon`](crate::Polygon).
#[derive(Debug, Clone, Copy)]
pub struct ActiveEdge {
    edge: Edge,
    /// The row it ends on; of a top that waits, the row it starts on.
    until: i32,
    /// 1 where the contour goes down, -1 where it goes up.
    winding: i32,
    contour: usize,
    /// The vertex it ends at; of a top that waits, the one it starts at.
    vertex: usize,
}

impl ActiveEdge {
    /// Unused scratch.
    pub const EMPTY: Self = Self { edge: Edge::EMPTY, until: 0, winding: 0, contour: 0, vertex: 0 };

    /// The edge that leaves `vertex` one way, if it goes down; `row` is the vertex's.
    #[inline]
    fn below(
        contours: Contours<'_>,
        (contour, vertex): (usize, usize),
        way: Way,
        row: i32,
        rows: &Range<i32>,
    ) -> Option<Self> {
        let (upper, lower, vertex, until) = edge_below(contours.contour(contour), vertex, way, rows)?;
        let winding = if way == Way::Forward { 1 } else { -1 };
        Some(Self { edge: Edge::on_row(upper, lower, row), until, winding, contour, vertex })
    }

    #[inline]
    fn way(&self) -> Way {
        if self.winding > 0 { Way::Forward } else { Way::Backward }
    }

    /// Down to `row`, along the contour where the edge ends; `false` where the contour turns up.
    #[inline(always)]
    fn step(&mut self, contours: Contours<'_>, row: i32, rows: &Range<i32>) -> bool {
        if self.until != row {
            self.edge.step_or(|| remade(contours.contour(self.contour), self.vertex, self.winding > 0, row));
            return true;
        }
        let Some(next) = Self::below(contours, (self.contour, self.vertex), self.way(), row, rows) else {
            return false;
        };
        *self = next;
        true
    }
}

/// An edge too tall to be stepped, for another row.
#[inline(never)]
fn remade(contour: &[crate::Vertex], lower: usize, is_forward: bool, row: i32) -> Edge {
    let upper = if is_forward { lower.checked_sub(1) } else { Some(lower + 1).filter(|&next| next < contour.len()) };
    let upper = upper.unwrap_or(if is_forward { contour.len().saturating_sub(1) } else { 0 });
    match (contour.get(upper), contour.get(lower)) {
        (Some(&upper), Some(&lower)) => Edge::on_row(upper, lower, row),
        _ => Edge::EMPTY,
    }
}

/// Owns scratch for `N` active edges; [`as_mut_slice`](Self::as_mut_slice) lends it.
#[derive(Debug, Clone)]
pub struct ActiveEdges<const N: usize>(heapless::Vec<ActiveEdge, N>);

impl<const N: usize> ActiveEdges<N> {
    /// Scratch for `N` active edges.
    #[inline]
    pub fn new() -> Self {
        let mut edges = heapless::Vec::new();
        edges.resize_default(N).unwrap_or_default();
        Self(edges)
    }

    /// All of it.
    #[inline]
    pub fn as_mut_slice(&mut self) -> &mut [ActiveEdge] {
        self.0.as_mut_slice()
    }
}

impl<const N: usize> Default for ActiveEdges<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for ActiveEdge {
    fn default() -> Self {
        Self::EMPTY
    }
}

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
pub(crate) struct Table<'a, 's> {
    contours: Contours<'a>,
    rows: &'s Range<i32>,
    slots: &'s mut [ActiveEdge],
    active: usize,
    waiting: usize,
    /// Every top above this row has started or waits; none at or below it does.
    horizon: i32,
}

impl<'a, 's> Table<'a, 's> {
    #[inline]
    pub(crate) fn new(contours: Contours<'a>, rows: &'s Range<i32>, slots: &'s mut [ActiveEdge]) -> Self {
        let waiting = slots.len();
        Self { contours, rows, slots, active: 0, waiting, horizon: rows.start }
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
    pub(crate) fn is_idle(&self) -> bool {
        self.active == 0
    }

    /// Hands over each active edge's column and winding from left to right, and takes it one row down, to `below`.
    #[inline(always)]
    pub(crate) fn cross<E>(
        &mut self,
        below: i32,
        mut crossing: impl FnMut(i32, i32) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(active) = self.slots.get_mut(..self.active) else { return Ok(()) };
        let mut kept = 0;
        let mut previous = i32::MIN;
        for index in 0..active.len() {
            let Some(edge) = active.get_mut(index) else { break };
            crossing(edge.edge.column, edge.winding)?;
            if !edge.step(self.contours, below, self.rows) {
                continue;
            }
            let column = edge.edge.column;
            if kept != index || column < previous {
                let edge = *edge;
                insert(active, kept, edge);
            }
            previous = previous.max(column);
            kept += 1;
        }
        self.active = kept;
        Ok(())
    }

    #[inline(never)]
    fn start_waiting(&mut self, row: i32) {
        let tops = self.slots.get(self.waiting..).unwrap_or_default();
        let group = tops.iter().take_while(|top| top.until == row).count();
        if self.active + group > self.waiting {
            // The later tops make room, and are looked up again when their row comes.
            if let Some(later) = tops.get(group) {
                self.horizon = later.until;
            }
            let end = self.slots.len();
            move_up(self.slots, self.waiting, group, end);
            self.waiting = end - group;
        }
        for _ in 0..group {
            let Some(&top) = self.slots.get(self.waiting) else { return };
            self.waiting += 1;
            for way in [Way::Forward, Way::Backward] {
                let start = (top.contour, top.vertex);
                if let Some(edge) = ActiveEdge::below(self.contours, start, way, row, self.rows) {
                    insert(self.slots, self.active, edge);
                    self.active += 1;
                }
            }
        }
    }

    /// Fills the free slots with the tops from `row` on, as many whole rows of them as fit.
    #[inline(never)]
    fn look_ahead(&mut self, row: i32) {
        let Some(free) = self.slots.get_mut(self.active..) else { return };
        let capacity = free.len();
        let mut queued = 0;
        let mut horizon = i32::MAX;
        // A heap of the earliest tops so far, the latest of them at the root.
        self.contours.for_each_top(self.rows, |contour, vertex, start| {
            let top = ActiveEdge { until: start, contour, vertex, ..ActiveEdge::EMPTY };
            if start < row {
            } else if queued < capacity {
                queued += 1;
                sift_up(free, queued - 1, top);
            } else if let Some(latest) = free.first().map(|latest| latest.until).filter(|&latest| start < latest) {
                horizon = horizon.min(latest);
                sift_down(free, queued, top);
            } else {
                horizon = horizon.min(start);
            }
        });
        for end in (1..queued).rev() {
            if let (Some(&latest), Some(&last)) = (free.first(), free.get(end)) {
                sift_down(free, end, last);
                set(free, end, latest);
            }
        }
        while free.get(queued.wrapping_sub(1)).is_some_and(|top| top.until >= horizon) {
            queued -= 1;
        }
        move_up(free, 0, queued, capacity);
        self.waiting = self.slots.len() - queued;
        self.horizon = horizon;
    }
}

#[inline(always)]
fn set(slots: &mut [ActiveEdge], index: usize, edge: ActiveEdge) {
    if let Some(slot) = slots.get_mut(index) {
        *slot = edge;
    }
}

/// Puts `edge` among the first `len` slots, which are sorted by column, and the one behind them.
#[inline]
fn insert(slots: &mut [ActiveEdge], len: usize, edge: ActiveEdge) {
    let mut place = len;
    while place > 0 {
        match slots.get(place - 1) {
            Some(&left) if left.edge.column > edge.edge.column => set(slots, place, left),
            _ => break,
        }
        place -= 1;
    }
    set(slots, place, edge);
}

/// Moves `count` slots from `start` so that they end at `end`, which is not before where they are.
#[inline]
fn move_up(slots: &mut [ActiveEdge], start: usize, count: usize, end: usize) {
    for offset in (0..count).rev() {
        if let Some(&top) = slots.get(start + offset) {
            set(slots, end - count + offset, top);
        }
    }
}

#[inline]
fn sift_up(heap: &mut [ActiveEdge], mut place: usize, top: ActiveEdge) {
    while place > 0 {
        let parent = (place - 1) / 2;
        match heap.get(parent) {
            Some(&above) if above.until < top.until => set(heap, place, above),
            _ => break,
        }
        place = parent;
    }
    set(heap, place, top);
}

/// Puts `top` in the place of the root of the first `len` slots.
#[inline]
fn sift_down(heap: &mut [ActiveEdge], len: usize, top: ActiveEdge) {
    let Some(heap) = heap.get_mut(..len) else { return };
    let mut place = 0;
    loop {
        let (left, right) = (2 * place + 1, 2 * place + 2);
        let until = |index: usize| heap.get(index).map_or(i32::MIN, |top| top.until);
        let child = if until(right) > until(left) { right } else { left };
        match heap.get(child) {
            Some(&below) if below.until > top.until => set(heap, place, below),
            _ => break,
        }
        place = child;
    }
    set(heap, place, top);
}
