//! Turning vertices by an angle.

use fixed::types::I24F8;

use crate::{Angle, Vertex, angle::SINE_BITS, limits::SUBPIXEL_BITS};

/// A rotation by an angle, for needles, hands and sprites.
///
/// Sine and cosine are made once, within 2^-29 (see [`Angle`]); turning a vertex takes four multiplications, rounds to
/// the nearest 1/256 pixel, saturates at the ends of the coordinate range, and gives the same bits on every machine: the
/// right ones, to that rounding, up to 2^20 pixels from the centre. The pixels of what is drawn from the turned vertices
/// are exact again.
///
/// ```text
///      + x                  clockwise, as y grows downwards
///      |\
///      | \  angle
///      y  v
/// ```
///
/// # Cost
///
/// Eight multiplications for the angle, four for a vertex. No floating point and no division.
///
/// # Examples
///
/// ```
/// use spanfill::{Angle, Triangle, Turn, Vertex};
///
/// let center = Vertex::pixel(32, 32);
/// let needle = [Vertex::pixel(30, 32), Vertex::pixel(34, 32), Vertex::pixel(32, 4)];
/// let turn = Turn::new(Angle::degrees(30));
/// let turned = Triangle::from_vertices(needle.map(|vertex| turn.about(center, vertex)));
/// # assert!(turned.vertices[2].x > center.x && turned.vertices[2].y < center.y);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Turn {
    /// In 2^-30.
    cos: i32,
    sin: i32,
}

impl Turn {
    /// A turn by an angle.
    #[inline]
    pub const fn new(angle: Angle) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { cos, sin }
    }

    /// A turn by an angle in degrees. One that is not finite does not turn.
    #[inline]
    pub const fn from_degrees(degrees: f32) -> Self {
        Self::new(Angle::from_degrees(degrees))
    }

    /// A turn by an angle in radians. One that is not finite does not turn.
    #[inline]
    pub const fn from_radians(radians: f32) -> Self {
        Self::new(Angle::from_radians(radians))
    }

    /// Where `vertex` goes, around `center`.
    pub fn about(self, center: Vertex, vertex: Vertex) -> Vertex {
        let offset = |vertex: I24F8, center: I24F8| i64::from(vertex.to_bits()) - i64::from(center.to_bits());
        let (x, y) = (offset(vertex.x, center.x), offset(vertex.y, center.y));
        let (cos, sin) = (i64::from(self.cos), i64::from(self.sin));
        let moved = |center: I24F8, product: i64| {
            let moved = i64::from(center.to_bits()) + ((product + (1 << (SINE_BITS - 1))) >> SINE_BITS);
            #[allow(clippy::cast_possible_truncation, reason = "clamped")]
            let bits = moved.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32;
            bits
        };
        Vertex::from_bits(moved(center.x, x * cos - y * sin), moved(center.y, x * sin + y * cos))
    }
}

// `x cos - y sin`: an offset below 2^32 times at most 2^30 (1 + 2^-29), of which the squares add up to one: below 2^63.
const _: () = assert!((24 + SUBPIXEL_BITS) + SINE_BITS < 63);

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(a: Vertex, b: Vertex) -> f64 {
        let (x, y) = (a.x.to_bits() - b.x.to_bits(), a.y.to_bits() - b.y.to_bits());
        f64::from(x).hypot(f64::from(y)) / 256.0
    }

    #[test]
    fn turned_vertices_are_the_nearest() {
        let (center, radius) = (Vertex::new(12.5, -7.25), 256.0);
        let start = Vertex::new(center.x + I24F8::from_num(radius), center.y);
        for tenths in -7200_i16..=7200 {
            let angle = f32::from(tenths) / 10.0;
            let turned = Turn::from_degrees(angle).about(center, start);
            let (sin, cos) = f64::from(angle).to_radians().sin_cos();
            let exact = Vertex::new(center.x.to_num::<f64>() + radius * cos, center.y.to_num::<f64>() + radius * sin);
            // The nearest 256th to a point known to 2^-20 pixel: one unit along an axis, where that lies half way.
            assert!(distance(turned, exact) <= 1.0 / 256.0, "{angle} degrees");
        }
    }

    #[test]
    fn the_ends_of_the_range_saturate() {
        let low = Vertex::from_bits(i32::MIN, i32::MIN);
        let high = Vertex::from_bits(i32::MAX, i32::MAX);
        let turned = Turn::from_degrees(180.0).about(high, low);
        assert_eq!(turned, high);
        assert_eq!(Turn::from_degrees(f32::NAN).about(low, high), high);
    }
}
