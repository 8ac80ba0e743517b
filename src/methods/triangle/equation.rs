//! The edge equation `A x + B y + C = 0` of two vertices.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT) and "CISC 440/640 Lecture 13: Scan
//! Converting Triangles" (University of Delaware, 2015), after Pineda, *A parallel algorithm for polygon
//! rasterization*, SIGGRAPH 1988.
//!
//! Both vertices fulfil the equation, which leaves one unknown free:
//!
//! ```text
//! A x0 + B y0 + C = 0        choose C = x0 y1 - x1 y0        then A = y0 - y1
//! A x1 + B y1 + C = 0                                             B = x1 - x0
//! ```
//!
//! `x0 y1 - x1 y0` subtracts two products that are nearly equal where the vertices are near each other and far from the
//! origin. With A and B known, either vertex gives C as well, `C = -A x0 - B y0`; the mean of both favours neither.
//! That is as good as the notes say: of 200 triangles of at most 8 px that lie 2^12 px right of and below the origin,
//! the cross product gets 327 pixels wrong in `f32`, either other way none, up to 2^14 px (counted in
//! `tests/methods/triangle.txt`).
//!
//! Large triangles are another matter: C is rounded to the spacing of numbers of the size of `A x0` however it comes
//! about, and all three have wrong pixels from 2^8 px on. Differences have no C that is rounded, `(x1 - x0)(y - y0) -
//! (y1 - y0)(x - x0)`; they last to 2^14 px.

use super::super::number::{Number, Real};

/// How C comes about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Constant {
    /// `x0 y1 - x1 y0`.
    CrossProduct,
    /// `-A x0 - B y0`.
    OneVertex,
    /// `-(A (x0 + x1) + B (y0 + y1)) / 2`.
    Averaged,
    /// There is none: `(x1 - x0)(y - y0) - (y1 - y0)(x - x0)`, set up for the first pixel.
    Differences,
}

/// An edge equation, positive to the left of the edge where y grows upwards, to the right where it grows downwards.
#[derive(Debug, Clone, Copy)]
pub struct EdgeEqn<N: Number> {
    /// What a step to the right adds.
    pub a: N,
    /// What a step along y adds.
    pub b: N,
    /// The value at the origin.
    pub c: N,
    /// As the notes keep the signs of A and B for the bounding box: 8 for `A >= 0`, 1 for `B >= 0`; before any flip.
    pub flag: u8,
    ends: [[N::Setup; 2]; 2],
    constant: Constant,
}

impl<N: Number> EdgeEqn<N> {
    /// The equation of the edge from `v0` to `v1`.
    #[inline(always)]
    pub fn new(v0: [N::Setup; 2], v1: [N::Setup; 2], constant: Constant) -> Self {
        let ([x0, y0], [x1, y1]) = (v0, v1);
        let a = y0 - y1;
        let b = x1 - x0;
        let c = match constant {
            Constant::CrossProduct => x0 * y1 - x1 * y0,
            Constant::OneVertex => -a * x0 - b * y0,
            Constant::Averaged | Constant::Differences => -N::Setup::HALF * (a * (x0 + x1) + b * (y0 + y1)),
        };
        let (a, b) = (N::from_setup(a), N::from_setup(b));
        let flag = if a.is_at_least_zero() { 8 } else { 0 } + u8::from(b.is_at_least_zero());
        Self { a, b, c: N::from_setup(c), flag, ends: [v0, v1], constant }
    }

    /// An equation of which only the coefficients are known.
    #[inline(always)]
    pub fn from_coefficients([a, b, c]: [N; 3]) -> Self {
        let flag = if a.is_at_least_zero() { 8 } else { 0 } + u8::from(b.is_at_least_zero());
        Self { a, b, c, flag, ends: [[N::Setup::ZERO; 2]; 2], constant: Constant::Averaged }
    }

    /// The other side becomes the positive one.
    #[inline(always)]
    pub fn flip(&mut self) {
        self.a = self.a.negated();
        self.b = self.b.negated();
        self.c = self.c.negated();
        self.ends.reverse();
    }

    /// `a x + b y + c` at any point, in the numbers of the setup: what of C was lost on conversion counts here, too.
    #[inline(always)]
    pub fn sidedness(&self, x: N::Setup, y: N::Setup) -> N::Setup {
        let [[x0, y0], [x1, y1]] = self.ends;
        if self.constant == Constant::Differences {
            return (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
        }
        N::to_setup(self.a) * x + N::to_setup(self.b) * y + N::to_setup(self.c)
    }

    /// The value at the corner of pixel (x, y) or at its centre.
    #[inline(always)]
    pub fn evaluate(&self, x: i32, y: i32, at_centre: bool) -> N {
        if self.constant == Constant::Differences {
            let offset = if at_centre { N::Setup::HALF } else { N::Setup::ZERO };
            return self.at([N::Setup::from_integer(x) + offset, N::Setup::from_integer(y) + offset]);
        }
        N::plane(self.a, self.b, self.c, x, y, at_centre)
    }

    /// The value at any point, from differences.
    #[inline(always)]
    pub fn at(&self, [x, y]: [N::Setup; 2]) -> N {
        let [[x0, y0], [x1, y1]] = self.ends;
        N::from_setup((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0))
    }
}
