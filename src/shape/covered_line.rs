//! Anti-aliased thin line: the rectangle of width 1 around it.
//!
//! Its corners lie half a pixel to either side of the ends, which no coordinate can say exactly. In the narrow zone they are
//! rounded to 2^-16 pixel, and the edges have the line's own slope or are square to it, so no pixel's area is off by more
//! than 2^-15. Beyond it, see `wide_line`.
//!
//! ```text
//!          top
//!           .-.  short
//!     short/   \.
//!          \     \.  long
//!        long\     \.
//!              \.   /
//!                '.'  bottom
//! ```

use core::ops::Range;

use crate::{
    PixelRect, Vertex,
    coverage::{CoverageSink, Straight, StraightSide, send_straight},
    geometry::{by_height, is_narrow},
    limits::{HALF, SUBPIXEL_BITS},
    shape::{
        Cover, Line,
        wide_line::{self, pixels_between},
    },
    span::clip_range,
};

/// Bits behind the binary point of a corner.
const CORNER_BITS: u32 = 16;

/// From 2^-16 pixel to a coordinate's 1/256.
const FINER: u32 = CORNER_BITS - SUBPIXEL_BITS;

impl Cover for Line {
    #[inline]
    fn touched(&self) -> PixelRect {
        let Self { start, end } = *self;
        if start == end {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        let pixels = |a: i32, b: i32| {
            pixels_between(i64::from(a.min(b)) - i64::from(HALF), i64::from(a.max(b)) + i64::from(HALF))
        };
        PixelRect {
            rows: pixels(start.y.to_bits(), end.y.to_bits()),
            columns: pixels(start.x.to_bits(), end.x.to_bits()),
        }
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let pixels = self.touched();
        let rows = clip_range(&pixels.rows, &clip.rows);
        let columns = clip_range(&pixels.columns, &clip.columns);
        if rows.is_empty() || columns.is_empty() {
            return Ok(());
        }
        let (upper, lower) = by_height(self.start, self.end);
        if is_narrow(upper) && is_narrow(lower) {
            let rectangle = Rectangle::around(upper, lower);
            let rows = clip_range(&rectangle.rows(), &rows);
            let [left, right] = rectangle.sides();
            send_straight(left, right, rows, &pixels.columns, &columns, sink)
        } else {
            wide_line::send_rows(upper, lower, &rows, &columns, sink)
        }
    }
}

/// In 2^-16 pixel.
type Corner = (i64, i64);

struct Rectangle {
    top: Corner,
    left: Corner,
    right: Corner,
    bottom: Corner,
    /// From the upper end of the line to the lower.
    dx: i64,
    dy: i64,
}

impl Rectangle {
    fn around(upper: Vertex, lower: Vertex) -> Self {
        let difference = |to: i32, from: i32| i64::from(to) - i64::from(from);
        let dx = difference(lower.x.to_bits(), upper.x.to_bits());
        let dy = difference(lower.y.to_bits(), upper.y.to_bits());
        let (across, up) = half_a_pixel_square_to(dx.unsigned_abs(), dy.unsigned_abs());
        let at = |vertex: Vertex, x: i64, y: i64| {
            ((i64::from(vertex.x.to_bits()) << FINER) + x, (i64::from(vertex.y.to_bits()) << FINER) + y)
        };
        if dx >= 0 {
            Self {
                top: at(upper, across, -up),
                left: at(upper, -across, up),
                right: at(lower, across, -up),
                bottom: at(lower, -across, up),
                dx,
                dy,
            }
        } else {
            Self {
                top: at(upper, -across, -up),
                left: at(lower, -across, -up),
                right: at(upper, across, up),
                bottom: at(lower, across, up),
                dx,
                dy,
            }
        }
    }

    /// Those that it has a part of.
    fn rows(&self) -> Range<i32> {
        let row = |y: i64| {
            #[allow(clippy::cast_possible_truncation, reason = "that of a coordinate, or the next")]
            let row = (y >> CORNER_BITS) as i32;
            row
        };
        row(self.top.1)..row(self.bottom.1 - 1) + 1
    }

    /// For corners in the narrow zone, or not far from it.
    fn sides(&self) -> [StraightSide<CORNER_BITS>; 2] {
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^29 + 2^15")]
        let y = |corner: Corner| corner.1 as i32;
        let end = |corner: Corner| (corner.0 << (32 - CORNER_BITS), y(corner));
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^22")]
        let (dx, dy) = (self.dx as i32, self.dy as i32);
        let edge =
            |from: Corner, (dx, dy): (i32, i32), to: Corner| Straight::new(end(from), end(to), dx, dy.unsigned_abs());
        let Self { top, left, right, bottom, .. } = *self;
        // Along the line, and square to it.
        let (long, square) = ((dx, dy), (if dx >= 0 { -dy } else { dy }, dx));
        let (to_left, to_right) = if dx >= 0 { (square, long) } else { (long, square) };
        let side = |via: Corner, direction: (i32, i32), then: (i32, i32)| {
            let lower = (y(via) < y(bottom)).then(|| edge(via, then, bottom));
            match lower {
                Some(edge) if y(via) <= y(top) => StraightSide { edge, next: None },
                next => StraightSide { edge: edge(top, direction, via), next },
            }
        };
        [side(left, to_left, to_right), side(right, to_right, to_left)]
    }
}

/// How far, in 2^-16 pixel, half a pixel goes across and up or down, square to (dx, dy), which is not (0, 0).
fn half_a_pixel_square_to(dx: u64, dy: u64) -> (i64, i64) {
    // Both below 2^32; 31 bits are kept, so that the squares' sum fits, and the more of a short one the better.
    let excess = 33_u32.saturating_sub((dx | dy).leading_zeros());
    let (dx, dy) = (dx >> excess, dy >> excess);
    let square = dx * dx + dy * dy;
    let more = square.leading_zeros() / 2;
    let length = (square << (2 * more)).isqrt().max(1);
    // `part` is at most `length / 2^more`, so `part 2^more` is below 2^32.
    let share = |part: u64| ((part << (more + CORNER_BITS)) / length).div_ceil(2).cast_signed();
    (share(dy), share(dx))
}
