//! Tops that wait in free slots: a heap of the earliest ones while they are found, sorted afterwards.

use crate::shape::polygon::active::{ActiveEdge, Track};

/// Where a contour turns down: two edges start on `row`.
#[derive(Debug, Clone, Copy)]
pub(in crate::shape) struct Top {
    pub(in crate::shape) row: i32,
    pub(in crate::shape) vertex: u32,
    pub(in crate::shape) contour: i32,
}

#[inline(always)]
fn set_top<T: Track>(slots: &mut [ActiveEdge<T>], index: usize, top: Top) {
    if let Some(slot) = slots.get_mut(index) {
        slot.wait_for(top);
    }
}

/// Moves `count` tops from `start` so that they end at `end`, which is not before where they are.
#[inline]
pub(in crate::shape) fn move_up<T: Track>(slots: &mut [ActiveEdge<T>], start: usize, count: usize, end: usize) {
    for offset in (0..count).rev() {
        if let Some(top) = slots.get(start + offset).map(ActiveEdge::top) {
            set_top(slots, end - count + offset, top);
        }
    }
}

/// Adds `top` to the heap, whose latest top is at the root, at its end.
#[inline]
pub(in crate::shape) fn sift_up<T: Track>(heap: &mut [ActiveEdge<T>], mut place: usize, top: Top) {
    while place > 0 {
        let parent = (place - 1) / 2;
        match heap.get(parent).map(ActiveEdge::top) {
            Some(above) if above.row < top.row => set_top(heap, place, above),
            _ => break,
        }
        place = parent;
    }
    set_top(heap, place, top);
}

/// Puts `top` in the place of the root.
#[inline]
pub(in crate::shape) fn sift_down<T: Track>(heap: &mut [ActiveEdge<T>], top: Top) {
    let mut place = 0;
    loop {
        let (left, right) = (2 * place + 1, 2 * place + 2);
        let row = |index: usize| heap.get(index).map_or(i32::MIN, |top| top.until);
        let child = if row(right) > row(left) { right } else { left };
        match heap.get(child).map(ActiveEdge::top) {
            Some(below) if below.row > top.row => set_top(heap, place, below),
            _ => break,
        }
        place = child;
    }
    set_top(heap, place, top);
}
