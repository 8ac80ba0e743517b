//! x as a quotient and a remainder, 1/m as another.

use core::ops::Range;

use super::Crossing;

/// x as an exact fraction, of vertices in 1/256 pixel.
///
/// A centre `256 c + 128` lies at x or to the right of it when
///
/// ```text
///   c >= N / D,   N = (Xlow - 128) dy + (row's centre - Ylow) dx,   D = 256 dy
/// ```
///
/// One row down adds `256 dx` to N. Quotients are rounded up and carried along with their remainders: nothing is
/// lost. With `dx` and `dy` of 33 bits, N has 67, remainders have 41.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exact {
    /// The quotient, rounded up.
    column: i32,
    column_step: i32,
    /// What the quotient is too large by, 0..D; and what each step adds to that.
    excess: i64,
    excess_step: i64,
    denominator: i64,
}

impl Crossing for Exact {
    type Number = i32;

    const UNUSED: Self = Self { column: 0, column_step: 0, excess: 0, excess_step: 0, denominator: 1 };

    fn rows([a, b]: [[i32; 2]; 2]) -> Option<(Range<i32>, bool)> {
        let (top, bottom) = (a[1].min(b[1]), a[1].max(b[1]));
        (top < bottom).then(|| (first_centre(top)..first_centre(bottom), a[1] < b[1]))
    }

    fn at_row([a, b]: [[i32; 2]; 2], row: i32) -> Self {
        let ([x_low, y_low], [x_high, y_high]) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let (dx, dy) = (i64::from(x_high) - i64::from(x_low), i64::from(y_high) - i64::from(y_low));
        let down = i64::from(row) * 256 + 128 - i64::from(y_low);
        let denominator = 256 * dy;
        let numerator = i128::from(i64::from(x_low) - 128) * i128::from(dy) + i128::from(down) * i128::from(dx);
        let (column, excess) = divide_up(numerator, denominator);
        let (column_step, excess_step) = divide_up(256 * i128::from(dx), denominator);
        Self { column, column_step, excess, excess_step, denominator }
    }

    fn step(&mut self) {
        self.column = self.column.wrapping_add(self.column_step);
        self.excess = self.excess.wrapping_add(self.excess_step);
        if self.excess >= self.denominator {
            self.excess = self.excess.wrapping_sub(self.denominator);
            self.column = self.column.wrapping_sub(1);
        }
    }

    /// Only columns are told apart: between edges of the same one there is nothing to fill.
    fn is_left_of(&self, other: &Self) -> bool {
        self.column < other.column
    }

    fn column(&self) -> i32 {
        self.column
    }
}

fn first_centre(coordinate: i32) -> i32 {
    // Rounded up: (coordinate - 128) / 256, which fits whatever the coordinate.
    (coordinate >> 8) + i32::from(coordinate & 255 > 128)
}

/// The quotient, rounded up, and what it is too large by, in units of the denominator's.
#[allow(
    clippy::cast_possible_truncation,
    reason = "a column on an edge, or one row's step: at most 2^32 / 256 times 256"
)]
fn divide_up(numerator: i128, denominator: i64) -> (i32, i64) {
    let denominator = i128::from(denominator.max(1));
    let quotient = -(-numerator).div_euclid(denominator);
    (quotient as i32, (quotient * denominator - numerator) as i64)
}
