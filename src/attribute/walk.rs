//! The walk over a triangle's spans with planes that follow it.

use core::marker::PhantomData;

use crate::{
    PixelRect, Triangle, Vertex,
    attribute::{plane::Planes, word::Word},
    shape::Shape,
    span::{Span, SpanSink},
};

/// A triangle whose vertices turn clockwise on the screen, from its top one on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Oriented {
    pub(crate) vertices: [Vertex; 3],
    /// Twice the triangle's.
    pub(crate) area: u64,
    order: [usize; 3],
    /// No vertex is this far or farther from the first in either direction, in sub-pixels; a power of two, less one, or `u32::MAX`.
    reach: u32,
}

impl Oriented {
    /// None for a triangle without area, which has no pixels.
    #[inline(always)]
    pub(crate) fn new(triangle: &Triangle) -> Option<Self> {
        let [a, b, c] = triangle.vertices;
        // Values near the top one, where the walk begins, have short numerators.
        let ([a, b, c], [i, j, k]) = if a.y <= b.y && a.y <= c.y {
            ([a, b, c], [0, 1, 2])
        } else if b.y <= c.y {
            ([b, c, a], [1, 2, 0])
        } else {
            ([c, a, b], [2, 0, 1])
        };
        let (is_clockwise, area, reach) = doubled_area(a, b, c);
        let (vertices, order) = if is_clockwise { ([a, b, c], [i, j, k]) } else { ([a, c, b], [i, k, j]) };
        (area > 0).then_some(Self { vertices, area, order, reach })
    }

    /// The values of the vertices, in the same order.
    #[inline(always)]
    pub(crate) fn ordered<T: Copy>(&self, values: &[T; 3]) -> [T; 3] {
        let [first, ..] = *values;
        self.order.map(|index| values.get(index).copied().unwrap_or(first))
    }

    /// Whether no vertex is `2^bits` sub-pixels from the first, or more.
    #[inline(always)]
    pub(crate) fn is_within(&self, bits: u32) -> bool {
        self.reach >> bits == 0
    }

    /// The area in 32 bits, where the vertices are less than 2^22 apart (16384 px), too.
    #[inline]
    pub(crate) fn near(&self) -> Option<u32> {
        let area = u32::try_from(self.area).ok()?;
        self.is_within(22).then_some(area)
    }

    /// Whether it is near, and has a quarter of a pixel.
    #[inline]
    pub(crate) fn is_middling(&self) -> bool {
        self.near().is_some_and(|area| area >= 1 << 14)
    }

    /// The same where everything else of `u32 as Word` holds, too, for such values.
    #[inline]
    pub(crate) fn narrow<const N: usize>(&self, values: &[[i32; N]; 3]) -> Option<u32> {
        let [c0, c1, c2] = values;
        let close = |a: &[i32; N], b: &[i32; N]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) < 1 << 31);
        let area = self.near()?;
        (close(c0, c1) && close(c0, c2) && close(c1, c2)).then_some(area)
    }
}

/// Whether the vertices turn clockwise on the screen, twice the area, and what is not less than the distance of any from `a`.
#[inline(always)]
fn doubled_area(a: Vertex, b: Vertex, c: Vertex) -> (bool, u64, u32) {
    let from_a = |of: Vertex| {
        let x = of.x.to_bits().checked_sub(a.x.to_bits())?;
        Some((x, of.y.to_bits().checked_sub(a.y.to_bits())?))
    };
    let (Some((x1, y1)), Some((x2, y2))) = (from_a(b), from_a(c)) else { return doubled_area_wide(a, b, c) };
    let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
    // Products of 32 bits with a sign, one of whose factors is never negative.
    let area = product(x1, y2).wrapping_sub(product(x2, y1));
    let magnitude = |distance: i32| (distance ^ (distance >> 31)).cast_unsigned();
    let reach = magnitude(x1) | magnitude(x2) | magnitude(y1) | magnitude(y2);
    (area > 0, area.unsigned_abs(), reach)
}

/// The same anywhere: at most the area of the box, below 2^64.
#[cold]
#[inline(never)]
fn doubled_area_wide(a: Vertex, b: Vertex, c: Vertex) -> (bool, u64, u32) {
    let from_a = |of: Vertex| {
        let difference = |to: i32, from: i32| i128::from(to) - i128::from(from);
        (difference(of.x.to_bits(), a.x.to_bits()), difference(of.y.to_bits(), a.y.to_bits()))
    };
    let ((x1, y1), (x2, y2)) = (from_a(b), from_a(c));
    let area = x1 * y2 - x2 * y1;
    (area > 0, u64::try_from(area.unsigned_abs()).unwrap_or(u64::MAX), u32::MAX)
}

/// Planes that go where a walk goes.
pub(crate) trait Follow {
    fn go_to(&mut self, row: i32, column: i32);
}

impl<W: Word, const N: usize> Follow for Planes<W, N> {
    #[inline(always)]
    fn go_to(&mut self, row: i32, column: i32) {
        Planes::go_to(self, row, column);
    }
}

impl<A: Follow, B: Follow> Follow for (A, B) {
    #[inline(always)]
    fn go_to(&mut self, row: i32, column: i32) {
        self.0.go_to(row, column);
        self.1.go_to(row, column);
    }
}

/// Emits every span of the triangle with the planes at its first centre.
#[inline(always)]
pub(crate) fn walk<P: Follow, E>(
    triangle: &Triangle,
    clip: &PixelRect,
    planes: &mut P,
    emit: impl FnMut(Span, &P) -> Result<(), E>,
) -> Result<(), E> {
    triangle.spans(clip, &mut Walk { planes, emit, error: PhantomData })
}

struct Walk<'p, P, F, E> {
    planes: &'p mut P,
    emit: F,
    error: PhantomData<fn() -> E>,
}

impl<P: Follow, F: FnMut(Span, &P) -> Result<(), E>, E> SpanSink for Walk<'_, P, F, E> {
    type Error = E;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), E> {
        self.planes.go_to(span.row, span.columns.start);
        (self.emit)(span, self.planes)
    }
}
