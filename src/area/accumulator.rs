//! Signed areas of a row of pixels, added up in whatever order, for a window of columns at a time.
//!
//! A segment that goes down from (x0, y0) to (x1, y1) covers everything to its right, between its two heights. What it
//! changes from one column to the next is kept: the running sum over the columns is the coverage.
//!
//! ```text
//!     column   i     i + 1
//!            |   /#|#####|          d: how much of the row's height the segment takes in column i
//!            |  /##|#####|          a: what of d is to its left in column i, a trapezoid
//!            | /###|#####|          difference[i] += d - a,  difference[i + 1] += a
//! ```
//!
//! Sums are in 2^-24 pixel and wrap: only the last one has to be right. Where a segment leads from a column to the next its
//! height is cut off to 2^-24, once for both, by a formula that knows the segment and the column alone: so no window, and no
//! clip, changes a bit.
//!
//! The method is that of accumulation buffers and cell rasterizers (R. Levien, "font-rs", 2016; D. Turner, FreeType's
//! smooth rasterizer, 2001), with weights for what the fill rule makes of a segment.

use crate::area::{
    cell::{CELL_BITS, WHOLE, column_of, trapezoid, within},
    source::FINE_BITS,
    steepness::{Steepness, height_of},
};

/// How many columns a window has: as many as a word has bits.
pub(crate) const WINDOW: usize = usize::BITS as usize;

/// The same, as a column.
pub(crate) const WINDOW_COLUMNS: i32 = usize::BITS.cast_signed();

/// The differences of a window.
#[derive(Debug)]
pub(crate) struct Accumulator {
    differences: [i32; WINDOW + 1],
    /// A bit for each column in which something changes.
    pub(crate) touched: usize,
    /// The window's first column.
    left: i32,
    /// What is covered of each pixel to the left.
    pub(crate) base: i32,
}

impl Accumulator {
    pub(crate) const fn new() -> Self {
        Self { differences: [0; WINDOW + 1], touched: 0, left: 0, base: 0 }
    }

    /// Moves an empty window.
    #[inline]
    pub(crate) fn begin(&mut self, column: i32, base: i32) {
        self.left = column;
        self.base = base;
    }

    /// Forgets what was added.
    pub(crate) fn clear(&mut self) {
        self.differences = [0; WINDOW + 1];
        self.touched = 0;
    }

    /// Adds a segment between `x0` and `x1`, in 2^-32 pixel, which goes down `dy`, in 2^-16 pixel and at most one.
    #[inline]
    pub(crate) fn add(&mut self, x0: i64, x1: i64, dy: i32, weight: i32, steepness: impl FnOnce() -> Steepness) {
        let column = column_of(x0);
        let index = column.wrapping_sub(self.left).cast_unsigned();
        let dy = height(dy);
        if column == column_of(x1) && index < usize::BITS {
            self.within_column(index as usize, within(x0) + within(x1), dy, weight);
        } else {
            self.outside_or_wide(x0.min(x1), x0.max(x1), dy, weight, steepness);
        }
    }

    /// Adds a segment within a column, `x0` and `x1` from its left side, in 2^-24 pixel and less than one.
    #[inline]
    pub(crate) fn add_to_column(&mut self, column: i32, (x0, x1): (u32, u32), dy: i32, weight: i32) {
        let index = column.wrapping_sub(self.left);
        if index < 0 {
            self.add_to_the_left(height(dy), weight);
        } else if index < WINDOW_COLUMNS {
            self.within_column(index.cast_unsigned() as usize, x0 + x1, height(dy), weight);
        }
    }

    /// `twice_x` is twice the segment's mean distance from the column's left side.
    #[inline]
    fn within_column(&mut self, index: usize, twice_x: u32, dy: u32, weight: i32) {
        let left = trapezoid(twice_x, dy);
        if let Some([here, next]) = self.differences.get_mut(index..).and_then(|rest| rest.first_chunk_mut::<2>()) {
            *here = here.wrapping_add((dy - left).cast_signed().wrapping_mul(weight));
            *next = next.wrapping_add(left.cast_signed().wrapping_mul(weight));
        }
        self.touched |= (1 | usize::from(left != 0) << 1) << index;
    }

    #[inline]
    fn outside_or_wide(&mut self, x0: i64, x1: i64, dy: u32, weight: i32, steepness: impl FnOnce() -> Steepness) {
        let (first, last) = (column_of(x0).wrapping_sub(self.left), column_of(x1).wrapping_sub(self.left));
        if last < 0 {
            self.add_to_the_left(dy, weight);
        } else if first < WINDOW_COLUMNS {
            self.wide(x0, x1, dy, weight, steepness());
        }
    }

    fn add_to_the_left(&mut self, dy: u32, weight: i32) {
        let [first, ..] = &mut self.differences;
        *first = first.wrapping_add(dy.cast_signed().wrapping_mul(weight));
        self.touched |= 1;
    }

    /// A segment of more than one column, maybe partly to the left; `x0 < x1`.
    #[inline(never)]
    fn wide(&mut self, x0: i64, x1: i64, dy: u32, weight: i32, steepness: Steepness) {
        let (mut column, last) = (column_of(x0).wrapping_sub(self.left), column_of(x1).wrapping_sub(self.left));
        let (mut x, mut gone) = (within(x0), 0);
        let (mut product, per_column) = (steepness.product(WHOLE - x), steepness.product(WHOLE));
        if column < 0 {
            // To where it enters the window.
            let unseen = u64::from(column.unsigned_abs()) - 1;
            product = product.wrapping_add(per_column.wrapping_mul(unseen));
            gone = height_of(product).min(dy);
            self.add_to_the_left(gone, weight);
            product = product.wrapping_add(per_column);
            (column, x) = (0, 0);
        }
        while column < last.min(WINDOW_COLUMNS) {
            let at = height_of(product).min(dy);
            self.within_column(column.cast_unsigned() as usize, x + WHOLE, at - gone, weight);
            (gone, x) = (at, 0);
            column += 1;
            product = product.wrapping_add(per_column);
        }
        if column < WINDOW_COLUMNS {
            self.within_column(column.cast_unsigned() as usize, x + within(x1), dy - gone, weight);
        }
    }

    /// Turns the differences of some columns into sums.
    #[inline]
    pub(crate) fn sums(&mut self, sum: &mut i32, from: usize, length: usize) -> &[i32] {
        let columns = self.differences.get_mut(from..from + length).unwrap_or_default();
        for difference in &mut *columns {
            *sum = sum.wrapping_add(*difference);
            *difference = *sum;
        }
        columns
    }

    /// Forgets what lies beyond the window's end.
    #[inline]
    pub(crate) fn clear_rest(&mut self, touched: usize) {
        if touched != 0 {
            self.clear();
        }
        let [.., last] = &mut self.differences;
        *last = 0;
    }

    /// Zeroes what has been handed over.
    #[inline]
    pub(crate) fn forget(&mut self, from: usize, length: usize) {
        self.differences.get_mut(from..from + length).unwrap_or_default().fill(0);
    }
}

/// From 2^-16 pixel to 2^-24.
#[inline]
fn height(dy: i32) -> u32 {
    dy.unsigned_abs() << (CELL_BITS - FINE_BITS)
}
