//! Points with 12 fraction bits, and roundings that mirror and move along.

use fixed::{traits::ToFixed, types::I20F12};

use crate::Vertex;

/// A point that is made, as those of a curve are: in 1/4096 pixel, -524288 to 524287.9998 pixels.
///
/// [`Vertex`] has 1/256: rounding to that may change a pixel's coverage by 1/255, rounding to this by 1/16 of that.
///
/// # Examples
///
/// ```
/// use spanfill::{FinePoint, Vertex};
///
/// assert_eq!(FinePoint::new(1.5, -2), FinePoint::from_bits(6144, -8192));
/// assert_eq!(FinePoint::from(Vertex::new(1.5, -2)), FinePoint::new(1.5, -2));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct FinePoint {
    /// In 1/4096 pixel to the right of the left edge of column 0.
    pub x: i32,
    /// In 1/4096 pixel below the top edge of row 0.
    pub y: i32,
}

impl FinePoint {
    /// A point in pixels, from anything `fixed` converts; what lies beyond the range saturates, NaN is 0.
    pub fn new<X, Y>(x: X, y: Y) -> Self
    where
        X: ToFixed + Copy,
        Y: ToFixed + Copy,
        I20F12: PartialOrd<X> + PartialOrd<Y>,
    {
        Self { x: saturate(x), y: saturate(y) }
    }

    /// A point in 1/4096 pixel.
    #[inline]
    pub const fn from_bits(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// A point in whole pixels; saturating.
    #[inline]
    pub const fn whole(x: i32, y: i32) -> Self {
        Self { x: x.saturating_mul(4096), y: y.saturating_mul(4096) }
    }

    /// A vertex, exactly; one beyond 524288 pixels saturates. The `const` form of `FinePoint::from`.
    #[inline]
    pub const fn from_vertex(vertex: Vertex) -> Self {
        Self { x: vertex.x.to_bits().saturating_mul(16), y: vertex.y.to_bits().saturating_mul(16) }
    }

    /// The nearest vertex; half way, the even one.
    #[inline]
    pub const fn to_vertex(self) -> Vertex {
        const fn nearest(fine: i32) -> i32 {
            let floor = fine >> 4;
            floor + ((fine & 15) + (floor & 1) > 8) as i32
        }
        Vertex::from_bits(nearest(self.x), nearest(self.y))
    }

    #[inline]
    pub(crate) const fn clamped(x: i64, y: i64) -> Self {
        Self { x: clamp_fine(x), y: clamp_fine(y) }
    }
}

impl From<Vertex> for FinePoint {
    #[inline]
    fn from(vertex: Vertex) -> Self {
        Self::from_vertex(vertex)
    }
}

fn saturate<T: ToFixed + Copy>(value: T) -> i32
where
    I20F12: PartialOrd<T>,
{
    match value.checked_to_fixed::<I20F12>() {
        Some(coordinate) => coordinate.to_bits(),
        None if I20F12::ZERO < value => i32::MAX,
        None if I20F12::ZERO > value => i32::MIN,
        None => 0,
    }
}

/// The nearest coordinate.
#[inline]
pub(crate) const fn clamp_fine(value: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "clamped")]
    let clamped = if value < i32::MIN as i64 {
        i32::MIN
    } else if value > i32::MAX as i64 {
        i32::MAX
    } else {
        value as i32
    };
    clamped
}

/// `value / 2^bits` to the nearest, half way to the even: the same for what is mirrored or moved by an even number.
/// `bits` from 1 to 62.
#[inline]
pub(crate) const fn shift_half_even(value: i64, bits: u32) -> i64 {
    let floor = value >> bits;
    let rest = value - (floor << bits);
    let half = 1 << (bits - 1);
    floor + (rest + (floor & 1) > half) as i64
}

/// The same of more bits.
#[inline]
pub(crate) const fn shift_half_even_wide(value: i128, bits: u32) -> i128 {
    let floor = value >> bits;
    let rest = value - (floor << bits);
    floor + (rest + (floor & 1) > 1 << (bits - 1)) as i128
}

/// `value / divisor` to the nearest, half way to the even. 0 for no divisor.
#[inline]
pub(crate) const fn divide_half_even(value: i128, divisor: i128) -> i128 {
    if divisor <= 0 {
        return 0;
    }
    let floor = value.div_euclid(divisor);
    let rest = value - floor * divisor;
    floor + (rest > divisor - rest || (rest == divisor - rest && floor & 1 == 1)) as i128
}

/// From one point to another, in 1/4096 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(crate) struct Vector {
    pub(crate) x: i64,
    pub(crate) y: i64,
}

impl Vector {
    #[inline]
    pub(crate) const fn new(x: i64, y: i64) -> Self {
        Self { x, y }
    }

    #[inline]
    pub(crate) const fn between(from: FinePoint, to: FinePoint) -> Self {
        Self { x: to.x as i64 - from.x as i64, y: to.y as i64 - from.y as i64 }
    }

    #[inline]
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }

    #[inline]
    pub(crate) const fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }

    #[inline]
    pub(crate) const fn times(self, factor: i64) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }

    #[inline]
    pub(crate) const fn over(self, divisor: i64) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor }
    }

    #[inline]
    pub(crate) const fn dot(self, other: Self) -> i128 {
        self.x as i128 * other.x as i128 + self.y as i128 * other.y as i128
    }

    /// A quarter of a turn clockwise.
    #[inline]
    pub(crate) const fn turned(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    #[inline]
    pub(crate) const fn is_zero(self) -> bool {
        self.x == 0 && self.y == 0
    }

    /// At least its length, at most an eighth more: the longer part and half of the shorter.
    #[inline]
    pub(crate) const fn length_at_most(self) -> u64 {
        let (x, y) = (self.x.unsigned_abs(), self.y.unsigned_abs());
        if x > y { x + y.div_ceil(2) } else { y + x.div_ceil(2) }
    }

    /// Where it leads to.
    #[inline]
    pub(crate) const fn from(self, point: FinePoint) -> FinePoint {
        FinePoint::clamped(point.x as i64 + self.x, point.y as i64 + self.y)
    }
}

/// A rectangle with its bounds in 1/4096 pixel, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FineRect {
    /// The upper left corner.
    pub low: FinePoint,
    /// The lower right corner. Left of or above the other when there is nothing.
    pub high: FinePoint,
}

impl FineRect {
    /// Around nothing.
    pub const EMPTY: Self =
        Self { low: FinePoint::from_bits(i32::MAX, i32::MAX), high: FinePoint::from_bits(i32::MIN, i32::MIN) };

    /// Grows to hold a point.
    #[inline]
    pub const fn add(&mut self, FinePoint { x, y }: FinePoint) {
        let Self { low, high } = self;
        if x < low.x {
            low.x = x;
        }
        if y < low.y {
            low.y = y;
        }
        if x > high.x {
            high.x = x;
        }
        if y > high.y {
            high.y = y;
        }
    }

    /// Grows by a margin on all sides.
    #[must_use]
    pub const fn grown(self, margin: i32) -> Self {
        let Self { low, high } = self;
        if low.x > high.x || low.y > high.y {
            return self;
        }
        Self {
            low: FinePoint::from_bits(low.x.saturating_sub(margin), low.y.saturating_sub(margin)),
            high: FinePoint::from_bits(high.x.saturating_add(margin), high.y.saturating_add(margin)),
        }
    }

    /// The pixels that have anything in common with it.
    pub fn pixels(&self) -> crate::PixelRect {
        let Self { low, high } = *self;
        if low.x >= high.x || low.y >= high.y {
            return crate::PixelRect { rows: 0..0, columns: 0..0 };
        }
        let pixels = |low: i32, high: i32| low >> 12..((high - 1) >> 12) + 1;
        crate::PixelRect { rows: pixels(low.y, high.y), columns: pixels(low.x, high.x) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roundings_are_mirrored_and_moved() {
        for value in -300..=300_i64 {
            let nearest = shift_half_even(value, 4);
            assert!((value - 16 * nearest).abs() <= 8);
            assert_eq!(shift_half_even(-value, 4), -nearest);
            assert_eq!(shift_half_even(value + 32, 4), nearest + 2);
            assert_eq!(divide_half_even(value.into(), 16), i128::from(nearest));
            let vertex = FinePoint::clamped(value, 0).to_vertex();
            assert_eq!(i64::from(vertex.x.to_bits()), nearest);
        }
        assert_eq!(divide_half_even(7, 0), 0);
        assert_eq!(FinePoint::from_bits(i32::MAX, i32::MIN).to_vertex(), Vertex::from_bits(1 << 27, -(1 << 27)));
    }

    #[test]
    fn the_ends_of_the_range_saturate() {
        let far = FinePoint::from_vertex(Vertex::from_bits(i32::MAX, i32::MIN));
        assert_eq!(far, FinePoint::from_bits(i32::MAX, i32::MIN));
        assert_eq!(FinePoint::new(1e9, f32::NAN), FinePoint::from_bits(i32::MAX, 0));
        assert_eq!(FinePoint::clamped(i64::MIN, i64::MAX), FinePoint::from_bits(i32::MIN, i32::MAX));
        assert_eq!(FineRect::EMPTY.grown(9), FineRect::EMPTY);
    }
}
