//! An edge that is walked by a float digital differential analyzer: `x += dx / dy`.
//!
//! Source: the lecture notes "Triangle Rasterization" (Purdue), "DDA method", and "Rasterization", "DDA algorithm".
//!
//! A step rounds to the spacing of floats near x, so after n rows x may be off by n half spacings: with `f32` at
//! 256..512 px, 2^-16 px a row, beside the slope's own rounding times n.

use super::{super::number::Real, edge_walk::Side};

/// x at the centre of a row, and the inverse slope.
#[derive(Debug, Clone, Copy)]
pub struct FloatDda<R> {
    x: R,
    step: R,
}

impl<R: Real> FloatDda<R> {
    /// Where the edge is, in pixels.
    #[inline(always)]
    pub fn x(&self) -> R {
        self.x
    }
}

impl<R: Real> Side for FloatDda<R> {
    type Coordinate = R;

    #[inline(always)]
    fn on_row([x0, y0]: [R; 2], [x1, y1]: [R; 2], row: i32) -> Self {
        let step = (x1 - x0) / (y1 - y0);
        let offset = R::from_integer(row) + R::HALF - y0;
        Self { x: x0 + offset * step, step }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x = self.x + self.step;
    }

    #[inline(always)]
    fn ceil(&self) -> i32 {
        (self.x - R::HALF).ceil()
    }

    #[inline(always)]
    fn floor(&self) -> i32 {
        (self.x - R::HALF).floor()
    }

    #[inline(always)]
    fn ceil_row(y: R) -> i32 {
        (y - R::HALF).ceil()
    }

    #[inline(always)]
    fn floor_row(y: R) -> i32 {
        (y - R::HALF).floor()
    }

    #[inline(always)]
    fn breaks_right([[x0, y0], [x1, y1], [x2, y2]]: &[[R; 2]; 3]) -> bool {
        (*x1 - *x0) * (*y2 - *y0) > (*x2 - *x0) * (*y1 - *y0)
    }
}
