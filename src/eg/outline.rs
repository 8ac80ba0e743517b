//! Outlines of circles and ellipses as polygons, for blending: vertices from rational points of the circle, in
//! integers.
//!
//! `((1 - t^2) / (1 + t^2), 2 t / (1 + t^2))` runs over an eighth of the circle while `t` runs from 0 to tan(22.5
//! degrees), and nearly evenly: the chords differ by a sixth. The other eighths mirror it.
//!
//! A chord of a circle of radius `r` with `8 n` of them is at most `(pi / 4 n)^2 r / 8 * 1.09` away from it, in the
//! middle. The vertices lie half of that outside the circle, the middles half of it inside: up to 150 pixels of radius
//! (`n` is then 28) that is below 1/100 pixel.

use embedded_graphics_core::draw_target::DrawTarget;
use heapless::Vec;

use crate::{Blend, Mix, PixelRect, Polygon, PolygonCoverageWith, TooManyEdges, Vertex};

use super::{
    Blended,
    layers::{Tile, draw_area, draw_layers},
    paint::Paint,
    pixel_box::{PixelBox, to_i32},
};

/// The vertices of one outline or two, 1920 bytes.
pub(super) type Outline = Vec<Vertex, ALONE>;

/// Room for one outline of the finest chords: 8 x 28, and the corners.
pub(super) const ALONE: usize = 240;

/// Room for each of two outlines.
pub(super) const PAIRED: usize = ALONE / 2;

/// Bits behind the binary point of a sine.
pub(super) const UNIT_BITS: u32 = 30;

/// Points evenly around the unit circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chords {
    /// In an eighth of the circle.
    eighth: u32,
}

impl Chords {
    /// As many as a radius in 1/256 pixel asks for, but at most `most` all around.
    pub(super) fn new(radius: i64, most: usize) -> Self {
        // (pi / 4 n)^2 r / 8 = 1/64 pixel; that is fine enough for 3000 pixels.
        let wanted = u32::try_from(radius).unwrap_or(u32::MAX).min(1 << 20) * 5 / 256;
        let most = u32::try_from(most / 8).unwrap_or(u32::MAX);
        Self { eighth: (wanted.isqrt() + 1).min(most).max(1) }
    }

    pub(super) fn count(self) -> i32 {
        8 * self.eighth.cast_signed()
    }

    /// The cosine and sine of point `index`, clockwise from the right, in 1/2^30.
    pub(super) fn unit(self, index: i32) -> (i64, i64) {
        /// tan(22.5 degrees) in 1/2^15.
        const LAST: u32 = 13573;
        const ONE: u64 = 1 << 30;
        let per_eighth = self.eighth.max(1);
        let index = index.rem_euclid(self.count().max(1)).cast_unsigned();
        let (eighth, step) = (index / per_eighth, index % per_eighth);
        // Odd eighths run backwards.
        let step = if eighth % 2 == 0 { step } else { per_eighth - step };
        let t = u64::from(LAST * step / per_eighth);
        let square = t * t;
        let part = |part: u64| ((part << UNIT_BITS) / (ONE + square).max(1)).cast_signed();
        let (near, far) = (part(ONE - square), part(t << 16));
        match eighth {
            0 => (near, far),
            1 => (far, near),
            2 => (-far, near),
            3 => (-near, far),
            4 => (-near, -far),
            5 => (-far, -near),
            6 => (far, -near),
            _ => (near, -far),
        }
    }

    /// How far the vertices lie outside a circle of this radius, in the unit of the radius: half the height of a chord.
    pub(super) fn margin(self, radius: i64) -> i64 {
        // (pi / 4)^2 / 16 = 2526 / 65536
        let eighth = i64::from(self.eighth);
        radius * 2526 / (65536 * eighth * eighth).max(1)
    }
}

/// `value`, in any unit, times a sine.
pub(super) fn scaled(value: i64, sine: i64) -> i64 {
    (value * sine + (1 << (UNIT_BITS - 1))) >> UNIT_BITS
}

/// The nearest value to this one that is at most `reach` from 0. (`clamp` has a panic in it.)
pub(super) fn within(value: i64, reach: i64) -> i64 {
    value.min(reach).max(-reach)
}

/// The corner of an outline nearest to a place in 1/256 pixel.
pub(super) fn vertex(x: i64, y: i64) -> Vertex {
    Vertex::from_bits(to_i32(x), to_i32(y))
}

/// A part of an ellipse from point `first` to point `last` of its chords; it stays inside the box around the ellipse.
pub(super) fn push_arc(
    outline: &mut Outline,
    center: (i64, i64),
    radii: (i64, i64),
    chords: Chords,
    points: impl Iterator<Item = i32>,
) {
    let grown = (radii.0 + chords.margin(radii.0), radii.1 + chords.margin(radii.1));
    for index in points {
        let (cos, sin) = chords.unit(index);
        let x = within(scaled(grown.0, cos), radii.0);
        let y = within(scaled(grown.1, sin), radii.1);
        // An outline has room for as many points as its chords were asked for.
        outline.push(vertex(center.0 + x, center.1 + y)).unwrap_or_default();
    }
}

/// Adds the ellipse that touches the sides of a box; there is room for so many vertices.
///
/// Outlines are filled where they are: to return one would take its space twice.
#[inline(never)]
pub(super) fn push_ellipse(outline: &mut Outline, room: usize, pixels: &PixelBox) {
    if pixels.is_empty() {
        return;
    }
    let (x, y) = pixels.center_2x();
    let radii = (radius(pixels.width), radius(pixels.height));
    let chords = Chords::new(radii.0.max(radii.1), room.saturating_sub(12));
    push_arc(outline, (128 * (x + 1), 128 * (y + 1)), radii, chords, 0..chords.count());
}

/// Half a size in pixels, in 1/256 pixel. Beyond the coordinates there are it does not grow.
pub(super) fn radius(size: i64) -> i64 {
    128 * size.min(1 << 24)
}

/// Adds to a tile what a closed outline covers.
pub(super) fn add_outline(outline: &[Vertex], clip: &PixelRect, tile: &mut Tile) {
    if let Ok(polygon) = covered(outline) {
        tile.add(&polygon, clip);
    }
}

/// An outline of which at most eight chains meet a row of pixels, as all that are made here.
pub(super) fn covered(outline: &[Vertex]) -> Result<PolygonCoverageWith<'_, 8>, TooManyEdges> {
    Polygon::new(outline).coverage_with()
}

/// Draws a closed outline in one colour. Not inlined: its scratch is not that of tiles.
#[inline(never)]
pub(super) fn draw_outline<D: DrawTarget, B: Blend<D>>(
    outline: &[Vertex],
    colour: D::Color,
    blended: &Blended<B>,
    target: &mut D,
) -> Result<(), D::Error> {
    match covered(outline) {
        Ok(area) => draw_area(area, colour, blended, target),
        Err(_) => Ok(()),
    }
}

/// Draws the stroke between two closed outlines in a box and the fill inside the second, or the fill alone.
///
/// `push` adds the first outline or the second, in the room for so many vertices.
pub(super) fn draw_outlines<D: DrawTarget, B: Blend<D>>(
    paint: &Paint<D::Color>,
    blended: &Blended<B>,
    target: &mut D,
    bounds: &PixelBox,
    push: impl Fn(&mut Outline, usize, Layer),
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    if let (Some(fill), None) = (paint.fill, paint.stroke) {
        let mut outline = Outline::new();
        push(&mut outline, ALONE, Layer::Inner);
        return draw_outline(&outline, fill, blended, target);
    }
    draw_outlines_in(paint, blended, target, &[*bounds], push)
}

/// What of both there is in some boxes.
pub(super) fn draw_outlines_in<D: DrawTarget, B: Blend<D>>(
    paint: &Paint<D::Color>,
    blended: &Blended<B>,
    target: &mut D,
    boxes: &[PixelBox],
    push: impl Fn(&mut Outline, usize, Layer),
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    let mut outline = Outline::new();
    push(&mut outline, PAIRED, Layer::Outer);
    let split = outline.len();
    push(&mut outline, PAIRED, Layer::Inner);
    let (outer, inner) = outline.split_at_checked(split).unwrap_or_default();
    boxes.iter().try_for_each(|pixels| {
        draw_layers(
            paint,
            blended,
            target,
            &pixels.rectangle().into(),
            |clip, tile| add_outline(outer, clip, tile),
            |clip, tile| add_outline(inner, clip, tile),
        )
    })
}

/// What the stroke ends at, and what it leaves to fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layer {
    Outer,
    Inner,
}
