//! Turning, scaling, skewing and moving a path.

use crate::{
    Angle,
    outline::{FinePoint, Vector, clamp_fine, shift_half_even},
};

/// Fraction bits of a factor.
const FACTOR_BITS: u32 = 16;

/// An affine transform: a point (x, y) goes to `(xx x + xy y, yx x + yy y) + by`.
///
/// Factors are in 1/65536, -32768 to 32767.99998. Points are rounded once to 1/4096 pixel; those that leave the range
/// saturate.
///
/// # Examples
///
/// ```
/// use spanfill::{Angle, FinePoint, Transform};
///
/// let around = FinePoint::whole(12, 12);
/// let transform = Transform::turned_about(around, Angle::QUARTER).then(Transform::scaled(2 << 16, 2 << 16));
/// assert_eq!(transform.apply(FinePoint::whole(13, 12)), FinePoint::whole(24, 26));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Transform {
    /// Factors in 1/65536.
    xx: i32,
    xy: i32,
    yx: i32,
    yy: i32,
    by: FinePoint,
}

impl Transform {
    /// Everything stays where it is.
    pub const IDENTITY: Self = Self::new([[1 << FACTOR_BITS, 0], [0, 1 << FACTOR_BITS]], FinePoint::from_bits(0, 0));

    /// Factors by rows, in 1/65536, and where the origin goes.
    #[inline]
    pub const fn new([[xx, xy], [yx, yy]]: [[i32; 2]; 2], by: FinePoint) -> Self {
        Self { xx, xy, yx, yy, by }
    }

    /// Moves by a distance.
    #[inline]
    pub const fn moved(by: FinePoint) -> Self {
        Self { by, ..Self::IDENTITY }
    }

    /// Scales about the origin, by factors in 1/65536.
    #[inline]
    pub const fn scaled(x: i32, y: i32) -> Self {
        Self { xx: x, yy: y, ..Self::IDENTITY }
    }

    /// Turns about the origin.
    #[inline]
    pub const fn turned(angle: Angle) -> Self {
        let (sin, cos) = angle.sin_cos();
        let (sin, cos) = (round_factor(sin as i128, 14), round_factor(cos as i128, 14));
        Self { xx: cos, xy: -sin, yx: sin, yy: cos, by: FinePoint::from_bits(0, 0) }
    }

    /// Turns about a point.
    #[inline]
    pub const fn turned_about(center: FinePoint, angle: Angle) -> Self {
        let turn = Self::turned(angle);
        let moved = turn.apply(center);
        Self { by: FinePoint::clamped(center.x as i64 - moved.x as i64, center.y as i64 - moved.y as i64), ..turn }
    }

    /// This first, and then the other.
    pub const fn then(self, other: Self) -> Self {
        const fn sum(a: i32, b: i32, c: i32, d: i32) -> i32 {
            round_factor(a as i128 * b as i128 + c as i128 * d as i128, FACTOR_BITS)
        }
        Self {
            xx: sum(other.xx, self.xx, other.xy, self.yx),
            xy: sum(other.xx, self.xy, other.xy, self.yy),
            yx: sum(other.yx, self.xx, other.yy, self.yx),
            yy: sum(other.yx, self.xy, other.yy, self.yy),
            by: other.apply(self.by),
        }
    }

    /// Where a point goes.
    #[inline]
    pub const fn apply(&self, FinePoint { x, y }: FinePoint) -> FinePoint {
        const fn row(a: i32, x: i32, b: i32, y: i32, by: i32) -> i32 {
            // Each product is at most 2^62.
            let sum = (a as i64 * x as i64).saturating_add(b as i64 * y as i64);
            clamp_fine(shift_half_even(sum, FACTOR_BITS) + by as i64)
        }
        FinePoint { x: row(self.xx, x, self.xy, y, self.by.x), y: row(self.yx, x, self.yy, y, self.by.y) }
    }

    /// Whether what was clockwise no longer is.
    pub(super) const fn mirrors(&self) -> bool {
        (self.xx as i64 * self.yy as i64) < self.xy as i64 * self.yx as i64
    }

    /// The half axes of an ellipse, turned and then transformed, with eight fraction bits more than points.
    pub(crate) const fn axes(&self, radii: FinePoint, rotation: Angle) -> [Vector; 2] {
        let (sin, cos) = rotation.sin_cos();
        [self.axis(radii.x, cos, sin), self.axis(radii.y, sin.saturating_neg(), cos)]
    }

    const fn axis(&self, radius: i32, along: i32, across: i32) -> Vector {
        const fn row(a: i32, x: i64, b: i32, y: i64) -> i64 {
            // What is larger than any coordinate is cut off.
            const MOST: i128 = 1 << 40;
            let sum = (a as i128 * x as i128 + b as i128 * y as i128) >> FACTOR_BITS;
            #[allow(clippy::cast_possible_truncation, reason = "compared")]
            let row = if sum > MOST {
                MOST as i64
            } else if sum < -MOST {
                -MOST as i64
            } else {
                sum as i64
            };
            row
        }
        let radius = radius.unsigned_abs() as i64;
        // In 2^-20 pixel: a radius of 12 bits times a sine of 30.
        let x = shift_half_even(radius * along as i64, 22);
        let y = shift_half_even(radius * across as i64, 22);
        Vector::new(row(self.xx, x, self.xy, y), row(self.yx, x, self.yy, y))
    }
}

impl Default for Transform {
    #[inline]
    fn default() -> Self {
        Self::IDENTITY
    }
}

const fn round_factor(value: i128, bits: u32) -> i32 {
    let nearest = (value + (1 << (bits - 1))) >> bits;
    #[allow(clippy::cast_possible_truncation, reason = "a sum of two products of 32 bits")]
    let nearest = nearest as i64;
    clamp_fine(nearest)
}
