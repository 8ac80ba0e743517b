//! Which ring lies in which, and what that makes of it.

use super::rings::{Rings, Role};
use crate::{FillRule, methods::polygon::Plane};

/// Rings that go nowhere across each other lie within or beside each other: the winding number around a ring is the sum of
/// the directions of those that it lies in.
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
    let mut from = 0;
    while let Some(ring) = rings.ring_from(from) {
        from = ring + 1;
        let own = direction(rings, ring);
        let around: i32 = rings
            .rings()
            .filter(|other| *other != ring && lies_in(rings, ring, *other))
            .map(|other| direction(rings, other))
            .sum();
        let (outside, inside) = (is_filled(around), is_filled(around + own));
        let role = match (outside, inside) {
            (false, true) => Role::Outline,
            // The outline is looked for below, when all of them are known.
            (true, false) => Role::HoleIn(ring),
            _ => Role::Nothing,
        };
        rings.set_role(ring, role);
    }
    let mut from = 0;
    while let Some(hole) = rings.ring_from(from) {
        from = hole + 1;
        if rings.role(hole) == Role::HoleIn(hole) {
            let outlines =
                rings.rings().filter(|ring| rings.role(*ring) == Role::Outline && lies_in(rings, hole, *ring));
            let innermost = outlines.min_by(|a, b| area(rings, *a).abs().total_cmp(&area(rings, *b).abs()));
            rings.set_role(hole, innermost.map_or(Role::Nothing, Role::HoleIn));
        }
    }
    let mut from = 0;
    while let Some(ring) = rings.ring_from(from) {
        from = ring + 1;
        let is_backwards = match rings.role(ring) {
            Role::Outline => direction(rings, ring) < 0,
            Role::HoleIn(_) => direction(rings, ring) > 0,
            Role::Nothing => false,
        };
        if is_backwards {
            rings.reverse(ring);
        }
    }
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
