//! Circles: in each row, chords of the left half and of the right one, which are mirrored.
//!
//! An arc of length `s` and its chord enclose `s^3 / 12 R` (in pixels). Each chord is moved outwards along its rows by what makes
//! up for that, so what lies wholly within a pixel is right.
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
//! With `s^3 <= 0.0186 R`, that is 0.00039 of a pixel, or 0.1 of 1/255. Lengths are in 2^-16 pixel.

use core::ops::Range;

use crate::{
    area::{
        AreaSink, PlacedAreaSink,
        accumulator::{Accumulator, Steepness},
        convex::ConvexRows,
        source::{FINE_BITS, FINE_ONE},
    },
    limits::SUBPIXEL_BITS,
};

/// From 1/256 pixel to 2^-16.
const FINER: u32 = FINE_BITS - SUBPIXEL_BITS;

/// Sends the areas of a circle in some rows and columns; `center` and `radius` are in 1/256 pixel, the radius
/// positive.
pub(crate) fn send_circle(
    center: (i32, i32),
    radius: i32,
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut dyn PlacedAreaSink,
) {
    let relative = |at: i32, corner: i32| (i64::from(at) << FINER) - (i64::from(corner) << FINE_BITS);
    let circle = Circle {
        x: relative(center.0, columns.start),
        y: relative(center.1, rows.start),
        radius: u64::from(radius.unsigned_abs()) << FINER,
        longest: longest_chord(radius.unsigned_abs()),
        width: columns.end - columns.start,
    };
    sink.place((columns.start, rows.start));
    circle.send(rows.end - rows.start, sink);
}

/// In 2^-16 pixel: the cube root of 0.0186 radii, at most a quarter of the radius and two pixels.
fn longest_chord(radius: u32) -> u64 {
    // In 2^-12 pixel. The cube is `0.0186 R 2^36`, with `R` in 1/256 pixel.
    let cube = u64::from(radius) * (((186_u64 << 36) / 10_000) >> SUBPIXEL_BITS);
    let mut root = 0_u32;
    for bit in (0..13).rev() {
        let more = root | 1 << bit;
        if u64::from(more * more) * u64::from(more) <= cube {
            root = more;
        }
    }
    u64::from(root << 4).min(u64::from(radius) << (FINER - 2))
}

/// A point of the right lower quarter: how far from the centre to the right, and down.
#[derive(Debug, Clone, Copy)]
struct Point {
    x: u64,
    y: u64,
}

/// In 2^-16 pixel, from the corner of what is drawn.
struct Circle {
    x: i64,
    y: i64,
    radius: u64,
    longest: u64,
    width: i32,
}

impl Circle {
    #[inline(never)]
    fn send(&self, height: i32, sink: &mut dyn AreaSink) -> bool {
        let radius = self.radius.cast_signed();
        let row_of = |y: i64| i32::try_from(y >> FINE_BITS).unwrap_or(i32::MAX);
        let (first, end) = (row_of(self.y - radius).max(0), row_of(self.y + radius - 1).saturating_add(1).min(height));
        let mut rows = ConvexRows::new(self.width);
        let border = |row: i32| {
            let y = ((i64::from(row) << FINE_BITS) - self.y).max(-radius).min(radius);
            (y, self.at_height(y.unsigned_abs()))
        };
        let (mut top_y, mut top) = border(first);
        for row in first..end {
            let (bottom_y, bottom) = border(row + 1);
            let (outer, inner) = if top_y < 0 && bottom_y > 0 {
                (self.radius, top.x.min(bottom.x))
            } else {
                (top.x.max(bottom.x), top.x.min(bottom.x))
            };
            let add = |accumulator: &mut Accumulator| {
                if top_y < 0 && bottom_y > 0 {
                    let middle = Point { x: self.radius, y: 0 };
                    self.add_arc(top, middle, accumulator);
                    self.add_arc(bottom, middle, accumulator);
                } else if top_y < 0 {
                    self.add_arc(top, bottom, accumulator);
                } else {
                    self.add_arc(bottom, top, accumulator);
                }
            };
            // Chords are moved outwards by less than a pixel.
            let outer = outer + u64::from(FINE_ONE.unsigned_abs());
            let column = |x: i64| i32::try_from(x >> FINE_BITS).unwrap_or(if x < 0 { i32::MIN } else { i32::MAX });
            let (outer, inner) = (outer.cast_signed(), inner.cast_signed());
            let extents =
                (column(self.x - outer)..column(self.x - inner), column(self.x + inner)..column(self.x + outer));
            if !rows.send(row, extents, add, sink) {
                return false;
            }
            (top_y, top) = (bottom_y, bottom);
        }
        true
    }

    /// The point at a distance from the horizontal through the centre.
    #[inline]
    fn at_height(&self, y: u64) -> Point {
        Point { x: self.other_leg(y), y }
    }

    /// Of a right triangle, of which the radius is the hypotenuse.
    #[inline]
    fn other_leg(&self, leg: u64) -> u64 {
        root(self.radius - leg, self.radius + leg)
    }

    /// Adds the arcs between two points, on the left and on the right; the first is the nearer one to the pole.
    fn add_arc(&self, mut from: Point, to: Point, accumulator: &mut Accumulator) {
        // Nearer to the vertical through the centre than this, nothing is seen, and nothing farther than that.
        let right = (i64::from(self.width) << FINE_BITS) - self.x;
        let margin = 1 << FINE_BITS;
        let nearest = (-self.x).max(-right).saturating_sub(margin).max(0).unsigned_abs();
        let farthest = self.x.max(right).saturating_add(margin).max(0).unsigned_abs();
        while from.y > to.y {
            let next = self.next(from, to, nearest, farthest);
            self.add_chord(from, next, accumulator);
            from = next;
        }
    }

    /// The end of a chord that is not too long, away from the pole.
    #[inline]
    fn next(&self, from: Point, to: Point, nearest: u64, farthest: u64) -> Point {
        if from.x > farthest {
            return to;
        }
        // Of a chord with a slope of at most 1/2 or 1, along the longer side: by sqrt(4/5) and sqrt(1/2).
        let step = |is_flat: bool| (self.longest * if is_flat { 229 } else { 181 }) >> 8;
        if from.x < from.y {
            let step = step(2 * from.x < from.y).max(1);
            let mut x = from.x + step;
            // As many more as are not seen.
            if nearest > x && 2 * nearest + u64::from(FINE_ONE.unsigned_abs()) < from.y {
                x += (nearest - x).checked_div(step).unwrap_or(0) * step;
            }
            let y = if x < to.x { self.other_leg(x) } else { 0 };
            if y > to.y { Point { x, y: y.min(from.y) } } else { to }
        } else {
            let y = from.y.saturating_sub(step(2 * from.y < from.x).max(1));
            if y > to.y { self.at_height(y) } else { to }
        }
    }

    #[inline]
    fn add_chord(&self, from: Point, to: Point, accumulator: &mut Accumulator) {
        let height = from.y - to.y;
        let across = to.x.abs_diff(from.x);
        // What is to make up for, `s^3 / 12 R`, is `height * s^2 / 12 x`, with `x` half-way between the ends.
        let outwards = if across < 1 << 18 {
            let (across, height) = (across >> 6, height >> 6);
            // In 2^-20 pixel, and 2^-17 below.
            let square = across * across + height * height;
            divide(square << 11, (3 * (to.x + from.x)).max(1))
        } else {
            0
        };
        let dy = i32::try_from(height).unwrap_or(0);
        let place = |x: i64| x << FINE_BITS;
        let (near, far) = ((from.x + outwards).cast_signed(), (to.x + outwards).cast_signed());
        let steepness = || Steepness::of_segment(across << FINE_BITS, dy.unsigned_abs());
        accumulator.add(place(self.x - near), place(self.x - far), dy, 1, steepness);
        accumulator.add(place(self.x + near), place(self.x + far), dy, -1, steepness);
    }
}

/// The square root of a product, to 2^-30 of it.
#[inline]
fn root(a: u64, b: u64) -> u64 {
    if let (Ok(a), Ok(b)) = (u32::try_from(a), u32::try_from(b)) {
        root_of_word(u64::from(a) * u64::from(b)).into()
    } else {
        root_of_wide(u128::from(a) * u128::from(b))
    }
}

/// A quotient, in words of 32 bits where they are wide enough.
#[inline]
fn divide(a: u64, b: u64) -> u64 {
    match (u32::try_from(a), u32::try_from(b)) {
        (Ok(a), Ok(b)) => a.checked_div(b).unwrap_or(0).into(),
        _ => a.checked_div(b).unwrap_or(0),
    }
}

#[inline]
fn root_of_word(square: u64) -> u32 {
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
#[inline]
fn root_of_normal(square: u32) -> u32 {
    // `0.34315 x + 0.6863`, for `x` from 1 to 4.
    let guess = (((square >> 16) * 44_977) >> 16) + 22_489;
    let nearer = |root: u32| (root + square / root.max(1)) / 2;
    let root = nearer(nearer(guess)).min(0xFFFF);
    root - u32::from(root * root > square)
}

/// Bit by bit, for circles of more than 32768 pixels.
#[cold]
#[inline(never)]
fn root_of_wide(square: u128) -> u64 {
    let mut root = 0_u64;
    for bit in (0..48).rev() {
        let more = root | 1 << bit;
        if u128::from(more) * u128::from(more) <= square {
            root = more;
        }
    }
    root
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
