//! Anti-aliased triangle.

use crate::{
    PixelRect, Vertex,
    area::{PlacedAreaSink, Rounded, send_convex, vertex_position},
    coverage::CoverageSink,
    geometry::{by_height, touched},
    shape::{Cover, Triangle},
    span::visible,
};

impl Cover for Triangle {
    #[inline]
    fn touched(&self) -> PixelRect {
        touched(self.vertices.iter())
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        Rounded::send(sink, |areas| self.areas(clip, areas))
    }
}

impl Triangle {
    /// Sends the areas of the pixels in `clip`, before anything is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let touched = Cover::touched(self);
        let Some((rows, columns)) = visible(&touched, clip) else { return };
        let [a, b, c] = self.vertices;
        let (a, b) = by_height(a, b);
        let (a, c) = by_height(a, c);
        let clockwise = if is_right_of(a, c, b) { [a, b, c] } else { [a, c, b] };
        send_convex(&clockwise.map(vertex_position), &touched, &rows, &columns, sink);
    }
}

/// Whether `c` lies to the right of the edge from `a` down to `b`.
fn is_right_of(a: Vertex, b: Vertex, c: Vertex) -> bool {
    let product = |across: Vertex, down: Vertex| {
        let across = i64::from(across.x.to_bits()) - i64::from(a.x.to_bits());
        let down = i64::from(down.y.to_bits()) - i64::from(a.y.to_bits());
        i128::from(across) * i128::from(down)
    };
    product(c, b) > product(b, c)
}
