//! Which pixels an outlined circle has, around a whole pixel and with a radius of whole pixels: in each column of the
//! octant 0 <= x <= y the one nearest to the true circle, and the seven mirror images. Whole numbers alone.

/// The outline of a circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Ring {
    pub(crate) center: [i64; 2],
    pub(crate) radius: i64,
}

impl Ring {
    /// Whether (x, y) of the octant is the pixel of its column: `y - 1/2 < sqrt(r^2 - x^2) < y + 1/2`, squared.
    ///
    /// `(y - 1/2)^2 = y^2 - y + 1/4` is never whole, so that no column has two pixels, or none.
    fn is_in_octant(self, x: i64, y: i64) -> bool {
        let square = self.radius * self.radius - x * x;
        (y == 0 || y * y - y < square) && square <= y * y + y
    }

    /// Whether the pixel is one of the outline's.
    pub(crate) fn has(self, column: i32, row: i32) -> bool {
        let (x, y) = ((i64::from(column) - self.center[0]).abs(), (i64::from(row) - self.center[1]).abs());
        self.is_in_octant(x.min(y), x.max(y))
    }

    /// Whether the pixel lies on the outline or within it: in its row, between two pixels of the outline.
    pub(crate) fn holds(self, column: i32, row: i32) -> bool {
        let (x, y) = ((i64::from(column) - self.center[0]).abs(), (i64::from(row) - self.center[1]).abs());
        let has = |x: i64| x >= 0 && self.is_in_octant(x.min(y), x.max(y));
        // The farthest pixel of the row is the one nearest to the circle, or, where the circle is flat, the last that is
        // nearest in its column: y^2 - y < r^2 - x^2.
        let square = self.radius * self.radius - y * y;
        let nearest = square.max(0).isqrt();
        let last = (square + y - 1).max(0).isqrt();
        [nearest, nearest + 1, last].into_iter().any(|farthest| x <= farthest && has(farthest))
    }

    /// The same, by looking at all of the row.
    pub(crate) fn holds_by_search(self, column: i32, row: i32) -> bool {
        let (x, y) = ((i64::from(column) - self.center[0]).abs(), (i64::from(row) - self.center[1]).abs());
        (x..=self.radius).any(|x| self.is_in_octant(x.min(y), x.max(y)))
    }
}
