//! What one edge leaves of each pixel of a row: the area to its right.
//!
//! ```text
//!        first           last
//!     |    .-'|     |     |          area:  0 before `first`, the whole height after `last`
//!     |  -'   | __..|--'' |                 half a product of width and height in the first and the last
//!     |.'__..-|'    |     |                 half way between its sides in those between
//! ```
//!
//! An edge and its mirror image, upper and lower end exchanged, leave the same areas in a row, so only the left end and the
//! right end count. Areas and heights are in units of which a pixel has 255 * 2^22: every formula here is off by at most a
//! few of them.

use core::ops::RangeInclusive;

use crate::coverage::slope::{Steepness, high_word};

/// The area of a pixel; also its height: a 255th is 2^22.
pub(crate) const FULL: u32 = 255 << 22;

/// A height in 2^-`BITS` pixel, at most a pixel.
#[inline(always)]
pub(crate) fn height_in<const BITS: u32>(height: i32) -> u32 {
    height.cast_unsigned() * (FULL >> BITS)
}

/// A height in 1/256 pixel, at most a pixel.
#[inline(always)]
pub(crate) fn height_of(subpixels: i32) -> u32 {
    height_in::<8>(subpixels)
}

/// See the module.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ramp {
    pub(crate) first: i32,
    pub(crate) last: i32,
    pub(crate) height: u32,
    pub(crate) first_area: u32,
    pub(crate) last_area: u32,
    /// In the column after the first.
    pub(crate) second_area: u32,
    /// From each to the next between the first and the last.
    pub(crate) step: u32,
    pub(crate) steepness: Steepness,
}

/// Over more columns than there are in the narrow zone, the steps' last bits would add up: they are multiplied out.
pub(crate) const STEPPED: i32 = 1 << 14;

/// The column that holds a position.
#[inline(always)]
pub(crate) fn column_of(position: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "24 bits are left")]
    let column = (position >> 40) as i32;
    column
}

/// How far into its column a position is, in 2^-32.
#[inline(always)]
pub(crate) fn part_of(position: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    #[allow(clippy::cast_sign_loss, reason = "bits")]
    let part = (position >> 8) as u32;
    part
}

impl Ramp {
    /// All of it in one column, of which the area is known.
    #[inline(always)]
    pub(crate) fn in_column(column: i32, height: u32, area: u32) -> Self {
        Self {
            first: column,
            last: column,
            height,
            first_area: area,
            last_area: area,
            second_area: 0,
            step: 0,
            steepness: Steepness::NONE,
        }
    }

    /// Between the positions of an edge's ends in the row, in either order, over `height`.
    #[inline(always)]
    pub(crate) fn between(a: i64, b: i64, height: u32, steepness: Steepness) -> Self {
        let (left, right) = (a.min(b), a.max(b));
        Self::within(column_of(left)..=column_of(right), part_of(left), part_of(right), height, steepness)
    }

    /// From one column to another, so far into the first, and so far into the last, in 2^-32.
    #[inline(always)]
    pub(crate) fn within(
        columns: RangeInclusive<i32>,
        left_part: u32,
        right_part: u32,
        height: u32,
        steepness: Steepness,
    ) -> Self {
        let (first, last) = (*columns.start(), *columns.end());
        if first == last {
            let mean = (left_part >> 1) + (right_part >> 1);
            return Self::in_column(first, height, height - high_word(height, mean));
        }
        let to_boundary = !left_part;
        let down = steepness.down(to_boundary).min(height);
        let (rest, step) = if last == first + 1 {
            (height - down, 0)
        } else {
            (steepness.down(right_part).min(height), steepness.down_a_pixel())
        };
        Self {
            first,
            last,
            height,
            first_area: high_word(to_boundary, down) >> 1,
            last_area: height - (high_word(right_part, rest) >> 1),
            second_area: down + (step >> 1),
            step,
            steepness,
        }
    }

    /// The area in a column.
    #[inline(always)]
    pub(crate) fn at(&self, column: i32) -> u32 {
        if column <= self.first {
            if column < self.first { 0 } else { self.first_area }
        } else if column >= self.last {
            if column > self.last { self.height } else { self.last_area }
        } else {
            let after = column.wrapping_sub(self.first).wrapping_sub(1).cast_unsigned();
            if self.last.wrapping_sub(self.first) <= STEPPED {
                self.second_area.wrapping_add(after.wrapping_mul(self.step))
            } else {
                self.second_area.wrapping_add(self.steepness.down_pixels(after)).min(self.height)
            }
        }
    }
}

/// An area, in 255ths of a pixel, to the nearest; a few units beyond either end belong to it.
#[inline(always)]
pub(crate) fn coverage_of(area: u32) -> u8 {
    #[allow(clippy::cast_possible_truncation, reason = "0 to 255")]
    let coverage = (area.wrapping_add(1 << 21) >> 22) as u8;
    coverage
}
