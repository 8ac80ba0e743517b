//! New vertices where edges cross, touch, or pass through the same vertex.

use super::rings::Rings;
use crate::methods::polygon::Plane;

/// How two edges meet.
enum Meeting {
    /// Inside both.
    Crossing,
    /// The second one's start lies inside the first.
    StartOfSecond,
    /// The first one's start lies inside the second.
    StartOfFirst,
    /// Both start there.
    Starts,
}

/// How the edges that start at two corners meet; none if they do not, or by an end, which is the start of another edge.
fn meeting<T: Plane>(rings: &Rings<'_, T>, first: usize, second: usize) -> Option<Meeting> {
    let (a, b) = (rings.at(first), rings.at(rings.next(first)));
    let (c, d) = (rings.at(second), rings.at(rings.next(second)));
    if a == c {
        return Some(Meeting::Starts);
    }
    let (c_side, d_side) = (T::turn(a, b, c), T::turn(a, b, d));
    let (a_side, b_side) = (T::turn(c, d, a), T::turn(c, d, b));
    if c_side == 0 && is_between(c, a, b) {
        return Some(Meeting::StartOfSecond);
    }
    if a_side == 0 && is_between(a, c, d) {
        return Some(Meeting::StartOfFirst);
    }
    (c_side * d_side < 0 && a_side * b_side < 0).then_some(Meeting::Crossing)
}

/// Whether a point of the line through a and b lies between them.
fn is_between<T: Plane>(point: [T; 2], a: [T; 2], b: [T; 2]) -> bool {
    let (p, a, b) = (T::wide(point), T::wide(a), T::wide(b));
    (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) < 0.0
}

/// How many slots more than vertices the meetings of edges ask for: their vertices, and two for each ring more.
pub(super) fn slots_for_meetings<T: Plane>(rings: &Rings<'_, T>) -> usize {
    let mut slots = 0;
    for first in 0..rings.len() {
        for second in first + 1..rings.len() {
            slots += match meeting(rings, first, second) {
                Some(Meeting::Crossing) => 4,
                Some(Meeting::StartOfFirst | Meeting::StartOfSecond) => 3,
                Some(Meeting::Starts) => 2,
                None => 0,
            };
        }
    }
    slots
}

/// Gives edges that meet a vertex there, and lets contours that cross change partners. What crosses only because new
/// vertices are rounded is seen to as long as there are slots.
pub(super) fn split_where_edges_meet<T: Plane>(rings: &mut Rings<'_, T>) {
    for _ in 0..ROUNDS {
        let before = rings.len();
        let mut first = 0;
        while first < rings.len() {
            let mut second = 0;
            while second < rings.len() {
                if second != first && rings.has_room_for(2) {
                    split(rings, first, second);
                }
                second += 1;
            }
            first += 1;
        }
        if rings.len() == before {
            break;
        }
    }
    // Where three or more ways cross in one place, a change may leave two others crossing.
    for _ in 0..ROUNDS {
        let mut changed = false;
        for first in 0..rings.len() {
            for second in first + 1..rings.len() {
                if rings.at(first) == rings.at(second) && cross_at(rings, first, second) {
                    rings.change_partners(first, second);
                    changed = true;
                }
            }
        }
        if !changed {
            break;
        }
    }
}

/// Rounding a vertex bends edges by half a unit: what that makes cross is rare, and what rounding its vertices makes
/// cross, rarer.
const ROUNDS: usize = 8;

fn split<T: Plane>(rings: &mut Rings<'_, T>, first: usize, second: usize) {
    match meeting(rings, first, second) {
        Some(Meeting::Crossing) => {
            let (a, b) = (rings.at(first), rings.at(rings.next(first)));
            let (c, d) = (rings.at(second), rings.at(rings.next(second)));
            let Some(x) = T::crossing(a, b, c, d) else { return };
            if [a, b, c, d].contains(&x) {
                return;
            }
            if let (Some(of_first), Some(of_second)) = (insert(rings, first, x), insert(rings, second, x)) {
                rings.change_partners(of_first, of_second);
            }
        }
        Some(Meeting::StartOfSecond) => {
            insert(rings, first, rings.at(second));
        }
        Some(Meeting::StartOfFirst) => {
            insert(rings, second, rings.at(first));
        }
        Some(Meeting::Starts) | None => {}
    }
}

/// A new corner after another.
fn insert<T: Plane>(rings: &mut Rings<'_, T>, after: usize, at: [T; 2]) -> Option<usize> {
    let next = rings.next(after);
    let corner = rings.add(at)?;
    rings.link(after, corner);
    rings.link(corner, next);
    Some(corner)
}

/// Whether the ways through two corners at the same place cross: the second comes from one side of the first and
/// leaves to the other. Ways that have an edge in common do not.
fn cross_at<T: Plane>(rings: &Rings<'_, T>, first: usize, second: usize) -> bool {
    let ends = |corner| [rings.at(rings.previous(corner)), rings.at(rings.next(corner))];
    let at = rings.at(first);
    let has_same_direction = |a, b| T::turn(at, a, b) == 0 && !is_between(at, a, b);
    let [from, to] = ends(second);
    if ends(first).into_iter().any(|end| has_same_direction(end, from) || has_same_direction(end, to)) {
        return false;
    }
    rings.is_right_of(first, from) != rings.is_right_of(first, to)
}
