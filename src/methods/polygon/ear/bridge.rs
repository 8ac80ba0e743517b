//! Holes joined to outlines by a cut there and back: one ring is left of a piece.

use super::rings::{Rings, Role};
use crate::methods::polygon::Plane;

/// From the rightmost hole to the leftmost: what is to the right of a hole's rightmost corner is the outline by then,
/// and a corner of it can be seen from there (Eberly 2002). A hole that sees none, because rounding has moved it, is
/// lost.
pub(super) fn join_holes<T: Plane>(rings: &mut Rings<'_, T>) {
    while let Some((hole, outline)) = rightmost_hole(rings) {
        let start = rightmost_corner(rings, hole);
        if let Some(end) = nearest_seen(rings, start, hole, outline) {
            join(rings, start, end);
        }
        rings.set_role(hole, Role::Nothing);
    }
}

fn x<T: Plane>(rings: &Rings<'_, T>, corner: usize) -> f64 {
    let [x, _] = T::wide(rings.at(corner));
    x
}

fn rightmost_corner<T: Plane>(rings: &Rings<'_, T>, ring: usize) -> usize {
    rings.around(ring).max_by(|a, b| x(rings, *a).total_cmp(&x(rings, *b))).unwrap_or(ring)
}

fn rightmost_hole<T: Plane>(rings: &Rings<'_, T>) -> Option<(usize, usize)> {
    let holes = rings.rings().filter_map(|ring| match rings.role(ring) {
        Role::HoleIn(outline) => Some((ring, outline)),
        _ => None,
    });
    let reach = |hole| x(rings, rightmost_corner(rings, hole));
    holes.max_by(|(a, _), (b, _)| reach(*a).total_cmp(&reach(*b)))
}

/// The outline's nearest corner that is seen from the hole's.
fn nearest_seen<T: Plane>(rings: &Rings<'_, T>, start: usize, hole: usize, outline: usize) -> Option<usize> {
    let distance = |corner| {
        let (a, b) = (T::wide(rings.at(start)), T::wide(rings.at(corner)));
        (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])
    };
    let mut nearest = None;
    for corner in rings.around(outline) {
        let distance = distance(corner);
        if nearest.is_none_or(|(_, least)| distance < least) && is_seen(rings, start, corner, hole, outline) {
            nearest = Some((corner, distance));
        }
    }
    nearest.map(|(corner, _)| corner)
}

fn is_seen<T: Plane>(rings: &Rings<'_, T>, start: usize, end: usize, hole: usize, outline: usize) -> bool {
    let (a, b) = (rings.at(start), rings.at(end));
    if a != b && !(rings.is_right_of(start, b) && rings.is_right_of(end, a)) {
        return false;
    }
    let bars = |corner: usize| {
        let (c, d) = (rings.at(corner), rings.at(rings.next(corner)));
        T::turn(a, b, c) * T::turn(a, b, d) < 0 && T::turn(c, d, a) * T::turn(c, d, b) < 0
    };
    let of_this_piece = |ring: &usize| rings.role(*ring) == Role::HoleIn(outline) || *ring == outline || *ring == hole;
    !rings.rings().filter(of_this_piece).any(|ring| rings.around(ring).any(bars))
}

/// `end -> start -> ... hole ... -> a second start -> a second end -> ...`
fn join<T: Plane>(rings: &mut Rings<'_, T>, start: usize, end: usize) {
    if !rings.has_room_for(2) {
        return;
    }
    let (before_start, after_end) = (rings.previous(start), rings.next(end));
    let (Some(second_start), Some(second_end)) = (rings.add(rings.at(start)), rings.add(rings.at(end))) else { return };
    if before_start == start {
        rings.link(start, second_start);
    } else {
        rings.link(before_start, second_start);
    }
    rings.link(second_start, second_end);
    rings.link(second_end, after_end);
    rings.link(end, start);
    // They belong to a ring that has its name already.
    rings.join_ring(second_start, end);
    rings.join_ring(second_end, end);
}
