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
        division::part_of,
        piece::{PIECE_BITS, Piece},
        winding::{Level, Winding},
    },
    outline::WindingRule,
};

/// So many pieces have room, 32 bytes of stack each. A pixel with more is taken in parts of its height.
///
/// The same everywhere: where parts meet is rounded once more, and hosts have a board's bits.
const MOST: usize = 32;

/// What the rounding of columns may make of two that are equal: 2^-17 pixel.
const TOLERANCE: i32 = 1 << (PIECE_BITS - 17);

/// How often a band is made shorter at the most.
const TRIES: usize = 64;

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
        let order = self.order();
        let mut order = order.iter().copied().take(self.count).peekable();
        let (mut y, mut level, mut is_known) = (heights.start, 0, true);
        (self.alive, self.end) = (0, i32::MAX);
        while y < heights.end {
            while let Some(number) = order.next_if(|&number| self.start_of(number) <= y) {
                self.start(number);
            }
            let mut to = order.peek().map_or(heights.end, |&number| self.start_of(number));
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

    /// Their numbers, by where they begin, from top to bottom.
    fn order(&self) -> [u8; MOST] {
        let mut order = [0; MOST];
        for (number, at) in (0..).zip(0..self.count) {
            if let Some(place) = order.get_mut(at) {
                *place = number;
            }
            let mut place = at;
            while let Some([.., before, here]) = order.get_mut(..=place)
                && self.start_of(*before) > self.start_of(*here)
            {
                core::mem::swap(before, here);
                place -= 1;
            }
        }
        order
    }

    #[inline]
    fn start_of(&self, number: u8) -> i32 {
        self.pieces.get(usize::from(number)).map_or(0, Piece::start)
    }

    fn start(&mut self, number: u8) {
        if let Some(place) = self.live.get_mut(self.alive) {
            *place = number;
            self.alive += 1;
            self.end = self.end.min(self.piece(self.alive - 1).end());
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
                piece.add(heights.start, weight, column, accumulator);
            }
            piece.above = piece.below;
            let end = piece.end();
            if end <= heights.end {
                piece.add(end, 0, column, accumulator);
            } else {
                self.set_number(kept, number);
                self.end = self.end.min(end);
                kept += 1;
            }
        }
        self.alive = kept;
        winding
    }
}
