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
//! Sums are in 2^-24 pixel and wrap: only the last one has to be right. Within a column, distances and heights have 20
//! bits behind the point, so that a trapezoid is a product of 41 bits, cut off to 2^-24. Where a segment leads from a column
//! to the next its height is rounded to 2^-20, once for both, by a formula that knows the segment and the column alone: so
//! no window, and no clip, changes a bit.
//!
//! The method is that of accumulation buffers and cell rasterizers (R. Levien, "font-rs", 2016; D. Turner, FreeType's
//! smooth rasterizer, 2001), with weights for what the fill rule makes of a segment.

use crate::area::{
    division::share,
    source::{FINE_BITS, FINE_ONE},
};

/// Bits behind the binary point of distances and heights within a pixel.
const CELL_BITS: u32 = 20;

/// A pixel in that unit.
const CELL_ONE: i32 = 1 << CELL_BITS;

/// A whole pixel's area.
pub(crate) const FULL: i32 = 1 << 24;

/// How many columns a window has: as many as a word has bits.
pub(crate) const WINDOW: usize = usize::BITS as usize;

/// The same, as a column.
pub(crate) const WINDOW_COLUMNS: i32 = usize::BITS.cast_signed();

/// How far a segment goes down over a distance along x, `(distance * factor) >> shift` for distances in 2^-16 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Steepness {
    pub(super) factor: u32,
    pub(super) shift: u8,
}

impl Steepness {
    /// Of what moves by `step`, in 2^-32 pixel, while it goes down a pixel; not 0.
    #[inline]
    pub(crate) fn of_step(step: u64) -> Self {
        Self::of_segment(step, FINE_ONE.unsigned_abs())
    }

    /// Of what moves by `dx`, in 2^-32 pixel and not 0, while it goes down `dy`, in 2^-16 pixel and at most a pixel.
    ///
    /// `dx` is `d 2^(32 - z)`, with `d` of 32 bits, the highest of them set, and `z` its leading zeros. A distance of 2^-16
    /// pixel is worth `dy 2^16 / dx` in 2^-16 pixel: `(dy 2^47 / d) 2^(z - 63)`, in which the quotient has at most 32 bits.
    #[inline]
    pub(crate) fn of_segment(dx: u64, dy: u32) -> Self {
        let zeros = dx.leading_zeros();
        #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
        let factor = share(dy, (dx << (zeros & 63) >> 32) as u32);
        #[allow(clippy::cast_possible_truncation, reason = "at most 63")]
        let shift = 63_u32.saturating_sub(zeros) as u8;
        Self { factor, shift }
    }

    /// For a distance in 2^-32 pixel.
    #[inline]
    fn over(self, distance: u64) -> u64 {
        (distance >> FINE_BITS).wrapping_mul(u64::from(self.factor))
    }

    /// What that is in 2^-20 pixel, to the nearest.
    #[inline]
    fn height(self, product: u64) -> i32 {
        const FINER: u32 = CELL_BITS - FINE_BITS;
        let shift = u32::from(self.shift & 63);
        let height = if shift > FINER { (product >> (shift - FINER - 1)).wrapping_add(1) >> 1 } else { product };
        i32::try_from(height).unwrap_or(i32::MAX)
    }
}

/// What a line that crosses a whole row, from `x0` to `x1` in 2^-32 pixel, leaves of each of its columns to its right; how many
/// there are, if there is room for them. The same bits as by an [`Accumulator`].
#[inline]
pub(super) fn areas_beside(
    (x0, x1): (i64, i64),
    steepness: impl FnOnce() -> Steepness,
    areas: &mut [i32],
) -> Option<usize> {
    if column_of(x0) == column_of(x1) {
        *areas.first_mut()? = FULL - area(within(x0) + within(x1), CELL_ONE);
        return Some(1);
    }
    let (x0, x1) = (x0.min(x1), x0.max(x1));
    let last = column_of(x1).wrapping_sub(column_of(x0)).cast_unsigned() as usize;
    let (last_area, others) = areas.get_mut(..=last)?.split_last_mut()?;
    let steepness = steepness();
    let mut product = steepness.over((x0 | i64::from(u32::MAX)).wrapping_sub(x0).wrapping_add(1).cast_unsigned());
    let per_column = steepness.over(1 << 32);
    let (mut x, mut gone) = (within(x0), 0);
    for here in others {
        let at = steepness.height(product).min(CELL_ONE);
        *here = (at << 4) - area(x + CELL_ONE, at - gone);
        (gone, x) = (at, 0);
        product = product.wrapping_add(per_column);
    }
    *last_area = FULL - area(within(x1), CELL_ONE - gone);
    Some(last + 1)
}

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
        let dy = dy << (CELL_BITS - FINE_BITS);
        if column == column_of(x1) && index < usize::BITS {
            self.within_column(index as usize, within(x0) + within(x1), dy, weight);
        } else {
            self.outside_or_wide(x0.min(x1), x0.max(x1), dy, weight, steepness);
        }
    }

    /// Adds a segment within a column, `x0` and `x1` from its left side, in `bits` bits behind the point.
    #[inline]
    pub(crate) fn add_to_column(&mut self, column: i32, (x0, x1): (i32, i32), bits: u32, dy: i32, weight: i32) {
        let index = column.wrapping_sub(self.left);
        let dy = dy << (CELL_BITS - FINE_BITS);
        if index < 0 {
            self.add_to_the_left(dy, weight);
        } else if index < WINDOW_COLUMNS {
            let finer = bits - CELL_BITS;
            self.within_column(index.cast_unsigned() as usize, (x0 >> finer) + (x1 >> finer), dy, weight);
        }
    }

    /// `twice_x` is twice the segment's mean distance from the column's left side.
    #[inline]
    fn within_column(&mut self, index: usize, twice_x: i32, dy: i32, weight: i32) {
        let left = area(twice_x, dy);
        if let Some([here, next]) = self.differences.get_mut(index..).and_then(|rest| rest.first_chunk_mut::<2>()) {
            *here = here.wrapping_add(((dy << 4) - left).wrapping_mul(weight));
            *next = next.wrapping_add(left.wrapping_mul(weight));
        }
        self.touched |= (1 | usize::from(left != 0) << 1) << index;
    }

    #[inline]
    fn outside_or_wide(&mut self, x0: i64, x1: i64, dy: i32, weight: i32, steepness: impl FnOnce() -> Steepness) {
        let (first, last) = (column_of(x0).wrapping_sub(self.left), column_of(x1).wrapping_sub(self.left));
        if last < 0 {
            self.add_to_the_left(dy, weight);
        } else if first < WINDOW_COLUMNS {
            self.wide(x0, x1, dy, weight, steepness());
        }
    }

    fn add_to_the_left(&mut self, dy: i32, weight: i32) {
        let [first, ..] = &mut self.differences;
        *first = first.wrapping_add((dy << 4).wrapping_mul(weight));
        self.touched |= 1;
    }

    /// A segment of more than one column, maybe partly to the left; `x0 < x1`.
    #[inline(never)]
    fn wide(&mut self, x0: i64, x1: i64, dy: i32, weight: i32, steepness: Steepness) {
        let (mut column, last) = (column_of(x0).wrapping_sub(self.left), column_of(x1).wrapping_sub(self.left));
        let (mut x, mut gone) = (within(x0), 0);
        let per_column = steepness.over(1 << 32);
        let boundary = i64::from(column.max(-1).wrapping_add(self.left).wrapping_add(1)) << 32;
        let mut product = steepness.over(boundary.wrapping_sub(x0).cast_unsigned());
        if column < 0 {
            gone = steepness.height(product).min(dy);
            self.add_to_the_left(gone, weight);
            product = product.wrapping_add(per_column);
            (column, x) = (0, 0);
        }
        while column < last.min(WINDOW_COLUMNS) {
            let at = steepness.height(product).min(dy);
            self.within_column(column.cast_unsigned() as usize, x + CELL_ONE, at - gone, weight);
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

/// The column of an x in 2^-32 pixel.
#[inline]
pub(super) fn column_of(x: i64) -> i32 {
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
fn area(twice_x: i32, dy: i32) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^24")]
    let area = ((i64::from(twice_x) * i64::from(dy)) >> (2 * CELL_BITS + 1 - 24)) as i32;
    area
}
