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
//! A piece is added where its weight changes, not at every band.
//!
//! J. L. Bentley and T. A. Ottmann, "Algorithms for reporting and counting geometric intersections", 1979, with the few
//! pieces of a pixel in place of trees.

use core::ops::Range;

use crate::{
    area::{
        accumulator::Accumulator,
        division::{floor_ratio, part_of},
        line::Line,
        winding::{Level, Winding},
    },
    outline::WindingRule,
};

/// So many pieces have room, 48 bytes of stack each. A pixel with more is taken in parts of its height.
///
/// The same everywhere: where parts meet is rounded once more, and hosts have a board's bits.
const MOST: usize = 16;

/// Bits behind the point of a column within the pixel.
const PIECE_BITS: u32 = 29;

/// What the rounding of columns may make of two that are equal: 2^-17 pixel.
const TOLERANCE: i32 = 1 << (PIECE_BITS - 17);

/// How often a band is made shorter at the most.
const TRIES: usize = 64;

/// A line within the pixel: columns in 2^-29 pixel from its left side, heights in 2^-16 from the top of the row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    x0: i32,
    y0: i32,
    x1: i32,
    y1: i32,
    /// Per 2^-16 pixel downwards, in 2^-45 pixel.
    slope: i64,
    /// Where it is at the top and the bottom of the band.
    above: i32,
    below: i32,
    /// Where what has not been added yet begins.
    from: (i32, i32),
    weight: i8,
    direction: i8,
}

impl Piece {
    pub(super) const NONE: Self =
        Self { x0: 0, y0: 0, x1: 0, y1: 0, slope: 0, above: 0, below: 0, from: (0, 0), weight: 0, direction: 0 };

    /// Of a line between the two sides of a column, the left one in 2^-32 pixel.
    #[inline]
    pub(super) fn new(line: &Line, direction: i8, left: i64) -> Self {
        #[allow(clippy::cast_possible_truncation, reason = "from 0 to 2^29")]
        let within = |x: i64| ((x - left) >> (32 - PIECE_BITS)) as i32;
        let (x0, x1) = (within(line.x0), within(line.x1));
        let slope = floor_ratio(i64::from(x1 - x0) << 16, (line.y1 - line.y0).unsigned_abs());
        Self { x0, y0: line.y0, x1, y1: line.y1, slope, above: x0, direction, ..Self::NONE }
    }

    #[inline]
    fn x_at(&self, y: i32) -> i32 {
        if y == self.y1 {
            return self.x1;
        }
        #[allow(clippy::cast_possible_truncation, reason = "between both ends")]
        let moved = ((self.slope * i64::from(y - self.y0)) >> 16) as i32;
        self.x0 + moved
    }

    /// Adds what is left of it, down to a height, and goes on with another weight.
    #[inline]
    fn add(&mut self, (x, y): (i32, i32), weight: i8, column: i32, accumulator: &mut Accumulator) {
        if self.weight != 0 && y > self.from.1 {
            accumulator.add_to_column(column, (self.from.0, x), PIECE_BITS, y - self.from.1, self.weight.into());
        }
        (self.from, self.weight) = ((x, y), weight);
    }
}

/// Pieces, and those of them that are there at a height, from left to right.
pub(super) struct Pieces {
    pieces: [Piece; MOST],
    count: usize,
    live: [u8; MOST],
    alive: usize,
    /// Where the first of them ends.
    end: i32,
}

impl Pieces {
    pub(super) const fn new() -> Self {
        Self { pieces: [Piece::NONE; MOST], count: 0, live: [0; MOST], alive: 0, end: i32::MAX }
    }

    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    /// `false` where there is no room.
    #[inline]
    pub(super) fn push(&mut self, piece: Piece) -> bool {
        let Some(place) = self.pieces.get_mut(self.count) else { return false };
        *place = piece;
        self.count += 1;
        true
    }

    /// Adds what lies between two heights, `left` being the winding to the left; that to the right goes to `right`.
    #[inline(never)]
    pub(super) fn add(
        &mut self,
        (column, heights): (i32, Range<i32>),
        (left, right): (&[Level], &mut Winding),
        inside: WindingRule,
        accumulator: &mut Accumulator,
    ) -> bool {
        let starts = self.starts();
        let mut starts =
            starts.get(..self.count).unwrap_or_default().iter().map(|start| (start >> 8, start & 0xFF)).peekable();
        let (mut y, mut level, mut is_known) = (heights.start, 0, true);
        (self.alive, self.end) = (0, i32::MAX);
        while y < heights.end {
            while let Some((_, piece)) = starts.next_if(|start| start.0 <= y) {
                self.start(piece);
            }
            let mut to = starts.peek().map_or(heights.end, |start| start.0);
            while left.get(level).is_some_and(|level| level.end <= y) {
                level += 1;
            }
            let mut winding = 0;
            if let Some(level) = left.get(level) {
                to = to.min(level.end);
                winding = level.winding;
            }
            to = self.sort_band(y, to);
            winding = self.pass_band(y..to, winding, inside, column, accumulator);
            is_known = is_known && right.append(to, winding).is_ok();
            y = to;
        }
        is_known
    }

    /// Where each begins, with its number, from top to bottom.
    fn starts(&self) -> [i32; MOST] {
        let mut starts = [0; MOST];
        for (at, piece) in self.pieces.iter().take(self.count).enumerate() {
            if let Some(start) = starts.get_mut(at) {
                #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "fewer than 256")]
                let number = at as i32;
                *start = piece.y0 << 8 | number;
            }
            let mut place = at;
            while let Some([.., before, here]) = starts.get_mut(..=place)
                && *before > *here
            {
                core::mem::swap(before, here);
                place -= 1;
            }
        }
        starts
    }

    fn start(&mut self, piece: i32) {
        if let Some(place) = self.live.get_mut(self.alive) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "fewer than 256")]
            let piece = piece as u8;
            *place = piece;
            self.alive += 1;
            self.end = self.end.min(self.piece(self.alive - 1).y1);
        }
    }

    #[inline]
    #[allow(clippy::indexing_slicing, reason = "below MOST: no check is left")]
    fn number(&self, live: usize) -> u8 {
        self.live[live % MOST]
    }

    #[inline]
    #[allow(clippy::indexing_slicing, reason = "below MOST: no check is left")]
    fn set_number(&mut self, live: usize, number: u8) {
        self.live[live % MOST] = number;
    }

    #[inline]
    #[allow(clippy::indexing_slicing, reason = "below MOST: no check is left")]
    fn piece(&mut self, live: usize) -> &mut Piece {
        &mut self.pieces[usize::from(self.live[live % MOST]) % MOST]
    }

    /// Orders what is there between two heights, or down to the first end or crossing.
    #[inline]
    fn sort_band(&mut self, y: i32, mut to: i32) -> i32 {
        to = to.min(self.end);
        // A crossing that is found may hide an earlier one; rounded ones could go on without an end.
        for _ in 0..TRIES {
            let (mut last, mut is_in_order) = ((i32::MIN, i32::MIN), true);
            for at in 0..self.alive {
                let piece = self.piece(at);
                piece.below = piece.x_at(to);
                is_in_order &= last.0 <= piece.above && last.1 <= piece.below;
                last = (piece.above, piece.below);
            }
            if is_in_order {
                break;
            }
            self.sort_live();
            let cut = self.first_crossing(y, to);
            if cut == to {
                break;
            }
            to = cut;
        }
        to
    }

    /// By the columns in the middle, by insertion: they are few, and mostly in order.
    fn sort_live(&mut self) {
        for at in 1..self.alive {
            let number = self.number(at);
            let piece = self.piece(at);
            let middle = piece.above + piece.below;
            let mut place = at;
            while place > 0 {
                let left = self.piece(place - 1);
                if left.above + left.below <= middle {
                    break;
                }
                self.set_number(place, self.number(place - 1));
                place -= 1;
            }
            self.set_number(place, number);
        }
    }

    fn first_crossing(&mut self, y: i32, to: i32) -> i32 {
        let mut cut = to;
        let mut left = (0, 0);
        for at in 0..self.alive {
            let piece = self.piece(at);
            let right = (piece.above, piece.below);
            let (above, below) = (right.0 - left.0, right.1 - left.1);
            if above < -TOLERANCE || below < -TOLERANCE {
                let (above, below) = (above.unsigned_abs(), below.unsigned_abs());
                let moved = part_of(above.into(), (to - y).unsigned_abs(), (above + below).into());
                let crossing = y + moved.cast_signed();
                if crossing > y {
                    cut = cut.min(crossing);
                }
            }
            left = right;
        }
        cut
    }

    /// The winding behind all that is there between two heights; what changes its weight, or ends, is added.
    #[inline]
    fn pass_band(
        &mut self,
        heights: Range<i32>,
        mut winding: i32,
        inside: WindingRule,
        column: i32,
        accumulator: &mut Accumulator,
    ) -> i32 {
        let mut kept = 0;
        self.end = i32::MAX;
        for at in 0..self.alive {
            let number = self.number(at);
            let piece = self.piece(at);
            #[allow(clippy::cast_possible_truncation, reason = "1, 0 or -1")]
            let weight = inside.weight(winding, piece.direction) as i8;
            winding += i32::from(piece.direction);
            if weight != piece.weight {
                piece.add((piece.above, heights.start), weight, column, accumulator);
            }
            piece.above = piece.below;
            if piece.y1 <= heights.end {
                piece.add((piece.x1, piece.y1), 0, column, accumulator);
            } else {
                let end = piece.y1;
                self.set_number(kept, number);
                self.end = self.end.min(end);
                kept += 1;
            }
        }
        self.alive = kept;
        winding
    }
}
