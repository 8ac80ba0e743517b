//! x and 1/m in fixed point.

use core::ops::Range;

use super::Crossing;

/// x and 1/m in 32 bits, `F` of them behind the binary point, as are the vertices; F from 1 to 30.
///
/// 1/m is cut off, so that x lags by up to 2^-F for each row of the edge. Integers wrap: with 16 bits, 32768 pixels
/// away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fixed<const F: u32> {
    x: i32,
    inverse_slope: i32,
}

impl<const F: u32> Fixed<F> {
    const HALF: i32 = 1 << (F - 1);

    /// The first pixel whose centre is at a coordinate or beyond it.
    fn first_centre(coordinate: i32) -> i32 {
        coordinate.wrapping_add(Self::HALF - 1) >> F
    }
}

impl<const F: u32> Crossing for Fixed<F> {
    type Number = i32;

    const UNUSED: Self = Self { x: 0, inverse_slope: 0 };

    fn rows([a, b]: [[i32; 2]; 2]) -> Option<(Range<i32>, bool)> {
        let (top, bottom) = (a[1].min(b[1]), a[1].max(b[1]));
        (top < bottom).then(|| (Self::first_centre(top)..Self::first_centre(bottom), a[1] < b[1]))
    }

    #[allow(clippy::cast_possible_truncation, reason = "integers wrap, as published code does")]
    fn at_row([a, b]: [[i32; 2]; 2], row: i32) -> Self {
        let (low, high) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let (dx, dy) = (i64::from(high[0]) - i64::from(low[0]), i64::from(high[1]) - i64::from(low[1]));
        let inverse_slope = (dx << F).checked_div(dy).unwrap_or(0) as i32;
        let down = row.wrapping_shl(F).wrapping_add(Self::HALF).wrapping_sub(low[1]);
        let x = low[0].wrapping_add((i64::from(down).wrapping_mul(inverse_slope.into()) >> F) as i32);
        Self { x, inverse_slope }
    }

    fn step(&mut self) {
        self.x = self.x.wrapping_add(self.inverse_slope);
    }

    fn is_left_of(&self, other: &Self) -> bool {
        self.x < other.x
    }

    fn column(&self) -> i32 {
        Self::first_centre(self.x)
    }
}
