//! Unit vectors in integers.

use crate::outline::{FinePoint, Vector, shift_half_even};

/// Fraction bits of a unit vector.
pub(super) const UNIT_BITS: u32 = 30;
pub(super) const UNIT: i64 = 1 << UNIT_BITS;

/// A vector of length 1, with 30 fraction bits: each part is within 2^-30.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unit(pub(crate) Vector);

impl Unit {
    pub(crate) const RIGHT: Self = Self(Vector::new(UNIT, 0));

    /// The direction of a vector; none of the one that has no length. Parts of up to 2^62.
    pub(crate) fn along(vector: Vector) -> Option<Self> {
        let size = vector.x.unsigned_abs() | vector.y.unsigned_abs();
        if size == 0 {
            return None;
        }
        // The larger part to 31 bits: its square, and the sum of both, fit 64.
        let zeros = size.leading_zeros();
        let scaled = |part: i64| {
            let magnitude = part.unsigned_abs();
            if zeros >= 33 { magnitude << (zeros - 33) } else { magnitude >> (33 - zeros) }
        };
        let (x, y) = (scaled(vector.x), scaled(vector.y));
        let square = x * x + y * y;
        let floor = square.isqrt();
        let length = (floor + u64::from(square - floor * floor > floor)).max(1);
        let part = |magnitude: u64, sign: i64| {
            let unit = ((magnitude << UNIT_BITS) + length / 2) / length;
            // At most 2^30 + 1.
            if sign < 0 { -unit.cast_signed() } else { unit.cast_signed() }
        };
        Some(Self(Vector::new(part(x, vector.x), part(y, vector.y))))
    }

    /// To its right, as seen along it with y upwards; clockwise where y grows downwards.
    pub(crate) const fn turned(self) -> Self {
        Self(self.0.turned())
    }

    /// What it was before it was turned.
    pub(crate) const fn turned_back(self) -> Self {
        Self(Vector::new(self.0.y, -self.0.x))
    }

    pub(super) const fn opposite(self) -> Self {
        Self(Vector::new(-self.0.x, -self.0.y))
    }

    pub(crate) const fn dot(self, other: Self) -> i64 {
        self.0.x * other.0.x + self.0.y * other.0.y
    }

    pub(crate) const fn cross(self, other: Self) -> i64 {
        self.0.x * other.0.y - self.0.y * other.0.x
    }

    /// So long, rounded. `length` below 2^32.
    pub(crate) const fn times(self, length: i64) -> Vector {
        Vector::new(shift_half_even(self.0.x * length, UNIT_BITS), shift_half_even(self.0.y * length, UNIT_BITS))
    }

    /// The point at a distance in this direction.
    pub(super) const fn from(self, point: FinePoint, length: i64) -> FinePoint {
        self.times(length).from(point)
    }
}

/// The length of a vector between points, in 2^-16 pixel, off by less than one.
pub(crate) fn length_q16(vector: Vector) -> u64 {
    let (x, y) = (vector.x.unsigned_abs(), vector.y.unsigned_abs());
    if (x | y) < 1 << 27 {
        ((x * x + y * y) << 8).isqrt()
    } else {
        let square = u128::from(x) * u128::from(x) + u128::from(y) * u128::from(y);
        // Below 2^73.
        u64::try_from((square << 8).isqrt()).unwrap_or(u64::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_are_of_length_one_and_mirrored() {
        let mut seed = 1_u64;
        for case in 0..100_000_u32 {
            seed = seed.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(99);
            let part = |bits: u64| ((bits & 0xffff_ffff).cast_signed() - (1 << 31)) >> (case % 31);
            let vector = Vector::new(part(seed), part(seed >> 32));
            let Some(unit) = Unit::along(vector) else { continue };
            let length = (vector.x as f64).hypot(vector.y as f64);
            for (part, exact) in [(unit.0.x, vector.x), (unit.0.y, vector.y)] {
                assert!((part as f64 / UNIT as f64 - exact as f64 / length).abs() < 1.0 / UNIT as f64);
            }
            assert_eq!(Unit::along(Vector::new(-vector.y, vector.x)), Some(unit.turned()));
            assert_eq!(unit.turned().turned_back(), unit);
        }
        assert_eq!(Unit::along(Vector::default()), None);
        assert_eq!(Unit::along(Vector::new(0, -7)).map(|unit| unit.times(40)), Some(Vector::new(0, -40)));
        assert_eq!(Unit::along(Vector::new(3, 4)), Unit::along(Vector::new(3 << 29, 4 << 29)));
    }
}
