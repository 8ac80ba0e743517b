//! The numbers that published rasterizers are written in: floats, and integers with a fixed number of fraction bits.
//!
//! Integers wrap, as those of published code do; a float that becomes an integer goes towards zero and saturates, NaN is
//! 0: what Java's `(int)` promises, and what C's does where it promises anything.

use core::{
    fmt::Debug,
    ops::{Add, Div, Mul, Neg, Sub},
};

/// A float: what vertices are given in, and what a setup is worked out in.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// 0.
    const ZERO: Self;
    /// 1/2: what lies between a pixel's corner and its centre.
    const HALF: Self;
    /// 1.
    const ONE: Self;

    /// A coordinate in 1/256 pixel, rounded to the nearest number.
    fn from_subpixels(subpixels: i32) -> Self;

    /// A whole number, rounded to the nearest number.
    fn from_integer(integer: i32) -> Self;

    /// The same value, rounded to the nearest number.
    fn from_f64(value: f64) -> Self;

    /// The same value.
    fn to_f64(self) -> f64;

    /// Towards zero: `(int) x`.
    fn truncate(self) -> i32;

    /// The whole number at or below.
    fn floor(self) -> i32;

    /// The whole number at or above.
    fn ceil(self) -> i32;

    /// The sign bit, which -0 and some NaNs have, too.
    fn sign_bit(self) -> bool;

    /// The nearest whole number, halves upwards.
    #[inline(always)]
    fn round(self) -> i32 {
        (self + Self::HALF).floor()
    }

    /// The smaller of two; the second where one is NaN.
    #[inline(always)]
    fn at_most(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    /// The larger of two; the second where one is NaN.
    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

macro_rules! real {
    ($real:ident, $floor:ident, $ceil:ident) => {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            clippy::cast_lossless,
            reason = "rounding to the nearest number and saturating are what the trait promises"
        )]
        impl Real for $real {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;

            #[inline(always)]
            fn from_subpixels(subpixels: i32) -> Self {
                // A power of two: rounds once.
                subpixels as Self / 256.0
            }

            #[inline(always)]
            fn from_integer(integer: i32) -> Self {
                integer as Self
            }

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as Self
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }

            #[inline(always)]
            fn truncate(self) -> i32 {
                self as i32
            }

            #[inline(always)]
            fn floor(self) -> i32 {
                libm::$floor(self) as i32
            }

            #[inline(always)]
            fn ceil(self) -> i32 {
                libm::$ceil(self) as i32
            }

            #[inline(always)]
            fn sign_bit(self) -> bool {
                self.is_sign_negative()
            }
        }
    };
}

real!(f32, floorf, ceilf);
real!(f64, floor, ceil);

/// A number that an edge equation's coefficients and values are kept in.
///
/// Coefficients are worked out in [`Setup`](Number::Setup) and converted; from there on values are only added, and
/// multiplied by whole pixels.
pub trait Number: Copy + Debug {
    /// What vertices are given in and coefficients are worked out in.
    type Setup: Real;

    /// Converts a coefficient: `(int) (a * (1 << F))`.
    fn from_setup(value: Self::Setup) -> Self;

    /// The value of a coefficient.
    fn to_setup(self) -> Self::Setup;

    /// The sum; wraps.
    fn plus(self, other: Self) -> Self;

    /// The negative; wraps.
    fn negated(self) -> Self;

    /// Whether it is below 0.
    fn is_negative(self) -> bool;

    /// Whether it is at or above 0, which NaN is not.
    fn is_at_least_zero(self) -> bool;

    /// Whether it is above 0.
    fn is_positive(self) -> bool;

    /// Its sign bit alone.
    fn sign_bit(self) -> bool;

    /// `a x + b y + c` at the corner of pixel (x, y) or at its centre; wraps.
    fn plane(a: Self, b: Self, c: Self, x: i32, y: i32, at_centre: bool) -> Self;
}

macro_rules! float_number {
    ($real:ident) => {
        impl Number for $real {
            type Setup = $real;

            #[inline(always)]
            fn from_setup(value: $real) -> Self {
                value
            }

            #[inline(always)]
            fn to_setup(self) -> $real {
                self
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }

            #[inline(always)]
            fn negated(self) -> Self {
                -self
            }

            #[inline(always)]
            fn is_negative(self) -> bool {
                self < 0.0
            }

            #[inline(always)]
            fn is_at_least_zero(self) -> bool {
                self >= 0.0
            }

            #[inline(always)]
            fn is_positive(self) -> bool {
                self > 0.0
            }

            #[inline(always)]
            fn sign_bit(self) -> bool {
                self.is_sign_negative()
            }

            #[inline(always)]
            fn plane(a: Self, b: Self, c: Self, x: i32, y: i32, at_centre: bool) -> Self {
                let offset = if at_centre { 0.5 } else { 0.0 };
                a * ($real::from_integer(x) + offset) + b * ($real::from_integer(y) + offset) + c
            }
        }
    };
}

float_number!(f32);
float_number!(f64);

/// The word that a fixed-point number is kept in.
pub trait Word: Copy + Debug + PartialOrd {
    /// 0.
    const ZERO: Self;

    /// Towards zero, saturating, NaN is 0.
    fn from_f64(value: f64) -> Self;

    /// The nearest float.
    fn to_f64(self) -> f64;

    /// A whole number.
    fn from_integer(integer: i32) -> Self;

    /// The sum; wraps.
    fn plus(self, other: Self) -> Self;

    /// The product; wraps.
    fn times(self, other: Self) -> Self;

    /// Half of it, rounded down.
    fn halved(self) -> Self;

    /// Times a power of two; wraps.
    fn shifted_left(self, bits: u32) -> Self;

    /// The pixel that holds a coordinate with `bits` fraction bits; saturates.
    fn pixel(self, bits: u32) -> i32;
}

macro_rules! word {
    ($word:ident) => {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            clippy::cast_lossless,
            reason = "saturates, as `(int)` does; a whole number of 32 bits fits"
        )]
        impl Word for $word {
            const ZERO: Self = 0;

            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as Self
            }

            #[inline(always)]
            fn from_integer(integer: i32) -> Self {
                integer as Self
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }

            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self.wrapping_mul(other)
            }

            #[inline(always)]
            fn halved(self) -> Self {
                self >> 1
            }

            #[inline(always)]
            fn shifted_left(self, bits: u32) -> Self {
                self.wrapping_shl(bits)
            }

            #[inline(always)]
            fn pixel(self, bits: u32) -> i32 {
                (self.wrapping_shr(bits) as i64).clamp(i32::MIN as i64, i32::MAX as i64) as i32
            }
        }
    };
}

word!(i32);
word!(i64);

/// A number with `F` fraction bits in a word of 32 or 64.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fixed<W, const F: u32>(pub W);

impl<W: Word, const F: u32> Number for Fixed<W, F> {
    /// The notes' setup is in doubles.
    type Setup = f64;

    #[inline(always)]
    fn from_setup(value: f64) -> Self {
        Self(W::from_f64(value * f64::from_integer(1_i32.wrapping_shl(F))))
    }

    #[inline(always)]
    fn to_setup(self) -> f64 {
        self.0.to_f64() / f64::from_integer(1_i32.wrapping_shl(F))
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0.plus(other.0))
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self(self.0.times(W::from_integer(-1)))
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        self.0 < W::ZERO
    }

    #[inline(always)]
    fn is_at_least_zero(self) -> bool {
        self.0 >= W::ZERO
    }

    #[inline(always)]
    fn is_positive(self) -> bool {
        self.0 > W::ZERO
    }

    #[inline(always)]
    fn sign_bit(self) -> bool {
        self.0 < W::ZERO
    }

    #[inline(always)]
    fn plane(a: Self, b: Self, c: Self, x: i32, y: i32, at_centre: bool) -> Self {
        let value = a.0.times(W::from_integer(x)).plus(b.0.times(W::from_integer(y))).plus(c.0);
        Self(if at_centre { value.plus(a.0.plus(b.0).halved()) } else { value })
    }
}
