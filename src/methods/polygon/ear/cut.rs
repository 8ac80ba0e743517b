//! Ears cut off and filled.

use super::rings::{Rings, Role};
use crate::{fragment::FragmentSink, geometry::PixelRect, methods::polygon::Plane};

/// Cuts every piece into triangles.
///
/// # Errors
///
/// The sink's.
pub(super) fn cut_ears<T: Plane, S: FragmentSink>(
    rings: &mut Rings<'_, T>,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut from = 0;
    while let Some(ring) = rings.ring_from(from) {
        from = ring + 1;
        if rings.role(ring) == Role::Outline {
            cut_piece(rings, ring, clip, sink)?;
        }
    }
    Ok(())
}

/// Around the piece until three corners are left. A round without an ear is one that rounding has made cross itself:
/// then a corner is cut off whatever it holds, so that there is an end.
fn cut_piece<T: Plane, S: FragmentSink>(
    rings: &mut Rings<'_, T>,
    first: usize,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut left = rings.around(first).count();
    let (mut corner, mut passed) = (first, 0);
    while left >= 3 {
        let (before, after) = (rings.previous(corner), rings.next(corner));
        let triangle = [before, corner, after].map(|corner| rings.at(corner));
        let [a, b, c] = triangle;
        let turn = T::turn(a, b, c);
        let is_flat = turn == 0;
        if is_flat || turn > 0 && (passed >= left || is_ear(rings, before, corner, after)) || passed >= 2 * left {
            if turn > 0 {
                T::fill(triangle, clip, sink)?;
            }
            rings.link(before, after);
            left -= 1;
            passed = 0;
            // Not the next: its turn comes when all others had theirs, which keeps slivers from piling up.
            corner = if is_flat { before } else { rings.next(after) };
        } else {
            corner = after;
            passed += 1;
        }
    }
    Ok(())
}

/// Whether the triangle of a corner that turns right holds nothing else of its ring.
fn is_ear<T: Plane>(rings: &Rings<'_, T>, before: usize, corner: usize, after: usize) -> bool {
    let [a, b, c] = [before, corner, after].map(|corner| rings.at(corner));
    let mut other = rings.next(after);
    while other != before {
        let point = rings.at(other);
        if point == b {
            // The ring passes through the same place again: not into the ear.
            let into = |next: usize| {
                let point = rings.at(next);
                T::turn(a, b, point) > 0 && T::turn(b, c, point) > 0
            };
            if into(rings.next(other)) || into(rings.previous(other)) {
                return false;
            }
        } else if point != a
            && point != c
            && T::turn(a, b, point) >= 0
            && T::turn(b, c, point) >= 0
            && T::turn(c, a, point) >= 0
        {
            return false;
        }
        other = rings.next(other);
    }
    true
}
