//! Circles of any size, anywhere in the range, for the few that are not near (see `coverage::NearCircle`).
//!
//! In a row of pixels, the arc is halved by height until a chord of length `s` has `s^2 <= R / 64` (in pixels): then the arc is
//! at most `s^2 / 8R = 1/512` pixel away from it. Two thirds of that are lost along the chord, and no pixel holds more of it
//! than its diagonal: at most 1/543 of the pixel, 0.47 of 1/255. Rows of 1/256 pixel are never halved: there
//! `s^2 <= 2 R / 256 + 1/65536`, and the arc is at most 1/680 pixel away.

use core::ops::Range;

use crate::{
    Vertex,
    coverage::{CoverageSink, Side, Steepness, height_of, send, send_within_range},
    limits::ONE,
    shape::Circle,
};

/// Sends the rows of a circle anywhere.
#[inline(never)]
pub(super) fn send_rows<S: CoverageSink>(
    circle: &Circle,
    rows: Range<i32>,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let arc = Arc { center: circle.center, radius: circle.radius.to_bits(), is_right: false };
    send(arc, Arc { is_right: true, ..arc }, rows, columns, sink)
}

/// The left or the right half.
#[derive(Debug, Clone, Copy)]
struct Arc {
    center: Vertex,
    radius: i32,
    is_right: bool,
}

impl Arc {
    /// How far it is from the vertical through the centre, `dy` below that, as a position.
    fn half_width(self, dy: i64) -> u64 {
        let radius = i64::from(self.radius);
        let square = ((radius - dy) * (radius + dy)).cast_unsigned();
        let more = (square.leading_zeros() & !1).min(62);
        // 16 bits behind the binary point are enough, and there are at least as many up to 2^23.
        if more >= 16 {
            (square << more).isqrt() << 32 >> (more / 2)
        } else {
            let root = (u128::from(square) << 32).isqrt();
            u64::try_from(root).unwrap_or(0) << 16
        }
    }

    fn position(self, half_width: u64) -> i128 {
        let center = i128::from(self.center.x.to_bits()) << 32;
        if self.is_right { center + i128::from(half_width) } else { center - i128::from(half_width) }
    }

    /// The chord between two heights below the centre, or those of its halves.
    fn chords(self, upper: (i64, u64), lower: (i64, u64), piece: &mut impl FnMut(i64, i64, u32, Steepness)) {
        let height = lower.0 - upper.0;
        let across = u128::from(upper.1.abs_diff(lower.1) >> 24);
        let square = across * across + (u128::from(height.unsigned_abs()) << 8).pow(2);
        if height <= 1 || square <= u128::from(self.radius.unsigned_abs()) << 18 {
            let (from, to) = (self.position(upper.1), self.position(lower.1));
            #[allow(clippy::cast_possible_truncation, reason = "at most a pixel")]
            let height = height_of(height as i32);
            return send_within_range(from, to, height, piece);
        }
        let dy = upper.0 + height / 2;
        let middle = (dy, self.half_width(dy));
        self.chords(upper, middle, piece);
        self.chords(middle, lower, piece);
    }
}

impl Side for Arc {
    fn pieces(&mut self, row: i32, mut piece: impl FnMut(i64, i64, u32, Steepness)) {
        let (y, radius) = (i64::from(self.center.y.to_bits()), i64::from(self.radius));
        let top = i64::from(row) * i64::from(ONE) - y;
        let (upper, lower) = (top.max(-radius), (top + i64::from(ONE)).min(radius));
        let at = |dy: i64| (dy, self.half_width(dy));
        if upper < lower {
            self.chords(at(upper), at(lower), &mut piece);
        }
    }
}
