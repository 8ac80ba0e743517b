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
//! pixel of the true line, and the same whichever row the clip begins at.

use crate::area::{
    accumulator::Steepness,
    division::ratio,
    row::Sides,
    source::{FINE_BITS, FINE_ONE, Point},
};

/// Bits behind the binary point of distances and heights within a pixel.
const CELL_BITS: u32 = 20;

/// A pixel in that unit.
const CELL_ONE: i32 = 1 << CELL_BITS;

/// From that unit to that of areas.
const FINER: u32 = 4;

/// An edge that goes down, and where it is in the current row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// At the bottom of the row, or at its own lower end there, in 2^-32 pixel.
    x: i64,
    /// At the top of the row, or at its own upper end there.
    x_top: i64,
    slope: i64,
    steepness: Steepness,
    /// Its ends, in 2^-16 pixel.
    pub(super) top: i32,
    pub(super) bottom: i32,
    /// How much of the row's height it takes, in 2^-20 pixel.
    height: i32,
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
        let steepness = Steepness::of_step(slope);
        let slope = if lower.x < upper.x { slope.cast_signed().wrapping_neg() } else { slope.cast_signed() };
        let x = i64::from(upper.x) << FINE_BITS;
        Some(Self { x, x_top: x, slope, steepness, top: upper.y, bottom: lower.y, height: 0, sign })
    }

    /// Moves to the row that the clip begins with.
    #[inline]
    pub(super) fn skip_to(&mut self, row_top: i32) {
        self.move_down((row_top.min(self.bottom) - self.top).max(0));
    }

    #[inline]
    fn move_down(&mut self, dy: i32) {
        self.x = self.x.wrapping_add(self.slope.wrapping_mul(i64::from(dy)) >> FINE_BITS);
    }

    /// Moves from the row above to this one; whether it has a part in it.
    #[inline]
    pub(super) fn advance(&mut self, row_top: i32) -> bool {
        let (from, to) = (self.top.max(row_top), self.bottom.min(row_top + FINE_ONE));
        self.height = (to - from).max(0) << (CELL_BITS - FINE_BITS);
        self.x_top = self.x;
        if self.height == CELL_ONE {
            self.x = self.x.wrapping_add(self.slope);
        } else if self.height > 0 {
            self.move_down(to - from);
        }
        self.height > 0
    }

    /// The leftmost and the rightmost column of its part in the row.
    #[inline]
    pub(super) fn columns(&self) -> (i32, i32) {
        let (a, b) = (column_of(self.x_top), column_of(self.x));
        (a.min(b), a.max(b))
    }

    #[inline]
    pub(super) fn is_left(&self) -> bool {
        self.sign > 0
    }

    /// What its part in the row adds to a pixel to the right of it, in 2^-24 pixel.
    #[inline]
    pub(super) fn signed_area(&self) -> i32 {
        self.sign.wrapping_mul(self.height << FINER)
    }

    /// Whether its part in the row is one of some sides.
    #[inline]
    pub(super) fn is_of(&self, sides: Sides) -> bool {
        self.height > 0
            && match sides {
                Sides::Left => self.sign > 0,
                Sides::Right => self.sign < 0,
                Sides::Both => true,
            }
    }

    /// Adds what it leaves of the columns from `start` on to its right, or takes it away.
    pub(super) fn add(&self, start: i32, areas: &mut [i32]) {
        let Self { height, sign, steepness, .. } = *self;
        let (x0, x1) = if self.slope < 0 { (self.x, self.x_top) } else { (self.x_top, self.x) };
        let (mut column, last) = (column_of(x0).wrapping_sub(start), column_of(x1).wrapping_sub(start));
        let (mut x, mut gone) = (within(x0), 0);
        if column < last {
            // Where it leaves the first column that is not to the left of all.
            let border = i64::from(column.max(-1).wrapping_add(start).wrapping_add(1)) << 32;
            let mut product = steepness.over(border.wrapping_sub(x0).cast_unsigned());
            let per_column = steepness.over(1 << 32);
            if column < 0 && last >= 0 {
                gone = steepness.height(product).min(height);
                product = product.wrapping_add(per_column);
                (column, x) = (0, 0);
            }
            let crossed = column.max(0).unsigned_abs() as usize..last.max(0).unsigned_abs() as usize;
            let end = crossed.end.min(areas.len());
            for area in areas.get_mut(crossed.start..end).unwrap_or_default() {
                let at = steepness.height(product).min(height);
                *area = area.wrapping_add(sign.wrapping_mul((at << FINER) - trapezoid(x + CELL_ONE, at - gone)));
                (gone, x) = (at, 0);
                product = product.wrapping_add(per_column);
            }
        }
        let mut after = last.wrapping_add(1).max(0).unsigned_abs() as usize;
        if last >= 0
            && let Some(area) = areas.get_mut(after - 1)
        {
            *area = area.wrapping_add(sign.wrapping_mul((height << FINER) - trapezoid(x + within(x1), height - gone)));
        }
        after = after.min(areas.len());
        for area in areas.get_mut(after..).unwrap_or_default() {
            *area = area.wrapping_add(self.signed_area());
        }
    }
}

/// The column of an x in 2^-32 pixel.
#[inline]
fn column_of(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let column = (x >> 32) as i32;
    column
}

/// How far within its column, in 2^-20 pixel.
#[inline]
fn within(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "20 bits of the lower half")]
    let within = ((x as u32) >> (32 - CELL_BITS)).cast_signed();
    within
}

/// `twice_x` at most 2^21, `dy` at most 2^20: 41 bits.
#[inline]
fn trapezoid(twice_x: i32, dy: i32) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^24")]
    let area = ((i64::from(twice_x) * i64::from(dy)) >> (2 * CELL_BITS + 1 - 24)) as i32;
    area
}
