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
    accumulator::{FULL, column_of},
    division::{ratio, share},
    source::{FINE_BITS, FINE_ONE, Point},
};

/// Bits behind the binary point of distances, heights and areas within a pixel.
const CELL_BITS: u32 = 24;

/// How far an edge goes down over a distance along x: `((distance << up) * factor) >> (32 + down)`, one of the two shifts being 0.
#[derive(Debug, Clone, Copy)]
struct Steepness {
    factor: u32,
    up: u8,
    down: u8,
}

impl Steepness {
    /// Of what moves by `slope`, in 2^-32 pixel, while it goes down a pixel.
    ///
    /// `slope` is `d 2^(32 - z)`, with `d` of 32 bits, the highest of them set, and `z` its leading zeros: `1 / slope` is
    /// `(2^63 / d) 2^(z - 63)`, in which the quotient has at most 32 bits.
    #[inline]
    fn new(slope: u64) -> Self {
        let zeros = slope.leading_zeros();
        #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
        let factor = share(FINE_ONE.unsigned_abs(), (slope << (zeros & 63) >> 32) as u32);
        #[allow(clippy::cast_possible_truncation, reason = "at most 32")]
        let (up, down) = (zeros.saturating_sub(31) as u8, 31_u32.saturating_sub(zeros) as u8);
        Self { factor, up, down }
    }

    /// In 2^-56 pixel, for a distance that is not wider than the edge is in a row.
    #[inline]
    fn product(self, distance: u32) -> u64 {
        (u64::from(distance << (self.up & 31)) * u64::from(self.factor)) >> (self.down & 31)
    }
}

/// From 2^-56 pixel.
#[inline]
fn height_of(product: u64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let height = (product >> 32) as u32;
    height
}

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
        let steepness = Steepness::new(slope);
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
        Some(Piece { left, right, slope, steepness, height, sign })
    }
}

/// What a row has of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// How far to the left it reaches and how far to the right, in 2^-32 pixel.
    left: i64,
    right: i64,
    slope: i64,
    steepness: Steepness,
    /// How much of the row's height it takes, in 2^-24 pixel.
    height: u32,
    sign: i32,
}

impl Piece {
    /// What the next row has of an edge that crosses both.
    #[inline]
    pub(super) fn step(&mut self) {
        self.left = self.left.wrapping_add(self.slope);
        self.right = self.right.wrapping_add(self.slope);
    }

    /// Whether it crosses the row from top to bottom.
    #[inline]
    pub(super) fn is_whole(&self) -> bool {
        self.height == FULL.unsigned_abs()
    }

    #[inline]
    pub(super) fn is_left(&self) -> bool {
        self.sign > 0
    }

    /// The first of its columns and the last.
    #[inline]
    pub(super) fn columns(&self) -> (i32, i32) {
        (column_of(self.left), column_of(self.right))
    }

    /// What it adds to a pixel to the right of it, in 2^-24 pixel.
    #[inline]
    pub(super) fn beyond(&self) -> i32 {
        self.sign.wrapping_mul(self.height.cast_signed())
    }

    /// What it leaves of its columns to its right, or the rest of them, if it crosses the row from top to bottom; how many there
    /// are, if there is room.
    #[inline]
    pub(super) fn areas<const COVERED: bool>(&self, areas: &mut [i32]) -> Option<usize> {
        let of = |area: u32| if COVERED { FULL - area.cast_signed() } else { area.cast_signed() };
        let count = column_of(self.right).wrapping_sub(column_of(self.left)).cast_unsigned() as usize;
        let height = FULL.unsigned_abs();
        let (x, to) = (within(self.left), within(self.right));
        if count == 0 {
            *areas.first_mut()? = of(height - (x + to) / 2);
            return Some(1);
        }
        let (last, others) = areas.get_mut(..=count)?.split_last_mut()?;
        let (mut product, per_column) = (self.steepness.product(height - x), self.steepness.product(height));
        let (mut x, mut gone) = (x, 0);
        for area in others {
            // Too few to be unrolled.
            black_box(());
            let at = height_of(product).min(height);
            *area = of(at - trapezoid(x + height, at - gone));
            product = product.wrapping_add(per_column);
            (gone, x) = (at, 0);
        }
        *last = of(height - trapezoid(to, height - gone));
        Some(count + 1)
    }

    /// Adds what it leaves of the columns from `start` on to its right, or takes it away.
    pub(super) fn add(&self, start: i32, areas: &mut [i32]) {
        let Self { left, right, steepness, height, sign, .. } = *self;
        let (mut column, last) = (column_of(left).wrapping_sub(start), column_of(right).wrapping_sub(start));
        let (mut x, mut gone) = (within(left), 0);
        let mut areas = areas.iter_mut().skip(column.max(0).unsigned_abs() as usize);
        if column < last && last >= 0 {
            // To where it leaves its first column, and from there to where it leaves the last one that is not seen.
            let one = FULL.unsigned_abs();
            let (mut product, per_column) = (steepness.product(one - x), steepness.product(one));
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
                *area = area.wrapping_add(sign.wrapping_mul((at - trapezoid(x + one, at - gone)).cast_signed()));
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

/// How far within its column, in 2^-24 pixel.
#[inline]
fn within(x: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the lower half")]
    let part = x as u32;
    part >> (32 - CELL_BITS)
}

/// `twice_x` is below 2^25, `dy` at most 2^24.
#[inline]
fn trapezoid(twice_x: u32, dy: u32) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let area = ((u64::from(twice_x << 7) * u64::from(dy)) >> 32) as u32;
    area
}
