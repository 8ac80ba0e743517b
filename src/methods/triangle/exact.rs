//! Edge functions in 64-bit integers with the top-left rule: the inside test that the traversals share, so that they
//! differ in nothing but which pixels they look at.
//!
//! ```text
//! e(x, y) = (x1 - x0)(y - y0) - (y1 - y0)(x - x0)     in 1/256 px, a step of a pixel adds 256 a or 256 b
//! ```
//!
//! Exact where vertices and pixels lie within 2^30 of the origin: differences are below 2^31, each product below 2^62.
//! A tie is decided by taking 1 from every edge that is neither left nor top: integers above 0 are 1 or more.

use core::ops::Range;

use crate::PixelRect;

/// An edge, positive or 0 where its pixels are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    /// What 1/256 px to the right adds: positive for a left edge.
    pub a: i64,
    /// What 1/256 px downwards adds.
    pub b: i64,
    /// The value at the centre of pixel (0, 0), ties decided.
    pub at_origin: i64,
}

/// What a step of a pixel is, in the coordinates' unit.
pub const PIXEL: i64 = 256;

/// The centre of a pixel, in 1/256 px.
#[inline(always)]
pub fn centre(pixel: i32) -> i64 {
    PIXEL * i64::from(pixel) + PIXEL / 2
}

impl Edge {
    /// The edge from `v0` to `v1`, the inside to its right where y grows downwards.
    #[inline(always)]
    pub fn new([x0, y0]: [i32; 2], [x1, y1]: [i32; 2]) -> Self {
        let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(i64::from);
        let (a, b) = (y0 - y1, x1 - x0);
        let half = PIXEL / 2;
        let value = b.wrapping_mul(half - y0).wrapping_add(a.wrapping_mul(half - x0));
        let edge = Self { a, b, at_origin: value };
        Self { at_origin: value.wrapping_sub(i64::from(!edge.is_left_or_top())), ..edge }
    }

    /// The value at the centre of pixel (x, y).
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> i64 {
        let steps = self.a.wrapping_mul(i64::from(x)).wrapping_add(self.b.wrapping_mul(i64::from(y)));
        self.at_origin.wrapping_add(steps.wrapping_mul(PIXEL))
    }

    /// Whether it is one that owns its pixels: left, or horizontal with the inside below.
    #[inline(always)]
    pub fn is_left_or_top(&self) -> bool {
        self.a > 0 || self.a == 0 && self.b > 0
    }

    /// The value at the centre of pixel (x, y), 0 on the edge.
    #[inline(always)]
    pub fn undecided_at(&self, x: i32, y: i32) -> i64 {
        self.at(x, y).wrapping_add(i64::from(!self.is_left_or_top()))
    }

    /// The value a number of pixels further to the right and further down.
    #[inline(always)]
    pub fn moved(&self, value: i64, dx: i64, dy: i64) -> i64 {
        let steps = self.a.wrapping_mul(dx).wrapping_add(self.b.wrapping_mul(dy));
        value.wrapping_add(steps.wrapping_mul(PIXEL))
    }
}

/// Three edges around the inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edges(pub [Edge; 3]);

impl Edges {
    /// The edges of a triangle in 1/256 px, in either order of its vertices; none where it has no area.
    #[inline(always)]
    pub fn new(v: &[[i32; 2]; 3]) -> Option<Self> {
        let [[x0, y0], [x1, y1], [x2, y2]] = v.map(|vertex| vertex.map(i64::from));
        let area = (x1 - x0).wrapping_mul(y2 - y0).wrapping_sub((x2 - x0).wrapping_mul(y1 - y0));
        let [v0, v1, v2] = if area < 0 { [v[0], v[2], v[1]] } else { *v };
        (area != 0).then(|| Self([Edge::new(v0, v1), Edge::new(v1, v2), Edge::new(v2, v0)]))
    }

    /// The three values at the centre of a pixel.
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> [i64; 3] {
        let [e0, e1, e2] = &self.0;
        [e0.at(x, y), e1.at(x, y), e2.at(x, y)]
    }

    /// The three values a number of pixels further on.
    #[inline(always)]
    pub fn moved(&self, [v0, v1, v2]: [i64; 3], dx: i64, dy: i64) -> [i64; 3] {
        let [e0, e1, e2] = &self.0;
        [e0.moved(v0, dx, dy), e1.moved(v1, dx, dy), e2.moved(v2, dx, dy)]
    }
}

/// Whether all three are at or above 0.
#[inline(always)]
pub fn is_inside([e0, e1, e2]: [i64; 3]) -> bool {
    e0 | e1 | e2 >= 0
}

/// The pixels of the clip whose centres lie in the bounding box of vertices in 1/256 px.
#[inline(always)]
pub fn bounding_box(v: &[[i32; 2]; 3], clip: &PixelRect) -> PixelRect {
    let [[x0, y0], [x1, y1], [x2, y2]] = *v;
    PixelRect { rows: extent([y0, y1, y2], &clip.rows), columns: extent([x0, x1, x2], &clip.columns) }
}

#[inline(always)]
fn extent([a, b, c]: [i32; 3], clip: &Range<i32>) -> Range<i32> {
    let first = ceil_to_centre(a.min(b).min(c)).max(clip.start);
    let last = (i64::from(a.max(b).max(c)) - PIXEL / 2).div_euclid(PIXEL);
    first..pixel(last + 1).min(clip.end)
}

/// The first pixel whose centre is at or after a coordinate.
#[inline(always)]
pub fn ceil_to_centre(coordinate: i32) -> i32 {
    pixel((i64::from(coordinate) - PIXEL / 2 + PIXEL - 1).div_euclid(PIXEL))
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "of a coordinate of 32 bits, divided by 256")]
fn pixel(pixel: i64) -> i32 {
    pixel as i32
}
