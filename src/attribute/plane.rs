//! Planes over a triangle: the value of an attribute at every pixel centre, exactly, by additions.
//!
//! With `A` twice the triangle's area, made positive, an attribute `c` of the vertices is at (X, Y)
//!
//! ```text
//!   gx = (c1-c0)(y2-y0) - (c2-c0)(y1-y0)        A dc/dx
//!   gy = (x1-x0)(c2-c0) - (x2-x0)(c1-c0)        A dc/dy
//!   c(X, Y) = c0 + (gx (X-x0) + gy (Y-y0)) / A
//! ```
//!
//! a fraction whose denominator is the same everywhere. So the value is kept as a quotient and a remainder, as an
//! [`Edge`](crate::edge::Edge) keeps its column, and a step of one pixel adds `256 gx / A`, divided once: nothing is
//! rounded, nothing accumulates (J. Pineda, "A parallel algorithm for polygon rasterization", 1988; C. Hecker,
//! "Perspective texture mapping", 1995; F. Giesen, "Triangle rasterization in practice", 2013). The remainder starts
//! `A/2` higher, which makes the quotient the nearest value in place of the floor.
//!
//! What remainders are kept in is a [`Word`]. It holds the remainder less `A`: then what carries out of it when a step is added is
//! the next unit, and no comparison is needed.
//!
//! The quotient is kept modulo 2^32. At a centre inside the triangle it lies between the vertices' values, so it is
//! right there; on the way, through centres outside, it may be any number. That is why a sliver, where a step may be
//! 2^50, costs nothing special.

use core::{array, hint::select_unpredictable};

use crate::{Vertex, attribute::word::Word, subpixel::centre};

/// The vectors from the first vertex to the others.
#[inline(always)]
fn sides(vertices: &[Vertex; 3]) -> [(i64, i64); 2] {
    let [origin, a, b] = vertices.map(|vertex| (i64::from(vertex.x.to_bits()), i64::from(vertex.y.to_bits())));
    [a, b].map(|(x, y)| (x - origin.0, y - origin.1))
}

/// How a value changes in one direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step<W> {
    /// Whole units, modulo 2^32.
    pub(super) whole: i32,
    /// What is left, below the area.
    pub(super) rest: W,
}

impl<W: Word> Step<W> {
    #[inline(always)]
    fn new(gradient: W::Product, area: W) -> Self {
        let (whole, rest) = W::per_pixel(gradient, area);
        Self { whole, rest }
    }
}

/// An attribute at the current centre.
#[derive(Debug, Clone, Copy)]
pub(crate) struct At<W> {
    pub(super) value: i32,
    /// The remainder less the area, modulo the word: what carries out of it is one more unit.
    pub(super) lacking: W,
}

impl<W: Word> At<W> {
    /// Two additions, and where the second carries, two more.
    #[inline(always)]
    fn step(&mut self, step: &Step<W>, area: W) {
        let (lacking, carries) = self.lacking.overflowing_add(step.rest);
        self.value = self.value.wrapping_add(step.whole).wrapping_add(i32::from(carries));
        self.lacking = select_unpredictable(carries, lacking.wrapping_sub(area), lacking);
    }

    #[inline(always)]
    fn step_back(&mut self, step: &Step<W>, area: W) {
        let borrows = self.lacking.wrapping_add(area).less(step.rest);
        let lacking = self.lacking.wrapping_sub(step.rest);
        self.value = self.value.wrapping_sub(step.whole).wrapping_sub(i32::from(borrows));
        self.lacking = select_unpredictable(borrows, lacking.wrapping_add(area), lacking);
    }
}

/// Wherever the next span starts further away than this, its values are divided afresh.
pub(super) const NEAR_COLUMNS: i32 = 8;

/// No pixel's row and column, nor next to one's.
const NOWHERE: i32 = i32::MIN;

/// `N` attributes over a triangle, at the centre of a pixel.
#[derive(Debug, Clone)]
pub(crate) struct Planes<W: Word, const N: usize> {
    pub(super) area: W,
    /// The vertex that the values are measured from, in sub-pixels.
    origin: (i32, i32),
    bases: [i32; N],
    gradients: [(W::Product, W::Product); N],
    pub(super) right: [Step<W>; N],
    pub(super) down: [Step<W>; N],
    pub(super) current: [At<W>; N],
    pub(super) column: i32,
    pub(super) row: i32,
}

impl<W: Word, const N: usize> Planes<W, N> {
    /// The planes through the values of the vertices, `area` being twice the triangle's, which turns clockwise. They are nowhere
    /// before they have gone to a centre.
    #[inline(always)]
    pub(crate) fn new(vertices: &[Vertex; 3], values: &[[i32; N]; 3], area: W) -> Self {
        let [(x1, y1), (x2, y2)] = sides(vertices);
        let [c0, c1, c2] = values;
        let gradient = |(c0, c1, c2): (i32, i32, i32)| {
            let (c1, c2) = (i64::from(c1) - i64::from(c0), i64::from(c2) - i64::from(c0));
            (W::cross(c1, y2, c2, y1), W::cross(x1, c2, x2, c1))
        };
        let gradients = zip3(c0, c1, c2).map(gradient);
        let [origin, ..] = vertices;
        Self {
            area,
            origin: (origin.x.to_bits(), origin.y.to_bits()),
            bases: *c0,
            gradients,
            right: gradients.map(|(x, _)| Step::new(x, area)),
            down: gradients.map(|(_, y)| Step::new(y, area)),
            current: [At { value: 0, lacking: area }; N],
            column: NOWHERE,
            row: NOWHERE,
        }
    }

    /// The values at the current centre, by a division each.
    #[inline(never)]
    pub(super) fn evaluate(&mut self) {
        let (x0, y0) = self.origin;
        let (x, y) = (distance(self.column, x0), distance(self.row, y0));
        for (at, ((gx, gy), base)) in self.current.iter_mut().zip(self.gradients.iter().zip(&self.bases)) {
            let (value, remainder) = W::divided(*gx, *gy, x, y, self.area);
            *at = At { value: value.wrapping_add(*base), lacking: remainder.wrapping_sub(self.area) };
        }
    }

    /// Goes to a centre that is inside.
    #[inline(never)]
    pub(crate) fn go_to(&mut self, row: i32, column: i32) {
        let columns = column.wrapping_sub(self.column);
        let rows = row.wrapping_sub(self.row);
        (self.row, self.column) = (row, column);
        if !(rows == 1 && columns.wrapping_add(NEAR_COLUMNS).cast_unsigned() <= 2 * NEAR_COLUMNS.cast_unsigned()) {
            if rows != 0 || columns != 0 {
                self.evaluate();
            }
            return;
        }
        let area = self.area;
        for ((current, down), right) in self.current.iter_mut().zip(&self.down).zip(&self.right) {
            let (mut at, right) = (*current, *right);
            at.step(down, area);
            for _ in 0..columns {
                at.step(&right, area);
            }
            for _ in columns..0 {
                at.step_back(&right, area);
            }
            *current = at;
        }
    }

    /// The values from the current centre to the right.
    #[inline(always)]
    pub(crate) fn to_the_right(&self) -> Rightwards<'_, W, N> {
        Rightwards { current: self.current, planes: self }
    }
}

/// From a coordinate to the centre of a pixel that a coordinate can name.
#[inline(always)]
fn distance(pixel: i32, from: i32) -> i64 {
    i64::from(centre(pixel)) - i64::from(from)
}

#[inline(always)]
fn zip3<const N: usize>(a: &[i32; N], b: &[i32; N], c: &[i32; N]) -> [(i32, i32, i32); N] {
    let of = |values: &[i32; N], index: usize| values.get(index).copied().unwrap_or_default();
    array::from_fn(|index| (of(a, index), of(b, index), of(c, index)))
}

/// The values at the centres of a span, from left to right; it has no end.
#[derive(Debug, Clone)]
pub(crate) struct Rightwards<'p, W: Word, const N: usize> {
    current: [At<W>; N],
    planes: &'p Planes<W, N>,
}

impl<W: Word, const N: usize> Iterator for Rightwards<'_, W, N> {
    type Item = [i32; N];

    #[inline(always)]
    fn next(&mut self) -> Option<[i32; N]> {
        let values = self.current.map(|at| at.value);
        for (at, step) in self.current.iter_mut().zip(&self.planes.right) {
            at.step(step, self.planes.area);
        }
        Some(values)
    }
}
