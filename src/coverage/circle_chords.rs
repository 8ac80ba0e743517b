//! The chords that stand for a circle's outline where it is anti-aliased.
//!
//! An arc of length `s` and its chord enclose `s^3 / 12 R` (in pixels; more by at most `3 s^2 / 40 R^2` of it). Each chord is
//! moved outwards along its rows by what makes up for that, so what lies wholly within a pixel is right.
//!
//! ```text
//!          . - ' arc               at both its ends the chord lies outside of the arc, and gains m / 2 each;
//!      . '___...---'               in the middle it lies inside and loses
//!     '--          chord           m = s^3 / (36 sqrt(3) R) = 0.01604 s^3 / R
//! ```
//!
//! The outline enters a pixel and leaves it, and only the chords that it does so on are cut. What is left of one chord is off
//! by at most `m`. What is left of two is off by at most `m / 2` each, and by what moving them along the rows, and not square
//! to them, shifts from one end to the other: `t = s^4 / (288 x R)`, with `x` from the vertical through the centre to the
//! chord's middle, gained by the end that is farther out and lost by the other. At the poles, `x` is `s / 2` for one chord and
//! `3 s / 2` for the next: together they are off by `m + (1/144 - 1/432) s^3 / R = 0.0207 s^3 / R`, and nowhere by more.
//!
//! A chord has `s^3 <= 15 R / 64`, or, if it is wider than high, with 5/4 for the square of its width. Near the poles, that
//! is 0.0035 of a pixel or 0.89 of 1/255; elsewhere, `m` alone is 0.0038 or 0.96 of 1/255. For the least circles, `s` is at most
//! a quarter of the radius, too. Lengths are in 2^-20 pixel and off by at most two units, and the steepness of a ramp is off by
//! 2^-15 of itself: with rounding to 255ths, 0.5 and 1 of 1/255 is never reached.

use core::ops::Range;

use crate::{
    coverage::{Extent, Ramp, Steepness, height_in},
    limits::{ONE, SUBPIXEL_BITS},
};

/// Bits behind the binary point of a length.
pub(super) const BITS: u32 = 20;

/// The height of a row.
pub(super) const ROW: u32 = 1 << BITS;

/// From a coordinate to a length.
pub(super) const FINER: u32 = BITS - SUBPIXEL_BITS;

/// The largest radius (1024 pixels): `R + y` fits 32 bits, and a row's outline is at most 46 pixels wide on either side.
pub(super) const LARGEST_RADIUS: i32 = 1 << 18;

/// A point of the circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// How far from the vertical through the centre, on either side.
    pub(super) width: u32,
    /// How far below the centre.
    pub(super) y: i32,
}

/// A chord, moved outwards.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    upper: u32,
    lower: u32,
    height: u32,
    pub(super) steepness: Steepness,
}

impl Chord {
    /// Left of the centre, without what sticks out of `touched`: a chord that does is less than a pixel wide.
    #[inline(always)]
    pub(super) fn left(&self, center: Center, touched: &Range<i32>) -> Ramp {
        let ramp = self.ramp(self.extents(center).0);
        if ramp.first < touched.start && ramp.first + 1 == ramp.last {
            return Ramp::in_column(ramp.last, ramp.height, ramp.last_area);
        }
        ramp
    }

    /// Right of it.
    #[inline(always)]
    pub(super) fn right(&self, center: Center, touched: &Range<i32>) -> Ramp {
        let ramp = self.ramp(self.extents(center).1);
        if ramp.last >= touched.end && ramp.first + 1 == ramp.last {
            return Ramp::in_column(ramp.first, ramp.height, ramp.first_area);
        }
        ramp
    }

    #[inline(always)]
    fn ramp(&self, extent: Extent) -> Ramp {
        Ramp::new(extent, self.height, self.steepness)
    }

    /// What it crosses on the left and on the right of the centre.
    #[inline(always)]
    pub(super) fn extents(&self, center: Center) -> (Extent, Extent) {
        let (inner, outer) = (self.upper.min(self.lower), self.upper.max(self.lower));
        let extent = |left: i32, right: i32| {
            let part = |place: i32| place.cast_unsigned() << (32 - BITS);
            let (first, last) = (center.column_at(left), center.column_at(right));
            Extent { first, last, left: part(left), right: part(right) }
        };
        (extent(center.left(outer), center.left(inner)), extent(center.right(inner), center.right(outer)))
    }
}

/// The vertical through the centre: the column that holds it, and where it is from there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Center {
    column: i32,
    part: i32,
}

impl Center {
    #[inline(always)]
    pub(super) fn new(x: i32) -> Self {
        Self { column: x >> SUBPIXEL_BITS, part: (x & (ONE - 1)) << FINER }
    }

    /// So far to the left, at most 2^30 and a few pixels.
    #[inline(always)]
    pub(super) fn left(self, width: u32) -> i32 {
        self.part - width.cast_signed()
    }

    #[inline(always)]
    pub(super) fn right(self, width: u32) -> i32 {
        self.part + width.cast_signed()
    }

    #[inline(always)]
    pub(super) fn column_at(self, place: i32) -> i32 {
        self.column + (place >> BITS)
    }
}

/// A circle of at most [`LARGEST_RADIUS`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Outline {
    pub(super) radius: u32,
    /// The square of the longest chord, in 2^-20 square pixel.
    longest_square: u32,
}

impl Outline {
    #[inline(always)]
    pub(super) fn new(radius: u32) -> Self {
        // In 2^-10 pixel: `s^3 = 15 R / 64`, but no longer than a quarter of the radius, and below 4 pixels.
        let cube = u64::from(15 * radius) << 16;
        let mut longest = 0_u32;
        for bit in (0..12).rev() {
            let longer = longest | 1 << bit;
            if u64::from(longer * longer) * u64::from(longer) <= cube {
                longest = longer;
            }
        }
        let longest = longest.min(radius);
        Self { radius: radius << FINER, longest_square: longest * longest }
    }

    /// The point at a height, which is at most the radius from the centre.
    #[inline(always)]
    pub(super) fn at(&self, y: i32) -> Point {
        Point { width: self.other_leg(y.unsigned_abs()), y }
    }

    /// Of a right triangle, of which the radius is the hypotenuse.
    #[inline(always)]
    fn other_leg(&self, leg: u32) -> u32 {
        root(u64::from(self.radius - leg) * u64::from(self.radius + leg))
    }

    /// The chord between two points, unless it is too long.
    #[inline(always)]
    pub(super) fn chord(&self, upper: Point, lower: Point) -> Option<Chord> {
        let (across, down) = (upper.width.abs_diff(lower.width), lower.y.abs_diff(upper.y));
        // In a row, each is below 46 pixels, and 5/4 of the square below 2^32.
        let across_square = (across >> 10) * (across >> 10);
        let square = across_square + (down >> 10) * (down >> 10);
        let stretched = if across > down { across_square / 4 } else { 0 };
        if square + stretched > self.longest_square {
            return None;
        }
        // What is to make up for, `s^3 / 12 R`, is `height * s^2 / 12 x`, with `x` half-way between the ends.
        let outwards = (square << 8) / (6 * ((upper.width + lower.width) >> 12)).max(1);
        let excess = 16_u32.saturating_sub(across.leading_zeros());
        Some(Chord {
            upper: upper.width + outwards,
            lower: lower.width + outwards,
            height: height_in::<BITS>(down.cast_signed()),
            // 16 bits: a pixel's area is off by a few 2^-16.
            steepness: Steepness::of(down >> excess, across >> excess),
        })
    }

    /// As many chords as it takes between two points, from top to bottom.
    pub(super) fn chords(&self, upper: Point, lower: Point, piece: &mut impl FnMut(&Chord)) {
        if let Some(chord) = self.chord(upper, lower) {
            return piece(&chord);
        }
        let middle = self.middle(upper, lower);
        self.chords(upper, middle, piece);
        self.chords(middle, lower, piece);
    }

    /// A point of the arc between two.
    #[inline(always)]
    fn middle(&self, upper: Point, lower: Point) -> Point {
        if upper.y < 0 && lower.y > 0 {
            return Point { width: self.radius, y: 0 };
        }
        let (least, most) = (upper.width.min(lower.width), upper.width.max(lower.width));
        let down = lower.y.abs_diff(upper.y);
        if most - least >= down {
            let width = least + (most - least) / 2;
            let y = self.other_leg(width).cast_signed();
            let y = if upper.y < 0 { -y } else { y };
            // A root may be off by a unit.
            Point { width, y: y.max(upper.y).min(lower.y) }
        } else {
            let y = upper.y + (down / 2).cast_signed();
            Point { width: self.other_leg(y.unsigned_abs()).max(least).min(most), y }
        }
    }
}

/// The square root, to 2^-30 of it.
#[inline(always)]
fn root(square: u64) -> u32 {
    let more = square.leading_zeros() & !1;
    if more >= 64 {
        return 0;
    }
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let top = ((square << more) >> 32) as u32;
    // 16 bits, and 16 more by the tangent there, which is at most 2^-16 of the last of the first too high.
    let root = root_of_normal(top);
    let rest = (top - root * root).min(2 * root - 1);
    // Never 0, but the compiler does not know, and would check.
    ((root << 16) + (rest << 15) / root.max(1)) >> (more / 2)
}

/// The square root of at least 2^30, rounded down, in half the instructions of `isqrt`, which takes any number.
///
/// A line is off by at most 3 % of it; two steps of Newton's make that 0.0005, then 10^-7, or less than 0.01. Both are means, of a
/// number and of what the square is of it, and so not below the root.
#[inline(always)]
fn root_of_normal(square: u32) -> u32 {
    // `0.34315 x + 0.6863`, for `x` from 1 to 4.
    let guess = (((square >> 16) * 44_977) >> 16) + 22_489;
    let nearer = |root: u32| (root + square / root.max(1)) / 2;
    let root = nearer(nearer(guess)).min(0xFFFF);
    root - u32::from(root * root > square)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Around every square of 16 bits, where the root changes.
    #[test]
    fn roots_of_normal_numbers_are_rounded_down() {
        for root in 1 << 15..1_u32 << 16 {
            for square in [root * root, root * root + root, root * root + 2 * root] {
                assert_eq!(root_of_normal(square), root, "{square}");
            }
        }
    }
}
