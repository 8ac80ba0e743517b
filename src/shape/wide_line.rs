//! The sides of a thin line's rectangle, anywhere in the range.
//!
//! Nothing is rounded to a coordinate. At any height, a long edge is the line itself, moved by half its width along the row,
//! and a short edge is the line square to it through its end:
//!
//! ```text
//!      upper
//!       .+.                      K = length / 2 dy pixels
//!     .'   '-
//!      '-.    '-.                only the corners' heights are rounded, to 2^-22 pixel: there the edges
//!     |--|'-.    '-.             meet that much too high or too low
//!      K     '-.    '-
//! ```

use core::ops::Range;

use crate::{
    Vertex,
    coverage::{CoverageSink, Side, Steepness, height_in, send, send_within_range},
    limits::{ONE, SUBPIXEL_BITS},
    span::clip_range,
};

/// Bits behind the binary point of a height, in pixels.
const HEIGHT_BITS: u32 = 22;

/// Bits behind the binary point of a position, in pixels.
const POSITION_BITS: u32 = 40;

/// Bits behind the binary point of a length, in 1/256 pixel.
const LENGTH_BITS: u32 = 30;

/// Sends the rows of the rectangle around a line that goes down, or is level.
#[inline(never)]
pub(super) fn send_rows<S: CoverageSink>(
    upper: Vertex,
    lower: Vertex,
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (dx, dy) = (difference(upper.x.to_bits(), lower.x.to_bits()), difference(upper.y.to_bits(), lower.y.to_bits()));
    let square = u128::from(dx.unsigned_abs()).pow(2) + u128::from(dy.unsigned_abs()).pow(2);
    let length = (square << (2 * LENGTH_BITS)).isqrt().max(1);
    // Half a pixel, square to the line: how far it goes up or down, and how far along a row from one long edge to the line.
    let up = (u128::from(dx.unsigned_abs()) << (HEIGHT_BITS - 1 + LENGTH_BITS)) / length;
    let up = i64::try_from(up).unwrap_or(0);
    let along = (length << (POSITION_BITS - 1 - LENGTH_BITS)) / u128::from(dy.unsigned_abs().max(1));
    let along = along.cast_signed();

    let height_of = |vertex: Vertex| i64::from(vertex.y.to_bits()) << (HEIGHT_BITS - SUBPIXEL_BITS);
    let (top, bottom) = (height_of(upper), height_of(lower));
    let long = |moved: i128, heights: Range<i64>| Edge { through: upper, dx, dy, moved, heights };
    let (square_dx, square_dy) = if dx >= 0 { (-dy, dx) } else { (dy, -dx) };
    let short =
        |through: Vertex, heights: Range<i64>| Edge { through, dx: square_dx, dy: square_dy, moved: 0, heights };
    let of_upper = short(upper, top - up..top + up);
    let of_lower = short(lower, bottom - up..bottom + up);
    let (left, right) = if dx >= 0 {
        ([of_upper, long(-along, top + up..bottom + up)], [long(along, top - up..bottom - up), of_lower])
    } else {
        ([long(-along, top - up..bottom - up), of_lower], [of_upper, long(along, top + up..bottom + up)])
    };
    let row = |height: i64| {
        #[allow(clippy::cast_possible_truncation, reason = "that of a coordinate, or the next")]
        let row = (height >> HEIGHT_BITS) as i32;
        row
    };
    let rows = clip_range(&(row(top - up)..row(bottom + up - 1) + 1), rows);
    send(WideSide(left), WideSide(right), rows, columns, sink)
}

fn difference(from: i32, to: i32) -> i64 {
    i64::from(to) - i64::from(from)
}

/// The pixels between two places that may be beyond the range of coordinates, along either axis, as far as they are inside it.
#[inline]
pub(super) fn pixels_between(low: i64, high: i64) -> Range<i32> {
    let pixel = |position: i64| {
        let one = i64::from(ONE);
        let clamped = position.clamp(i64::from(i32::MIN), i64::from(i32::MAX) + 1);
        #[allow(clippy::cast_possible_truncation, reason = "a coordinate, less eight bits")]
        let pixel = clamped.div_euclid(one) as i32;
        pixel
    };
    pixel(low)..pixel(high + i64::from(ONE) - 1)
}

/// A part of a straight line.
#[derive(Debug, Clone)]
struct Edge {
    through: Vertex,
    dx: i64,
    dy: i64,
    /// So far along the row, as a position.
    moved: i128,
    heights: Range<i64>,
}

impl Edge {
    fn position(&self, height: i64) -> i128 {
        let start = i128::from(self.through.x.to_bits()) << (POSITION_BITS - SUBPIXEL_BITS);
        let below = i128::from(height) - (i128::from(self.through.y.to_bits()) << (HEIGHT_BITS - SUBPIXEL_BITS));
        // 47 bits, 33 and 18.
        let across = (below * i128::from(self.dx)) << (POSITION_BITS - HEIGHT_BITS);
        start + self.moved + across / i128::from(self.dy.max(1))
    }
}

/// Two edges, one below the other; either may have no height.
#[derive(Debug, Clone)]
struct WideSide([Edge; 2]);

impl Side for WideSide {
    fn pieces(&mut self, row: i32, mut piece: impl FnMut(i64, i64, u32, Steepness)) {
        let top = i64::from(row) << HEIGHT_BITS;
        let row = top..top + (1 << HEIGHT_BITS);
        for edge in &self.0 {
            let (from, to) = (edge.heights.start.max(row.start), edge.heights.end.min(row.end));
            if from < to {
                let height = height_in::<HEIGHT_BITS>(i32::try_from(to - from).unwrap_or(0));
                send_within_range(edge.position(from), edge.position(to), height, &mut piece);
            }
        }
    }
}
