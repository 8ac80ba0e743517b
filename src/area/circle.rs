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
//! of which two terms are taken. The third is `s^7 / 1195 R^5`: with `s^2 <= 2`, that is less than 0.0002, or 0.05 of 1/255,
//! for a radius of 2.2 pixels. Rows of smaller circles are cut in four or sixteen, so that chords are short enough.
//!
//! Both sides are the same but for where the columns' borders are: where the centre lies on a border or in the middle between
//! two, the right side is the left one, mirrored. Everything is worked out from a row and a column alone, so no clip changes a
//! bit. Lengths are in 2^-16 pixel.

use core::ops::Range;

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
    let mut send = |corner: (i32, i32), size: (i32, i32)| {
        sink.place(corner);
        Circle::new(center, radius, corner).send(size, sink)
    };
    if u64::from(radius) << FINER <= REACH {
        send((columns.start, rows.start), (columns.end - columns.start, rows.end - rows.start));
    } else {
        for_each_tile(rows, columns, |_, corner, size| send(corner, size));
    }
}

/// A height, and where the outline is at it.
#[derive(Debug, Clone, Copy)]
struct Section {
    y: i32,
    left: i32,
    right: i32,
}

/// What a row has of a circle: between two sections, with the widest of all.
struct Part {
    top: Section,
    bottom: Section,
    middle: Section,
    row: i32,
}

/// From the corner of what is drawn.
struct Circle {
    x: i64,
    y: i64,
    radius: i64,
    poles: (i32, i32),
    /// Whether 32 bits are enough for all of them.
    is_near: bool,
    /// `1 / 12 R`, in 2^-28, and `3 / 40 R^2`, in 2^-16.
    bulge: (u32, u32),
    /// Into how many parts a row is cut, as a power of two.
    parts: u32,
}

impl Circle {
    fn new(center: (i32, i32), radius: u32, corner: (i32, i32)) -> Self {
        let relative = |at: i32, corner: i32| (i64::from(at) << FINER) - (i64::from(corner) << FINE_BITS);
        let inverse = u32::MAX / radius.max(1);
        let bulge = ((inverse / 3).saturating_mul(4), (inverse / radius.max(1)).saturating_mul(3) / 40);
        let parts = if radius >= WHOLE_ROWS {
            0
        } else if radius >= QUARTERS {
            2
        } else {
            4
        };
        let (x, y) = (relative(center.0, corner.0), relative(center.1, corner.1));
        let radius = i64::from(radius) << FINER;
        let is_near = radius.unsigned_abs() <= REACH;
        Self { x, y, radius, poles: (narrow(y - radius), narrow(y + radius)), is_near, bulge, parts }
    }

    #[inline(never)]
    fn send(&self, (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
        let poles = self.poles;
        let (first, end) = ((poles.0 >> FINE_BITS).max(0), height.min(((poles.1 - 1) >> FINE_BITS) + 1));
        let middle =
            Section { y: narrow(self.y), left: narrow(self.x - self.radius), right: narrow(self.x + self.radius) };
        // Both sides are the same, then.
        let is_symmetric = self.x & i64::from(FINE_ONE / 2 - 1) == 0;
        let mut top = self.section(first << FINE_BITS);
        let mut areas = [0; WINDOW];
        for row in first..end {
            let bottom = self.section((row + 1) << FINE_BITS);
            let widest = if top.y < middle.y && bottom.y > middle.y { middle } else { top };
            let inside = (bottom.y - top.y) << TO_AREA;
            let columns = |from: i32, to: i32| from >> FINE_BITS..(to >> FINE_BITS) + 1;
            let left = columns(widest.left.min(bottom.left), top.left.max(bottom.left));
            let right = columns(top.right.min(bottom.right) - 1, widest.right.max(bottom.right) - 1);
            let part = Part { top, bottom, middle, row };
            let is_apart = left.end < right.start && left.start >= 0 && right.end <= width;
            let goes_on = if is_symmetric
                && is_apart
                && let Some(side) = areas.get_mut(..left.len())
            {
                side.fill(0);
                self.add_part(&part, Sides::Left, left.start, side);
                sink.run(row, left.start, side) && sink.span(row, left.end..right.start, inside) && {
                    side.reverse();
                    sink.run(row, right.start, side)
                }
            } else {
                let cover = |sides: Sides, start: i32, areas: &mut [i32]| {
                    areas.fill(if sides == Sides::Both { -inside } else { 0 });
                    self.add_part(&part, sides, start, areas);
                };
                Row { row, width, left, right, inside }.send(&mut areas, cover, sink)
            };
            if !goes_on {
                return false;
            }
            top = bottom;
        }
        true
    }

    /// Adds what a row has of some sides to pixels from `start` on.
    #[inline(never)]
    fn add_part(&self, part: &Part, sides: Sides, start: i32, areas: &mut [i32]) {
        let Part { top: mut above, bottom, middle, row } = *part;
        let start = start << FINE_BITS;
        for part in 1..=1 << self.parts {
            let below = if part == 1 << self.parts {
                bottom
            } else {
                self.section((row << FINE_BITS) + (part << (FINE_BITS - self.parts)))
            };
            let (pole, inner) = if above.y >= middle.y {
                (below, above)
            } else if below.y <= middle.y {
                (above, below)
            } else {
                self.add(above, middle, sides, start, areas);
                (below, middle)
            };
            self.add(pole, inner, sides, start, areas);
            above = below;
        }
    }

    /// The section at a height, or the pole that is nearer.
    #[inline(never)]
    fn section(&self, y: i32) -> Section {
        let y = y.max(self.poles.0).min(self.poles.1);
        if self.is_near {
            let (x, across) = (low(self.x), self.near_leg(y - low(self.y)));
            return Section { y, left: x - across, right: x + across };
        }
        let across = self.far_leg(i64::from(y) - self.y);
        Section { y, left: narrow(self.x - across), right: narrow(self.x + across) }
    }

    /// How much farther than some height the outline is from the horizontal through the centre in a column.
    #[inline]
    fn rise(&self, x: i32, y: i32) -> i32 {
        if self.is_near {
            return self.near_leg(x - low(self.x)) - (y - low(self.y)).abs();
        }
        narrow(self.far_leg(i64::from(x) - self.x) - (i64::from(y) - self.y).abs())
    }

    /// Of a right triangle, of which the radius is the hypotenuse.
    #[inline]
    fn near_leg(&self, leg: i32) -> i32 {
        let (radius, leg) = (low(self.radius).unsigned_abs(), leg.unsigned_abs());
        root_of_word(u64::from(radius.saturating_sub(leg)) * u64::from(radius + leg)).cast_signed()
    }

    #[cold]
    #[inline(never)]
    fn far_leg(&self, leg: i64) -> i64 {
        let (radius, leg) = (self.radius.unsigned_abs(), leg.unsigned_abs());
        root(radius.saturating_sub(leg), radius + leg).cast_signed()
    }

    /// Adds what is between the arcs on some sides from one section to the one that is nearer to the centre, to pixels from
    /// `start` on: of the left side's pixels what it leaves to its right, of the right one's what it leaves to its left.
    fn add(&self, pole: Section, middle: Section, sides: Sides, start: i32, areas: &mut [i32]) {
        let heights = (pole.y, middle.y);
        if sides != Sides::Right {
            self.add_arc((middle.left - start, pole.left - start), heights, (start, 1), areas);
        }
        if sides != Sides::Left {
            let end = start + (i32::try_from(areas.len()).unwrap_or(0) << FINE_BITS);
            areas.reverse();
            self.add_arc((end - middle.right, end - pole.right), heights, (end, -1), areas);
            areas.reverse();
        }
    }

    /// Adds one of them: from its left end to its right one, in columns from one on, or backwards.
    #[inline(never)]
    fn add_arc(
        &self,
        (left, right): (i32, i32),
        (pole, middle): (i32, i32),
        (start, direction): (i32, i32),
        areas: &mut [i32],
    ) {
        let height = pole.abs_diff(middle).cast_signed();
        let height_at = |x: i32| self.rise(start + direction * x, middle).max(0).min(height);
        let (mut x, mut below) = (left, 0);
        if left < 0 && right >= 0 {
            (x, below) = (0, height_at(0));
        }
        let mut border = x.max(0) & -FINE_ONE;
        let mut areas = areas.iter_mut().skip((border >> FINE_BITS).unsigned_abs() as usize);
        while border <= right {
            let Some(area) = areas.next() else { return };
            border += FINE_ONE;
            let (to, above) = if right < border { (right, height) } else { (border, height_at(border).max(below)) };
            let (dx, dy) = ((to - x).unsigned_abs(), (above - below).unsigned_abs());
            let beside = (2 * border - to - x).unsigned_abs() / 2;
            *area += (below << TO_AREA) + ((beside.min(0xFFFF) * dy) >> (32 - 24)).cast_signed() + self.segment(dx, dy);
            (x, below) = (to, above);
        }
        for area in areas {
            *area += height << TO_AREA;
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

/// The lower half of what is near.
#[inline]
fn low(at: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "it is near")]
    let low = at as i32;
    low
}

/// What is farther than 16384 pixels is moved closer.
#[inline]
fn narrow(at: i64) -> i32 {
    const FAR: i64 = 1 << 30;
    low(at.clamp(-FAR, FAR))
}
