//! Integers with fraction bits; sums and products wrap.

use core::fmt::Debug;

use super::{Number, Real};

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
