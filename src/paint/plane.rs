//! Places that are planes over the screen.

use crate::{Vertex, paint::stops::WHOLE, subpixel::centre};

/// How a plane changes with x and y, in `2^-48` of a gradient a sub-pixel.
pub(super) type Slope = [i64; 2];

/// Fraction bits of a slope.
pub(super) const SLOPE_BITS: u32 = 48;

/// Beyond, a plane runs through a million gradients a pixel: nothing is seen of that but noise.
const STEEPEST: i128 = 1 << 60;

/// A numerator in `2^-48` over a denominator, to the nearest; 0 over 0.
pub(super) fn slope(numerator: i128, denominator: i128) -> i64 {
    let (numerator, denominator) =
        if denominator < 0 { (numerator.saturating_neg(), -denominator) } else { (numerator, denominator) };
    let nearest = numerator.saturating_add(denominator / 2).div_euclid(denominator.max(1));
    i64::try_from(nearest.clamp(-STEEPEST, STEEPEST)).unwrap_or(0)
}

/// From one vertex to another, in sub-pixels.
pub(super) fn difference(from: Vertex, to: Vertex) -> [i128; 2] {
    [
        i128::from(to.x.to_bits()) - i128::from(from.x.to_bits()),
        i128::from(to.y.to_bits()) - i128::from(from.y.to_bits()),
    ]
}

/// A plane: `offset` at `origin`, in `2^-32` of a gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Plane {
    pub(super) origin: Vertex,
    pub(super) offset: i64,
    pub(super) slope: Slope,
}

/// Far beyond, no gradient has anything but its ends; repeated ones lose their phase.
const REACH: i128 = (WHOLE as i128) << 29;

impl Plane {
    /// The places of the pixels of a row, from a column on. A slope is off by `2^-49`, so that places up to 2^32 sub-pixels from
    /// the origin are exact to `2^-17` of a gradient; steps lose nothing, so it does not matter where a row begins.
    #[inline]
    pub(super) fn row(&self, row: i32, column: i32) -> Places {
        let [gx, gy] = self.slope.map(i128::from);
        let x = i128::from(centre(column)) - i128::from(self.origin.x.to_bits());
        let y = i128::from(centre(row)) - i128::from(self.origin.y.to_bits());
        // Below 2^95: 2^60 times twice a distance of 2^33.
        Places { at: gx * x + gy * y + (i128::from(self.offset) << 16), step: gx << 8 }
    }
}

/// Places in a line, in `2^-48` of a gradient.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places {
    at: i128,
    step: i128,
}

impl Places {
    /// One for all of them.
    pub(super) fn alike(place: i64) -> Self {
        Self { at: i128::from(place) << 16, step: 0 }
    }
}

impl Iterator for Places {
    type Item = i64;

    #[inline]
    fn next(&mut self) -> Option<i64> {
        let place = (self.at >> 16).clamp(-REACH, REACH);
        self.at = self.at.wrapping_add(self.step);
        i64::try_from(place).ok()
    }
}
