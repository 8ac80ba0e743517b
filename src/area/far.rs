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
    area::{
        source::{FINE_BITS, Outline, Point},
        tiles::{REACH, TILE},
    },
    contours::{Contours, next_index},
    limits::SUBPIXEL_BITS,
    outline::{self, FinePoint},
};

/// The longest edge that is not cut, in 2^-16 pixel.
const LONGEST: u64 = REACH;

/// As close as what lies beyond is moved, in 2^-16 pixel from the tile's corner.
const BEYOND: i64 = (3 * (TILE as i64)) << FINE_BITS;

/// From 1/256 pixel to 2^-16.
const FINER: u32 = FINE_BITS - SUBPIXEL_BITS;

/// From 1/4096 pixel to 2^-16.
const FROM_FINE: u32 = 4;

/// Vertices anywhere, in 2^-16 pixel.
#[derive(Clone, Copy)]
pub(super) enum Vertices<'a> {
    Contours(Contours<'a>),
    /// In 1/4096 pixel.
    Outline(&'a dyn outline::Vertices),
}

impl Vertices<'_> {
    fn at(&self, contour: u32, vertex: u32) -> (i64, i64) {
        match self {
            Self::Contours(contours) => {
                let vertex = contours.contour(contour as usize).get(vertex as usize).copied().unwrap_or_default();
                (i64::from(vertex.x.to_bits()) << FINER, i64::from(vertex.y.to_bits()) << FINER)
            }
            Self::Outline(outline) => {
                let FinePoint { x, y } = outline.vertex(contour, vertex);
                (i64::from(x) << FROM_FINE, i64::from(y) << FROM_FINE)
            }
        }
    }

    fn next(&self, contour: u32, vertex: u32, is_forward: bool) -> u32 {
        match self {
            Self::Contours(contours) => next_index(contours.contour(contour as usize), vertex, is_forward),
            Self::Outline(outline) => outline.next(contour, vertex, is_forward),
        }
    }
}

/// See the module. An index is a vertex's, times four, and how many cuts of the edge behind it lie before.
pub(super) struct Far<'a> {
    pub(super) vertices: Vertices<'a>,
    /// The corner of the tile, and that of what is drawn, in pixels.
    pub(super) tile: (i32, i32),
    pub(super) corner: (i32, i32),
}

/// An edge that is cut.
struct Long {
    along_x: bool,
    /// The ends, the first along the longer axis being the first; (along, across).
    ends: [(i64, i64); 2],
    /// The tile's near border, and its far one.
    borders: [i64; 2],
    /// Whether it is cut at them.
    cuts: [bool; 2],
    is_reversed: bool,
}

impl Long {
    /// None for one that is not cut, however far away it is.
    fn new(a: (i64, i64), b: (i64, i64), tile: (i32, i32)) -> Option<Self> {
        let (dx, dy) = (a.0.abs_diff(b.0), a.1.abs_diff(b.1));
        if dx <= LONGEST && dy <= LONGEST {
            return None;
        }
        let along_x = dx >= dy;
        let turned = |(x, y): (i64, i64)| if along_x { (x, y) } else { (y, x) };
        let (a, b) = (turned(a), turned(b));
        let is_reversed = a.0 > b.0;
        let ends = if is_reversed { [b, a] } else { [a, b] };
        let near = if along_x { tile.0 } else { tile.1 };
        let borders = [near, near.saturating_add(TILE)].map(|border| i64::from(border) << FINE_BITS);
        let cuts = borders.map(|border| ends[0].0 < border && border < ends[1].0);
        Some(Self { along_x, ends, borders, cuts, is_reversed })
    }

    /// Where it is cut.
    #[inline(never)]
    fn at(&self, is_far: bool) -> (i64, i64) {
        let [start, end] = self.ends;
        let along = if is_far { self.borders[1] } else { self.borders[0] };
        let moved = share(along.abs_diff(start.0), start.1.abs_diff(end.1), end.0.abs_diff(start.0)).cast_signed();
        let across = start.1 + if start.1 <= end.1 { moved } else { -moved };
        if self.along_x { (along, across) } else { (across, along) }
    }
}

/// Relative to `corner`, which lies in the tile; what lies beyond is moved closer.
#[inline(never)]
fn relative((x, y): (i64, i64), tile: (i32, i32), corner: (i32, i32)) -> Point {
    let near = |at: i64, tile: i32, corner: i32| {
        let from_tile = (at - (i64::from(tile) << FINE_BITS)).clamp(-BEYOND, BEYOND);
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^30, as the corner lies in the tile")]
        let near = (from_tile - (i64::from(corner - tile) << FINE_BITS)) as i32;
        near
    };
    Point { x: near(x, tile.0, corner.0), y: near(y, tile.1, corner.1) }
}

/// Calls with the parts that an edge is cut into, relative to `corner`, in order.
pub(super) fn each_part(
    [a, b]: [(i64, i64); 2],
    tile: (i32, i32),
    corner: (i32, i32),
    mut part: impl FnMut(Point, Point),
) {
    let relative = |at| relative(at, tile, corner);
    let mut from = relative(a);
    if let Some(long) = Long::new(a, b, tile) {
        for is_far in [long.is_reversed, !long.is_reversed] {
            let [near, far] = long.cuts;
            if (is_far && far) || (!is_far && near) {
                let to = relative(long.at(is_far));
                part(from, to);
                from = to;
            }
        }
    }
    part(from, relative(b));
}

impl Far<'_> {
    fn long(&self, contour: u32, vertex: u32) -> Option<Long> {
        let next = self.vertices.next(contour, vertex, true);
        Long::new(self.vertices.at(contour, vertex), self.vertices.at(contour, next), self.tile)
    }

    fn cuts(&self, contour: u32, vertex: u32) -> u32 {
        self.long(contour, vertex).map_or(0, |long| long.cuts.iter().map(|&cut| u32::from(cut)).sum())
    }

    fn relative(&self, at: (i64, i64)) -> Point {
        relative(at, self.tile, self.corner)
    }
}

impl Outline for Far<'_> {
    fn contours(&self) -> u32 {
        match self.vertices {
            Vertices::Contours(contours) => u32::try_from(contours.len()).unwrap_or(u32::MAX),
            Vertices::Outline(outline) => outline.contours(),
        }
    }

    fn first(&self, contour: u32) -> Option<u32> {
        match self.vertices {
            Vertices::Contours(contours) => (!contours.contour(contour as usize).is_empty()).then_some(0),
            Vertices::Outline(outline) => outline.first(contour).map(|index| index << 2),
        }
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        let (vertex, cut) = (index >> 2, index & 3);
        let neighbour = self.vertices.next(contour, vertex, is_forward);
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
        let Some(long) = long else {
            return self.relative(self.vertices.at(contour, vertex));
        };
        // Of two cuts, the first is the near one, unless the edge is the other way round.
        let is_far = if long.cuts == [true, true] { (cut == 2) != long.is_reversed } else { long.cuts[1] };
        self.relative(long.at(is_far))
    }
}

/// `distance * across / length`, to the nearest, for `distance < length` and `across <= length`, all below 2^48: bit by bit, so
/// that no product is wider than a word, and no division is linked for the few edges that need one.
fn share(distance: u64, across: u64, length: u64) -> u64 {
    let (mut quotient, mut rest) = (0, 0);
    for bit in (0..u64::BITS - distance.leading_zeros()).rev() {
        (quotient, rest) = (2 * quotient, 2 * rest + if distance >> bit & 1 == 1 { across } else { 0 });
        // Below three lengths.
        for _ in 0..2 {
            if rest >= length {
                (quotient, rest) = (quotient + 1, rest - length);
            }
        }
    }
    quotient + u64::from(2 * rest >= length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_rounded_to_the_nearest() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> (64 - bits)
        };
        for _ in 0..100_000 {
            let bits = 3 + u32::try_from(random(6) % 40).unwrap_or(0);
            let length = random(bits).max(2);
            let (distance, across) = (random(43) % length, random(43) % (length + 1));
            let expected =
                (2 * u128::from(distance) * u128::from(across) + u128::from(length)) / (2 * u128::from(length));
            assert_eq!(u128::from(share(distance, across, length)), expected, "{distance} {across} {length}");
        }
    }
}
