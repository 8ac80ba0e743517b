//! Outlines as polygons, in vertices that the caller lends.

use core::fmt;

use crate::{
    Polygon, Vertex,
    outline::{FinePoint, Outline, OutlineSink},
};

/// There is too little room for the vertices of an outline; nothing has been drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TooFewVertices {
    /// How many vertices the outline needs.
    pub needed: usize,
    /// How many there is room for.
    pub available: usize,
}

impl fmt::Display for TooFewVertices {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the outline needs room for {} vertices, {} available", self.needed, self.available)
    }
}

impl core::error::Error for TooFewVertices {}

/// Any outline as a [`Polygon`], non-zero, in vertices that the caller lends.
///
/// Points are rounded to 1/256 pixel, which may change a pixel's coverage by 1/255. All contours become one, joined by
/// edges that are gone along there and back, and so have no inside: two vertices more for each.
///
/// # Errors
///
/// When there is too little room.
///
/// # Cost
///
/// 8 bytes a vertex.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{ActiveEdge, Cap, Stroke, StrokeStyle, Vertex, collect, path, prelude::*};
///
/// let corner = Stroke::new(path!("M2 8V2h5"), StrokeStyle::pixels(2).cap(Cap::Square));
/// let mut vertices = [Vertex::default(); 32];
/// let mut edges = [ActiveEdge::EMPTY; 16];
/// let polygon = collect(&corner, &mut vertices)?;
/// let mut display = MockDisplay::new();
/// polygon.in_scratch(&mut edges)?.filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&[
///     "        ", " #######", " #######", " ##     ", " ##     ", " ##     ", " ##     ", " ##     ", " ##     ",
/// ]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub fn collect<'v>(outline: &impl Outline, vertices: &'v mut [Vertex]) -> Result<Polygon<'v>, TooFewVertices> {
    let available = vertices.len();
    let mut room = Room { vertices, needed: 0, anchor: None, first: None };
    outline.emit(&mut room);
    let Room { vertices, needed, .. } = room;
    let vertices: &'v [Vertex] = vertices;
    match vertices.get(..needed) {
        Some(vertices) => Ok(Polygon::new(vertices)),
        None => Err(TooFewVertices { needed, available }),
    }
}

struct Room<'v> {
    vertices: &'v mut [Vertex],
    needed: usize,
    /// Of all contours, and of the current one.
    anchor: Option<Vertex>,
    first: Option<Vertex>,
}

impl Room<'_> {
    fn push(&mut self, vertex: Vertex) {
        if let Some(slot) = self.vertices.get_mut(self.needed) {
            *slot = vertex;
        }
        self.needed += 1;
    }
}

impl OutlineSink for Room<'_> {
    fn point(&mut self, x: i64, y: i64) {
        let vertex = FinePoint::clamped(x, y).to_vertex();
        self.first.get_or_insert(vertex);
        self.push(vertex);
    }

    fn close(&mut self) {
        if let Some(first) = self.first.take() {
            self.push(first);
            let anchor = *self.anchor.get_or_insert(first);
            self.push(anchor);
        }
    }
}
