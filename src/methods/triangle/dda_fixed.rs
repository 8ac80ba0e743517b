//! An edge that is walked by a fixed-point digital differential analyzer: `x += (dx << F) / dy`.
//!
//! Source: the lecture notes "Triangle Rasterization" (Purdue), "DDA method"; the usual 16.16 is Hecker's, *Perspective
//! texture mapping*, Game Developer 1995-96.
//!
//! Steps add up without rounding, but the slope is cut to `F` bits: after n rows x is off by up to `n 2^-F` px to one
//! side, as division goes towards zero. In 32 bits, 16 fraction bits leave 32768 px; slopes beyond, of edges that run
//! almost along a row, wrap.

use super::edge_walk::Side;

/// x at the centre of a row, and the inverse slope, with `F` fraction bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FixedDda<const F: u32> {
    x: i32,
    step: i32,
}

impl<const F: u32> FixedDda<F> {
    const HALF: i32 = 1 << (F - 1);
    const BELOW_ONE: i32 = (1 << F) - 1;

    /// A vertex in 1/256 px as one with `F` fraction bits; wraps.
    #[inline(always)]
    pub fn vertex(subpixels: [i32; 2]) -> [i32; 2] {
        subpixels.map(|value| if F < 8 { value >> (8 - F) } else { value.wrapping_shl(F - 8) })
    }
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "words of 32 bits wrap, as those of published code do")]
fn narrow(value: i64) -> i32 {
    value as i32
}

impl<const F: u32> Side for FixedDda<F> {
    type Coordinate = i32;

    #[inline(always)]
    fn on_row([x0, y0]: [i32; 2], [x1, y1]: [i32; 2], row: i32) -> Self {
        let (dx, dy) = (i64::from(x1) - i64::from(x0), i64::from(y1) - i64::from(y0));
        // Never 0 where an edge is walked; 1 rather than a panic.
        let step = narrow((dx << F) / dy.max(1));
        let centre = row.wrapping_shl(F).wrapping_add(Self::HALF);
        let offset = i64::from(centre.wrapping_sub(y0)) * i64::from(step);
        Self { x: x0.wrapping_add(narrow(offset >> F)), step }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }

    #[inline(always)]
    fn ceil(&self) -> i32 {
        Self::ceil_row(self.x)
    }

    #[inline(always)]
    fn floor(&self) -> i32 {
        Self::floor_row(self.x)
    }

    #[inline(always)]
    fn ceil_row(y: i32) -> i32 {
        y.wrapping_sub(Self::HALF).wrapping_add(Self::BELOW_ONE) >> F
    }

    #[inline(always)]
    fn floor_row(y: i32) -> i32 {
        y.wrapping_sub(Self::HALF) >> F
    }

    #[inline(always)]
    fn breaks_right([[x0, y0], [x1, y1], [x2, y2]]: &[[i32; 2]; 3]) -> bool {
        let difference = |a: &i32, b: &i32| i64::from(*a) - i64::from(*b);
        let product = |a: i64, b: i64| a.wrapping_mul(b);
        product(difference(x1, x0), difference(y2, y0)) > product(difference(x2, x0), difference(y1, y0))
    }
}
