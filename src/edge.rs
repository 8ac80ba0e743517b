//! An edge: the boundary column of every row it crosses, exactly, with one division and then additions.
//!
//! ```text
//!            top (x0, y0)
//!              \         row centre Y:  x(Y) = x0 + (Y - y0) dx / dy
//!    . . . . . .\. . . .
//!                \ # # #   column = ceil((x(Y) - 128) / 256): the first pixel centre at or right of the edge
//!    . . . . . . .\. # #
//!                  bottom (x1, y1)
//! ```
//!
//! The same ceiling bounds a span on the left (`column..`) and on the right (`..column`), so two shapes that share an
//! edge share each pixel exactly once, and a centre that lies on the edge belongs to the shape on its right: the
//! top-left rule.
//!
//! With `D = 256 dy` the column is `ceil(n / D)` for an integer `n`. An edge keeps `column` and
//! `remainder = column D - n`, which is in `0..D`. One row down, `n` grows by `256 dx`; with `dx = q dy + rem` that is
//! `q` columns and `256 rem` off the remainder, and one more column when that borrows. Nothing is rounded, so nothing
//! accumulates: row `k` is as exact as row 0. It is Bresenham's error term (J. E. Bresenham, "Algorithm for computer
//! control of a digital plotter", 1965) carried to sub-pixel vertices.

use crate::{
    Vertex,
    limits::{HALF, NARROW_REACH, ONE, STEPPED_COLUMNS, STEPPED_HEIGHT, SUBPIXEL_BITS},
    subpixel::{centre, first_centre_at_or_after_wide},
};

/// See the module. `modulus` is `D`; 0 where `D` does not fit, and the edge cannot be stepped.
#[derive(Debug, Clone, Copy, Default)]
pub struct Edge {
    pub(crate) column: i32,
    remainder: i32,
    step_columns: i32,
    step_remainder: i32,
    modulus: i32,
}

/// The line through an edge's ends, downwards: what an [`Edge`] is made from, for whichever row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Descent {
    /// x of the upper end.
    pub(crate) x0: i32,
    /// x of the lower end.
    pub(crate) x1: i32,
    /// How far down the lower end is; not 0.
    pub(crate) dy: u32,
}

impl Edge {
    pub(crate) const EMPTY: Self = Self { column: 0, remainder: 0, step_columns: 0, step_remainder: 0, modulus: 0 };

    /// The edge on `row`, whose centre lies in `top.y..bottom.y`, for vertices anywhere.
    #[inline]
    pub(crate) fn on_row(top: Vertex, bottom: Vertex, row: i32) -> Self {
        let below = centre(row).wrapping_sub(top.y.to_bits()).cast_unsigned();
        let descent = Descent::between(top, bottom);
        if below <= ONE.cast_unsigned() && descent.is_narrow() {
            descent.near_top(below.cast_signed())
        } else {
            descent.at(i64::from(below))
        }
    }

    /// The same for the first row of an edge in the narrow zone.
    #[inline(always)]
    pub(crate) fn on_first_row(top: Vertex, bottom: Vertex, row: i32) -> Self {
        Descent::between(top, bottom).near_top(centre(row).wrapping_sub(top.y.to_bits()))
    }

    /// One row down. An edge that cannot be stepped stays as it is.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        let remainder = self.remainder.wrapping_sub(self.step_remainder);
        // All ones where it borrows: no jump.
        let borrows = remainder >> 31;
        self.column = self.column.wrapping_add(self.step_columns).wrapping_sub(borrows);
        self.remainder = remainder.wrapping_add(self.modulus & borrows);
    }

    /// Neither too tall nor too flat: see `limits::STEPPED_HEIGHT`, `limits::STEPPED_COLUMNS`.
    #[inline]
    pub(crate) fn can_step(&self) -> bool {
        self.modulus != 0
    }

    /// One row down: by a step where the edge can, else made anew for that row.
    #[inline]
    pub(crate) fn step_or(&mut self, next: impl FnOnce() -> Self) {
        if self.can_step() {
            self.step();
        } else {
            *self = next();
        }
    }

    /// Gives a centre that lies exactly on the edge to the other side: `floor + 1` in place of `ceil`, from here on.
    #[inline(always)]
    pub(crate) fn nudged(self) -> Self {
        // `n` grows by one.
        let remainder = self.remainder.wrapping_sub(1);
        let borrows = remainder >> 31;
        Self {
            column: self.column.wrapping_sub(borrows),
            remainder: remainder.wrapping_add(self.modulus & borrows),
            ..self
        }
    }
}

impl Descent {
    #[inline(always)]
    pub(crate) fn between(top: Vertex, bottom: Vertex) -> Self {
        let dy = bottom.y.to_bits().wrapping_sub(top.y.to_bits()).cast_unsigned();
        Self { x0: top.x.to_bits(), x1: bottom.x.to_bits(), dy }
    }

    /// Both ends in the narrow zone, as far as x is concerned, and no higher than that.
    #[inline]
    pub(crate) fn is_narrow(self) -> bool {
        let is_in_zone = |x: i32| x.wrapping_add(NARROW_REACH).cast_unsigned() <= 2 * NARROW_REACH.cast_unsigned();
        self.dy <= 2 * NARROW_REACH.cast_unsigned() && is_in_zone(self.x0) && is_in_zone(self.x1)
    }

    /// The edge `below` sub-pixels below the top, `-128 <= below <= 256`, in `i32` with one division; ends in the
    /// narrow zone.
    ///
    /// With `dx = q dy + rem`, `0 <= rem < dy`, `x = x0 + below q + below rem / dy`: the last term is less than 256, so
    /// it moves the column by at most one pixel and needs no division of its own.
    #[inline(always)]
    pub(crate) fn near_top(self, below: i32) -> Edge {
        let dx = self.x1.wrapping_sub(self.x0);
        // Never 0, but the compiler does not know, and would check.
        let dy = self.dy.cast_signed().max(1);
        let mut quotient = dx.wrapping_div(dy);
        let mut rem = dx.wrapping_sub(quotient.wrapping_mul(dy));
        if rem < 0 {
            rem += dy;
            quotient -= 1;
        }
        let x = self.x0.wrapping_add(below.wrapping_mul(quotient));
        let modulus = dy << SUBPIXEL_BITS;
        let mut column = x >> SUBPIXEL_BITS;
        let mut remainder = (HALF - (x & (ONE - 1))) * dy - below * rem;
        if remainder < 0 {
            remainder += modulus;
            column += 1;
        }
        if remainder < 0 {
            remainder += modulus;
            column += 1;
        }
        Edge { column, remainder, step_columns: quotient, step_remainder: rem << SUBPIXEL_BITS, modulus }
    }

    /// The edge `below` sub-pixels below the top, anywhere from 2^16 above the top to 2^16 below the bottom.
    #[inline(never)]
    pub(crate) fn at(self, below: i64) -> Edge {
        self.at_nudged(below, false)
    }

    /// As [`at`](Self::at); `nudged` as by [`Edge::nudged`], also for an edge that cannot be stepped.
    pub(crate) fn at_nudged(self, below: i64, nudged: bool) -> Edge {
        let Self { x0, x1, dy } = self;
        let width = x1.abs_diff(x0);
        // Measured from the nearer end when outside, so that the product of magnitudes stays below 2^64.
        let (from, offset) = if below > i64::from(dy) { (x1, below - i64::from(dy)) } else { (x0, below) };
        let distance = offset.unsigned_abs();
        let (whole, part) = divide_product(distance, width, dy);
        let rightwards = (x1 >= x0) == (offset >= 0);
        // x = ceil(x(Y)), and how far that is beyond x(Y), in 1/dy.
        let (x, beyond) = if !rightwards {
            (i64::from(from).wrapping_sub_unsigned(whole), part)
        } else if part == 0 {
            (i64::from(from).wrapping_add_unsigned(whole), 0)
        } else {
            (i64::from(from).wrapping_add_unsigned(whole).wrapping_add(1), dy.wrapping_sub(part))
        };
        let column = first_centre_at_or_after_wide(x);
        // The centre's distance from x, in 0..256, and from x(Y), in 1/dy.
        let excess = (column << SUBPIXEL_BITS) + i64::from(HALF) - x;
        let remainder = excess.cast_unsigned() * u64::from(dy) + u64::from(beyond);
        let column = clamp_to_i32(column);
        let (quotient, rem) = (width / dy.max(1), width % dy.max(1));
        let (step_columns, rem) = if x1 >= x0 {
            (quotient.cast_signed(), rem)
        } else if rem == 0 {
            (quotient.wrapping_neg().cast_signed(), 0)
        } else {
            (quotient.wrapping_neg().wrapping_sub(1).cast_signed(), dy.wrapping_sub(rem))
        };
        if dy >= STEPPED_HEIGHT || quotient > STEPPED_COLUMNS {
            let column = column.saturating_add(i32::from(nudged && remainder == 0));
            return Edge { column, ..Edge::EMPTY };
        }
        // All below 2^31, as `dy` is below 2^23.
        let modulus = (dy << SUBPIXEL_BITS).cast_signed();
        let step_remainder = (rem << SUBPIXEL_BITS).cast_signed();
        let edge = Edge { column, remainder: low_word(remainder).cast_signed(), step_columns, step_remainder, modulus };
        if nudged { edge.nudged() } else { edge }
    }
}

/// `a b / c` and the remainder, in 32 bits where the product allows; `a b < 2^64`, `c > 0`.
#[inline]
pub(crate) fn divide_product(a: u64, b: u32, c: u32) -> (u64, u32) {
    let product = a.wrapping_mul(u64::from(b));
    let c = c.max(1);
    match u32::try_from(product) {
        Ok(product) => (u64::from(product / c), product % c),
        Err(_) => (product / u64::from(c), low_word(product % u64::from(c))),
    }
}

#[inline]
#[allow(clippy::cast_possible_truncation, reason = "the callers' values are below 2^32")]
fn low_word(value: u64) -> u32 {
    value as u32
}

/// A boundary outside `i32` belongs to a line that was extended past its end: every clip is on one side of it.
#[inline]
fn clamp_to_i32(value: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "clamped")]
    let value = value.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32;
    value
}
