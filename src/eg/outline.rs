//! Outlines of circles and ellipses as polygons, for blending: vertices from rational points of the circle, in integers.
//!
//! `((1 - t^2) / (1 + t^2), 2 t / (1 + t^2))` runs over an eighth of the circle while `t` runs from 0 to tan(22.5
//! degrees), and nearly evenly: the chords differ by a sixth. The other eighths mirror it.
//!
//! A chord of a circle of radius `r` with `8 n` of them is at most `(pi / 4 n)^2 r / 8 * 1.09` away from it, in the
//! middle. The vertices lie half of that outside the circle, the middles half of it inside: up to 200 pixels of radius
//! (`n` is then 32) that is below 1/100 pixel.

use heapless::Vec;

use crate::{Cover, PixelRect, Polygon, Vertex};

use super::{layers::COLUMNS, layers::Tile, pixel_box::{PixelBox, to_i32}};

/// The vertices of an outline, at most `N`.
pub(super) type Outline<const N: usize> = Vec<Vertex, N>;

/// Enough for one outline of the finest chords: 8 x 32, and the corners.
pub(super) const ALONE: usize = 268;

/// Enough for an outline of chords twice as long, where two are on the stack at once.
pub(super) const PAIRED: usize = 140;

/// Bits behind the binary point of a sine.
pub(super) const UNIT_BITS: u32 = 30;

/// Points evenly around the unit circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chords {
    /// In an eighth of the circle.
    eighth: i64,
}

impl Chords {
    /// As many as a radius in 1/256 pixel asks for, but at most `most` all around.
    pub(super) fn new(radius: i64, most: usize) -> Self {
        // (pi / 4 n)^2 r / 8 = 1/64 pixel.
        let wanted = (radius.clamp(0, 1 << 40).cast_unsigned() * 5 / 256).isqrt().cast_signed() + 1;
        Self { eighth: wanted.clamp(1, i64::try_from(most / 8).unwrap_or(1).max(1)) }
    }

    pub(super) fn count(self) -> i64 {
        8 * self.eighth
    }

    /// The cosine and sine of point `index`, clockwise from the right, in 1/2^30.
    pub(super) fn unit(self, index: i64) -> (i64, i64) {
        /// tan(22.5 degrees) in 1/2^15.
        const LAST: i64 = 13573;
        const ONE: i64 = 1 << 30;
        let index = index.rem_euclid(self.count());
        let (eighth, step) = (index / self.eighth, index % self.eighth);
        // Odd eighths run backwards.
        let step = if eighth % 2 == 0 { step } else { self.eighth - step };
        let t = LAST * step / self.eighth;
        let square = t * t;
        let whole = ONE + square;
        let (near, far) = (((ONE - square) << UNIT_BITS) / whole, (t << (16 + UNIT_BITS)) / whole);
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
        radius * 2526 / (65536 * self.eighth * self.eighth)
    }
}

/// `value`, in any unit, times a sine.
pub(super) fn scaled(value: i64, sine: i64) -> i64 {
    (value * sine + (1 << (UNIT_BITS - 1))) >> UNIT_BITS
}

/// The corner of an outline nearest to a place in 1/256 pixel.
pub(super) fn vertex(x: i64, y: i64) -> Vertex {
    Vertex::from_bits(to_i32(x), to_i32(y))
}

/// A part of an ellipse from point `first` to point `last` of its chords; it stays inside the box around the ellipse.
pub(super) fn push_arc<const N: usize>(
    outline: &mut Outline<N>,
    center: (i64, i64),
    radii: (i64, i64),
    chords: Chords,
    points: impl Iterator<Item = i64>,
) {
    let grown = (radii.0 + chords.margin(radii.0), radii.1 + chords.margin(radii.1));
    for index in points {
        let (cos, sin) = chords.unit(index);
        let x = scaled(grown.0, cos).clamp(-radii.0, radii.0);
        let y = scaled(grown.1, sin).clamp(-radii.1, radii.1);
        // An outline has room for as many points as its chords were asked for.
        outline.push(vertex(center.0 + x, center.1 + y)).unwrap_or_default();
    }
}

/// The ellipse that touches the sides of a box.
pub(super) fn ellipse<const N: usize>(pixels: &PixelBox) -> Outline<N> {
    let mut outline = Outline::new();
    if pixels.is_empty() {
        return outline;
    }
    let (x, y) = pixels.center_2x();
    let radii = (radius(pixels.width), radius(pixels.height));
    let chords = Chords::new(radii.0.max(radii.1), N - 12);
    push_arc(&mut outline, (128 * (x + 1), 128 * (y + 1)), radii, chords, 0..=chords.count() - 1);
    outline
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

/// An outline of which at most eight edges cross a row, as all that are made here.
pub(super) fn covered(outline: &[Vertex]) -> Result<impl Cover, crate::TooManyEdges> {
    const CELLS: usize = COLUMNS.cast_unsigned() as usize;
    Polygon::new(outline).coverage_with::<8, CELLS>()
}
