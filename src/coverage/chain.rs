//! Sides of at most two straight edges.

use crate::{
    Vertex,
    coverage::{FULL, Ramp, Slope, Steepness, convex::Side, ramp::height_in, slope::wide_position},
    edge::Descent,
    limits::SUBPIXEL_BITS,
};

/// One or two edges in the narrow zone; heights in 2^-`BITS` pixel.
#[derive(Debug, Clone)]
pub(crate) struct Chain<const BITS: u32> {
    /// At `y`.
    edge: Slope,
    y: i32,
    until: i32,
    /// At `until`, and where it ends.
    next: Option<(Slope, i32)>,
}

impl<const BITS: u32> Chain<BITS> {
    /// Edges at their upper ends, and where those are.
    #[inline(always)]
    pub(crate) fn new(y: i32, (edge, until): (Slope, i32), next: Option<(Slope, i32)>) -> Self {
        Self { edge, y, until, next }
    }

    /// Takes the chain down to the top of a row, unless it starts farther down.
    #[inline(always)]
    pub(crate) fn skip_to(&mut self, row: i32) {
        let y = row << BITS;
        if y > self.y {
            if y >= self.until {
                self.turn();
            }
            self.go_to(y.min(self.until).max(self.y));
        }
    }

    /// On to the next edge.
    #[inline(always)]
    fn turn(&mut self) {
        if let Some((edge, until)) = self.next.take() {
            self.y = self.until;
            (self.edge, self.until) = (edge, until);
        }
    }

    #[inline(always)]
    fn go_to(&mut self, y: i32) -> i64 {
        let moved = (self.edge.step() * i64::from(y - self.y)) >> (BITS - SUBPIXEL_BITS);
        let position = self.edge.position() + moved;
        self.edge.move_to(position);
        self.y = y;
        position
    }
}

impl<const BITS: u32> Side for Chain<BITS> {
    #[inline(always)]
    fn whole_rows(&self) -> i32 {
        let is_at_top = self.y & ((1 << BITS) - 1) == 0;
        if is_at_top { (self.until - self.y) >> BITS } else { 0 }
    }

    #[inline(always)]
    fn whole_row(&mut self) -> Ramp {
        let from = self.edge.position();
        let to = from + (self.edge.step() << SUBPIXEL_BITS);
        self.edge.move_to(to);
        self.y += 1 << BITS;
        Ramp::between(from, to, FULL, self.edge.steepness)
    }

    #[inline(always)]
    fn pieces(&mut self, row: i32, mut piece: impl FnMut(i64, i64, u32, Steepness)) {
        let bottom = (row + 1) << BITS;
        loop {
            let end = bottom.min(self.until);
            if end > self.y {
                let from = self.edge.position();
                let height = height_in::<BITS>(end - self.y);
                let to = self.go_to(end);
                piece(from, to, height, self.edge.steepness);
            }
            if end < self.until || self.next.is_none() {
                return;
            }
            self.turn();
        }
    }
}

/// One or two edges anywhere.
#[derive(Debug, Clone)]
pub(crate) struct WideChain {
    edge: (Vertex, Vertex),
    next: Option<(Vertex, Vertex)>,
    y: i32,
}

impl WideChain {
    pub(crate) fn new(edge: (Vertex, Vertex), next: Option<(Vertex, Vertex)>) -> Self {
        Self { edge, next, y: edge.0.y.to_bits() }
    }

    /// Takes the chain down to the top of a row, unless it starts farther down.
    pub(crate) fn skip_to(&mut self, row: i32) {
        self.y = self.y.max(row.saturating_mul(1 << SUBPIXEL_BITS));
        if self.y >= self.edge.1.y.to_bits() {
            self.edge = self.next.take().unwrap_or(self.edge);
        }
    }
}

impl Side for WideChain {
    fn whole_rows(&self) -> i32 {
        0
    }

    fn whole_row(&mut self) -> Ramp {
        Ramp::between(0, 0, 0, Steepness::NONE)
    }

    fn pieces(&mut self, row: i32, mut piece: impl FnMut(i64, i64, u32, Steepness)) {
        let bottom = row.saturating_add(1).saturating_mul(1 << SUBPIXEL_BITS);
        loop {
            let (upper, lower) = self.edge;
            let end = bottom.min(lower.y.to_bits());
            if end > self.y {
                let descent = Descent::between(upper, lower);
                let at = |y: i32| wide_position(descent, y.wrapping_sub(upper.y.to_bits()).cast_unsigned());
                let (from, to) = (at(self.y), at(end));
                let height = height_in::<SUBPIXEL_BITS>(end - self.y);
                piece(from, to, height, Steepness::of_positions(height, to.abs_diff(from)));
                self.y = end;
            }
            if end < lower.y.to_bits() {
                return;
            }
            let Some(next) = self.next.take() else { return };
            self.edge = next;
        }
    }
}
