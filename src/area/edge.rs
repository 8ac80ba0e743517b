//! A straight edge, and what it leaves of the pixels of a row to its right.
//!
//! ```text
//!     column   i     i + 1  i + 2
//!            |   /#|#####|#####|          nothing before its first column, a trapezoid in each that it crosses,
//!            |  /##|#####|#####|          and all of its height after its last
//!            | /###|#####|#####|
//! ```
//!
//! On an edge x is `x0 + (y - y0) slope`, with `slope = dx / dy` cut off at 2^-32, as on a [chain](super::chain): within 2^-19
//! pixel of the true line, and the same whichever row the clip begins at. Within a row, distances and heights have 24 bits
//! behind the point. Where the edge leaves a column depends on the edge and the column alone, so no clip changes a bit.

use core::hint::black_box;

use crate::area::{
    cell::{CELL_BITS, WHOLE, column_of, trapezoid, within},
    division::ratio,
    pair::Side,
    source::{FINE_BITS, FINE_ONE, Point},
    steepness::{Steepness, height_of},
};

/// An edge that goes down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// At its upper end, in 2^-32 pixel.
    x: i64,
    slope: i64,
    steepness: Steepness,
    /// Its ends, in 2^-16 pixel.
    pub(super) top: i32,
    pub(super) bottom: i32,
    /// 1 on the left side, -1 on the right.
    sign: i32,
}

impl Edge {
    /// From one vertex of a clockwise contour to the next; none where it is flat.
    pub(super) fn new(from: Point, to: Point) -> Option<Self> {
        let (upper, lower, sign) = if from.y < to.y { (from, to, -1) } else { (to, from, 1) };
        if upper.y == lower.y {
            return None;
        }
        let slope = ratio(lower.x.abs_diff(upper.x), lower.y.abs_diff(upper.y));
        let steepness = Steepness::of_slope(slope);
        let slope = if lower.x < upper.x { slope.cast_signed().wrapping_neg() } else { slope.cast_signed() };
        let x = i64::from(upper.x) << FINE_BITS;
        Some(Self { x, slope, steepness, top: upper.y, bottom: lower.y, sign })
    }

    #[inline]
    fn x_at(&self, y: i32) -> i64 {
        self.x.wrapping_add(self.slope.wrapping_mul(i64::from(y - self.top)) >> FINE_BITS)
    }

    /// What a row has of it.
    #[inline]
    pub(super) fn piece(&self, row_top: i32) -> Option<Piece> {
        let (from, to) = (self.top.max(row_top), self.bottom.min(row_top + FINE_ONE));
        if from >= to {
            return None;
        }
        let (a, b) = (self.x_at(from), self.x_at(to));
        let (left, right) = if self.slope < 0 { (b, a) } else { (a, b) };
        let Self { slope, steepness, sign, .. } = *self;
        let height = (to - from).unsigned_abs() << (CELL_BITS - FINE_BITS);
        Some(Piece { side: Side { left, right, steepness }, slope, height, sign })
    }
}

/// What a row has of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) side: Side,
    slope: i64,
    /// How much of the row's height it takes, in 2^-24 pixel.
    height: u32,
    sign: i32,
}

impl Piece {
    /// What the next row has of an edge that crosses both.
    #[inline]
    pub(super) fn step(&mut self) {
        self.side.left = self.side.left.wrapping_add(self.slope);
        self.side.right = self.side.right.wrapping_add(self.slope);
    }

    /// Whether it crosses the row from top to bottom.
    #[inline]
    pub(super) fn is_whole(&self) -> bool {
        self.height == WHOLE
    }

    #[inline]
    pub(super) fn is_left(&self) -> bool {
        self.sign > 0
    }

    /// What it adds to a pixel to the right of it, in 2^-24 pixel.
    #[inline]
    pub(super) fn beyond(&self) -> i32 {
        self.sign.wrapping_mul(self.height.cast_signed())
    }

    /// Adds what it leaves of the columns from `start` on to its right, or takes it away.
    pub(super) fn add(&self, start: i32, areas: &mut [i32]) {
        let Self { side: Side { left, right, steepness }, height, sign, .. } = *self;
        let (mut column, last) = (column_of(left).wrapping_sub(start), column_of(right).wrapping_sub(start));
        let (mut x, mut gone) = (within(left), 0);
        let mut areas = areas.iter_mut().skip(column.max(0).unsigned_abs() as usize);
        if column < last && last >= 0 {
            // To where it leaves its first column, and from there to where it leaves the last one that is not seen.
            let (mut product, per_column) = (steepness.product(WHOLE - x), steepness.product(WHOLE));
            if column < 0 {
                let unseen = u64::from(column.unsigned_abs()) - 1;
                product = product.wrapping_add(per_column.wrapping_mul(unseen));
                gone = height_of(product).min(height);
                product = product.wrapping_add(per_column);
                (column, x) = (0, 0);
            }
            while column < last {
                let Some(area) = areas.next() else { return };
                let at = height_of(product).min(height);
                *area = area.wrapping_add(sign.wrapping_mul((at - trapezoid(x + WHOLE, at - gone)).cast_signed()));
                product = product.wrapping_add(per_column);
                (gone, x) = (at, 0);
                column += 1;
            }
        }
        if last >= 0
            && let Some(area) = areas.next()
        {
            let beside = trapezoid(x + within(right), height - gone);
            *area = area.wrapping_add(sign.wrapping_mul((height - beside).cast_signed()));
        }
        for area in areas {
            black_box(());
            *area = area.wrapping_add(self.beyond());
        }
    }
}
