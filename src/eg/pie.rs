//! Outlines of rings and pies cut by a wedge, for blending. The rays are exact to 2^-30, and angles in single precision less.

use embedded_graphics::geometry;

use crate::{Angle, outline::Vector, stroke::Unit};

use super::{
    outline::{Chords, Outline, push, radius},
    pixel_box::PixelBox,
    wedge::Sweep,
};

/// A wedge, clockwise.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rays {
    start: Angle,
    end: Angle,
    pub(super) sweep: Sweep,
}

impl Rays {
    pub(super) fn new(start: geometry::Angle, sweep: geometry::Angle) -> Self {
        let angle = |angle: geometry::Angle| Angle::from_radians(angle.to_radians());
        let (from, to) = (angle(start), angle(start + sweep));
        let (start, end) = if sweep < geometry::Angle::zero() { (to, from) } else { (from, to) };
        Self { start, end, sweep: Sweep::of(sweep) }
    }

    /// Adds an arc from one angle to another, with both ends, or back.
    fn push_arc(&self, outline: &mut Outline, middle: Vector, radius: i64, room: usize, is_back: bool) {
        let Self { start, end, sweep } = *self;
        let radii = Vector::new(radius, radius);
        let turn = (end - start).to_bits() >> 16;
        let is_wide = sweep != Sweep::Narrow;
        let chords = Chords::new(radius, room, if turn == 0 && is_wide { 1 << 16 } else { turn + 1 });
        let first = chords.after(start);
        let count = chords.between(first, chords.after(end), is_wide);
        let points = (0..count).map(|point| first + if is_back { count - 1 - point } else { point });
        chords.push(outline, middle, radii, points);
    }
}

/// The direction of an angle.
pub(super) fn direction(angle: Angle) -> Unit {
    let (sin, cos) = angle.sin_cos();
    Unit(Vector::new(cos.into(), sin.into()))
}

/// Adds the outline of what is between two circles and in a wedge.
#[inline(never)]
pub(super) fn push_ring(outline: &mut Outline, room: usize, outer: &PixelBox, inner: &PixelBox, rays: &Rays) {
    let (middle, start, end) = (outer.center(), direction(rays.start), direction(rays.end));
    let (far, near) = (radius(outer.width), radius(inner.width));
    push(outline, middle.plus(start.times(far)));
    rays.push_arc(outline, middle, far, room / 2, false);
    push(outline, middle.plus(end.times(far)));
    push(outline, middle.plus(end.times(near)));
    if near > 0 {
        rays.push_arc(outline, middle, near, room / 2, true);
        push(outline, middle.plus(start.times(near)));
    }
}

/// A pie whose straight sides are moved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pie {
    /// Around the circle.
    pub(super) pixels: PixelBox,
    pub(super) rays: Rays,
    /// How far the straight sides are moved into the wedge, in 1/256 pixel.
    pub(super) offset: i64,
    /// A sharp corner is cut off square: along the middle of the wedge, where this much of it is left, in 1/256 pixel.
    pub(super) bevel: Option<(Unit, i64)>,
}

impl Pie {
    /// Adds the outline, with room for so many vertices. It may reach out of the circle, but not out of its box, where
    /// the straight sides take up most of it.
    #[inline(never)]
    pub(super) fn push(&self, outline: &mut Outline, room: usize) {
        let Self { pixels, rays, offset, .. } = *self;
        let (start, end, sweep) = (direction(rays.start), direction(rays.end), rays.sweep);
        let (middle, radius) = (pixels.center(), radius(pixels.width));
        let (after_start, before_end) = (start.turned(), end.turned_back());
        let corner = meet(after_start, offset, before_end, offset);
        let is_outside = |place: Vector| {
            place.x.abs() >= radius || place.y.abs() >= radius || place.dot(place) >= i128::from(radius * radius)
        };
        // Half a turn has both sides on one line.
        let is_straight = corner.is_none() && start.dot(end) < 0;
        let is_far = !is_straight && corner.is_none_or(is_outside);
        let is_full = match sweep {
            Sweep::Whole => true,
            Sweep::Wide => offset <= -radius || (offset < 0 && is_far),
            Sweep::Narrow => offset <= -radius,
        };
        if !is_full && (offset >= radius || (offset > 0 && is_far && sweep == Sweep::Narrow)) {
            return;
        }
        if is_full {
            let whole = Rays { start: Angle::ZERO, end: Angle::ZERO, sweep: Sweep::Whole };
            return whole.push_arc(outline, middle, radius, room, false);
        }
        let length = (radius * radius - offset * offset).cast_unsigned().isqrt().cast_signed();
        let first = start.times(length).plus(after_start.times(offset));
        let last = end.times(length).plus(before_end.times(offset));
        // Clamped: a corner may be far away.
        let within = |at: i64| at.min(radius).max(-radius);
        let mut add = |Vector { x, y }: Vector| push(outline, middle.plus(Vector::new(within(x), within(y))));
        let cut = self.bevel.and_then(|(bisector, at)| {
            let reach = |corner: Vector| corner.dot(bisector.0) >> 30;
            let is_cut = corner.is_none_or(|corner| (reach(corner) < i128::from(at)) == (sweep == Sweep::Narrow));
            let cut = |side: Unit| meet(side, offset, bisector, at);
            if is_cut { cut(before_end).zip(cut(after_start)) } else { None }
        });
        let corner = corner.unwrap_or(after_start.times(offset));
        let (from, to) = cut.unwrap_or((corner, corner));
        [last, from, to, first].into_iter().for_each(&mut add);
        let arc = Rays { start: Angle::of(first.x, first.y), end: Angle::of(last.x, last.y), sweep };
        arc.push_arc(outline, middle, radius, room, false);
    }
}

/// Where two lines meet that lie `a_offset` and `b_offset` along their normals. None when they are nearly parallel.
fn meet(a: Unit, a_offset: i64, b: Unit, b_offset: i64) -> Option<Vector> {
    let determinant = a.cross(b) >> 30;
    if determinant.abs() < 1 << 20 {
        return None;
    }
    let x = (a_offset * b.0.y - b_offset * a.0.y).checked_div(determinant)?;
    let y = (b_offset * a.0.x - a_offset * b.0.x).checked_div(determinant)?;
    Some(Vector::new(x, y))
}
