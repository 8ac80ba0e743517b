//! How far a segment goes down over a distance along x.

use crate::area::{division::share, source::FINE_ONE};

/// `((distance << up) * factor) >> (32 + down)`, one of the two shifts being 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steepness {
    /// 0 only for what has not been worked out.
    pub(super) factor: u32,
    pub(super) up: u8,
    pub(super) down: u8,
}

impl Steepness {
    /// Not worked out.
    pub(super) const UNKNOWN: Self = Self { factor: 0, up: 0, down: 0 };

    /// Of what moves by `slope`, in 2^-32 pixel, while it goes down a pixel.
    #[inline]
    pub(super) fn of_slope(slope: u64) -> Self {
        Self::of_segment(slope, FINE_ONE.unsigned_abs())
    }

    /// Of what moves by `dx`, in 2^-32 pixel, while it goes down `dy`, in 2^-16 pixel and at most a pixel.
    ///
    /// `dx` is `d 2^(32 - z)`, with `d` of 32 bits, the highest of them set, and `z` its leading zeros: `dy / dx` is
    /// `(dy 2^47 / d) 2^(z - 63)` for `dy` in 2^-16 pixel, in which the quotient has at most 32 bits.
    #[inline]
    pub(super) fn of_segment(dx: u64, dy: u32) -> Self {
        let zeros = dx.leading_zeros();
        #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
        let factor = share(dy, (dx << (zeros & 63) >> 32) as u32);
        #[allow(clippy::cast_possible_truncation, reason = "at most 33")]
        let (up, down) = (zeros.saturating_sub(31) as u8, 31_u32.saturating_sub(zeros) as u8);
        Self { factor, up, down }
    }

    /// In 2^-56 pixel, for a distance in 2^-24 pixel that is not wider than the segment.
    #[inline]
    pub(super) fn product(self, distance: u32) -> u64 {
        (u64::from(distance << (self.up & 31)) * u64::from(self.factor)) >> (self.down & 31)
    }
}

/// From 2^-56 pixel to 2^-24.
#[inline]
pub(super) fn height_of(product: u64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let height = (product >> 32) as u32;
    height
}
