//! The words that planes are kept in, and their divisions.
//!
//! Twice a triangle's area, `A`, is at most the area of the bounding box, and so fits 64 bits for every triangle there is, and 32
//! bits for boxes up to 256 x 256 px.

use core::fmt::Debug;

/// What remainders are kept in, with a number that holds products.
pub(crate) trait Word: Copy + Debug {
    type Product: Copy + Debug;

    fn overflowing_add(self, other: Self) -> (Self, bool);
    fn less(self, other: Self) -> bool;
    fn wrapping_add(self, other: Self) -> Self;
    fn wrapping_sub(self, other: Self) -> Self;

    /// `a b - c d`.
    fn cross(a: i64, b: i64, c: i64, d: i64) -> Self::Product;

    /// `256 n`, divided by `area`: quotient modulo 2^32, and remainder.
    fn per_pixel(n: Self::Product, area: Self) -> (i32, Self);

    /// `gx x + gy y + area / 2`, divided by `area`; the value is one inside the triangle.
    fn divided(gx: Self::Product, gy: Self::Product, x: i64, y: i64, area: Self) -> (i32, Self);
}

/// For areas below 2^32, values that differ by less than 2^31 and vertices less than 2^22 from the first.
///
/// `|gx|` is twice an area in the plane of `c` and `y`, so at most `2^31 * 2^23`, and `256 gx` fits 63 bits. Inside the
/// triangle `gx x + gy y` is `A (c - c0)`, at most `(2^32 - 1) (2^31 - 1)`: its terms may wrap, their sum does not, nor with
/// half an area more.
impl Word for u32 {
    type Product = i64;

    #[inline(always)]
    fn overflowing_add(self, other: Self) -> (Self, bool) {
        self.overflowing_add(other)
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }

    #[inline(always)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i64 {
        #[allow(clippy::cast_possible_truncation, reason = "differences of this path have 32 bits, see above")]
        let product = |a: i64, b: i64| i64::from(a as i32) * i64::from(b as i32);
        product(a, b).wrapping_sub(product(c, d))
    }

    #[inline(always)]
    fn per_pixel(n: i64, area: u32) -> (i32, u32) {
        divide_narrow(n << 8, area)
    }

    #[inline(always)]
    fn divided(gx: i64, gy: i64, x: i64, y: i64, area: u32) -> (i32, u32) {
        let n = gx.wrapping_mul(x).wrapping_add(gy.wrapping_mul(y));
        divide_narrow(n.wrapping_add(i64::from(area / 2)), area)
    }
}

/// Floor and remainder; by the processor's own division where the numerator has 32 bits.
#[inline]
fn divide_narrow(n: i64, area: u32) -> (i32, u32) {
    let area = area.max(1);
    let magnitude = n.unsigned_abs();
    let (quotient, remainder) = match u32::try_from(magnitude) {
        Ok(magnitude) => (magnitude / area, magnitude % area),
        Err(_) => divide_long(magnitude, area),
    };
    if n >= 0 {
        (quotient.cast_signed(), remainder)
    } else if remainder == 0 {
        (quotient.wrapping_neg().cast_signed(), 0)
    } else {
        ((!quotient).cast_signed(), area - remainder)
    }
}

/// The quotient modulo 2^32.
#[cfg(target_pointer_width = "64")]
#[inline]
fn divide_long(magnitude: u64, area: u32) -> (u32, u32) {
    let area = u64::from(area.max(1));
    #[allow(clippy::cast_possible_truncation, reason = "the quotient is wanted modulo 2^32, the remainder is less")]
    let parts = ((magnitude / area) as u32, (magnitude % area) as u32);
    parts
}

#[cfg(not(target_pointer_width = "64"))]
use divide_by_digits as divide_long;

/// The quotient modulo 2^32, by three divisions of 32 bits: a fifth of what the compiler's own takes.
///
/// The upper word only counts by its remainder. Two digits of 16 bits follow, as by hand: with the divisor shifted up
/// until its highest bit is set, a digit guessed from its upper half is at most two too large (D. E. Knuth, "The art
/// of computer programming", volume 2, 4.3.1, algorithm D).
#[cfg(any(test, not(target_pointer_width = "64")))]
#[inline(never)]
fn divide_by_digits(magnitude: u64, area: u32) -> (u32, u32) {
    let area = area.max(1);
    #[allow(clippy::cast_possible_truncation, reason = "the two words")]
    let (high, low) = ((magnitude >> 32) as u32 % area, magnitude as u32);
    let shift = area.leading_zeros();
    let divisor = area << shift;
    let shifted = ((u64::from(high) << 32) | u64::from(low)) << shift;
    #[allow(clippy::cast_possible_truncation, reason = "the two words")]
    let (high, low) = ((shifted >> 32) as u32, shifted as u32);
    // Never below 2^15; the compiler does not know.
    let (upper, lower) = ((divisor >> 16).max(1), divisor & 0xffff);
    let digit = |rest: u32, next: u32| {
        let (mut digit, guess_rest) = (rest / upper, rest % upper);
        let mut left = guess_rest;
        while digit > 0xffff || digit.wrapping_mul(lower) > ((left << 16) | next) {
            digit = digit.wrapping_sub(1);
            left = left.wrapping_add(upper);
            if left > 0xffff {
                break;
            }
        }
        let rest = (rest << 16).wrapping_add(next).wrapping_sub(digit.wrapping_mul(divisor));
        (digit, rest)
    };
    let (first, rest) = digit(high, low >> 16);
    let (second, rest) = digit(rest, low & 0xffff);
    ((first << 16).wrapping_add(second), rest >> shift)
}

/// For everything: `|256 gx| < 2^74`, and `gx x` below 2^99.
impl Word for u64 {
    type Product = i128;

    #[inline(always)]
    fn overflowing_add(self, other: Self) -> (Self, bool) {
        self.overflowing_add(other)
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }

    #[inline(never)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i128 {
        i128::from(a).wrapping_mul(i128::from(b)).wrapping_sub(i128::from(c).wrapping_mul(i128::from(d)))
    }

    #[inline]
    fn per_pixel(n: i128, area: u64) -> (i32, u64) {
        divide_wide(n << 8, area)
    }

    #[inline]
    fn divided(gx: i128, gy: i128, x: i64, y: i64, area: u64) -> (i32, u64) {
        let n = gx.wrapping_mul(i128::from(x)).wrapping_add(gy.wrapping_mul(i128::from(y)));
        divide_wide(n.wrapping_add(i128::from(area / 2)), area)
    }
}

#[inline(never)]
fn divide_wide(n: i128, area: u64) -> (i32, u64) {
    let area = i128::from(area).max(1);
    let (mut quotient, mut remainder) = (n / area, n % area);
    if remainder < 0 {
        remainder += area;
        quotient -= 1;
    }
    #[allow(clippy::cast_possible_truncation, reason = "the quotient is wanted modulo 2^32")]
    let quotient = quotient as i32;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 <= remainder < area")]
    let remainder = remainder as u64;
    (quotient, remainder)
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, reason = "what is tested is modulo 2^32")]
mod tests {
    use super::*;

    #[test]
    fn long_divisions_are_the_same_in_any_words() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state ^ (state >> 29)
        };
        for _ in 0..1_000_000 {
            let magnitude = next() >> (next() % 64);
            let area = ((next() >> 32) as u32 >> (next() % 32)).max(1);
            let expected = ((magnitude / u64::from(area)) as u32, (magnitude % u64::from(area)) as u32);
            assert_eq!(divide_by_digits(magnitude, area), expected, "{magnitude} {area}");
        }
    }
}
