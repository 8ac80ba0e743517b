//! Planes over the screen: edge equations, and what is interpolated.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT) and "CISC 440/640 Lecture 13"
//! (Delaware).
//!
//! ```text
//! r = Ar x + Br y + Cr     for each vertex; solved:     Ar = (A0 r0 + A1 r1 + A2 r2) / (2 area)
//! ```
//!
//! where `Ai x + Bi y + Ci` is the equation of the edge opposite vertex i, and B and C go the same way: "they're exactly
//! the coefficients of our edge equations". The area's reciprocal is taken once.

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    super::{
        number::Real,
        triangle::bounds::{centres, clipped},
    },
    Corner,
};

/// `A x + B y + C`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane<R> {
    /// What a step to the right adds.
    pub a: R,
    /// What a step down adds.
    pub b: R,
    /// The value at the origin.
    pub c: R,
}

impl<R: Real> Plane<R> {
    /// The value at the centre of a pixel.
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> R {
        self.a * (R::from_integer(x) + R::HALF) + self.b * (R::from_integer(y) + R::HALF) + self.c
    }

    /// The line through two points; C averaged over both.
    #[inline(always)]
    fn through(x0: R, y0: R, x1: R, y1: R) -> Self {
        let (a, b) = (y0 - y1, x1 - x0);
        Self { a, b, c: -R::HALF * (a * (x0 + x1) + b * (y0 + y1)) }
    }

    #[inline(always)]
    fn flipped(self) -> Self {
        Self { a: -self.a, b: -self.b, c: -self.c }
    }
}

/// The edges, each opposite the vertex of its number and positive inside, and twice the area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setup<R> {
    /// `e0, e1, e2`.
    pub edges: [Plane<R>; 3],
    /// `1 / (2 area)`.
    pub scale: R,
    /// The vertices' x and y.
    extent: [[R; 3]; 2],
}

impl<R: Real> Setup<R> {
    /// None without an area.
    #[inline(always)]
    pub fn new<const N: usize>([p0, p1, p2]: &[Corner<R, N>; 3]) -> Option<Self> {
        let edge = |from: &Corner<R, N>, to: &Corner<R, N>| Plane::through(from.x, from.y, to.x, to.y);
        let edges = [edge(p1, p2), edge(p2, p0), edge(p0, p1)];
        let [e0, e1, e2] = edges;
        let area = e0.c + e1.c + e2.c;
        let extent = [[p0.x, p1.x, p2.x], [p0.y, p1.y, p2.y]];
        if area > R::ZERO {
            Some(Self { edges, scale: R::ONE / area, extent })
        } else if area < R::ZERO {
            Some(Self { edges: edges.map(Plane::flipped), scale: R::ONE / -area, extent })
        } else {
            None
        }
    }

    /// The plane through a parameter of the vertices.
    #[inline(always)]
    pub fn plane(&self, [p0, p1, p2]: [R; 3]) -> Plane<R> {
        let [sp0, sp1, sp2] = [self.scale * p0, self.scale * p1, self.scale * p2];
        let [e0, e1, e2] = &self.edges;
        Plane {
            a: e0.a * sp0 + e1.a * sp1 + e2.a * sp2,
            b: e0.b * sp0 + e1.b * sp1 + e2.b * sp2,
            c: e0.c * sp0 + e1.c * sp1 + e2.c * sp2,
        }
    }

    /// The pixels of the clip whose centres lie in the bounding box.
    #[inline(always)]
    pub fn bounds(&self, clip: &PixelRect) -> PixelRect {
        let [columns, rows] = self.extent.map(|[a, b, c]| centres(a.at_most(b).at_most(c), a.at_least(b).at_least(c)));
        PixelRect { rows: clipped(rows, &clip.rows), columns: clipped(columns, &clip.columns) }
    }

    /// Steps edges and planes over the box, and makes a fragment wherever all edges are at or above 0.
    ///
    /// # Errors
    ///
    /// The sink's.
    #[inline(always)]
    pub fn scan<const N: usize, const P: usize, S: FragmentSink<N>>(
        &self,
        planes: &[Plane<R>; P],
        clip: &PixelRect,
        sink: &mut S,
        shade: impl Fn([R; 3], [R; P]) -> ([i32; N], u16),
    ) -> Result<(), S::Error> {
        self.scan_both(planes, &[], clip, sink, |e, values, []| shade(e, values))
    }

    /// The same with planes of two kinds, as `N + 1` of them cannot be written.
    ///
    /// # Errors
    ///
    /// The sink's.
    #[inline(always)]
    pub fn scan_both<const N: usize, const P: usize, const Q: usize, S: FragmentSink<N>>(
        &self,
        planes: &[Plane<R>; P],
        others: &[Plane<R>; Q],
        clip: &PixelRect,
        sink: &mut S,
        shade: impl Fn([R; 3], [R; P], [R; Q]) -> ([i32; N], u16),
    ) -> Result<(), S::Error> {
        let PixelRect { rows, columns } = self.bounds(clip);
        let (left, top) = (columns.start, rows.start);
        let mut t = self.edges.map(|edge| edge.at(left, top));
        let mut p = planes.map(|plane| plane.at(left, top));
        let mut q = others.map(|plane| plane.at(left, top));
        for y in rows {
            let (mut e, mut values, mut other_values) = (t, p, q);
            for x in columns.clone() {
                sink.visit(x, y);
                if e.iter().all(|value| *value >= R::ZERO) {
                    let (attributes, depth) = shade(e, values, other_values);
                    sink.fragment(Fragment { x, y, coverage: 255, depth, attributes })?;
                }
                step(&mut e, &self.edges, |plane| plane.a);
                step(&mut values, planes, |plane| plane.a);
                step(&mut other_values, others, |plane| plane.a);
            }
            step(&mut t, &self.edges, |plane| plane.b);
            step(&mut p, planes, |plane| plane.b);
            step(&mut q, others, |plane| plane.b);
        }
        Ok(())
    }
}

/// Adds to each accumulator its plane's coefficient.
#[inline(always)]
pub fn step<R: Real>(accumulators: &mut [R], planes: &[Plane<R>], coefficient: impl Fn(&Plane<R>) -> R) {
    for (value, plane) in accumulators.iter_mut().zip(planes) {
        *value = *value + coefficient(plane);
    }
}
