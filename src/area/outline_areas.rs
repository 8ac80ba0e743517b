//! Outlines whose vertices are worked out, near or far.

use crate::{
    PixelRect, WindingRule,
    area::{
        CoverageEdge, Inside, Rounded,
        far::TILE,
        fill::fill,
        source::{FINE_BITS, Outline, Point, Source},
    },
    coverage::CoverageSink,
    outline::{FinePoint, Vertices},
    span::clip_range,
};

/// From 1/4096 pixel to 2^-16.
const FINER: u32 = 4;

/// The longest edge that is not cut, and the largest outline of which none is, in pixels.
const REACH: i64 = 2 * TILE as i64;

/// As close as what lies beyond is moved, in 2^-16 pixel from the tile's corner.
const BEYOND: i64 = (3 * (TILE as i64)) << FINE_BITS;

/// Sends how much of each pixel in `clip` an outline covers that lies within the pixels `touched`.
pub(crate) fn send_outline<S: CoverageSink>(
    vertices: &dyn Vertices,
    rule: WindingRule,
    touched: &PixelRect,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    let (rows, columns) = (clip_range(&touched.rows, &clip.rows), clip_range(&touched.columns, &clip.columns));
    if rows.is_empty() || columns.is_empty() {
        return Ok(());
    }
    let inside = Inside { mask: rule.mask, flip: rule.flip, least: rule.least };
    let mut rounded = Rounded { sink, corner: (columns.start, rows.start), result: Ok(()) };
    let length = |range: &core::ops::Range<i32>| i64::from(range.end) - i64::from(range.start);
    if length(&touched.rows) <= REACH && length(&touched.columns) <= REACH {
        let near = Near { vertices, corner: (columns.start, rows.start) };
        let size = (columns.end - columns.start, rows.end - rows.start);
        fill(Source::Outline(&near), inside, size, slots, &mut rounded);
        return rounded.result;
    }
    let mut y = rows.start;
    while y < rows.end {
        let tile_y = y & -TILE;
        let bottom = rows.end.min(tile_y.saturating_add(TILE));
        let mut x = columns.start;
        while x < columns.end {
            let tile_x = x & -TILE;
            let right = columns.end.min(tile_x.saturating_add(TILE));
            rounded.corner = (x, y);
            let far = FarVertices { vertices, tile: (tile_x, tile_y), corner: (x, y) };
            if !fill(Source::Outline(&far), inside, (right - x, bottom - y), slots, &mut rounded) {
                return rounded.result;
            }
            x = right;
        }
        y = bottom;
    }
    rounded.result
}

struct Near<'a> {
    vertices: &'a dyn Vertices,
    /// Of what is drawn, in pixels.
    corner: (i32, i32),
}

impl Outline for Near<'_> {
    fn contours(&self) -> u32 {
        self.vertices.contours()
    }

    fn first(&self, contour: u32) -> Option<u32> {
        self.vertices.first(contour)
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        self.vertices.next(contour, index, is_forward)
    }

    fn vertex(&self, contour: u32, index: u32) -> Point {
        let FinePoint { x, y } = self.vertices.vertex(contour, index);
        // At most 2^29 apart, whatever is lost of each.
        let relative = |at: i32, corner: i32| (at << FINER).wrapping_sub(corner << FINE_BITS);
        Point { x: relative(x, self.corner.0), y: relative(y, self.corner.1) }
    }
}

/// As seen from a tile: long edges are cut at its borders, as those of `Far` are. An index is a vertex's, times four, and
/// how many cuts of the edge behind it lie before.
struct FarVertices<'a> {
    vertices: &'a dyn Vertices,
    tile: (i32, i32),
    corner: (i32, i32),
}

impl FarVertices<'_> {
    /// Where the edge behind a vertex is cut, in 2^-16 pixel, in its order.
    fn cuts(&self, contour: u32, vertex: u32) -> [Option<(i64, i64)>; 2] {
        let next = self.vertices.next(contour, vertex, true);
        let wide = |index: u32| {
            let FinePoint { x, y } = self.vertices.vertex(contour, index);
            (i64::from(x) << FINER, i64::from(y) << FINER)
        };
        let (a, b) = (wide(vertex), wide(next));
        let (dx, dy) = ((a.0 - b.0).abs(), (a.1 - b.1).abs());
        if dx.max(dy) <= REACH << FINE_BITS {
            return [None, None];
        }
        let turned = |(x, y): (i64, i64)| if dx >= dy { (x, y) } else { (y, x) };
        let near = i64::from(if dx >= dy { self.tile.0 } else { self.tile.1 });
        // The same whichever way the edge goes.
        let is_reversed = turned(a).0 > turned(b).0;
        let (low, high) = if is_reversed { (turned(b), turned(a)) } else { (turned(a), turned(b)) };
        let cut = |border: i64| {
            let along = border << FINE_BITS;
            let product = i128::from(high.1 - low.1) * i128::from(along - low.0);
            let moved = i64::try_from(crate::outline::divide_half_even(product, i128::from(high.0 - low.0)));
            let is_there = low.0 < along && along < high.0;
            is_there.then(|| turned((along, low.1 + moved.unwrap_or(0))))
        };
        let cuts = [cut(near), cut(near + i64::from(TILE))];
        match cuts {
            [Some(near), Some(far)] if is_reversed => [Some(far), Some(near)],
            [None, far] => [far, None],
            cuts => cuts,
        }
    }

    fn count(&self, contour: u32, vertex: u32) -> u32 {
        self.cuts(contour, vertex).iter().map(|cut| u32::from(cut.is_some())).sum()
    }
}

impl Outline for FarVertices<'_> {
    fn contours(&self) -> u32 {
        self.vertices.contours()
    }

    fn first(&self, contour: u32) -> Option<u32> {
        self.vertices.first(contour).map(|index| index << 2)
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        let (vertex, cut) = (index >> 2, index & 3);
        match (is_forward, cut) {
            (true, cut) if cut < self.count(contour, vertex) => index + 1,
            (true, _) => self.vertices.next(contour, vertex, true) << 2,
            (false, 0) => {
                let before = self.vertices.next(contour, vertex, false);
                before << 2 | self.count(contour, before)
            }
            (false, _) => index - 1,
        }
    }

    fn vertex(&self, contour: u32, index: u32) -> Point {
        let (vertex, cut) = (index >> 2, index & 3);
        let [first, second] = if cut == 0 { [None, None] } else { self.cuts(contour, vertex) };
        let (x, y) = (if cut == 2 { second } else { first }).unwrap_or_else(|| {
            let FinePoint { x, y } = self.vertices.vertex(contour, vertex);
            (i64::from(x) << FINER, i64::from(y) << FINER)
        });
        let near = |at: i64, tile: i32, corner: i32| {
            let from_tile = (at - (i64::from(tile) << FINE_BITS)).clamp(-BEYOND, BEYOND);
            #[allow(clippy::cast_possible_truncation, reason = "at most 2^30, as the corner lies in the tile")]
            let near = (from_tile - (i64::from(corner - tile) << FINE_BITS)) as i32;
            near
        };
        Point { x: near(x, self.tile.0, self.corner.0), y: near(y, self.tile.1, self.corner.1) }
    }
}
