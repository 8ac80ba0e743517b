//! Convex outlines: in each row there is a left side and a right one, so nothing is to be ordered, and no winding is asked for.
//!
//! ```text
//!            .  vertices[0]           the left side adds what is to its right,
//!           / \                       the right one takes it away again
//!     left /    \ right
//!         /     .'  row: |  /#|####|####|#\  |
//!         \   .'
//! ```

use core::ops::Range;

use heapless::Vec;

use crate::area::{
    AreaSink, PlacedAreaSink, WINDOW,
    edge::Edge,
    far::each_part,
    row::{Row, Sides},
    source::{FINE_BITS, FINE_ONE, Point},
    tiles::{REACH, for_each_tile},
};

/// Four edges, each of which a tile may cut in two that it sees something of.
type Edges = Vec<Edge, 8>;

/// Sends the areas of a convex outline in some rows and columns.
///
/// Its vertices, four at the most, are in 2^-16 pixel and clockwise as seen on the screen.
pub(crate) fn send_convex(
    vertices: &[(i64, i64)],
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut dyn PlacedAreaSink,
) {
    let Some(&last) = vertices.last() else { return };
    let mut send = |tile: (i32, i32), corner: (i32, i32), size: (i32, i32)| {
        let (mut edges, mut from) = (Edges::new(), last);
        for &to in vertices {
            each_part([from, to], tile, corner, |from, to| push(&mut edges, from, to, size));
            from = to;
        }
        sink.place(corner);
        send_edges(&mut edges, size, sink)
    };
    let (corner, size) = ((columns.start, rows.start), (columns.end - columns.start, rows.end - rows.start));
    let mut from = last;
    let is_near = vertices.iter().all(|&to| {
        let (dx, dy) = (to.0.abs_diff(from.0), to.1.abs_diff(from.1));
        from = to;
        dx <= REACH && dy <= REACH
    });
    if is_near {
        send(corner, corner, size);
    } else {
        for_each_tile(rows, columns, send);
    }
}

/// Keeps an edge, unless nothing is seen of it.
fn push(edges: &mut Edges, from: Point, to: Point, (width, height): (i32, i32)) {
    let is_right = from.x.min(to.x) >> FINE_BITS >= width;
    let is_outside = from.y.max(to.y) <= 0 || from.y.min(to.y) >> FINE_BITS >= height;
    if !is_right
        && !is_outside
        && let Some(edge) = Edge::new(from, to)
    {
        // There are never more.
        let _ = edges.push(edge);
    }
}

#[inline(never)]
fn send_edges(edges: &mut [Edge], (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
    let (mut top, mut bottom) = (i32::MAX, 0);
    for edge in &*edges {
        (top, bottom) = (top.min(edge.top), bottom.max(edge.bottom));
    }
    let mut row = top.max(0) >> FINE_BITS;
    for edge in &mut *edges {
        edge.skip_to(row << FINE_BITS);
    }
    let end = height.min((bottom + FINE_ONE - 1) >> FINE_BITS);
    let mut areas = [0; WINDOW];
    while row < end {
        let (mut left, mut right) = (width..i32::MIN, width..i32::MIN);
        let (mut inside, mut unseen) = (0, 0);
        for edge in &mut *edges {
            if !edge.advance(row << FINE_BITS) {
                continue;
            }
            let (first, last) = edge.columns();
            let side = if edge.is_left() { &mut left } else { &mut right };
            (side.start, side.end) = (side.start.min(first), side.end.max(last + 1));
            unseen += edge.signed_area();
            inside += edge.signed_area().max(0);
        }
        // Edges to the right of all columns have been left out.
        if unseen > 0 {
            right.end = width;
        }
        let add = |sides, start: i32, areas: &mut [i32]| {
            areas.fill(if sides == Sides::Right { inside } else { 0 });
            for edge in edges.iter().filter(|edge| edge.is_of(sides)) {
                edge.add(start, areas);
            }
        };
        if !(Row { row, width, left, right, inside }).send(&mut areas, add, sink) {
            return false;
        }
        row += 1;
    }
    true
}
