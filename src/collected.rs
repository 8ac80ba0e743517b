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
        let Self { needed, available } = self;
        write!(f, "the outline needs room for {needed} vertices, not {available}: [Vertex::default(); {needed}]")
    }
}

impl core::error::Error for TooFewVertices {}

/// Any outline as a [`Polygon`], by the outline's own fill rule, in vertices that the caller lends.
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
    collect_and_count(outline, vertices).map_err(|(error, _)| error)
}

/// The same; an error comes with as many edges of scratch as are enough for the polygon.
pub(crate) fn collect_and_count<'v>(
    outline: &impl Outline,
    vertices: &'v mut [Vertex],
) -> Result<Polygon<'v>, (TooFewVertices, usize)> {
    let available = vertices.len();
    let mut room = Room { vertices, needed: 0, anchor: None, first: None, turns: Turns::default() };
    outline.emit(&mut room);
    let Room { vertices, needed, turns, .. } = room;
    let vertices: &'v [Vertex] = vertices;
    match vertices.get(..needed) {
        Some(vertices) => Ok(Polygon::new(vertices).winding_rule(outline.winding_rule())),
        None => Err((TooFewVertices { needed, available }, turns.of_closed())),
    }
}

struct Room<'v> {
    vertices: &'v mut [Vertex],
    needed: usize,
    /// Of all contours, and of the current one.
    anchor: Option<Vertex>,
    first: Option<Vertex>,
    turns: Turns,
}

impl Room<'_> {
    fn push(&mut self, vertex: Vertex) {
        if let Some(slot) = self.vertices.get_mut(self.needed) {
            *slot = vertex;
        }
        self.needed += 1;
        self.turns.add(vertex.y.to_bits());
    }
}

/// Counts how often a contour turns from going up to going down, or back: a chain starts at each.
#[derive(Debug, Clone, Copy, Default)]
struct Turns {
    count: usize,
    first: Option<i32>,
    last: i32,
    first_goes_down: Option<bool>,
    goes_down: Option<bool>,
}

impl Turns {
    fn add(&mut self, y: i32) {
        if self.first.is_none() {
            self.first = Some(y);
        } else if y != self.last {
            let goes_down = Some(y > self.last);
            if self.goes_down.is_none() {
                self.first_goes_down = goes_down;
            } else if self.goes_down != goes_down {
                self.count += 1;
            }
            self.goes_down = goes_down;
        }
        self.last = y;
    }

    /// With the edge from the last vertex to the first.
    fn of_closed(mut self) -> usize {
        if let Some(first) = self.first {
            self.add(first);
        }
        self.count + usize::from(self.goes_down != self.first_goes_down)
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
