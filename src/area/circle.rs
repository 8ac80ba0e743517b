//! Circles: in each row, the arcs between its top and its bottom, cut where they cross the borders of columns.
//!
//! Within a pixel there is a chord then, from where the outline comes in to where it goes out, and the segment between the chord
//! and the arc. Of a chord of length `s` (in pixels), that is
//!
//! ```text
//!        .--'| arc
//!      .'..-'|                s^3              3  s^2
//!     / -'   |               -----  ( 1  +  ---------  + ... )
//!     |-chord|                12 R            40  R^2
//! ```
//!
//! of which the first term is taken. The second is at most `s^5 / 160 R^3`: with `s^2 <= 2`, that is less than 0.0002 for a radius
//! of 5.6 pixels. Rows of smaller circles are cut in two or eight, so that chords are short enough: 0.0002 is less than 0.06
//! of 1/255.
//!
//! Both sides are the same but for where the columns' borders are. Everything is worked out from a row and a column alone, so
//! no clip changes a bit. Lengths are in 2^-16 pixel.

use core::ops::{Add, Neg, Range, Sub};

use crate::{
    area::{
        AreaSink, PlacedAreaSink, WINDOW,
        root::{root, root_of_word},
        row::{Row, Sides},
        source::{FINE_BITS, FINE_ONE},
        tiles::{REACH, for_each_tile},
    },
    limits::SUBPIXEL_BITS,
};

/// From 1/256 pixel to 2^-16.
const FINER: u32 = FINE_BITS - SUBPIXEL_BITS;

/// From a height to the area of a pixel of that height.
const TO_AREA: u32 = 24 - FINE_BITS;

/// From this radius on, in 1/256 pixel, rows are taken as they are.
const WHOLE_ROWS: u32 = 563;

/// From this one on they are cut in four, below in sixteen.
const QUARTERS: u32 = 256;

/// Sends the areas of a circle in some rows and columns; `center` and `radius` are in 1/256 pixel, the radius
/// positive.
pub(crate) fn send_circle(
    center: (i32, i32),
    radius: i32,
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut dyn PlacedAreaSink,
) {
    let radius = radius.unsigned_abs();
    if u64::from(radius) << FINER <= REACH {
        let size = (columns.end - columns.start, rows.end - rows.start);
        sink.place((columns.start, rows.start));
        Circle::<i32>::new(center, radius, (columns.start, rows.start)).send(size, sink);
        return;
    }
    for_each_tile(rows, columns, |_, corner, size| {
        sink.place(corner);
        Circle::<i64>::new(center, radius, corner).send(size, sink)
    });
}

/// A length in 2^-16 pixel: 32 bits for circles of up to 8192 pixels, 64 for those that are larger.
trait Length: Copy + Ord + From<i32> + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    /// One that is not too long.
    fn new(length: i64) -> Self;

    /// What is farther than 8192 pixels is moved closer.
    fn narrow(self) -> i32;

    /// Of a right triangle, of which this is the hypotenuse.
    fn other_leg(self, leg: Self) -> Self;
}

impl Length for i32 {
    #[inline]
    fn new(length: i64) -> Self {
        #[allow(clippy::cast_possible_truncation, reason = "near")]
        let length = length as Self;
        length
    }

    #[inline]
    fn narrow(self) -> i32 {
        self
    }

    #[inline]
    fn other_leg(self, leg: Self) -> Self {
        let (radius, leg) = (self.unsigned_abs(), leg.unsigned_abs());
        root_of_word(u64::from(radius.saturating_sub(leg)) * u64::from(radius + leg)).cast_signed()
    }
}

impl Length for i64 {
    fn new(length: i64) -> Self {
        length
    }

    fn narrow(self) -> i32 {
        const FAR: i32 = 1 << 30;
        i32::try_from(self).unwrap_or(if self < 0 { -FAR } else { FAR })
    }

    fn other_leg(self, leg: Self) -> Self {
        let (radius, leg) = (self.unsigned_abs(), leg.unsigned_abs());
        root(radius.saturating_sub(leg), radius + leg).cast_signed()
    }
}

/// How far a point of the outline is from the vertical through the centre, and how far below the horizontal through it.
#[derive(Debug, Clone, Copy)]
struct Point<L> {
    x: L,
    y: L,
}

/// What a quarter has of a row, or of a part of it: from where it is nearest to the vertical through the centre to where it
/// is farthest.
struct Arc<L> {
    nearest: L,
    farthest: L,
    /// From the horizontal through the centre to where it is farthest from the vertical, and from there to where it is nearest.
    beyond: L,
    height: i32,
}

/// From the corner of what is drawn.
struct Circle<L> {
    x: L,
    y: L,
    radius: L,
    /// `1 / 12 R`, in 2^-28, and `3 / 40 R^2`, in 2^-16.
    bulge: (u32, u32),
    /// Into how many parts a row is cut, as a power of two.
    parts: u32,
}

impl<L: Length> Circle<L> {
    fn new(center: (i32, i32), radius: u32, corner: (i32, i32)) -> Self {
        let relative = |at: i32, corner: i32| L::new((i64::from(at) << FINER) - (i64::from(corner) << FINE_BITS));
        let inverse = u32::MAX / radius.max(1);
        Self {
            x: relative(center.0, corner.0),
            y: relative(center.1, corner.1),
            radius: L::new(i64::from(radius) << FINER),
            bulge: ((inverse / 3).saturating_mul(4), (inverse / radius.max(1)).saturating_mul(3) / 40),
            parts: if radius >= WHOLE_ROWS {
                0
            } else if radius >= QUARTERS {
                2
            } else {
                4
            },
        }
    }

    #[inline(never)]
    fn send(&self, (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
        let column = |x: L| x.narrow() >> FINE_BITS;
        let (first, end) =
            (column(self.y - self.radius).max(0), height.min(column(self.y + self.radius - L::from(1)) + 1));
        // Both sides are the same, then.
        let is_symmetric = self.x.narrow() & (FINE_ONE / 2 - 1) == 0;
        let mut top = self.point_below(first, 0);
        let mut areas = [0; WINDOW];
        for row in first..end {
            let bottom = self.point_below(row + 1, 0);
            let zero = L::from(0);
            let nearest = top.x.min(bottom.x);
            let farthest = if top.y < zero && bottom.y > zero { self.radius } else { top.x.max(bottom.x) };
            let inside = (bottom.y - top.y).narrow() << TO_AREA;
            let last = |x: L| column(x - L::from(1));
            let left = column(self.x - farthest)..column(self.x - nearest) + 1;
            let right = last(self.x + nearest)..last(self.x + farthest) + 1;
            let around = Row { row, width, left: left.clone(), right: right.clone(), inside };
            let is_mirrored = is_symmetric && left.start >= 0 && right.end <= width && left.len() <= WINDOW;
            let cover = |sides: Sides, start: i32, areas: &mut [i32]| {
                if sides == Sides::Right && is_mirrored {
                    // What is left there of the left side.
                    areas.reverse();
                    return;
                }
                areas.fill(if sides == Sides::Both { -inside } else { 0 });
                let left = self.x - L::new(i64::from(start) << FINE_BITS);
                let right = L::new(i64::try_from(areas.len()).unwrap_or(0) << FINE_BITS) - left;
                if sides != Sides::Right {
                    self.add_parts(row, (top, bottom), left, areas);
                }
                if sides != Sides::Left {
                    areas.reverse();
                    self.add_parts(row, (top, bottom), right, areas);
                    areas.reverse();
                }
            };
            if !around.send(&mut areas, cover, sink) {
                return false;
            }
            top = bottom;
        }
        true
    }

    /// The point so many parts of a row below its top, or the pole that is nearer.
    #[inline]
    fn point_below(&self, row: i32, parts: i32) -> Point<L> {
        let y = L::new(i64::from(row) << FINE_BITS) + L::from(parts << (FINE_BITS - self.parts)) - self.y;
        let y = y.max(-self.radius).min(self.radius);
        Point { x: self.radius.other_leg(y), y }
    }

    /// Adds what a row's arcs on the left leave of pixels to their right, the first of which begins at `center` to the left of
    /// the centre.
    #[inline(never)]
    fn add_parts(&self, row: i32, (mut above, bottom): (Point<L>, Point<L>), center: L, areas: &mut [i32]) {
        let mut arc = |nearest: Point<L>, farthest: Point<L>| {
            let (end, beyond) = (nearest.y.max(-nearest.y), farthest.y.max(-farthest.y));
            let height = (end - beyond).narrow();
            self.add(&Arc { nearest: nearest.x, farthest: farthest.x, beyond, height }, center, areas);
        };
        let (zero, parts) = (L::from(0), 1 << self.parts);
        for part in 1..=parts {
            let below = if part == parts { bottom } else { self.point_below(row, part) };
            if above.y >= zero {
                arc(below, above);
            } else if below.y <= zero {
                arc(above, below);
            } else {
                let middle = Point { x: self.radius, y: zero };
                arc(above, middle);
                arc(below, middle);
            }
            above = below;
        }
    }

    #[inline(never)]
    fn add(&self, arc: &Arc<L>, center: L, areas: &mut [i32]) {
        let (left, right) = ((center - arc.farthest).narrow(), (center - arc.nearest).narrow());
        let height_at = |x: i32| {
            let height = self.radius.other_leg(center - L::from(x)) - arc.beyond;
            height.narrow().max(0).min(arc.height)
        };
        let (mut x, mut below) = (left, 0);
        if left < 0 && right >= 0 {
            (x, below) = (0, height_at(0));
        }
        let mut border = x.max(0) & -FINE_ONE;
        let mut areas = areas.iter_mut().skip((border >> FINE_BITS).unsigned_abs() as usize);
        while border <= right {
            let Some(area) = areas.next() else { return };
            border += FINE_ONE;
            let (to, above) = if right < border { (right, arc.height) } else { (border, height_at(border).max(below)) };
            let (dx, dy) = ((to - x).unsigned_abs(), (above - below).unsigned_abs());
            let beside = (2 * border - to - x).unsigned_abs() / 2;
            *area += (below << TO_AREA) + ((beside.min(0xFFFF) * dy) >> (32 - 24)).cast_signed() + self.segment(dx, dy);
            (x, below) = (to, above);
        }
        for area in areas {
            *area += arc.height << TO_AREA;
        }
    }

    /// The area between a chord and its arc, in 2^-24 pixel.
    #[inline]
    fn segment(&self, dx: u32, dy: u32) -> i32 {
        // In 2^-14 pixel, and its square in 2^-28.
        let (dx, dy) = (dx >> 2, dy >> 2);
        let square = dx * dx + dy * dy;
        // 7 % too long at most, 0.2 % after a step of Newton's.
        let guess = dx.max(dy) + dx.min(dy) * 3 / 8;
        let length = u32::midpoint(guess, square / guess.max(1));
        let cube = (square >> 14) * length;
        let area = (u64::from(cube) * u64::from(self.bulge.0)) >> 32;
        #[allow(clippy::cast_possible_truncation, reason = "at most a quarter of a pixel")]
        let area = area as u32;
        let more = ((square >> 14) * self.bulge.1) >> 18;
        (area + ((area * more) >> 12)).cast_signed()
    }
}
