//! What one edge leaves of each pixel of a row: the area to its right.
//!
//! ```text
//!        first           last
//!     |    .-'|     |     |          area:  0 before `first`, the whole height after `last`
//!     |  -'   | __..|--'' |                 half a product of width and height in the first and the last
//!     |.'__..-|'    |     |                 half way between its sides in those between
//! ```
//!
//! An edge and its mirror image, left and right exchanged, leave the same areas in a row, so only the left end and the
//! right end count. Areas and heights are in 2^-30 of a pixel: every formula here is off by at most a few units.

use crate::coverage::slope::{Steepness, high_word};

/// The area of a pixel; also its height.
pub(crate) const FULL: u32 = 1 << 30;

/// A height in 1/256 pixel, at most a pixel.
#[inline(always)]
pub(crate) fn height_of(subpixels: i32) -> u32 {
    subpixels.cast_unsigned() << 22
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
    steepness: Steepness,
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
    /// Between the positions of an edge's ends in the row, in either order, over `height`.
    #[inline(always)]
    pub(crate) fn between(a: i64, b: i64, height: u32, steepness: Steepness) -> Self {
        let (left, right) = (a.min(b), a.max(b));
        let (first, last) = (column_of(left), column_of(right));
        let (left_part, right_part) = (part_of(left), part_of(right));
        if first == last {
            let mean = (left_part >> 1) + (right_part >> 1);
            let area = height - high_word(height, mean);
            return Self { first, last, height, first_area: area, last_area: area, second_area: 0, step: 0, steepness };
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
    let area = area.cast_signed();
    let coverage = (area - (area >> 8) + (1 << 21)) >> 22;
    #[allow(clippy::cast_possible_truncation, reason = "0 to 255")]
    #[allow(clippy::cast_sign_loss, reason = "0 to 255")]
    let coverage = coverage as u8;
    coverage
}
