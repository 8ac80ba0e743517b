//! Which ring lies in which, and what that makes of it.

use super::rings::{Rings, Role};
use crate::{methods::polygon::Plane, shape::FillRule};

/// Rings that go nowhere across each other lie within or beside each other: the winding number around a ring is the
/// sum of the directions of those that it lies in.
///
/// ```text
///     outside | inside         outlines then go clockwise, holes the other way round:
///     empty   | filled    outline        what is filled lies to the right of both
///     filled  | empty     hole
///     same    | same      nothing
/// ```
pub(super) fn find_roles<T: Plane>(rings: &mut Rings<'_, T>, rule: FillRule) {
    rings.name_rings();
    let is_filled = |winding: i32| match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding & 1 != 0,
    };
    for_each_ring(rings, |rings, ring| {
        let others = rings.rings().filter(|other| *other != ring && lies_in(rings, ring, *other));
        let around: i32 = others.map(|other| direction(rings, other)).sum();
        let role = match (is_filled(around), is_filled(around + direction(rings, ring))) {
            (false, true) => Role::Outline,
            (true, false) => Role::HoleIn(ring),
            _ => Role::Nothing,
        };
        rings.set_role(ring, role);
    });
    for_each_ring(rings, |rings, ring| match (rings.role(ring), direction(rings, ring)) {
        (Role::Nothing, _) => rings.remove(ring),
        (Role::Outline, ..0) | (Role::HoleIn(_), 1..) => rings.reverse(ring),
        _ => {}
    });
    part_where_rings_touch(rings);
    rings.name_rings();
    for_each_ring(rings, |rings, ring| {
        let role = if direction(rings, ring) > 0 { Role::Outline } else { Role::HoleIn(ring) };
        rings.set_role(ring, role);
    });
    for_each_ring(rings, |rings, hole| {
        if rings.role(hole) == Role::HoleIn(hole) {
            let is_around = |ring: &usize| rings.role(*ring) == Role::Outline && lies_in(rings, hole, *ring);
            let by_area = |a: &usize, b: &usize| area(rings, *a).abs().total_cmp(&area(rings, *b).abs());
            let innermost = rings.rings().filter(is_around).min_by(by_area);
            rings.set_role(hole, innermost.map_or(Role::Nothing, Role::HoleIn));
        }
    });
}

fn for_each_ring<T: Plane>(rings: &mut Rings<'_, T>, mut work: impl FnMut(&mut Rings<'_, T>, usize)) {
    let mut from = 0;
    while let Some(ring) = rings.ring_from(from) {
        from = ring + 1;
        work(rings, ring);
    }
}

/// Where two ways pass through one place, what is filled to the right of one must not hold the other: else they
/// change partners.
///
/// ```text
///      \ /            \ /       A hole (.) that touches the outline in a corner becomes a
///    ###x###   ->   ###x###     notch of it; one that touches it twice parts the piece.
///    ##/.\##        ##/.\##
/// ```
fn part_where_rings_touch<T: Plane>(rings: &mut Rings<'_, T>) {
    // Each change leaves more rings or fewer holes: there are not more changes in a row than corners.
    for _ in 0..rings.len() {
        let mut changed = false;
        for first in 0..rings.len() {
            for second in first + 1..rings.len() {
                if rings.at(first) == rings.at(second)
                    && rings.role(first) != Role::Nothing
                    && rings.role(second) != Role::Nothing
                    && holds_way(rings, first, second)
                    && holds_way(rings, second, first)
                {
                    rings.change_partners(first, second);
                    changed = true;
                }
            }
        }
        if !changed {
            return;
        }
    }
}

/// Whether what is to the right of the way through one corner holds the way through another.
fn holds_way<T: Plane>(rings: &Rings<'_, T>, corner: usize, other: usize) -> bool {
    let ends = [rings.previous(other), rings.next(other)];
    ends.into_iter().any(|end| rings.is_right_of(corner, rings.at(end)))
}

/// 1 for clockwise, -1 for counter-clockwise, 0 for a ring without area.
fn direction<T: Plane>(rings: &Rings<'_, T>, ring: usize) -> i32 {
    let area = area(rings, ring);
    i32::from(area > 0.0) - i32::from(area < 0.0)
}

/// Eight times the area to the right.
fn area<T: Plane>(rings: &Rings<'_, T>, ring: usize) -> f64 {
    let first = T::wide(rings.at(ring));
    let from_first = |corner| {
        let at = T::wide(rings.at(corner));
        [at[0] - first[0], at[1] - first[1]]
    };
    let triangle = |corner| {
        let (a, b) = (from_first(corner), from_first(rings.next(corner)));
        a[0] * b[1] - a[1] * b[0]
    };
    rings.around(ring).map(triangle).sum()
}

/// Whether a ring lies in another, by the first middle of an edge that is not on the other.
fn lies_in<T: Plane>(rings: &Rings<'_, T>, ring: usize, other: usize) -> bool {
    let middle = |corner| T::middle(rings.at(corner), rings.at(rings.next(corner)));
    rings.around(ring).find_map(|corner| holds(rings, other, middle(corner))).unwrap_or(false)
}

/// Whether a ring goes around a point, in doubled coordinates; none if it goes through.
fn holds<T: Plane>(rings: &Rings<'_, T>, ring: usize, point: [f64; 2]) -> Option<bool> {
    let mut is_inside = false;
    for corner in rings.around(ring) {
        let (a, b) = (T::wide(rings.at(corner)), T::wide(rings.at(rings.next(corner))));
        let side = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
        let level = |v: [f64; 2]| v[1] <= point[1];
        if side == 0.0 && (point[0] - a[0]) * (point[0] - b[0]) + (point[1] - a[1]) * (point[1] - b[1]) <= 0.0 {
            return None;
        }
        if level(a) != level(b) && (side < 0.0) == (a[1] < b[1]) {
            is_inside = !is_inside;
        }
    }
    Some(is_inside)
}
