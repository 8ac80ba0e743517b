//! Anti-aliased thin line: the rectangle of width 1 around it.
//!
//! Its corners lie half a pixel to either side of the ends, which no coordinate can say exactly: they are rounded to 2^-16
//! pixel, so no pixel's area is off by more than 2^-15.
//!
//! ```text
//!          top
//!           .-.
//!          /   \.
//!      left \     \.
//!            \.     \ right
//!              \.   /
//!                '.'  bottom
//! ```

use crate::{
    PixelRect, Vertex,
    area::{
        PlacedAreaSink, Rounded, division::ratio, root::root_of_word, send_convex, source::FINE_BITS, vertex_position,
    },
    coverage::CoverageSink,
    geometry::{by_height, pixels_between},
    limits::HALF,
    shape::{Cover, Line},
    span::visible,
};

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
        Rounded::send(sink, |areas| self.areas(clip, areas))
    }
}

impl Line {
    /// Sends the areas of the pixels in `clip`, before anything is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let touched = Cover::touched(self);
        let Some((rows, columns)) = visible(&touched, clip) else { return };
        let (upper, lower) = by_height(self.start, self.end);
        send_convex(&corners(upper, lower), &touched, &rows, &columns, sink);
    }
}

/// The corners of the rectangle, clockwise from the topmost.
fn corners(upper: Vertex, lower: Vertex) -> [(i64, i64); 4] {
    let difference = |to: i32, from: i32| i64::from(to) - i64::from(from);
    let dx = difference(lower.x.to_bits(), upper.x.to_bits());
    let dy = difference(lower.y.to_bits(), upper.y.to_bits());
    let (across, up) = half_a_pixel_square_to(dx.unsigned_abs(), dy.unsigned_abs());
    let at = |vertex: Vertex, x: i64, y: i64| {
        let position = vertex_position(vertex);
        (position.0 + x, position.1 + y)
    };
    if dx >= 0 {
        [at(upper, across, -up), at(lower, across, -up), at(lower, -across, up), at(upper, -across, up)]
    } else {
        [at(upper, -across, -up), at(upper, across, up), at(lower, across, up), at(lower, -across, -up)]
    }
}

/// How far, in 2^-16 pixel, half a pixel goes across and up or down, square to (dx, dy), which is not (0, 0).
fn half_a_pixel_square_to(dx: u64, dy: u64) -> (i64, i64) {
    // The longer one has 31 bits then, so that the squares' sum fits, and both below 2^32.
    let zeros = (dx | dy).leading_zeros();
    let normal = |part: u64| u32::try_from(part << (zeros & 63) >> 33).unwrap_or(u32::MAX);
    let (dx, dy) = (normal(dx), normal(dy));
    let length = root_of_word(u64::from(dx) * u64::from(dx) + u64::from(dy) * u64::from(dy));
    // Half of the ratio, from 2^-32 to 2^-16, to the nearest.
    let share = |part: u32| (((ratio(part, length) >> FINE_BITS) + 1) >> 1).cast_signed();
    (share(dy), share(dx))
}
