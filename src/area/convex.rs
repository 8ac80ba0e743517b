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

use crate::{
    area::{
        AreaSink, PlacedAreaSink,
        accumulator::{Accumulator, WINDOW_COLUMNS},
        chain::CoverageEdge,
        emission::Emission,
        far::{Far, Vertices},
        lines::Row,
        pair::{NO_AREAS, send_pair},
        source::{FINE_BITS, Outline, Point, Source},
        tiles::{REACH, for_each_tile},
    },
    contours::next_index,
};

/// Sends the areas of a convex outline in some rows and columns.
///
/// Its `N` vertices are in 2^-16 pixel and clockwise as seen on the screen, the first of them a topmost one.
pub(crate) fn send_convex<const N: usize>(
    vertices: &[(i64, i64); N],
    rows: &Range<i32>,
    columns: &Range<i32>,
    sink: &mut dyn PlacedAreaSink,
) {
    let corner = (columns.start, rows.start);
    let size = (columns.end - columns.start, rows.end - rows.start);
    let mut points = [Point { x: 0, y: 0 }; N];
    let mut is_near = true;
    for (point, vertex) in points.iter_mut().zip(vertices) {
        let relative = |at: i64, corner: i32| at.wrapping_sub(i64::from(corner) << FINE_BITS);
        let (x, y) = (relative(vertex.0, corner.0), relative(vertex.1, corner.1));
        is_near &= x.unsigned_abs() <= REACH && y.unsigned_abs() <= REACH;
        #[allow(clippy::cast_possible_truncation, reason = "where it matters, at most 2^29")]
        let near = Point { x: x as i32, y: y as i32 };
        *point = near;
    }
    if is_near {
        sink.place(corner);
        fill_convex(Source::Outline(&Ring(points)), size, sink);
        return;
    }
    for_each_tile(rows, columns, |tile, corner, size| {
        sink.place(corner);
        let far = Far { vertices: Vertices::Ring(vertices), tile, corner };
        fill_convex(Source::Outline(&far), size, sink)
    });
}

/// A contour that is near.
struct Ring<const N: usize>([Point; N]);

impl<const N: usize> Outline for Ring<N> {
    fn contours(&self) -> u32 {
        1
    }

    fn first(&self, _: u32) -> Option<u32> {
        Some(0)
    }

    fn next(&self, _: u32, index: u32, is_forward: bool) -> u32 {
        next_index(&self.0, index, is_forward)
    }

    fn vertex(&self, _: u32, index: u32) -> Point {
        self.0.get(index as usize).copied().unwrap_or(Point { x: 0, y: 0 })
    }
}

/// Sends the areas of an outline of one convex contour; see [`send_convex`].
#[inline(never)]
fn fill_convex(outline: Source<'_>, (width, height): (i32, i32), sink: &mut dyn AreaSink) -> bool {
    let mut row = (outline.vertex(0, 0).y >> FINE_BITS).max(0);
    let (mut left, mut right) = (CoverageEdge::EMPTY, CoverageEdge::EMPTY);
    let (mut rows, mut areas) = (ConvexRows::new(width), NO_AREAS);
    if !right.begin(&outline, (0, 0), 1, row << FINE_BITS) || !left.begin(&outline, (0, 0), -1, row << FINE_BITS) {
        return true;
    }
    while row < height {
        let row_top = row << FINE_BITS;
        let extent = |side: &mut CoverageEdge| {
            let low = side.advance(&outline, row_top);
            low >> FINE_BITS..side.high >> FINE_BITS
        };
        let extents = (extent(&mut left), extent(&mut right));
        let pair = ((&mut left, extents.0.start), (&mut right, extents.1.start));
        let goes_on = send_pair(row, width, pair.0, pair.1, &mut areas, sink).unwrap_or_else(|| {
            let add = |accumulator: &mut Accumulator| {
                let row = Row { source: outline, top: row_top, kept: &[] };
                left.add(&row, 1, accumulator);
                right.add(&row, -1, accumulator);
            };
            rows.send(row, extents, add, sink)
        });
        if !goes_on {
            return false;
        }
        if left.ends || right.ends {
            break;
        }
        left.leave_row();
        right.leave_row();
        row += 1;
    }
    true
}

/// Sends rows that lie between a left side and a right one.
pub(super) struct ConvexRows {
    accumulator: Accumulator,
    width: i32,
}

impl ConvexRows {
    pub(super) const fn new(width: i32) -> Self {
        Self { accumulator: Accumulator::new(), width }
    }

    /// Sends a row; `extents` are the first and the last column of either side, which `add` adds.
    #[inline]
    pub(super) fn send(
        &mut self,
        row: i32,
        (left, right): (Range<i32>, Range<i32>),
        mut add: impl FnMut(&mut Accumulator),
        sink: &mut dyn AreaSink,
    ) -> bool {
        let mut start = left.start.max(0);
        let end = self.width.min(right.end.saturating_add(2));
        while start < end {
            self.accumulator.begin(start, 0);
            add(&mut self.accumulator);
            let reach = start + WINDOW_COLUMNS;
            // Behind the column after the left side, there is nothing to add up before the right one.
            let is_gap = left.end + 1 < reach && right.start >= reach;
            let until = if is_gap { end.min(right.start) } else { end.min(reach) };
            let emission = Emission { row, start, until, is_complete: is_gap, gap: None };
            if !self.accumulator.emit(emission, sink) {
                return false;
            }
            start = until;
        }
        true
    }
}
