//! An edge that is walked with its exact remainder.
//!
//! Source: Bresenham, *Algorithm for computer control of a digital plotter*, 1965, with a divisor that is not 1; the
//! lecture notes "Triangle Rasterization" (Purdue) for the walk.
//!
//! ```text
//! x(Y) - 1/2 px = ((x0 - 128) dy + (Y - y0) dx) / dy        in columns: over 256 dy
//! ```
//!
//! Quotient and remainder are stepped by the quotient and the remainder of `256 dx / (256 dy)`: two divisions an edge,
//! and x is right on every row. For vertices within 2^30 of the origin.

use super::{
    edge_walk::Side,
    exact::{PIXEL, ceil_to_centre, centre},
};

/// The column at or left of the edge, and what is left of a column, in parts of `256 dy`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ExactDda {
    column: i32,
    step: i32,
    remainder: i64,
    remainder_step: i64,
    divisor: i64,
}

/// The quotient rounded down, and the remainder; the divisor is positive.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "of coordinates of 32 bits; wraps where the edge is not walked")]
fn divided(value: i64, divisor: i64) -> (i32, i64) {
    (value.div_euclid(divisor) as i32, value.rem_euclid(divisor))
}

impl Side for ExactDda {
    type Coordinate = i32;

    #[inline(always)]
    fn on_row([x0, y0]: [i32; 2], [x1, y1]: [i32; 2], row: i32) -> Self {
        let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(i64::from);
        // Never 0 where an edge is walked; 1 rather than a panic.
        let (dx, dy) = (x1 - x0, (y1 - y0).max(1));
        let divisor = PIXEL * dy;
        let value = (x0 - PIXEL / 2).wrapping_mul(dy).wrapping_add((centre(row) - y0).wrapping_mul(dx));
        let (column, remainder) = divided(value, divisor);
        let (step, remainder_step) = divided(PIXEL * dx, divisor);
        Self { column, step, remainder, remainder_step, divisor }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.column = self.column.wrapping_add(self.step);
        self.remainder += self.remainder_step;
        if self.remainder >= self.divisor {
            self.remainder -= self.divisor;
            self.column = self.column.wrapping_add(1);
        }
    }

    #[inline(always)]
    fn ceil(&self) -> i32 {
        self.column.wrapping_add(i32::from(self.remainder > 0))
    }

    #[inline(always)]
    fn floor(&self) -> i32 {
        self.column
    }

    #[inline(always)]
    fn ceil_row(y: i32) -> i32 {
        ceil_to_centre(y)
    }

    #[inline(always)]
    fn floor_row(y: i32) -> i32 {
        y.saturating_sub(128) >> 8
    }

    #[inline(always)]
    fn breaks_right([[x0, y0], [x1, y1], [x2, y2]]: &[[i32; 2]; 3]) -> bool {
        let difference = |a: &i32, b: &i32| i64::from(*a) - i64::from(*b);
        let product = |a: i64, b: i64| a.wrapping_mul(b);
        product(difference(x1, x0), difference(y2, y0)) > product(difference(x2, x0), difference(y1, y0))
    }
}
