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

use crate::coverage::steepness::{Steepness, high_word};

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

/// How far down an edge goes for a width.
pub(crate) trait Steep: Copy {
    /// For `across`, less than a pixel, in 2^-32; at most about a pixel.
    fn down(self, across: u32) -> u32;

    /// For a pixel, of an edge that crosses one within a row.
    fn down_a_pixel(self) -> u32;

    /// For any number of pixels.
    fn steepness(self) -> Steepness;
}

/// The columns that an edge crosses in a row, and how far into the first and the last, in 2^-32.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) first: i32,
    pub(crate) last: i32,
    pub(crate) left: u32,
    pub(crate) right: u32,
}

impl Extent {
    /// Between the positions of an edge's ends, in either order.
    #[inline(always)]
    pub(crate) fn between(a: i64, b: i64) -> Self {
        let (left, right) = (a.min(b), a.max(b));
        Self { first: column_of(left), last: column_of(right), left: part_of(left), right: part_of(right) }
    }
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

    /// Of an edge over `height`.
    #[inline(always)]
    pub(crate) fn new(extent: Extent, height: u32, steep: impl Steep) -> Self {
        let Extent { first, last, left, right } = extent;
        let in_one = || height - high_word(height, (left >> 1) + (right >> 1));
        if first == last {
            return Self::in_column(first, height, in_one());
        }
        let beyond = high_word(right, steep.down(right).min(height)) >> 1;
        let (first_area, second_area, step) = if last == first + 1 {
            (in_two(in_one(), height, beyond), 0, 0)
        } else {
            let (down, step) = (steep.down(!left).min(height), steep.down_a_pixel());
            (high_word(!left, down) >> 1, down + (step >> 1), step)
        };
        Self {
            first,
            last,
            height,
            first_area,
            last_area: height - beyond,
            second_area,
            step,
            steepness: steep.steepness(),
        }
    }

    /// The same over a pixel's height, without a jump, for edges that cross few columns.
    #[inline(always)]
    pub(crate) fn new_few(extent: Extent, steep: impl Steep) -> Self {
        let Extent { first, last, left, right } = extent;
        let across = last.wrapping_sub(first);
        let in_one = FULL - high_word(FULL, (left >> 1) + (right >> 1));
        let beyond = high_word(right, steep.down(right).min(FULL)) >> 1;
        let (down, step) = (steep.down(!left).min(FULL), steep.down_a_pixel());
        let in_two = in_two(in_one, FULL, beyond);
        let first_area = select(across == 0, in_one, select(across == 1, in_two, high_word(!left, down) >> 1));
        let last_area = select(across == 0, in_one, FULL - beyond);
        let second_area = down.wrapping_add(step >> 1);
        Self { first, last, height: FULL, first_area, last_area, second_area, step, steepness: steep.steepness() }
    }

    /// The areas in the first column and in the one after it, over a pixel's height, of an edge that is
    /// [steep](Steepness::is_steep): without a jump.
    #[inline(always)]
    pub(crate) fn ends_of_steep(extent: Extent, steep: impl Steep) -> (u32, u32) {
        let Extent { first, last, left, right } = extent;
        let in_one = FULL - high_word(FULL, (left >> 1) + (right >> 1));
        let is_crossed = u32::from(first != last).wrapping_neg();
        let right = right & is_crossed;
        let beyond = high_word(right, steep.down(right)) >> 1;
        (in_two(in_one, FULL & is_crossed, beyond), FULL - beyond)
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

/// What is right of an edge in the first column of two.
///
/// If that column went on to the right, it would be as in one column, half a pixel farther to the left, as `right` counts from the
/// second. What the edge leaves beyond it is not part of the column: the triangle that is missing in the second.
///
/// ```text
///     |  /  |     |
///     | /   |     |        in one column:  # - :
///     |/####|#####|        the triangle :  is counted as missing, and is given back
///     |#####|#..::|
/// ```
#[inline(always)]
fn in_two(in_one: u32, height: u32, beyond: u32) -> u32 {
    in_one.wrapping_sub(height >> 1).wrapping_add(beyond)
}

/// One of two, without a jump.
#[inline(always)]
fn select(condition: bool, yes: u32, no: u32) -> u32 {
    let mask = u32::from(condition).wrapping_neg();
    no ^ ((yes ^ no) & mask)
}

/// The coverage of what a left edge leaves of a pixel, or of what a right one takes of it, from the area to its right.
#[inline(always)]
pub(super) fn coverage_beside<const IS_RIGHT: bool>(area: u32) -> u8 {
    coverage_of(if IS_RIGHT { FULL.wrapping_sub(area) } else { area })
}

/// An area, in 255ths of a pixel, to the nearest; a few units beyond either end belong to it.
#[inline(always)]
pub(crate) fn coverage_of(area: u32) -> u8 {
    #[allow(clippy::cast_possible_truncation, reason = "0 to 255")]
    let coverage = (area.wrapping_add(1 << 21) >> 22) as u8;
    coverage
}
