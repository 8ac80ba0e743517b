//! The numbers that published rasterizers are written in: floats, and integers with a fixed number of fraction bits.
//!
//! Integers wrap, as those of published code do; a float that becomes an integer goes towards zero and saturates, NaN is
//! 0: what Java's `(int)` promises, and what C's does where it promises anything.

mod fixed;
mod real;

use core::fmt::Debug;

pub use fixed::{Fixed, Word};
pub use real::Real;

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
