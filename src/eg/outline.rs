//! Outlines of circles and ellipses as polygons, for blending: as few vertices as tiles have time for.
//!
//! A chord of a circle of radius `r` with `n` of them is at most `(pi / n)^2 r / 2` away from it, in the middle. The vertices
//! lie half of that outside the circle, the middles half of it inside: up to 150 pixels of radius (`n` is then 224) that
//! is below 1/100 pixel.

use heapless::Vec;

use crate::{
    Angle, CoverageSink, PixelRect, Polygon, Vertex,
    geometry::touched,
    outline::{Vector, shift_half_even},
    shape::Cover,
};

use super::{
    layers::Layers,
    pixel_box::{PixelBox, to_i32},
};

/// The vertices of one outline or two, 1920 bytes.
pub(super) type Outline = Vec<Vertex, ALONE>;

/// Room for one outline of the finest chords, and the corners.
const ALONE: usize = 240;

/// Vertices that are not those of chords, at most.
const CORNERS: usize = 12;

/// Points evenly around the circle: a multiple of 8.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chords {
    count: u32,
}

impl Chords {
    /// As many as a radius in 1/256 pixel asks for, but at most as have room for their part of a turn, in 1/65536.
    pub(super) fn new(radius: i64, room: usize, turn: u32) -> Self {
        // (pi / n)^2 r / 2 = 1/64 pixel; that is fine enough for 3000 pixels.
        let wanted = u32::try_from(radius).unwrap_or(u32::MAX).min(1 << 20) * 5 / 256;
        let room = u32::try_from(room.saturating_sub(CORNERS)).unwrap_or(0) << 16;
        Self { count: 8 * (wanted.isqrt() + 1).min(room / turn.max(1 << 10) / 8).max(1) }
    }

    pub(super) const fn quarter(self) -> u32 {
        self.count / 4
    }

    /// The number of the first point at an angle or clockwise after it.
    pub(super) fn after(self, angle: Angle) -> u32 {
        let point = (u64::from(angle.to_bits()) * u64::from(self.count)).div_ceil(1 << 32);
        u32::try_from(point).unwrap_or(0)
    }

    /// How many points there are from `first` on and before `end`; all, where there is none between a wide pair.
    pub(super) fn between(self, first: u32, end: u32, is_wide: bool) -> u32 {
        let count = (end + self.count).saturating_sub(first).checked_rem(self.count).unwrap_or(0);
        if count == 0 && is_wide { self.count } else { count }
    }

    /// Adds a part of an ellipse; it stays inside the box around it.
    pub(super) fn push(self, outline: &mut Outline, center: Vector, radii: Vector, points: impl Iterator<Item = u32>) {
        // Half the height of a chord: pi^2 / 4 = 161704 / 65536.
        let count = i64::from(self.count);
        let grown = |radius: i64| radius + (radius * 161_704).checked_div((count * count) << 16).unwrap_or(0);
        for point in points {
            let turns = (u64::from(point) << 32).checked_div(self.count.into()).unwrap_or(0);
            #[allow(clippy::cast_possible_truncation, reason = "whole turns do not matter")]
            let (sin, cos) = Angle::from_bits(turns as u32).sin_cos();
            let place =
                |radius: i64, sine: i32| shift_half_even(grown(radius) * i64::from(sine), 30).min(radius).max(-radius);
            push(outline, center.plus(Vector::new(place(radii.x, cos), place(radii.y, sin))));
        }
    }
}

/// Adds a vertex; there is room for as many as chords were asked for.
pub(super) fn push(outline: &mut Outline, at: Vector) {
    outline.push(vertex(at)).unwrap_or_default();
}

/// The corner of an outline nearest to a place in 1/256 pixel.
pub(super) fn vertex(Vector { x, y }: Vector) -> Vertex {
    Vertex::from_bits(to_i32(x), to_i32(y))
}

/// Half a size in pixels, in 1/256 pixel. Beyond the coordinates there are it does not grow.
pub(super) fn radius(size: i64) -> i64 {
    128 * size.min(1 << 24)
}

/// Adds the ellipse that touches the sides of a box; there is room for so many vertices.
///
/// Outlines are filled where they are: to return one would take its space twice.
#[inline(never)]
pub(super) fn push_ellipse(outline: &mut Outline, room: usize, pixels: &PixelBox) {
    if pixels.is_empty() {
        return;
    }
    let radii = Vector::new(radius(pixels.width), radius(pixels.height));
    let chords = Chords::new(radii.x.max(radii.y), room, 1 << 16);
    chords.push(outline, pixels.center(), radii, 0..chords.count);
}

/// A closed outline, of which at most eight chains meet a row of pixels, as all that are made here.
#[derive(Debug, Clone, Copy)]
pub(super) struct Area<'v>(pub(super) &'v [Vertex]);

impl Cover for Area<'_> {
    fn touched(&self) -> PixelRect {
        touched(self.0.iter())
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        Polygon::new(self.0).coverage_with::<8>().map_or(Ok(()), |polygon| polygon.coverage(clip, sink))
    }
}

/// Draws the stroke between two closed outlines and the fill inside the second, or the fill alone.
///
/// `push` adds the first outline or the second, in the room for so many vertices.
pub(super) fn draw_outlines<L: Layers>(
    layers: &mut L,
    push: impl Fn(&mut Outline, usize, bool),
) -> Result<(), L::Error> {
    with_outlines(layers.has_stroke(), push, |outer, inner| layers.draw(&outer, &inner))
}

/// Hands over the first outline, which is empty where there is no stroke, and the second.
#[inline(never)]
pub(super) fn with_outlines<R>(
    has_stroke: bool,
    push: impl Fn(&mut Outline, usize, bool),
    draw: impl FnOnce(Area<'_>, Area<'_>) -> R,
) -> R {
    let mut outline = Outline::new();
    let room = if has_stroke { ALONE / 2 } else { ALONE };
    if has_stroke {
        push(&mut outline, room, true);
    }
    let split = outline.len();
    push(&mut outline, room, false);
    let (outer, inner) = outline.split_at_checked(split).unwrap_or_default();
    draw(Area(outer), Area(inner))
}
