//! The pieces of crossing chains within one pixel: from height to height, so that between two of them nothing begins, ends
//! or crosses.
//!
//! ```text
//!     y   --\---/------      where the two cross, the band ends: above, one is to the left, below the other
//!            \ /
//!     to  ----X--------      rounded to 2^-16 pixel, which moves no area by more than that
//!            / \
//! ```
//!
//! J. L. Bentley and T. A. Ottmann, "Algorithms for reporting and counting geometric intersections", 1979, with the few
//! pieces of a pixel in place of trees.

use crate::{
    area::{accumulator::Accumulator, chain::Line, source::FINE_ONE, winding::Level},
    outline::WindingRule,
};

/// So many pieces have room, 56 bytes of stack each.
///
/// The same everywhere: what does not fit may be rounded another way, and hosts have a board's bits.
pub(super) const MOST: usize = 24;

/// What the rounding of columns may make of two that are equal, in 2^-32 pixel: 2^-17 pixel.
const TOLERANCE: i64 = 1 << 15;

/// How often a band is made shorter at the most.
const TRIES: usize = 64;

/// A line within the pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    line: Line,
    /// Per 2^-16 pixel downwards, in 2^-48 pixel.
    slope: i64,
    /// Where it is at the top and the bottom of the band.
    above: i64,
    below: i64,
    direction: i8,
}

impl Piece {
    pub(super) const NONE: Self =
        Self { line: Line { x0: 0, y0: 0, x1: 0, y1: 0 }, slope: 0, above: 0, below: 0, direction: 0 };

    pub(super) fn new(line: Line, direction: i8) -> Self {
        let slope = ((line.x1 - line.x0) << 16) / i64::from((line.y1 - line.y0).max(1));
        Self { line, slope, above: line.x0, below: line.x0, direction }
    }

    pub(super) fn heights(&self) -> (i32, i32, i8) {
        (self.line.y0, self.line.y1, self.direction)
    }

    #[inline]
    fn x_at(&self, y: i32) -> i64 {
        if y == self.line.y1 { self.line.x1 } else { self.line.x0 + ((self.slope * i64::from(y - self.line.y0)) >> 16) }
    }
}

/// Adds the pieces, `levels` being the winding to their left.
#[inline(never)]
pub(super) fn add_pieces(pieces: &mut [Piece], levels: &[Level], inside: WindingRule, accumulator: &mut Accumulator) {
    sort_by(pieces, |piece| i64::from(piece.line.y0));
    let (mut y, mut live, mut level) = (0, 0, 0);
    let mut started = 0;
    while y < FINE_ONE {
        // What starts here goes to the live ones, which come first; those that have ended are overwritten.
        while let Some(&piece) = pieces.get(started).filter(|piece| piece.line.y0 <= y) {
            if let Some(free) = pieces.get_mut(live) {
                *free = piece;
            }
            live += 1;
            started += 1;
        }
        let mut to = pieces.get(started).map_or(FINE_ONE, |piece| piece.line.y0);
        while levels.get(level).is_some_and(|level| level.end <= y) {
            level += 1;
        }
        let mut winding = 0;
        if let Some(level) = levels.get(level) {
            to = to.min(level.end);
            winding = level.winding;
        }
        let band = pieces.get_mut(..live).unwrap_or_default();
        for piece in &mut *band {
            to = to.min(piece.line.y1);
        }
        to = sort_band(band, y, to);
        for piece in &mut *band {
            let weight = inside.weight(winding, piece.direction);
            winding += i32::from(piece.direction);
            if weight != 0 {
                Line { x0: piece.above, y0: y, x1: piece.below, y1: to }.add(weight, accumulator);
            }
            piece.above = piece.below;
        }
        let mut kept = 0;
        for at in 0..live {
            let Some(&piece) = pieces.get(at) else { break };
            if piece.line.y1 > to {
                if let Some(place) = pieces.get_mut(kept) {
                    *place = piece;
                }
                kept += 1;
            }
        }
        (live, y) = (kept, to);
    }
}

/// Orders what is there between two heights, or down to the first crossing.
fn sort_band(band: &mut [Piece], y: i32, mut to: i32) -> i32 {
    // A crossing that is found may hide an earlier one; rounded ones could go on without an end.
    for _ in 0..TRIES {
        for piece in &mut *band {
            piece.below = piece.x_at(to);
        }
        sort_by(band, |piece| piece.above + piece.below);
        let mut cut = to;
        for pair in band.windows(2) {
            let [left, right] = pair else { break };
            let (above, below) = (right.above - left.above, right.below - left.below);
            if above < -TOLERANCE || below < -TOLERANCE {
                // In 2^-32 pixel, both less than one.
                let (above, below) = (above.abs() >> 2, below.abs() >> 2);
                #[allow(clippy::cast_possible_truncation, reason = "at most the height of the band")]
                let crossing = y + (i64::from(to - y) * above / (above + below).max(1)) as i32;
                if crossing > y {
                    cut = cut.min(crossing);
                }
            }
        }
        if cut == to {
            break;
        }
        to = cut;
    }
    to
}

/// By insertion: they are few, and mostly in order.
#[inline]
fn sort_by(pieces: &mut [Piece], key: impl Fn(&Piece) -> i64) {
    for at in 1..pieces.len() {
        let mut place = at;
        while let Some([.., left, right]) = pieces.get_mut(..=place) {
            if key(left) <= key(right) {
                break;
            }
            core::mem::swap(left, right);
            place -= 1;
        }
    }
}
