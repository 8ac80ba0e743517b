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

use crate::area::{
    accumulator::Accumulator,
    cell::column_of,
    division::ratio,
    line::{Line, ceil, finest, floor},
    lines::{Course, Kept, Lines, Row},
    pair::Side,
    source::{FINE_BITS, FINE_ONE, Source},
    steepness::Steepness,
};

/// Scratch for one active edge of an anti-aliased polygon: 80 bytes.
#[derive(Debug, Clone, Copy)]
pub struct CoverageEdge {
    /// At the bottom of the row, in 2^-32 pixel.
    x: i64,
    slope: i64,
    /// Where the edge at the top of the row is there, in 2^-32 pixel.
    x_top: i64,
    /// The steepness of the edge at the bottom of the row, worked out when it is first asked for.
    factor: u32,
    up: u8,
    down: u8,
    /// How many of its lines are kept, and the first of them.
    kept: u8,
    first_kept: u8,
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
        factor: 0,
        up: 0,
        down: 0,
        kept: 0,
        first_kept: 0,
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
        (self.state, self.ends, self.kept) = (State::Active, false, 0);
        let vertices = source.contour(contour);
        let mut from = vertices.vertex(index);
        loop {
            let (index, to) = vertices.step(self.index, direction > 0);
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
        self.factor = 0;
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
            let vertices = source.contour(self.contour);
            let mut from = vertices.vertex(self.index);
            loop {
                (low, high) = (low.min(finest(from.x)), high.max(finest(from.x)));
                let (index, to) = vertices.step(self.index, self.direction > 0);
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
    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn lines<'r>(&self, row: &Row<'r>) -> Lines<'r> {
        match self.kept_lines(row) {
            [] => Lines::worked_out(self.course(row.source, row.top)),
            kept => Lines::kept(kept),
        }
    }

    /// The same, but for some that end above a height, where they are kept.
    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn lines_from<'r>(&self, row: &Row<'r>, y: i32) -> Lines<'r> {
        let kept = self.kept_lines(row);
        match kept.get(kept.partition_point(|line| line.y1 <= y)..).unwrap_or_default() {
            [] => self.lines(row),
            below => Lines::kept(below),
        }
    }

    #[inline]
    fn kept_lines<'r>(&self, row: &Row<'r>) -> &'r [Line] {
        let first = usize::from(self.first_kept);
        row.kept.get(first..first + usize::from(self.kept)).unwrap_or_default()
    }

    #[cfg_attr(target_pointer_width = "64", inline)]
    fn course<'r>(&self, source: Source<'r>, row_top: i32) -> Course<'r> {
        let vertices = source.contour(self.contour);
        let first = (self.index != self.top_index || self.ends).then_some(self.top_index);
        let end = (!self.ends).then_some(self.x);
        Course::new((vertices, self.direction > 0), row_top, (self.x_top, self.top), (first, self.index), end)
    }

    /// Keeps its lines, if there is room for all.
    pub(super) fn keep(&mut self, source: Source<'_>, top: i32, kept: &mut Kept) {
        if !self.is_single
            && let Some((first, count)) = kept.keep(self.course(source, top))
        {
            (self.first_kept, self.kept) = (first, count);
        }
    }

    #[inline]
    pub(super) fn forget_lines(&mut self) {
        self.kept = 0;
    }

    /// Where it crosses the row; it does so without a vertex.
    #[inline]
    pub(super) fn side(&mut self) -> Side {
        let (left, right) = (self.x_top.min(self.x), self.x_top.max(self.x));
        let is_narrow = column_of(left) == column_of(right);
        Side { left, right, steepness: if is_narrow { Steepness::UNKNOWN } else { self.steepness() } }
    }

    /// Adds it to a row, with a weight.
    #[inline]
    pub(super) fn add(&mut self, row: &Row<'_>, weight: i32, accumulator: &mut Accumulator) {
        if self.is_single {
            accumulator.add(self.x_top, self.x, FINE_ONE, weight, || self.steepness());
        } else {
            self.add_lines(row, weight, accumulator);
        }
    }

    #[inline]
    fn steepness(&mut self) -> Steepness {
        if self.factor == 0 {
            let Steepness { factor, up, down } = Steepness::of_slope(self.slope.unsigned_abs());
            (self.factor, self.up, self.down) = (factor, up, down);
        }
        Steepness { factor: self.factor, up: self.up, down: self.down }
    }

    #[inline(never)]
    fn add_lines(&self, row: &Row<'_>, weight: i32, accumulator: &mut Accumulator) {
        let kept = self.kept_lines(row);
        if kept.is_empty() {
            self.course(row.source, row.top).for_each(|line| line.add(weight, accumulator));
        } else {
            kept.iter().for_each(|line| line.add(weight, accumulator));
        }
    }

    /// Adds what of it lies between two heights.
    #[inline(never)]
    pub(super) fn add_between(
        &self,
        row: &Row<'_>,
        (top, bottom): (i32, i32),
        weight: i32,
        accumulator: &mut Accumulator,
    ) {
        for line in self.lines(row) {
            if line.y1 > top && line.y0 < bottom {
                line.between(line.y0.max(top), line.y1.min(bottom)).add(weight, accumulator);
            }
        }
    }

    /// Finds out again what it reaches.
    pub(super) fn measure(&mut self, row: &Row<'_>) -> i32 {
        let (mut low, mut high) = (self.x_top, self.x_top);
        for line in self.lines(row) {
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
