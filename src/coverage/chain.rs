//! Sides of at most two straight edges anywhere in the range.

use crate::{
    Vertex,
    coverage::{Steepness, convex::Side, ramp::height_in, slope::wide_position},
    edge::Descent,
    limits::SUBPIXEL_BITS,
};

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
