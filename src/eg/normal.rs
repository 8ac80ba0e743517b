//! Unit vectors and the places where lines meet, in integers.

use super::outline::{UNIT_BITS, scaled};

/// One, in the unit of unit vectors.
pub(super) const ONE: i64 = 1 << UNIT_BITS;

/// A vector.
pub(super) type Vector = (i64, i64);

/// The direction of a vector, below 2^62 in each component, to about 1/2^29. None for the zero vector.
pub(super) fn unit((x, y): Vector) -> Option<Vector> {
    let most = x.unsigned_abs() | y.unsigned_abs();
    if most == 0 {
        return None;
    }
    // To the size of a unit vector: the squares fit, and short vectors keep their direction.
    let spare = i64::from(most.leading_zeros()) - i64::from(64 - UNIT_BITS);
    let sized = |value: i64| if spare >= 0 { value << spare } else { value >> -spare };
    let (x, y) = (sized(x), sized(y));
    let length = (x * x + y * y).cast_unsigned().isqrt().cast_signed().max(1);
    Some(((x << UNIT_BITS) / length, (y << UNIT_BITS) / length))
}

/// A quarter turn to the left, which is up for a direction to the right.
pub(super) fn left((x, y): Vector) -> Vector {
    (y, -x)
}

/// How much of one unit vector points along another.
pub(super) fn dot(a: Vector, b: Vector) -> i64 {
    (a.0 * b.0 + a.1 * b.1) >> UNIT_BITS
}

/// Positive when `b` is clockwise of `a`.
pub(super) fn cross(a: Vector, b: Vector) -> i64 {
    (a.0 * b.1 - a.1 * b.0) >> UNIT_BITS
}

/// `length` along a unit vector.
pub(super) fn along(direction: Vector, length: i64) -> Vector {
    (scaled(length, direction.0), scaled(length, direction.1))
}

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    (a.0 + b.0, a.1 + b.1)
}

/// Where two lines meet that lie `a_offset` and `b_offset` along their normals. None when they are nearly parallel.
pub(super) fn meet(a: Vector, a_offset: i64, b: Vector, b_offset: i64) -> Option<Vector> {
    let determinant = cross(a, b);
    if determinant.abs() < ONE >> 10 {
        return None;
    }
    let x = (a_offset * b.1 - b_offset * a.1).checked_div(determinant)?;
    let y = (b_offset * a.0 - a_offset * b.0).checked_div(determinant)?;
    Some((x, y))
}
