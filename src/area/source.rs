//! Where the vertices of an outline come from: slices, or whatever can tell one by its index.
//!
//! Nothing here stores a vertex. An active edge remembers an index, and asks for the next one along the contour when it
//! ends. So an outline that is worked out on the fly (a curve, a stroke) is as good as a slice.

use fixed::types::I24F8;

use crate::{
    Vertex,
    contours::{Contours, next_index},
    limits::SUBPIXEL_BITS,
};

/// Bits behind the binary point of a [`Point`].
pub(crate) const FINE_BITS: u32 = 16;

/// A pixel, in a [`Point`]'s unit.
pub(crate) const FINE_ONE: i32 = 1 << FINE_BITS;

/// In 2^-16 pixel, from the top left corner of what is drawn; within 2^29 (8192 pixels) of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Point {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

/// Closed contours whose vertices are worked out when they are asked for.
pub(crate) trait Outline {
    /// How many contours there are.
    fn contours(&self) -> u32;

    /// The index of some vertex of a contour; none where it is empty.
    fn first(&self, contour: u32) -> Option<u32>;

    /// The index that follows along the contour, or comes before; the last is followed by the first.
    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32;

    /// The vertex of an index that was handed out.
    fn vertex(&self, contour: u32, index: u32) -> Point;
}

/// An outline, relative to the pixel that drawing starts at.
#[derive(Clone, Copy)]
pub(crate) enum Source<'a> {
    /// No vertex is farther than 8192 pixels from `origin`, which is in 1/256 pixel.
    Contours {
        contours: Contours<'a>,
        origin: (i32, i32),
    },
    Outline(&'a dyn Outline),
}

/// One contour of it.
#[derive(Clone, Copy)]
pub(crate) enum Contour<'a> {
    Slice { vertices: &'a [Vertex], origin: (i32, i32) },
    Outline { outline: &'a dyn Outline, contour: u32 },
}

impl Contour<'_> {
    #[inline]
    pub(crate) fn vertex(&self, index: u32) -> Point {
        match *self {
            Self::Slice { vertices, origin } => {
                relative(vertices.get(index as usize).copied().unwrap_or_default(), origin)
            }
            Self::Outline { outline, contour } => outline.vertex(contour, index),
        }
    }

    /// The index that follows, and its vertex.
    #[inline]
    pub(crate) fn step(&self, index: u32, is_forward: bool) -> (u32, Point) {
        let next = match *self {
            Self::Slice { vertices, .. } => next_index(vertices, index, is_forward),
            Self::Outline { outline, contour } => outline.next(contour, index, is_forward),
        };
        (next, self.vertex(next))
    }
}

impl<'a> Source<'a> {
    pub(crate) fn contours(&self) -> u32 {
        match self {
            Self::Contours { contours, .. } => u32::try_from(contours.len()).unwrap_or(u32::MAX),
            Self::Outline(outline) => outline.contours(),
        }
    }

    pub(crate) fn first(&self, contour: u32) -> Option<u32> {
        match self {
            Self::Contours { contours, .. } => (!contours.contour(contour as usize).is_empty()).then_some(0),
            Self::Outline(outline) => outline.first(contour),
        }
    }

    #[inline]
    pub(crate) fn contour(&self, contour: u32) -> Contour<'a> {
        match *self {
            Self::Contours { contours, origin } => {
                Contour::Slice { vertices: contours.contour(contour as usize), origin }
            }
            Self::Outline(outline) => Contour::Outline { outline, contour },
        }
    }

    /// For each vertex at which a contour turns down, its contour, its index and its height.
    ///
    /// Of vertices side by side, it is the last before the contour goes down.
    #[inline]
    pub(crate) fn for_each_top(&self, mut found: impl FnMut(u32, u32, i32)) {
        for contour in 0..self.contours() {
            let Some(first) = self.first(contour) else { continue };
            let vertices = self.contour(contour);
            let start = vertices.vertex(first).y;
            // How the contour arrives at its first vertex: by its last edge that is not flat.
            let mut before = first;
            let mut went_up = loop {
                let (index, point) = vertices.step(before, false);
                before = index;
                if point.y != start || index == first {
                    break point.y > start;
                }
            };
            let (mut index, mut y) = (first, start);
            loop {
                let (next, point) = vertices.step(index, true);
                if point.y > y && went_up {
                    found(contour, index, y);
                }
                if point.y != y {
                    went_up = point.y < y;
                }
                (index, y) = (next, point.y);
                if next == first {
                    break;
                }
            }
        }
    }
}

/// At most 2^21 away.
#[inline]
fn relative(vertex: Vertex, (x, y): (i32, i32)) -> Point {
    const FINER: u32 = FINE_BITS - SUBPIXEL_BITS;
    Point { x: vertex.x.to_bits().wrapping_sub(x) << FINER, y: vertex.y.to_bits().wrapping_sub(y) << FINER }
}

/// In 2^-16 pixel.
#[inline]
pub(crate) fn vertex_position(vertex: Vertex) -> (i64, i64) {
    let position = |at: I24F8| i64::from(at.to_bits()) << (FINE_BITS - SUBPIXEL_BITS);
    (position(vertex.x), position(vertex.y))
}
