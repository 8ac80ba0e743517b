//! Outlines that reach farther than 8192 pixels, as seen from one of the tiles that the plane is cut into.
//!
//! An edge longer than that is cut where it enters and leaves the tile's rows or columns, whichever it is longer along. The
//! cuts lie on the borders of tiles, so they do not depend on the clip. They are rounded to 2^-16 pixel. What lies beyond is
//! moved closer, on its own side of the tile: there only heights count.
//!
//! ```text
//!          |          |
//!      A---P----------P'------------ B
//!          |   tile   |
//! ```

use crate::{
    Vertex,
    area::source::{FINE_BITS, Outline, Point},
    contours::{Contours, next_index},
    edge::divide_product,
    limits::SUBPIXEL_BITS,
};

/// The side of a tile, in pixels.
pub(crate) const TILE: i32 = 1 << 12;

/// The longest edge that is not cut, in 1/256 pixel.
pub(crate) const LONGEST: u32 = 1 << 21;

/// As close as what lies beyond is moved, in 2^-16 pixel from the tile's corner.
const BEYOND: i64 = (3 * (TILE as i64)) << FINE_BITS;

/// From 1/256 pixel to 2^-16.
const FINER: u32 = FINE_BITS - SUBPIXEL_BITS;

/// See the module. An index is a vertex's, times four, and how many cuts of the edge behind it lie before.
pub(super) struct Far<'a> {
    pub(super) contours: Contours<'a>,
    /// The corner of the tile, and that of what is drawn, in pixels.
    pub(super) tile: (i32, i32),
    pub(super) corner: (i32, i32),
}

/// An edge that is cut.
struct Long {
    along_x: bool,
    /// The ends, the first along the longer axis being the first; (along, across).
    ends: [(i32, i32); 2],
    /// Cut at the tile's near border, at its far one.
    cuts: [bool; 2],
    is_reversed: bool,
}

impl Far<'_> {
    fn vertex_at(&self, contour: u32, vertex: u32) -> Vertex {
        self.contours.contour(contour as usize).get(vertex as usize).copied().unwrap_or_default()
    }

    fn long(&self, contour: u32, vertex: u32) -> Option<Long> {
        let next = next_index(self.contours.contour(contour as usize), vertex, true);
        let bits = |vertex: Vertex| (vertex.x.to_bits(), vertex.y.to_bits());
        let (a, b) = (bits(self.vertex_at(contour, vertex)), bits(self.vertex_at(contour, next)));
        let (dx, dy) = (a.0.abs_diff(b.0), a.1.abs_diff(b.1));
        if dx <= LONGEST && dy <= LONGEST {
            return None;
        }
        let along_x = dx >= dy;
        let turned = |(x, y): (i32, i32)| if along_x { (x, y) } else { (y, x) };
        let (a, b) = (turned(a), turned(b));
        let is_reversed = a.0 > b.0;
        let ends = if is_reversed { [b, a] } else { [a, b] };
        let near = turned(self.tile).0;
        let cuts = [near, near.saturating_add(TILE)].map(|border| {
            let border = i64::from(border) << SUBPIXEL_BITS;
            i64::from(ends[0].0) < border && border < i64::from(ends[1].0)
        });
        Some(Long { along_x, ends, cuts, is_reversed })
    }

    fn cuts(&self, contour: u32, vertex: u32) -> u32 {
        self.long(contour, vertex).map_or(0, |long| long.cuts.iter().map(|&cut| u32::from(cut)).sum())
    }

    /// Relative to what is drawn, from 2^-16 pixel.
    fn relative(&self, (x, y): (i64, i64)) -> Point {
        let near = |at: i64, tile: i32, corner: i32| {
            let from_tile = (at - (i64::from(tile) << FINE_BITS)).clamp(-BEYOND, BEYOND);
            #[allow(clippy::cast_possible_truncation, reason = "at most 2^30, as the corner lies in the tile")]
            let near = (from_tile - (i64::from(corner - tile) << FINE_BITS)) as i32;
            near
        };
        Point { x: near(x, self.tile.0, self.corner.0), y: near(y, self.tile.1, self.corner.1) }
    }
}

impl Outline for Far<'_> {
    fn contours(&self) -> u32 {
        u32::try_from(self.contours.len()).unwrap_or(u32::MAX)
    }

    fn first(&self, contour: u32) -> Option<u32> {
        (!self.contours.contour(contour as usize).is_empty()).then_some(0)
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        let (vertex, cut) = (index >> 2, index & 3);
        let neighbour = next_index(self.contours.contour(contour as usize), vertex, is_forward);
        match (is_forward, cut) {
            (true, cut) if cut < self.cuts(contour, vertex) => index + 1,
            (true, _) => neighbour << 2,
            (false, 0) => neighbour << 2 | self.cuts(contour, neighbour),
            (false, _) => index - 1,
        }
    }

    fn vertex(&self, contour: u32, index: u32) -> Point {
        let (vertex, cut) = (index >> 2, index & 3);
        let long = if cut == 0 { None } else { self.long(contour, vertex) };
        let Some(Long { along_x, ends: [start, end], cuts, is_reversed }) = long else {
            let vertex = self.vertex_at(contour, vertex);
            return self.relative((i64::from(vertex.x.to_bits()) << FINER, i64::from(vertex.y.to_bits()) << FINER));
        };
        // Of two cuts, the first is the near one, unless the edge is the other way round.
        let is_far = if cuts == [true, true] { (cut == 2) != is_reversed } else { cuts[1] };
        let near = if along_x { self.tile.0 } else { self.tile.1 };
        let along = (i64::from(near) + if is_far { i64::from(TILE) } else { 0 }) << SUBPIXEL_BITS;
        let length = end.0.wrapping_sub(start.0).cast_unsigned();
        let distance = (along - i64::from(start.0)).unsigned_abs();
        let (whole, part) = divide_product(distance, start.1.abs_diff(end.1), length);
        let moved = (whole << FINER)
            .wrapping_add(((u64::from(part) << (FINER + 1)) / u64::from(length.max(1)) + 1) >> 1)
            .cast_signed();
        let across = (i64::from(start.1) << FINER) + if start.1 <= end.1 { moved } else { -moved };
        let along = along << FINER;
        self.relative(if along_x { (along, across) } else { (across, along) })
    }
}
