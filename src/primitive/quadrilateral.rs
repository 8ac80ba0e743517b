//! Convex quadrilaterals without anti-aliasing: thick lines, and those that taper.
//!
//! From the highest corner two chains of up to three edges lead to the lowest; a row has the columns between them. Which is
//! the left one is seen from the columns.

use crate::{
    PixelRect, Vertex,
    edge::Edge,
    geometry::touched,
    shape::Shape,
    span::{BlockSink, OpenBlock, SpanSink, SplitRows, clip_range},
    subpixel::first_centre_at_or_after,
};
#[cfg(feature = "embedded-graphics")]
use crate::{
    area::{Rounded, send_convex, vertex_position},
    span::visible,
};

/// Four corners in order, whichever way around.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quadrilateral(pub(crate) [Vertex; 4]);

/// One side of it.
struct Chain {
    edge: Edge,
    from: Vertex,
    to: Vertex,
    /// Of the corner that the edge leads to.
    corner: u8,
    /// The row after the edge's last.
    end: i32,
}

impl Quadrilateral {
    fn corner(&self, index: u8) -> Vertex {
        self.0.get(usize::from(index & 3)).copied().unwrap_or_default()
    }

    /// The corners clockwise, from a topmost one.
    #[cfg(feature = "embedded-graphics")]
    pub(crate) fn clockwise(&self) -> [Vertex; 4] {
        let [a, b, c, d] = self.0.map(|Vertex { x, y }| (i128::from(x.to_bits()), i128::from(y.to_bits())));
        // Twice the area, from the diagonals.
        let is_clockwise = (c.0 - a.0) * (d.1 - b.1) >= (c.1 - a.1) * (d.0 - b.0);
        let top = (0..4).min_by_key(|index| self.corner(*index).y).unwrap_or(0);
        let step = if is_clockwise { 1 } else { 3 };
        [0, 1, 2, 3].map(|index| self.corner(top + step * index))
    }

    /// The edge of a side that meets a row, from a corner on.
    fn chain(&self, mut corner: u8, step: u8, row: i32) -> Chain {
        let mut from = self.corner(corner);
        // Three edges at most lead down.
        for _ in 0..3 {
            corner = (corner + step) & 3;
            let to = self.corner(corner);
            let end = first_centre_at_or_after(to.y.to_bits());
            if end > row {
                return Chain { edge: Edge::on_row(from, to, row), from, to, corner, end };
            }
            from = to;
        }
        Chain { edge: Edge::EMPTY, from, to: from, corner, end: i32::MAX }
    }
}

impl Shape for Quadrilateral {
    fn bounds(&self) -> PixelRect {
        touched(self.0.iter())
    }

    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.blocks(clip, &mut SplitRows(sink))
    }

    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let row_of = |index: u8| first_centre_at_or_after(self.corner(index).y.to_bits());
        let (mut top, mut bottom) = (0, 0);
        for index in 1..4 {
            if self.corner(index).y < self.corner(top).y {
                top = index;
            }
            if self.corner(index).y > self.corner(bottom).y {
                bottom = index;
            }
        }
        let first = row_of(top).max(clip.rows.start);
        let end = row_of(bottom).min(clip.rows.end);
        if first >= end {
            return Ok(());
        }
        let [mut one, mut other] = [1, 3].map(|step| self.chain(top, step, first));
        let mut block = OpenBlock::new();
        let mut row = first;
        while row < end {
            let turn = one.end.min(other.end).min(end);
            while row < turn {
                let (a, b) = (one.edge.column, other.edge.column);
                block.row(row, clip_range(&(a.min(b)..a.max(b)), &clip.columns), sink)?;
                row += 1;
                if row < turn {
                    let Chain { from, to, .. } = one;
                    one.edge.step_or(|| Edge::on_row(from, to, row));
                    let Chain { from, to, .. } = other;
                    other.edge.step_or(|| Edge::on_row(from, to, row));
                }
            }
            for (chain, step) in [(&mut one, 1), (&mut other, 3)] {
                if row >= end {
                    break;
                }
                if chain.end <= row {
                    *chain = self.chain(chain.corner, step, row);
                } else {
                    let Chain { from, to, .. } = *chain;
                    chain.edge.step_or(|| Edge::on_row(from, to, row));
                }
            }
        }
        block.finish(end, sink)
    }
}

#[cfg(feature = "embedded-graphics")]
impl crate::shape::Cover for Quadrilateral {
    fn touched(&self) -> PixelRect {
        touched(self.0.iter())
    }

    fn coverage<S: crate::CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let touched = self.touched();
        let Some((rows, columns)) = visible(&touched, clip) else { return Ok(()) };
        let corners = self.clockwise().map(vertex_position);
        Rounded::send(sink, |areas| send_convex(&corners, &touched, &rows, &columns, areas))
    }
}
