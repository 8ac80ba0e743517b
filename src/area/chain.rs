//! A chain: edges of a contour that follow each other downwards, and where they are in the current row of pixels.
//!
//! Within a row a chain is a polyline that goes down: from where it enters (or begins), over the vertices in the row, to
//! where it leaves (or ends). Only the two ends and an index are kept, the vertices between are asked for again.
//!
//! ```text
//!    row top     ---x_top---------          x: what the column of the edge is at a row's boundary, in 2^-32 pixel
//!                    \ vertex `top_index`
//!                     |
//!                    / edge to `index`
//!    row bottom  ---x-------------
//! ```
//!
//! On an edge x is `x0 + (y - y0) slope`, with `slope = dx / dy` rounded down to 2^-32. As an edge is at most 8192 pixels
//! high, it is within 2^-19 pixel of the true line. Adding a slope is exact, so x does not depend on the row that the clip
//! begins at.

use crate::area::{
    accumulator::{Accumulator, Steepness},
    source::{FINE_BITS, FINE_ONE, Source},
};

/// Scratch for one active edge of an anti-aliased polygon: 80 bytes.
#[derive(Debug, Clone, Copy)]
pub struct CoverageEdge {
    /// At the bottom of the row, in 2^-32 pixel.
    x: i64,
    slope: i64,
    steepness: Steepness,
    contour: u32,
    /// Of the vertex that the edge at the bottom of the row leads to.
    index: u32,
    /// Of the vertex that the edge at the top of the row leads to.
    top_index: u32,
    /// Where that edge is at the top, in 2^-32 pixel.
    x_top: i64,
    /// Where the edge at the bottom ends.
    end: i32,
    /// What the chain reaches within the row; of the slots that wait or are free, the next in their list.
    pub(super) low: i32,
    pub(super) high: i32,
    /// The heights at which it begins and ends within the row.
    pub(super) top: i32,
    pub(super) bottom: i32,
    /// 1 where the contour goes down, -1 where it goes up.
    pub(super) direction: i8,
    pub(super) is_single: bool,
    pub(super) ends: bool,
    /// A top that waits for its row, `high`.
    pub(super) is_waiting: bool,
    /// The slot of the chain in the place of this slot, from left to right.
    pub(super) order: u32,
    /// The list of what starts on the rows that this slot stands for.
    pub(super) starting: u32,
}

impl CoverageEdge {
    /// Unused scratch.
    pub const EMPTY: Self = Self {
        x: 0,
        slope: 0,
        steepness: Steepness::NONE,
        contour: 0,
        index: 0,
        top_index: 0,
        x_top: 0,
        end: 0,
        low: 0,
        high: 0,
        top: 0,
        bottom: 0,
        direction: 0,
        is_single: false,
        ends: false,
        is_waiting: false,
        order: 0,
        starting: 0,
    };

    /// Makes it a top that waits for its row, the next of its list being `next`.
    #[inline]
    pub(super) fn set_waiting(&mut self, contour: u32, index: u32, row: i32, next: u32) {
        let Self { order, starting, .. } = *self;
        let low = next.cast_signed();
        *self = Self { contour, index, low, high: row, is_waiting: true, order, starting, ..Self::EMPTY };
    }

    /// Makes it the chain that leaves a top, one way or the other.
    #[inline]
    pub(super) fn leave(&mut self, top: &Self, direction: i8) {
        let Self { order, starting, .. } = *self;
        *self = Self { order, starting, ..Self::leaving(top.contour, top.index, direction) };
    }

    #[inline]
    pub(super) fn leaving(contour: u32, index: u32, direction: i8) -> Self {
        Self { contour, index, direction, ..Self::EMPTY }
    }

    /// Goes down from the vertex it stands at, to its first edge below `row_top`; its ends come to lie in the row, if there
    /// are any.
    #[inline]
    pub(super) fn begin(&mut self, source: &Source<'_>, row_top: i32) -> bool {
        let mut from = source.vertex(self.contour, self.index);
        loop {
            let (index, to) = source.step(self.contour, self.index, self.direction > 0);
            if to.y < from.y {
                return false;
            }
            self.index = index;
            if to.y > row_top && to.y > from.y {
                self.end = to.y;
                self.top_index = index;
                self.top = (from.y - row_top).max(0);
                self.x = finest(from.x);
                if from.y < row_top || to.y > row_top + FINE_ONE {
                    self.set_slope(to.x - from.x, to.y - from.y);
                }
                if from.y < row_top {
                    self.move_down(row_top - from.y);
                }
                self.x_top = self.x;
                return true;
            }
            from = to;
        }
    }

    #[inline]
    fn set_slope(&mut self, dx: i32, dy: i32) {
        self.slope = (i64::from(dx) << 32).div_euclid(i64::from(dy.max(1)));
        self.steepness = Steepness::NONE;
    }

    #[inline(always)]
    fn move_down(&mut self, dy: i32) {
        self.x = self.x.wrapping_add(self.slope.wrapping_mul(i64::from(dy)) >> FINE_BITS);
    }

    /// From one row to the next: where it is at the bottom, and what it reaches.
    #[inline(always)]
    pub(super) fn advance(&mut self, source: &Source<'_>, row_top: i32) {
        let bottom = row_top + FINE_ONE;
        if self.end > bottom && self.top == 0 {
            // Most of all: an edge that crosses the whole row.
            self.x = self.x.wrapping_add(self.slope);
            (self.low, self.high) = (floor(self.x.min(self.x_top)), ceil(self.x.max(self.x_top)));
            self.bottom = FINE_ONE;
            self.is_single = true;
        } else {
            self.advance_over_vertices(source, row_top);
        }
    }

    #[inline(never)]
    fn advance_over_vertices(&mut self, source: &Source<'_>, row_top: i32) {
        let bottom = row_top + FINE_ONE;
        (self.low, self.high) = (i32::MAX, i32::MIN);
        self.reach(self.x_top);
        self.bottom = FINE_ONE;
        self.is_single = false;
        if self.end > bottom {
            self.move_down(FINE_ONE - self.top);
            self.reach(self.x);
            return;
        }
        let mut from = source.vertex(self.contour, self.index);
        loop {
            self.reach(finest(from.x));
            let (index, to) = source.step(self.contour, self.index, self.direction > 0);
            if to.y < from.y {
                self.bottom = from.y - row_top;
                self.ends = true;
                return;
            }
            self.index = index;
            if to.y > bottom {
                self.end = to.y;
                self.x = finest(from.x);
                self.set_slope(to.x - from.x, to.y - from.y);
                if from.y < bottom {
                    self.move_down(bottom - from.y);
                }
                self.reach(self.x);
                return;
            }
            from = to;
        }
    }

    /// Finds out again what it reaches.
    pub(super) fn measure(&mut self, source: &Source<'_>, row_top: i32) {
        let chain = *self;
        (self.low, self.high) = (i32::MAX, i32::MIN);
        for line in chain.lines(source, row_top) {
            self.reach(line.x0);
            self.reach(line.x1);
        }
    }

    #[inline(always)]
    fn reach(&mut self, x: i64) {
        self.low = self.low.min(floor(x));
        self.high = self.high.max(ceil(x));
    }

    /// What is at the bottom of a row is at the top of the next.
    #[inline(always)]
    pub(super) fn leave_row(&mut self) {
        self.x_top = self.x;
        self.top_index = self.index;
        self.top = 0;
    }

    /// Whether it crosses the whole row.
    #[inline(always)]
    pub(super) fn is_whole(&self) -> bool {
        self.top == 0 && self.bottom == FINE_ONE
    }

    /// Where it crosses the top and the bottom of the row, if it does both.
    #[inline(always)]
    pub(super) fn ends_if_single(&self) -> Option<(i64, i64)> {
        self.is_single.then_some((self.x_top, self.x))
    }

    /// The lines that it consists of in the row, downwards.
    #[inline]
    pub(super) fn lines<'s, 'a>(&self, source: &'s Source<'a>, row_top: i32) -> Lines<'s, 'a> {
        Lines { source, chain: *self, row_top, x: self.x_top, y: self.top, index: self.top_index, is_over: false }
    }

    /// Adds it to a row, with a weight.
    #[inline(always)]
    pub(super) fn add(&mut self, source: &Source<'_>, row_top: i32, weight: i32, accumulator: &mut Accumulator) {
        if let Some((x0, x1)) = self.ends_if_single() {
            let Self { slope, steepness, .. } = self;
            accumulator.add(x0, x1, FINE_ONE, weight, || {
                if *steepness == Steepness::NONE {
                    *steepness = Steepness::of_step(slope.unsigned_abs());
                }
                *steepness
            });
        } else {
            self.add_lines(source, row_top, (self.top, self.bottom), weight, accumulator);
        }
    }

    /// Adds what of it lies between two heights.
    #[inline(never)]
    pub(super) fn add_lines(
        &self,
        source: &Source<'_>,
        row_top: i32,
        (top, bottom): (i32, i32),
        weight: i32,
        accumulator: &mut Accumulator,
    ) {
        for line in self.lines(source, row_top) {
            if line.y1 > top && line.y0 < bottom {
                line.between(line.y0.max(top), line.y1.min(bottom)).add(weight, accumulator);
            }
        }
    }
}

impl Default for CoverageEdge {
    fn default() -> Self {
        Self::EMPTY
    }
}

const _: () = assert!(size_of::<CoverageEdge>() <= 80);

/// From 2^-16 pixel to 2^-32.
#[inline(always)]
fn finest(x: i32) -> i64 {
    i64::from(x) << FINE_BITS
}

/// From 2^-32 pixel to 2^-16.
#[inline(always)]
fn floor(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    let x = (x >> FINE_BITS) as i32;
    x
}

#[inline(always)]
fn ceil(x: i64) -> i32 {
    floor(x + i64::from(FINE_ONE - 1))
}

/// The same, to the nearest.
#[inline(always)]
pub(super) fn nearest(x: i64) -> i32 {
    floor(x + i64::from(FINE_ONE / 2))
}

/// A part of a chain without a vertex within it: columns in 2^-32 pixel, heights in 2^-16 from the top of the row; y0 < y1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Line {
    pub(super) x0: i64,
    pub(super) y0: i32,
    pub(super) x1: i64,
    pub(super) y1: i32,
}

impl Line {
    /// Where it is at a height.
    #[inline]
    pub(super) fn x_at(&self, y: i32) -> i64 {
        if y == self.y0 {
            return self.x0;
        }
        if y == self.y1 {
            return self.x1;
        }
        // At most 2^46 and 2^16.
        self.x0 + ((self.x1 - self.x0) * i64::from(y - self.y0)).div_euclid(i64::from((self.y1 - self.y0).max(1)))
    }

    #[inline]
    pub(super) fn between(&self, y0: i32, y1: i32) -> Self {
        Self { x0: self.x_at(y0), y0, x1: self.x_at(y1), y1 }
    }

    #[inline]
    pub(super) fn add(&self, weight: i32, accumulator: &mut Accumulator) {
        let dy = self.y1 - self.y0;
        accumulator.add(self.x0, self.x1, dy, weight, || {
            Steepness::of_segment(self.x0.abs_diff(self.x1), dy.unsigned_abs())
        });
    }
}

/// The lines of a chain in a row.
#[derive(Clone)]
pub(super) struct Lines<'s, 'a> {
    source: &'s Source<'a>,
    chain: CoverageEdge,
    row_top: i32,
    x: i64,
    y: i32,
    index: u32,
    is_over: bool,
}

impl Iterator for Lines<'_, '_> {
    type Item = Line;

    #[inline]
    fn next(&mut self) -> Option<Line> {
        let Self { source, chain, row_top, .. } = *self;
        loop {
            if self.is_over {
                return None;
            }
            let is_last = self.index == chain.index;
            let (x1, y1) = if is_last && !chain.ends {
                (chain.x, FINE_ONE)
            } else {
                let point = source.vertex(chain.contour, self.index);
                (finest(point.x), point.y - row_top)
            };
            let line = Line { x0: self.x, y0: self.y, x1, y1 };
            (self.x, self.y) = (x1, y1);
            if is_last {
                self.is_over = true;
            } else {
                self.index = source.step(chain.contour, self.index, chain.direction > 0).0;
            }
            if line.y0 < line.y1 {
                return Some(line);
            }
        }
    }
}
