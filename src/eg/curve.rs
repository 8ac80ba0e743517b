//! How wide an ellipse is on a row: embedded-graphics' own inequality, without its overflow.

use core::ops::Range;

/// Up to this size in pixels the inequality fits `i64`: 3 (2^15)^4 < 2^62.
const STEPPED_SIZE: i64 = 1 << 15;

/// An ellipse in doubled coordinates around its middle: `b x^2 + a y^2 < limit`.
///
/// `a` and `b` are the squares of its width and height, `limit` their product; of a circle all are divided by the
/// square of the diameter. The circle of three pixels has a smaller limit, which leaves out its corners, as in
/// embedded-graphics.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    width: i64,
    height: i64,
    a: u64,
    b: u64,
    limit: u128,
    /// The answer on the last row, and at first the pixel nearest to the middle: the outline moves little from row to row.
    last: i64,
}

impl Curve {
    pub(super) fn new(width: i64, height: i64) -> Self {
        let [width, height] = [width, height].map(|size| size.clamp(0, u32::MAX.into()));
        let (a, b) = (width.cast_unsigned().pow(2), height.cast_unsigned().pow(2));
        let (a, b, limit) = match a == b {
            true => (1, 1, u128::from(if width == 3 { 8 } else { a })),
            false => (a, b, u128::from(a) * u128::from(b)),
        };
        // Half of the pixels lie at odd distances from the middle of an even size.
        Self { width, height, a, b, limit, last: 1 - (width & 1) }
    }

    /// The columns on a row, around twice the middle.
    pub(super) fn columns(&mut self, row: i64, (x, y): (i64, i64)) -> Range<i64> {
        match self.reach(2 * row - y) {
            Some(reach) => (x - reach) >> 1..((x + reach) >> 1) + 1,
            None => 0..0,
        }
    }

    /// The farthest pixel from the middle on the row `y` from it, in doubled coordinates. None when there is none.
    pub(super) fn reach(&mut self, y: i64) -> Option<i64> {
        let nearest = 1 - (self.width & 1);
        if y.abs() >= self.height || self.width <= 0 {
            return None;
        }
        if self.width < STEPPED_SIZE && self.height < STEPPED_SIZE {
            let (a, b) = (self.a.cast_signed(), self.b.cast_signed());
            #[allow(clippy::cast_possible_truncation, reason = "below 2^60: STEPPED_SIZE")]
            let rest = a * y * y - self.limit as i64;
            let is_inside = |x: i64| b * x * x + rest < 0;
            if !is_inside(nearest) {
                return None;
            }
            while is_inside(self.last + 2) {
                self.last += 2;
            }
            while !is_inside(self.last) {
                self.last -= 2;
            }
            return Some(self.last);
        }
        let square = |value: i64| u128::from(value.unsigned_abs()) * u128::from(value.unsigned_abs());
        // y is less than the height: the product is less than the limit of an ellipse, and of a circle smaller yet.
        let rest = self.limit.saturating_sub(u128::from(self.a) * square(y));
        // x is less than the width, and so b x^2 less than 2^128.
        let is_inside = |steps: i64| u128::from(self.b) * square(nearest + 2 * steps) < rest;
        // One inside, and one beyond the width.
        let (mut inside, mut outside) = (0, (self.width + 1) / 2);
        while outside - inside > 1 {
            let middle = inside + (outside - inside) / 2;
            if is_inside(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        is_inside(inside).then_some(nearest + 2 * inside)
    }
}
