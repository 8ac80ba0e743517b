//! Floats of both sizes; what `core` lacks of roundings is `libm`'s.

use core::{
    fmt::Debug,
    ops::{Add, Div, Mul, Neg, Sub},
};

use super::Number;

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
