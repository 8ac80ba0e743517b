//! How wide an ellipse is on a row: embedded-graphics' own inequality, without its overflow.

use core::ops::Range;

/// Up to this size in pixels the inequality fits `i64`: 3 (2^15)^4 < 2^62.
const STEPPED_SIZE: u64 = 1 << 15;

/// An ellipse in doubled coordinates around its middle: `b x^2 + a y^2 < limit`.
///
/// `a` and `b` are the squares of its width and height, `limit` their product; of a circle all are divided by the
/// square of the diameter. Circles of up to four pixels have a smaller limit, which leaves out the corners of the one
/// of three, as in embedded-graphics.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    width: u64,
    height: u64,
    a: u64,
    b: u64,
    limit: u128,
    /// The answer on the last row: the outline moves little from row to row.
    last: i64,
}

impl Curve {
    pub(super) fn new(width: i64, height: i64) -> Self {
        let clamped = |size: i64| size.clamp(0, u32::MAX.into()).cast_unsigned();
        let (width, height) = (clamped(width), clamped(height));
        let (a, b) = (width * width, height * height);
        if a == b {
            let limit = if width <= 4 { a - width / 2 } else { a };
            Self { width, height, a: 1, b: 1, limit: limit.into(), last: -1 }
        } else {
            Self { width, height, a, b, limit: u128::from(a) * u128::from(b), last: -1 }
        }
    }

    /// The columns on a row, around twice the middle column.
    pub(super) fn columns(&mut self, y: i64, center_2x: i64) -> Range<i64> {
        match self.reach(y) {
            Some(x) => (center_2x - x) >> 1..((center_2x + x) >> 1) + 1,
            None => 0..0,
        }
    }

    /// The farthest pixel from the middle on the row `y` from it, in doubled coordinates. None when there is none.
    pub(super) fn reach(&mut self, y: i64) -> Option<i64> {
        if y.unsigned_abs() >= self.height {
            return None;
        }
        if self.width < STEPPED_SIZE && self.height < STEPPED_SIZE {
            let (a, b) = (self.a.cast_signed(), self.b.cast_signed());
            #[allow(clippy::cast_possible_truncation, reason = "below 2^60: STEPPED_SIZE")]
            let rest = a * y * y - self.limit as i64;
            self.nearby(|x| b * x * x + rest < 0)
        } else {
            let square = |value: u64| u128::from(value) * u128::from(value);
            // y is less than the height: the product is less than the limit of an ellipse, and of a circle smaller yet.
            let rest = self.limit.saturating_sub(u128::from(self.a) * square(y.unsigned_abs()));
            let b = u128::from(self.b);
            // x is less than the width, and so b x^2 less than 2^128.
            self.bisected(|x| b * square(x.unsigned_abs()) < rest)
        }
    }

    /// Half of the pixels lie at odd distances from the middle of an even size.
    fn nearest(&self) -> i64 {
        i64::from(self.width.is_multiple_of(2))
    }

    fn nearby(&mut self, is_inside: impl Fn(i64) -> bool) -> Option<i64> {
        if !is_inside(self.nearest()) {
            return None;
        }
        if self.last < 0 {
            return self.bisected(is_inside);
        }
        while is_inside(self.last + 2) {
            self.last += 2;
        }
        while !is_inside(self.last) {
            self.last -= 2;
        }
        Some(self.last)
    }

    fn bisected(&mut self, is_inside: impl Fn(i64) -> bool) -> Option<i64> {
        let nearest = self.nearest();
        let at = |steps: i64| nearest + 2 * steps;
        if self.width == 0 || !is_inside(nearest) {
            return None;
        }
        // One inside, and one beyond the width.
        let (mut inside, mut outside) = (0, (self.width.cast_signed() + 1) / 2);
        while outside - inside > 1 {
            let middle = inside + (outside - inside) / 2;
            if is_inside(at(middle)) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        self.last = at(inside);
        Some(self.last)
    }
}
