//! Outlines of rings and pies cut by a wedge, for blending.

use embedded_graphics::geometry::Angle;

use super::{
    normal::{Vector, add, along, cross, left, meet, unit},
    outline::{ALONE, Chords, Outline, push_arc, radius, vertex, within},
    pixel_box::PixelBox,
    wedge::{Sweep, Wedge},
};

/// The middle of a box in 1/256 pixel.
pub(super) fn center(pixels: &PixelBox) -> Vector {
    let (x, y) = pixels.center_2x();
    (128 * (x + 1), 128 * (y + 1))
}

/// As many chords as leave room for `arcs` arcs of such a sweep and `spare` other vertices among `room`.
fn chords(radius: i64, sweep: Angle, room: usize, arcs: usize) -> Chords {
    const SPARE: usize = 6;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped; how fine, not where")]
    let degrees = sweep.to_degrees().abs().clamp(1.0, 360.0) as usize + 1;
    Chords::new(radius, (room.saturating_sub(arcs * SPARE) * 360 / (arcs * degrees).max(1)).min(1024))
}

/// The first point of the chords at a direction or clockwise after it.
fn first_after(chords: Chords, (x, y): Vector) -> i32 {
    let eighth = match (x > 0, y > 0) {
        _ if y >= 0 && x > 0 => i32::from(y >= x),
        (false, true) => 2 + i32::from(-x >= y),
        _ if x < 0 => 4 + i32::from(-y >= -x),
        _ => 6 + i32::from(x >= -y),
    };
    let start = eighth * (chords.count() / 8);
    let end = start + chords.count() / 8;
    (start..end).find(|&point| cross((x, y), chords.unit(point)) >= 0).unwrap_or(end)
}

/// The points between two directions, clockwise; those of a whole turn or none when there is none between.
fn between(chords: Chords, start: Vector, end: Vector, sweep: Sweep) -> core::ops::Range<i32> {
    let first = first_after(chords, start);
    let count = (first_after(chords, end) - first).rem_euclid(chords.count().max(1));
    let count = if count == 0 && sweep != Sweep::Narrow { chords.count() } else { count };
    first..first + count
}

/// Adds the outline of what is between two circles and in a wedge.
#[inline(never)]
pub(super) fn push_ring(outline: &mut Outline, outer: &PixelBox, inner: &PixelBox, wedge: &Wedge, sweep: Angle) {
    let (Some(start), Some(end)) = (unit(wedge.start), unit(wedge.end)) else { return };
    let (middle, far, near) = (center(outer), radius(outer.width), radius(inner.width));
    let chords = chords(far, sweep, ALONE, 2);
    let points = between(chords, start, end, wedge.sweep);
    let push = |outline: &mut Outline, place: Vector| {
        let (x, y) = add(middle, place);
        // There is room: `chords` has seen to it.
        outline.push(vertex(x, y)).unwrap_or_default();
    };
    push(outline, along(start, far));
    push_arc(outline, middle, (far, far), chords, points.clone());
    push(outline, along(end, far));
    push(outline, along(end, near));
    if near > 0 {
        push_arc(outline, middle, (near, near), chords, points.rev());
        push(outline, along(start, near));
    }
}

/// A pie whose straight sides are moved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pie {
    /// Around the circle.
    pub(super) pixels: PixelBox,
    pub(super) wedge: Wedge,
    pub(super) sweep: Angle,
    /// How far the straight sides are moved into the wedge, in 1/256 pixel.
    pub(super) offset: i64,
    /// A sharp corner is cut off square: along the middle of the wedge, where this much of it is left, in 1/256 pixel.
    pub(super) bevel: Option<(Vector, i64)>,
}

impl Pie {
    /// Adds the outline, with room for so many vertices. It may reach out of the circle, but not out of its box, where
    /// the straight sides take up most of it.
    #[inline(never)]
    pub(super) fn push(&self, outline: &mut Outline, room: usize) {
        let Self { pixels, wedge, offset, .. } = *self;
        let (Some(start), Some(end)) = (unit(wedge.start), unit(wedge.end)) else { return };
        let (middle, radius) = (center(&pixels), radius(pixels.width));
        let (after_start, before_end) = (left(left(left(start))), left(end));
        let corner = meet(after_start, offset, before_end, offset);
        let is_outside = |place: Vector| {
            place.0.abs() >= radius
                || place.1.abs() >= radius
                || place.0 * place.0 + place.1 * place.1 >= radius * radius
        };
        // Half a turn has both sides on one line.
        let is_straight = corner.is_none() && (start.0 * end.0 + start.1 * end.1) < 0;
        let is_far = !is_straight && corner.is_none_or(is_outside);
        let is_full = match wedge.sweep {
            Sweep::Whole => true,
            Sweep::Wide => offset <= -radius || (offset < 0 && is_far),
            Sweep::Narrow => offset <= -radius,
        };
        if !is_full && (offset >= radius || (offset > 0 && is_far && wedge.sweep == Sweep::Narrow)) {
            return;
        }
        let chords = chords(radius, if is_full { Angle::from_degrees(360.0) } else { self.sweep }, room, 1);
        if is_full {
            push_arc(outline, middle, (radius, radius), chords, 0..chords.count());
            return;
        }
        let length = (radius * radius - offset * offset).cast_unsigned().isqrt().cast_signed();
        let first = add(along(start, length), along(after_start, offset));
        let last = add(along(end, length), along(before_end, offset));
        let push = |outline: &mut Outline, (x, y): Vector| {
            // Clamped: a corner may be far away.
            let (x, y) = add(middle, (within(x, radius), within(y, radius)));
            outline.push(vertex(x, y)).unwrap_or_default();
        };
        push(outline, first);
        if let (Some(from), Some(to)) = (unit(first), unit(last)) {
            push_arc(outline, middle, (radius, radius), chords, between(chords, from, to, wedge.sweep));
        }
        push(outline, last);
        let cut = self.bevel.and_then(|(bisector, at)| {
            let is_cut = corner.is_none_or(|(x, y)| {
                // A corner is at most 2^36 away.
                let reach = ((x >> 6) * bisector.0 + (y >> 6) * bisector.1) >> 24;
                if wedge.sweep == Sweep::Narrow { reach < at } else { reach > at }
            });
            if !is_cut {
                return None;
            }
            Some((meet(before_end, offset, bisector, at)?, meet(after_start, offset, bisector, at)?))
        });
        match (cut, corner) {
            (Some((from, to)), _) => {
                push(outline, from);
                push(outline, to);
            }
            (None, Some(corner)) => push(outline, corner),
            (None, None) => push(outline, along(after_start, offset)),
        }
    }
}
