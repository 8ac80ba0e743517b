//! Convex outlines: in each row there is a left side and a right one, so nothing is to be ordered, and no winding is asked for.
//!
//! ```text
//!            .  vertices[0]           the left side adds what is to its right,
//!           / \                       the right one takes it away again
//!     left /    \ right
//!         /     .'  row: |  /#|####|####|#\  |
//!         \   .'
//! ```

use core::{mem::swap, ops::Range};

use heapless::Vec;

use crate::{
    PixelRect,
    area::{
        AreaSink, PlacedAreaSink, WINDOW,
        edge::{Edge, Piece},
        far::each_part,
        pair::send_pair,
        row::{Row, Sides},
        source::{FINE_BITS, FINE_ONE, Point},
        tiles::{for_each_tile, is_near},
    },
};

/// Four edges, each of which a tile may cut in two that it sees something of.
type Edges = Vec<Edge, 8>;

/// Of either side of a row.
type Areas = [i32; 2 * WINDOW];

/// What a row has of them.
type Pieces = Vec<Piece, 8>;

/// Sends the areas of a convex outline, which touches some pixels, in some rows and columns.
///
/// Its vertices, four at the most, are in 2^-16 pixel and clockwise as seen on the screen.
pub(crate) fn send_convex(
    vertices: &[(i64, i64)],
    touched: &PixelRect,
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut dyn PlacedAreaSink,
) {
    if !is_near(touched) {
        return send_far(vertices, rows, columns, sink);
    }
    let (x, y) = (columns.start, rows.start);
    let size = (columns.end - x, rows.end - y);
    let relative = |vertex: &(i64, i64)| {
        let relative = |at: i64, corner: i32| at.wrapping_sub(i64::from(corner) << FINE_BITS);
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^29")]
        let point = Point { x: relative(vertex.0, x) as i32, y: relative(vertex.1, y) as i32 };
        point
    };
    let mut edges = Edges::new();
    let mut from = vertices.last().map_or(Point { x: 0, y: 0 }, relative);
    for to in vertices.iter().map(relative) {
        push(&mut edges, from, to, size);
        from = to;
    }
    sink.place((x, y));
    send_edges(&edges, size, sink);
}

/// The same, tile by tile.
#[cold]
#[inline(never)]
fn send_far(vertices: &[(i64, i64)], rows: &Range<i32>, columns: &Range<i32>, sink: &mut dyn PlacedAreaSink) {
    let Some(&last) = vertices.last() else { return };
    for_each_tile(rows, columns, |tile, corner, size| {
        let (mut edges, mut from) = (Edges::new(), last);
        for &to in vertices {
            each_part([from, to], tile, corner, |from, to| push(&mut edges, from, to, size));
            from = to;
        }
        sink.place(corner);
        send_edges(&edges, size, sink)
    });
}

/// Keeps an edge, unless nothing is seen of it.
#[inline(never)]
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
fn send_edges(edges: &[Edge], (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
    let (mut top, mut bottom) = (i32::MAX, 0);
    for edge in edges {
        (top, bottom) = (top.min(edge.top), bottom.max(edge.bottom));
    }
    let (mut row, end) = (top.max(0) >> FINE_BITS, height.min((bottom + FINE_ONE - 1) >> FINE_BITS));
    let mut areas = [0; 2 * WINDOW];
    while row < end {
        let (mut pieces, mut until) = (Pieces::new(), end);
        for edge in edges {
            if let Some(piece) = edge.piece(row << FINE_BITS) {
                until = until.min(if piece.is_whole() { edge.bottom >> FINE_BITS } else { row });
                // There are never more.
                let _ = pieces.push(piece);
            }
        }
        // Of two that cross it from top to bottom, one is on either side.
        if let [left, right] = &mut *pieces
            && until > row
            && right.is_left()
        {
            swap(left, right);
        }
        if let [left, right] = &mut *pieces
            && until > row
        {
            while row < until {
                let sent = send_pair(row, width, [&left.side, &right.side], &mut areas, sink);
                if !sent.unwrap_or_else(|| send_row(row, width, &[*left, *right], &mut areas, sink)) {
                    return false;
                }
                left.step();
                right.step();
                row += 1;
            }
            continue;
        }
        if !send_row(row, width, &pieces, &mut areas, sink) {
            return false;
        }
        row += 1;
    }
    true
}

#[inline(never)]
fn send_row(row: i32, width: i32, pieces: &[Piece], areas: &mut Areas, sink: &mut dyn AreaSink) -> bool {
    let (mut left, mut right) = (width..i32::MIN, width..i32::MIN);
    let (mut inside, mut unseen) = (0, 0);
    for piece in pieces {
        let (first, last) = piece.side.columns();
        let side = if piece.is_left() { &mut left } else { &mut right };
        (side.start, side.end) = (side.start.min(first), side.end.max(last + 1));
        inside += piece.beyond().max(0);
        unseen += piece.beyond();
    }
    // Edges to the right of all columns have been left out.
    if unseen > 0 {
        right.end = width;
    }
    let cover = |sides, start: i32, areas: &mut [i32]| {
        areas.fill(if sides == Sides::Right { inside } else { 0 });
        for piece in pieces {
            if sides == Sides::Both || (sides == Sides::Left) == piece.is_left() {
                piece.add(start, areas);
            }
        }
    };
    Row { row, width, left, right, inside }.send(areas, cover, sink)
}
