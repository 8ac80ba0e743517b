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

use core::ops::Range;

use crate::{
    area::{
        AreaSink, PlacedAreaSink, WINDOW,
        root::root,
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
        let relative = |at: i32, corner: i32| (i64::from(at) << FINER) - (i64::from(corner) << FINE_BITS);
        let circle = Circle {
            x: relative(center.0, corner.0),
            y: relative(center.1, corner.1),
            radius: i64::from(radius) << FINER,
            bulge: (
                (u32::MAX / radius.max(1) / 3).saturating_mul(4),
                (u32::MAX / radius.max(1) / radius.max(1)).saturating_mul(3) / 40,
            ),
            parts: if radius >= 563 {
                0
            } else if radius >= 256 {
                2
            } else {
                4
            },
        };
        sink.place(corner);
        circle.send(size, sink)
    };
    let is_near = u64::from(radius) << FINER <= REACH;
    if is_near {
        send((columns.start, rows.start), (columns.end - columns.start, rows.end - rows.start));
    } else {
        for_each_tile(rows, columns, |_, corner, size| send(corner, size));
    }
}

/// How far a point of the outline is from the vertical through the centre, and how far below the horizontal through it.
#[derive(Debug, Clone, Copy)]
struct Point {
    x: i64,
    y: i64,
}

/// What a quarter has of a row, or of a part of it: from where it is nearest to the vertical through the centre to where it
/// is farthest.
#[derive(Debug)]
struct Arc {
    nearest: i64,
    farthest: i64,
    /// From the horizontal through the centre to where it is farthest from the vertical, and from there to where it is nearest.
    beyond: i64,
    height: i32,
}

/// From the corner of what is drawn.
struct Circle {
    x: i64,
    y: i64,
    radius: i64,
    /// `1 / 12 R`, in 2^-28, and `3 / 40 R^2`, in 2^-16.
    bulge: (u32, u32),
    /// Into how many parts a row is cut, as a power of two.
    parts: u32,
}

impl Circle {
    #[inline(never)]
    fn send(&self, (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
        let row_of = |y: i64| narrow(y) >> FINE_BITS;
        let (first, end) = (row_of(self.y - self.radius).max(0), height.min(row_of(self.y + self.radius - 1) + 1));
        let mut top = self.point_below(first, 0);
        let mut areas = [0; WINDOW];
        for row in first..end {
            let bottom = self.point_below(row + 1, 0);
            let nearest = top.x.min(bottom.x);
            let farthest = if top.y < 0 && bottom.y > 0 { self.radius } else { top.x.max(bottom.x) };
            let column = |x: i64| narrow(x) >> FINE_BITS;
            let inside = narrow(bottom.y - top.y) << TO_AREA;
            let around = Row {
                row,
                width,
                left: column(self.x - farthest)..column(self.x - nearest) + 1,
                right: column(self.x + nearest)..column(self.x + farthest) + 1,
                inside,
            };
            let add = |sides: Sides, start: i32, areas: &mut [i32]| {
                areas.fill(if sides == Sides::Both { -inside } else { 0 });
                let left = self.x - (i64::from(start) << FINE_BITS);
                let right = (i64::try_from(areas.len()).unwrap_or(0) << FINE_BITS) - left;
                let mut above = top;
                for part in 1..=1 << self.parts {
                    let below = if part == 1 << self.parts { bottom } else { self.point_below(row, part) };
                    self.each_arc(above, below, |arc| {
                        if sides != Sides::Right {
                            self.add(arc, left, areas.iter_mut());
                        }
                        if sides != Sides::Left {
                            self.add(arc, right, areas.iter_mut().rev());
                        }
                    });
                    above = below;
                }
            };
            if !around.send(&mut areas, add, sink) {
                return false;
            }
            top = bottom;
        }
        true
    }

    /// The point so many parts of a row below its top, or the pole that is nearer.
    #[inline]
    fn point_below(&self, row: i32, parts: i32) -> Point {
        let y = (i64::from(row) << FINE_BITS) + i64::from(parts << (FINE_BITS - self.parts)) - self.y;
        let y = y.max(-self.radius).min(self.radius);
        Point { x: self.other_leg(y.abs()), y }
    }

    /// The arcs between two heights.
    #[inline]
    fn each_arc(&self, above: Point, below: Point, mut found: impl FnMut(&Arc)) {
        let mut arc = |nearest: Point, farthest: Point| {
            let (end, beyond) = (nearest.y.abs(), farthest.y.abs());
            found(&Arc { nearest: nearest.x, farthest: farthest.x, beyond, height: narrow(end - beyond) });
        };
        if above.y >= 0 {
            arc(below, above);
        } else if below.y <= 0 {
            arc(above, below);
        } else {
            let middle = Point { x: self.radius, y: 0 };
            arc(above, middle);
            arc(below, middle);
        }
    }

    /// Of a right triangle, of which the radius is the hypotenuse.
    #[inline]
    fn other_leg(&self, leg: i64) -> i64 {
        root((self.radius - leg).max(0).unsigned_abs(), (self.radius + leg).unsigned_abs()).cast_signed()
    }

    /// Adds what an arc on the left leaves of pixels to its right, the first of which begins at `center` to the left of the
    /// centre.
    #[inline(never)]
    fn add<'a>(&self, arc: &Arc, center: i64, areas: impl Iterator<Item = &'a mut i32>) {
        let (left, right) = (narrow(center - arc.farthest), narrow(center - arc.nearest));
        let height_at = |x: i32| {
            let height = self.other_leg(center - i64::from(x)) - arc.beyond;
            narrow(height).max(0).min(arc.height)
        };
        let (mut x, mut border, mut below) = (left, 0, 0);
        if left < 0 && right >= 0 {
            (x, below) = (0, height_at(0));
        }
        for area in areas {
            let from = border;
            border += FINE_ONE;
            if left >= border {
                continue;
            }
            if right < from {
                *area += arc.height << TO_AREA;
                continue;
            }
            let (to, above) = if right < border { (right, arc.height) } else { (border, height_at(border).max(below)) };
            let (dx, dy) = ((to - x).unsigned_abs(), (above - below).unsigned_abs());
            let beside = (2 * border - to - x).unsigned_abs() / 2;
            *area += (below << TO_AREA) + ((beside.min(0xFFFF) * dy) >> (32 - 24)).cast_signed() + self.segment(dx, dy);
            (x, below) = (to, above);
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

/// What is farther than 8192 pixels is moved closer.
#[inline]
fn narrow(at: i64) -> i32 {
    const FAR: i32 = 1 << 30;
    i32::try_from(at).unwrap_or(if at < 0 { -FAR } else { FAR })
}
