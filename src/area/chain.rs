//! A chain: edges of a contour that follow each other downwards, and where they are in the current row of pixels.
//!
//! Within a row a chain is a polyline that goes down: from where it enters (or begins), over the vertices in the row, to
//! where it leaves (or ends). Only the two ends and an index are kept, the vertices between are asked for again.
//!
//! ```text
//!    row top     ---x_top---------          x: the column of the edge at the row's bottom, in 2^-32 pixel
//!                    \ vertex `top_index`
//!                     |
//!                    / edge to `index`
//!    row bottom  ---x-------------
//! ```
//!
//! On an edge x is `x0 + (y - y0) slope`, with `slope = dx / dy` cut off at 2^-32. As an edge is at most 8192 pixels
//! high, it is within 2^-19 pixel of the true line. Adding a slope is exact, so x does not depend on the row that the clip
//! begins at.

use core::ops::Range;

use crate::area::{
    accumulator::{Accumulator, Steepness, areas_beside},
    division::ratio,
    source::{FINE_BITS, FINE_ONE, Source},
};

/// Scratch for one active edge of an anti-aliased polygon: 80 bytes.
#[derive(Debug, Clone, Copy)]
pub struct CoverageEdge {
    /// At the bottom of the row, in 2^-32 pixel.
    x: i64,
    slope: i64,
    /// Where the edge at the top of the row is there, in 2^-32 pixel.
    x_top: i64,
    steepness: Steepness,
    contour: u32,
    /// Of the vertex that the edge at the bottom of the row leads to.
    index: u32,
    /// Of the vertex that the edge at the top of the row leads to.
    top_index: u32,
    /// Where the edge at the bottom ends; of a top that waits, its row.
    pub(super) end: i32,
    /// How far it reaches within the row, in 2^-16 pixel.
    pub(super) high: i32,
    /// The heights at which it begins and ends within the row.
    pub(super) top: i32,
    pub(super) bottom: i32,
    /// 1 where the contour goes down, -1 where it goes up.
    pub(super) direction: i8,
    pub(super) is_single: bool,
    pub(super) ends: bool,
    pub(super) state: State,
    /// The chain in the place of this slot, from left to right.
    pub(super) place: Place,
    /// What starts on the rows that this slot stands for, and the next of those that this one, which waits, is of.
    pub(super) starting: u32,
    pub(super) next: u32,
}

/// What a slot, or a chain, is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    Free,
    /// A top that waits for its row.
    Waits,
    Active,
    /// Active, and swept together with the one to its left.
    Joined,
}

/// A chain from left to right: how far to the left it reaches within the row, in 2^-16 pixel, and its slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) low: i32,
    pub(super) slot: u32,
}

impl CoverageEdge {
    /// Unused scratch.
    pub const EMPTY: Self = Self {
        x: 0,
        slope: 0,
        x_top: 0,
        steepness: Steepness::NONE,
        contour: 0,
        index: 0,
        top_index: 0,
        end: 0,
        high: 0,
        top: 0,
        bottom: 0,
        direction: 0,
        is_single: false,
        ends: false,
        state: State::Free,
        place: Place { low: 0, slot: 0 },
        starting: 0,
        next: 0,
    };

    /// Makes it a top that waits for its row.
    #[inline]
    pub(super) fn wait(&mut self, contour: u32, index: u32, row: i32, next: u32) {
        (self.contour, self.index, self.end, self.next) = (contour, index, row, next);
        self.state = State::Waits;
    }

    /// The contour and the index of a top.
    #[inline]
    pub(super) fn vertex(&self) -> (u32, u32) {
        (self.contour, self.index)
    }

    /// Makes it the chain that leaves a top one way, as far as it is in the row that begins at `row_top`; `false` if there is
    /// none that is.
    #[inline]
    pub(super) fn begin(
        &mut self,
        source: &Source<'_>,
        (contour, index): (u32, u32),
        direction: i8,
        row_top: i32,
    ) -> bool {
        (self.contour, self.index, self.direction) = (contour, index, direction);
        (self.state, self.ends) = (State::Active, false);
        let mut from = source.vertex(contour, index);
        loop {
            let (index, to) = source.step(contour, self.index, direction > 0);
            if to.y < from.y {
                return false;
            }
            self.index = index;
            if to.y > row_top && to.y > from.y {
                (self.end, self.top_index) = (to.y, index);
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
        let slope = ratio(dx.unsigned_abs(), dy.unsigned_abs()).cast_signed();
        self.slope = if dx < 0 { -slope } else { slope };
        self.steepness = Steepness::NONE;
    }

    #[inline]
    fn move_down(&mut self, dy: i32) {
        self.x = self.x.wrapping_add(self.slope.wrapping_mul(i64::from(dy)) >> FINE_BITS);
    }

    /// From one row to the next: where it is at the bottom, and what it reaches; how far to the left.
    #[inline]
    pub(super) fn advance(&mut self, source: &Source<'_>, row_top: i32) -> i32 {
        if self.end > row_top + FINE_ONE && self.top == 0 {
            // Most of all: an edge that crosses the whole row.
            self.x = self.x.wrapping_add(self.slope);
            self.bottom = FINE_ONE;
            self.is_single = true;
            self.high = ceil(self.x.max(self.x_top));
            floor(self.x.min(self.x_top))
        } else {
            self.advance_over_vertices(source, row_top)
        }
    }

    #[inline(never)]
    fn advance_over_vertices(&mut self, source: &Source<'_>, row_top: i32) -> i32 {
        let bottom = row_top + FINE_ONE;
        (self.bottom, self.is_single) = (FINE_ONE, false);
        let (mut low, mut high) = (self.x_top, self.x_top);
        if self.end > bottom {
            self.move_down(FINE_ONE - self.top);
        } else {
            let mut from = source.vertex(self.contour, self.index);
            loop {
                (low, high) = (low.min(finest(from.x)), high.max(finest(from.x)));
                let (index, to) = source.step(self.contour, self.index, self.direction > 0);
                if to.y < from.y {
                    self.bottom = from.y - row_top;
                    self.ends = true;
                    self.x = finest(from.x);
                    break;
                }
                self.index = index;
                if to.y > bottom {
                    self.end = to.y;
                    self.x = finest(from.x);
                    self.set_slope(to.x - from.x, to.y - from.y);
                    if from.y < bottom {
                        self.move_down(bottom - from.y);
                    }
                    break;
                }
                from = to;
            }
        }
        self.high = ceil(high.max(self.x));
        floor(low.min(self.x))
    }

    /// What is at the bottom of a row is at the top of the next.
    #[inline]
    pub(super) fn leave_row(&mut self) {
        (self.x_top, self.top_index, self.top) = (self.x, self.index, 0);
    }

    /// Whether it crosses the whole row.
    #[inline]
    pub(super) fn is_whole(&self) -> bool {
        self.top == 0 && self.bottom == FINE_ONE
    }

    /// Where it crosses the top and the bottom of the row, if it does both without a vertex.
    #[inline]
    pub(super) fn ends_if_single(&self) -> Option<(i64, i64)> {
        self.is_single.then_some((self.x_top, self.x))
    }

    /// The lines that it consists of in the row, downwards.
    #[inline]
    pub(super) fn lines<'s, 'a>(&self, source: &'s Source<'a>, row_top: i32) -> Lines<'s, 'a> {
        let has_vertices = self.index != self.top_index || self.ends;
        Lines {
            source,
            contour: self.contour,
            is_forward: self.direction > 0,
            row_top,
            start: (self.x_top, self.top),
            end: (!self.ends).then_some(self.x),
            vertex: has_vertices.then(|| (self.top_index, source.vertex(self.contour, self.top_index))),
            last: self.index,
        }
    }

    /// What it leaves of its columns to its right, if there is room for all; it crosses the whole row without a vertex.
    #[inline]
    pub(super) fn areas_beside(&mut self, areas: &mut [i32]) -> Option<usize> {
        let Self { slope, steepness, .. } = self;
        areas_beside((self.x_top, self.x), || known(steepness, *slope), areas)
    }

    /// Adds it to a row, with a weight.
    #[inline]
    pub(super) fn add(&mut self, source: &Source<'_>, row_top: i32, weight: i32, accumulator: &mut Accumulator) {
        if self.is_single {
            let Self { slope, steepness, .. } = self;
            accumulator.add(self.x_top, self.x, FINE_ONE, weight, || known(steepness, *slope));
        } else {
            self.add_lines(source, row_top, weight, accumulator);
        }
    }

    #[inline(never)]
    fn add_lines(&self, source: &Source<'_>, row_top: i32, weight: i32, accumulator: &mut Accumulator) {
        for line in self.lines(source, row_top) {
            line.add(weight, accumulator);
        }
    }

    /// Adds what of it lies between two heights.
    #[inline(never)]
    pub(super) fn add_between(
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

    /// Finds out again what it reaches.
    pub(super) fn measure(&mut self, source: &Source<'_>, row_top: i32) -> i32 {
        let (mut low, mut high) = (self.x_top, self.x_top);
        for line in self.lines(source, row_top) {
            (low, high) = (low.min(line.x0).min(line.x1), high.max(line.x0).max(line.x1));
        }
        self.high = ceil(high);
        floor(low)
    }
}

impl Default for CoverageEdge {
    fn default() -> Self {
        Self::EMPTY
    }
}

const _: () = assert!(size_of::<CoverageEdge>() == 80);

/// The steepness of an edge, which is worked out when it is first asked for.
#[inline]
fn known(steepness: &mut Steepness, slope: i64) -> Steepness {
    if *steepness == Steepness::NONE {
        *steepness = Steepness::of_step(slope.unsigned_abs());
    }
    *steepness
}

/// From 2^-16 pixel to 2^-32.
#[inline]
fn finest(x: i32) -> i64 {
    i64::from(x) << FINE_BITS
}

/// From 2^-32 pixel to 2^-16.
#[inline]
fn floor(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    let x = (x >> FINE_BITS) as i32;
    x
}

#[inline]
fn ceil(x: i64) -> i32 {
    floor(x + i64::from(FINE_ONE - 1))
}

/// The same, to the nearest.
#[inline]
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

    /// At which height it is at a column.
    #[inline]
    fn y_at(&self, x: i64) -> i32 {
        // At most 2^16 and 2^46.
        let product = i64::from(self.y1 - self.y0) * (x - self.x0);
        let dy = product.checked_div(self.x1 - self.x0).unwrap_or(0);
        #[allow(clippy::cast_possible_truncation, reason = "between both ends")]
        let y = self.y0 + dy as i32;
        y
    }

    /// What of it lies between two columns, the left one belonging to it.
    #[inline]
    pub(super) fn within(&self, columns: &Range<i64>) -> Option<Self> {
        let (low, high) = (self.x0.min(self.x1), self.x0.max(self.x1));
        if low >= columns.end || high < columns.start || (high == columns.start && low < high) {
            return None;
        }
        let mut line = *self;
        if low < columns.start {
            let y = self.y_at(columns.start);
            if self.x0 < self.x1 {
                (line.x0, line.y0) = (columns.start, y)
            } else {
                (line.x1, line.y1) = (columns.start, y)
            }
        }
        if high > columns.end {
            let y = self.y_at(columns.end);
            if self.x0 < self.x1 {
                (line.x1, line.y1) = (columns.end, y)
            } else {
                (line.x0, line.y0) = (columns.end, y)
            }
        }
        (line.y0 < line.y1).then_some(line)
    }

    #[inline]
    pub(super) fn between(&self, y0: i32, y1: i32) -> Self {
        Self { x0: self.x_at(y0), y0, x1: self.x_at(y1), y1 }
    }

    #[inline]
    pub(super) fn add(&self, weight: i32, accumulator: &mut Accumulator) {
        let dy = self.y1 - self.y0;
        accumulator
            .add(self.x0, self.x1, dy, weight, || Steepness::of_segment(self.x0.abs_diff(self.x1), dy.unsigned_abs()));
    }
}

/// The lines of a chain in a row.
pub(super) struct Lines<'s, 'a> {
    source: &'s Source<'a>,
    contour: u32,
    is_forward: bool,
    row_top: i32,
    /// Where the next line starts.
    start: (i64, i32),
    /// The next vertex, if there is one within the row.
    vertex: Option<(u32, crate::area::source::Point)>,
    /// The index that the row ends before, or at which the chain ends.
    last: u32,
    /// Where it leaves the row, if it does not end.
    end: Option<i64>,
}

impl Iterator for Lines<'_, '_> {
    type Item = Line;

    #[inline]
    fn next(&mut self) -> Option<Line> {
        loop {
            let (x0, y0) = self.start;
            let (x1, y1) = if let Some((index, point)) = self.vertex {
                self.vertex = None;
                if index != self.last {
                    let (next, point) = self.source.step(self.contour, index, self.is_forward);
                    if next != self.last || self.end.is_none() {
                        self.vertex = Some((next, point));
                    }
                }
                (finest(point.x), point.y - self.row_top)
            } else {
                (self.end.take()?, FINE_ONE)
            };
            self.start = (x1, y1);
            if y0 < y1 {
                return Some(Line { x0, y0, x1, y1 });
            }
        }
    }
}
