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
//! # Sizes
//!
//! `A` is at most the area of the bounding box, and so fits 64 bits for every triangle there is, and 32 bits for boxes
//! up to 256 x 256 px: the word that remainders are kept in. It holds the remainder less `A`: then what carries out of
//! it when a step is added is the next unit, and no comparison is needed.
//!
//! The quotient is kept modulo 2^32. At a centre inside the triangle it lies between the vertices' values, so it is
//! right there; on the way, through centres outside, it may be any number. That is why a sliver, where a step may be
//! 2^50, costs nothing special.

use core::{array, fmt::Debug, hint::select_unpredictable};

use crate::{Vertex, subpixel::centre};

/// What remainders are kept in, with a number that holds products.
pub(crate) trait Word: Copy + Debug {
    type Product: Copy + Debug;

    fn overflowing_add(self, other: Self) -> (Self, bool);
    fn less(self, other: Self) -> bool;
    fn wrapping_add(self, other: Self) -> Self;
    fn wrapping_sub(self, other: Self) -> Self;

    /// `a b - c d`.
    fn cross(a: i64, b: i64, c: i64, d: i64) -> Self::Product;

    /// `256 n`, divided by `area`: quotient modulo 2^32, and remainder.
    fn per_pixel(n: Self::Product, area: Self) -> (i32, Self);

    /// `gx x + gy y + area / 2`, divided by `area`; the value is one inside the triangle.
    fn divided(gx: Self::Product, gy: Self::Product, x: i64, y: i64, area: Self) -> (i32, Self);
}

/// For areas below 2^32, values that differ by less than 2^31 and vertices less than 2^22 from the first.
///
/// `|gx|` is twice an area in the plane of `c` and `y`, so at most `2^31 * 2^23`, and `256 gx` fits 63 bits. Inside the
/// triangle `gx x + gy y` is `A (c - c0)`, at most `(2^32 - 1) (2^31 - 1)`: its terms may wrap, their sum does not, nor with
/// half an area more.
impl Word for u32 {
    type Product = i64;

    #[inline(always)]
    fn overflowing_add(self, other: Self) -> (Self, bool) {
        self.overflowing_add(other)
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }

    #[inline(always)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i64 {
        #[allow(clippy::cast_possible_truncation, reason = "differences of this path have 32 bits, see above")]
        let product = |a: i64, b: i64| i64::from(a as i32) * i64::from(b as i32);
        product(a, b).wrapping_sub(product(c, d))
    }

    #[inline(always)]
    fn per_pixel(n: i64, area: u32) -> (i32, u32) {
        divide_narrow(n << 8, area)
    }

    #[inline(always)]
    fn divided(gx: i64, gy: i64, x: i64, y: i64, area: u32) -> (i32, u32) {
        let n = gx.wrapping_mul(x).wrapping_add(gy.wrapping_mul(y));
        divide_narrow(n.wrapping_add(i64::from(area / 2)), area)
    }
}

/// Floor and remainder; by the processor's own division where the numerator has 32 bits.
#[inline]
fn divide_narrow(n: i64, area: u32) -> (i32, u32) {
    let area = area.max(1);
    let magnitude = n.unsigned_abs();
    let (quotient, remainder) = match u32::try_from(magnitude) {
        Ok(magnitude) => (magnitude / area, magnitude % area),
        Err(_) => divide_long(magnitude, area),
    };
    if n >= 0 {
        (quotient.cast_signed(), remainder)
    } else if remainder == 0 {
        (quotient.wrapping_neg().cast_signed(), 0)
    } else {
        ((!quotient).cast_signed(), area - remainder)
    }
}

/// The quotient modulo 2^32.
#[cfg(target_pointer_width = "64")]
#[inline]
fn divide_long(magnitude: u64, area: u32) -> (u32, u32) {
    let area = u64::from(area.max(1));
    #[allow(clippy::cast_possible_truncation, reason = "the quotient is wanted modulo 2^32, the remainder is less")]
    let parts = ((magnitude / area) as u32, (magnitude % area) as u32);
    parts
}

#[cfg(not(target_pointer_width = "64"))]
use divide_by_digits as divide_long;

/// The quotient modulo 2^32, by three divisions of 32 bits: a fifth of what the compiler's own takes.
///
/// The upper word only counts by its remainder. Two digits of 16 bits follow, as by hand: with the divisor shifted up
/// until its highest bit is set, a digit guessed from its upper half is at most two too large (D. E. Knuth, "The art
/// of computer programming", volume 2, 4.3.1, algorithm D).
#[cfg(any(test, not(target_pointer_width = "64")))]
#[inline(never)]
fn divide_by_digits(magnitude: u64, area: u32) -> (u32, u32) {
    let area = area.max(1);
    #[allow(clippy::cast_possible_truncation, reason = "the two words")]
    let (high, low) = ((magnitude >> 32) as u32 % area, magnitude as u32);
    let shift = area.leading_zeros();
    let divisor = area << shift;
    let shifted = ((u64::from(high) << 32) | u64::from(low)) << shift;
    #[allow(clippy::cast_possible_truncation, reason = "the two words")]
    let (high, low) = ((shifted >> 32) as u32, shifted as u32);
    // Never below 2^15; the compiler does not know.
    let (upper, lower) = ((divisor >> 16).max(1), divisor & 0xffff);
    let digit = |rest: u32, next: u32| {
        let (mut digit, guess_rest) = (rest / upper, rest % upper);
        let mut left = guess_rest;
        while digit > 0xffff || digit.wrapping_mul(lower) > ((left << 16) | next) {
            digit = digit.wrapping_sub(1);
            left = left.wrapping_add(upper);
            if left > 0xffff {
                break;
            }
        }
        let rest = (rest << 16).wrapping_add(next).wrapping_sub(digit.wrapping_mul(divisor));
        (digit, rest)
    };
    let (first, rest) = digit(high, low >> 16);
    let (second, rest) = digit(rest, low & 0xffff);
    ((first << 16).wrapping_add(second), rest >> shift)
}

/// For everything: `|256 gx| < 2^74`, and `gx x` below 2^99.
impl Word for u64 {
    type Product = i128;

    #[inline(always)]
    fn overflowing_add(self, other: Self) -> (Self, bool) {
        self.overflowing_add(other)
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }

    #[inline(never)]
    fn cross(a: i64, b: i64, c: i64, d: i64) -> i128 {
        i128::from(a).wrapping_mul(i128::from(b)).wrapping_sub(i128::from(c).wrapping_mul(i128::from(d)))
    }

    #[inline]
    fn per_pixel(n: i128, area: u64) -> (i32, u64) {
        divide_wide(n << 8, area)
    }

    #[inline]
    fn divided(gx: i128, gy: i128, x: i64, y: i64, area: u64) -> (i32, u64) {
        let n = gx.wrapping_mul(i128::from(x)).wrapping_add(gy.wrapping_mul(i128::from(y)));
        divide_wide(n.wrapping_add(i128::from(area / 2)), area)
    }
}

#[inline(never)]
fn divide_wide(n: i128, area: u64) -> (i32, u64) {
    let area = i128::from(area).max(1);
    let (mut quotient, mut remainder) = (n / area, n % area);
    if remainder < 0 {
        remainder += area;
        quotient -= 1;
    }
    #[allow(clippy::cast_possible_truncation, reason = "the quotient is wanted modulo 2^32")]
    let quotient = quotient as i32;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 <= remainder < area")]
    let remainder = remainder as u64;
    (quotient, remainder)
}

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

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, reason = "what is tested is modulo 2^32")]
mod tests {
    use super::*;

    #[test]
    fn long_divisions_are_the_same_in_any_words() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state ^ (state >> 29)
        };
        for _ in 0..1_000_000 {
            let magnitude = next() >> (next() % 64);
            let area = ((next() >> 32) as u32 >> (next() % 32)).max(1);
            let expected = ((magnitude / u64::from(area)) as u32, (magnitude % u64::from(area)) as u32);
            assert_eq!(divide_by_digits(magnitude, area), expected, "{magnitude} {area}");
        }
    }
}
