//! Planes over a triangle in binary fixed point: 32 bits of fraction, and one reciprocal for all of them.
//!
//! What [`plane`](super::plane) keeps exactly, as a quotient and a remainder, is rounded here: a step is 64 bits, modulo
//! 2^64, and one addition. A value at any centre is that at the first one, and so many steps: integers, so it does not
//! matter on which way one gets there, and no clip changes it.
//!
//! # Errors
//!
//! The reciprocal of the area is off by a relative `e`, below `2^-29`. As all planes are divided by the same one, a value at a
//! distance `d` from the origin is the exact one at the distance `d (1 + e)`: it is as if the point were moved by a
//! part of 2^29 of its distance, which changes no value by more than that part of its range. Beyond that, each step
//! loses less than `2^-32`, which is `2^-7` after all the columns and rows that coordinates can name.

use crate::{
    attribute::walk::Oriented,
    subpixel::{centre, pixel_holding},
};

/// One over an area: `mantissa / 2^(63 + 32 - zeros)`, where the area has so many leading zeros.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reciprocal {
    mantissa: u32,
    zeros: u32,
}

impl Reciprocal {
    /// By a division of 32 bits and one step of Newton's, `x (2 - top x)`, whose error is the square of the division's,
    /// 2^-15, and on the same side always: the mantissa is at most `2^63 / top`.
    #[inline(always)]
    fn of(area: u64) -> Self {
        let zeros = area.max(1).leading_zeros();
        #[allow(clippy::cast_possible_truncation, reason = "the upper word")]
        let top = (area.max(1).wrapping_shl(zeros) >> 32) as u32;
        // 2^48 / top.
        let guess = u32::MAX / (top >> 16).max(1);
        let missing = (1_u64 << 48).wrapping_sub(u64::from(top).wrapping_mul(u64::from(guess))).cast_signed();
        let correction = (i64::from(guess).wrapping_mul(missing) >> 33).cast_unsigned();
        let mantissa = (u64::from(guess) << 15).wrapping_add(correction);
        Self { mantissa: u32::try_from(mantissa).unwrap_or(u32::MAX), zeros }
    }
}

/// What gradients are kept in before they are divided.
pub(crate) trait Product: Copy {
    /// `a b - c d`.
    fn cross(a: i64, b: i64, c: i64, d: i64) -> Self;
    /// 256 times as much over the area, with 32 bits of fraction, modulo 2^64.
    fn per_pixel(self, area: Reciprocal) -> u64;
    /// `gx x + gy y` over the area, with 32 bits of fraction, modulo 2^64; `steps` are `gx` and `gy` per pixel, and `x` and `y`
    /// at most half of one.
    fn near(gradient: (Self, Self), steps: (u64, u64), x: i32, y: i32, area: Reciprocal) -> u64;
}

/// For values that differ by less than 2^6, areas from 2^14 to 2^32 and vertices less than 2^22 from the first: gradients are
/// below `126 2^22`, steps below `126 2^16`, and 128 of two of them below 2^31.
impl Product for i32 {
    #[inline(always)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i32 {
        #[allow(clippy::cast_possible_truncation, reason = "differences of this path have 32 bits")]
        let product = |a: i64, b: i64| (a as i32).wrapping_mul(b as i32);
        product(a, b).wrapping_sub(product(c, d))
    }

    #[inline(always)]
    fn per_pixel(self, area: Reciprocal) -> u64 {
        let mantissa = (area.mantissa >> 1).cast_signed();
        let down = 54_u32.wrapping_sub(area.zeros) & 31;
        (i64::from(self).wrapping_mul(mantissa.into()) >> down).cast_unsigned()
    }

    #[inline(always)]
    fn near(_: (i32, i32), (right, down): (u64, u64), x: i32, y: i32, _: Reciprocal) -> u64 {
        let across = right.cast_signed().wrapping_mul(x.into());
        (across.wrapping_add(down.cast_signed().wrapping_mul(y.into())) >> 8).cast_unsigned()
    }
}

/// For gradients below 2^54.
impl Product for i64 {
    #[inline(always)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i64 {
        a.wrapping_mul(b).wrapping_sub(c.wrapping_mul(d))
    }

    #[inline(always)]
    fn per_pixel(self, area: Reciprocal) -> u64 {
        over(self << 8, area)
    }

    #[inline(always)]
    fn near((gx, gy): (i64, i64), _: (u64, u64), x: i32, y: i32, area: Reciprocal) -> u64 {
        over(gx.wrapping_mul(x.into()).wrapping_add(gy.wrapping_mul(y.into())), area)
    }
}

#[inline(never)]
fn over(product: i64, area: Reciprocal) -> u64 {
    let mantissa = u64::from(area.mantissa);
    let low = u64::from(low_word(product.cast_unsigned())).wrapping_mul(mantissa);
    let high = (product >> 32).wrapping_mul(mantissa.cast_signed()).wrapping_add_unsigned(low >> 32);
    // The product is 2^32 high and the lower word of low; 63 - zeros bits of it are too many.
    match 63_u32.wrapping_sub(area.zeros) {
        down @ 32.. => high.wrapping_shr(down.wrapping_sub(32)).cast_unsigned(),
        down => (high.cast_unsigned() << 1 << (31 - down)).wrapping_add(u64::from(low_word(low) >> down)),
    }
}

/// For all there are, below 2^65.
impl Product for i128 {
    #[inline(never)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i128 {
        i128::from(a).wrapping_mul(i128::from(b)).wrapping_sub(i128::from(c).wrapping_mul(i128::from(d)))
    }

    #[inline]
    fn per_pixel(self, area: Reciprocal) -> u64 {
        over_wide(self << 8, area)
    }

    #[inline]
    fn near((gx, gy): (i128, i128), _: (u64, u64), x: i32, y: i32, area: Reciprocal) -> u64 {
        over_wide(gx.wrapping_mul(x.into()).wrapping_add(gy.wrapping_mul(y.into())), area)
    }
}

#[inline(never)]
fn over_wide(product: i128, area: Reciprocal) -> u64 {
    let product = product.wrapping_mul(area.mantissa.into()).wrapping_shr(63_u32.wrapping_sub(area.zeros));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "wanted modulo 2^64")]
    let product = product as u64;
    product
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the lower word is wanted")]
pub(crate) fn low_word(value: u64) -> u32 {
    value as u32
}

/// `N` values at the centre of a pixel, and their steps, with 32 bits of fraction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BinaryPlanes<const N: usize> {
    pub(crate) at: [u64; N],
    pub(crate) right: [u64; N],
    down: [u64; N],
    row: i32,
    column: i32,
}

impl<const N: usize> BinaryPlanes<N> {
    /// The planes through the values of the vertices, at whichever pixel has the first vertex; for which triangles, the product
    /// says.
    #[inline(always)]
    pub(crate) fn new<P: Product>(oriented: &Oriented, values: &[[i32; N]; 3]) -> Self {
        let [origin, a, b] = oriented.vertices.map(|vertex| (vertex.x.to_bits(), vertex.y.to_bits()));
        let to = |end: (i32, i32)| (difference(end.0, origin.0), difference(end.1, origin.1));
        let ((x1, y1), (x2, y2)) = (to(a), to(b));
        let (column, row) = (pixel_holding(origin.0), pixel_holding(origin.1));
        let (x, y) = (centre(column).wrapping_sub(origin.0), centre(row).wrapping_sub(origin.1));
        let area = Reciprocal::of(oriented.area);
        let mut planes = Self { at: [0; N], right: [0; N], down: [0; N], row, column };
        let [c0, c1, c2] = values;
        let steps = planes.right.iter_mut().zip(&mut planes.down);
        for ((at, (right, down)), (c0, (c1, c2))) in
            planes.at.iter_mut().zip(steps).zip(c0.iter().zip(c1.iter().zip(c2)))
        {
            let (c1, c2) = (difference(*c1, *c0), difference(*c2, *c0));
            let (gx, gy) = (P::cross(c1, y2, c2, y1), P::cross(x1, c2, x2, c1));
            (*right, *down) = (gx.per_pixel(area), gy.per_pixel(area));
            *at = P::near((gx, gy), (*right, *down), x, y, area).wrapping_add_signed(i64::from(*c0) << 32);
        }
        planes
    }

    #[inline(always)]
    pub(crate) fn column(&self) -> i32 {
        self.column
    }

    #[inline(always)]
    pub(crate) fn row(&self) -> i32 {
        self.row
    }

    /// The values in a column of the current row.
    #[inline(always)]
    pub(crate) fn at_column(&self, column: i32) -> [u64; N] {
        let columns = i64::from(column.wrapping_sub(self.column)).cast_unsigned();
        let mut at = self.at;
        for (at, right) in at.iter_mut().zip(&self.right) {
            *at = at.wrapping_add(right.wrapping_mul(columns));
        }
        at
    }

    /// Goes to a centre, inside or outside.
    #[inline(always)]
    pub(crate) fn go_to(&mut self, row: i32, column: i32) {
        let (rows, columns) = (row.wrapping_sub(self.row), column.wrapping_sub(self.column));
        (self.row, self.column) = (row, column);
        self.move_by(rows, columns);
    }

    /// Most often by one row.
    #[inline(always)]
    pub(crate) fn move_by(&mut self, rows: i32, columns: i32) {
        if rows == 1 && columns == 0 {
            for (at, down) in self.at.iter_mut().zip(&self.down) {
                *at = at.wrapping_add(*down);
            }
        } else {
            self.leap(rows, columns);
        }
    }

    #[inline(never)]
    fn leap(&mut self, rows: i32, columns: i32) {
        let (rows, columns) = (i64::from(rows).cast_unsigned(), i64::from(columns).cast_unsigned());
        for (at, (right, down)) in self.at.iter_mut().zip(self.right.iter().zip(&self.down)) {
            *at = at.wrapping_add(down.wrapping_mul(rows)).wrapping_add(right.wrapping_mul(columns));
        }
    }
}

#[inline(always)]
fn difference(to: i32, from: i32) -> i64 {
    i64::from(to).wrapping_sub(i64::from(from))
}
