//! The walk over a triangle's spans with planes that follow it.

use core::marker::PhantomData;

use crate::{
    PixelRect, Triangle, Vertex,
    attribute::plane::{Planes, Word, doubled_area},
    shape::Shape,
    span::{Span, SpanSink},
};

/// A triangle whose vertices turn clockwise on the screen, from its top one on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Oriented {
    pub(crate) vertices: [Vertex; 3],
    pub(crate) area: u64,
    order: [usize; 3],
}

impl Oriented {
    /// None for a triangle without area, which has no pixels.
    #[inline]
    pub(crate) fn new(triangle: &Triangle) -> Option<Self> {
        let [a, b, c] = triangle.vertices;
        let area = doubled_area(&triangle.vertices);
        let ([a, b, c], [i, j, k]) = if area < 0 { ([a, c, b], [0, 2, 1]) } else { ([a, b, c], [0, 1, 2]) };
        // Values near the top one, where the walk begins, have short numerators.
        let (vertices, order) = if a.y <= b.y && a.y <= c.y {
            ([a, b, c], [i, j, k])
        } else if b.y <= c.y {
            ([b, c, a], [j, k, i])
        } else {
            ([c, a, b], [k, i, j])
        };
        let area = u64::try_from(area.unsigned_abs()).unwrap_or(u64::MAX);
        (area > 0).then_some(Self { vertices, area, order })
    }

    /// The values of the vertices, in the same order.
    #[inline]
    pub(crate) fn ordered<T: Copy>(&self, values: &[T; 3]) -> [T; 3] {
        let [first, ..] = *values;
        self.order.map(|index| values.get(index).copied().unwrap_or(first))
    }

    /// The area in 32 bits, where everything else of `u32 as Word` holds, too, for such values.
    #[inline]
    pub(crate) fn narrow<const N: usize>(&self, values: &[[i32; N]; 3]) -> Option<u32> {
        let area = u32::try_from(self.area).ok()?;
        let near = |distance: u32| distance < 1 << 23;
        let [a, b, c] = self.vertices.map(|vertex| (vertex.x.to_bits(), vertex.y.to_bits()));
        let near = near(a.0.abs_diff(b.0))
            && near(a.0.abs_diff(c.0))
            && near(b.0.abs_diff(c.0))
            && near(a.1.abs_diff(b.1))
            && near(a.1.abs_diff(c.1));
        let [c0, c1, c2] = values;
        let close = |a: &[i32; N], b: &[i32; N]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) < 1 << 31);
        (near && close(c0, c1) && close(c0, c2) && close(c1, c2)).then_some(area)
    }
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

/// Emits every span of the triangle with the planes at its first centre. They are made at the first of all.
#[inline(always)]
pub(crate) fn walk<P: Follow, E>(
    triangle: &Triangle,
    clip: &PixelRect,
    make: impl FnOnce((i32, i32)) -> P,
    emit: impl FnMut(Span, &P) -> Result<(), E>,
) -> Result<(), E> {
    triangle.spans(clip, &mut Walk { make: Some(make), planes: None, emit, error: PhantomData })
}

struct Walk<P, M, F, E> {
    make: Option<M>,
    planes: Option<P>,
    emit: F,
    error: PhantomData<fn() -> E>,
}

impl<P: Follow, M: FnOnce((i32, i32)) -> P, F: FnMut(Span, &P) -> Result<(), E>, E> SpanSink for Walk<P, M, F, E> {
    type Error = E;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), E> {
        if let Some(make) = self.make.take() {
            self.planes = Some(make((span.row, span.columns.start)));
        }
        let Some(planes) = &mut self.planes else { return Ok(()) };
        planes.go_to(span.row, span.columns.start);
        (self.emit)(span, planes)
    }
}
