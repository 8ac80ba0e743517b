//! Attributes that are seen in perspective: quotients of planes.
//!
//! With `w` the distance from the eye's plane, `1/w` and `s/w` are planes over the screen, and `s` is their quotient
//! (J. F. Blinn, "Hyperbolic interpolation", 1992; P. Heckbert and H. Moreton, "Interpolation for polygon texture
//! mapping and shading", 1991).
//!
//! # Errors
//!
//! - The three `1/w` are scaled by one power of two, so that the largest has as many bits `b` as there is room for, at
//!   most 16, and rounded to whole numbers `W`; the numerators are made from the same `W`. A `W` that is off by a
//!   relative error of `e` moves `s` by `range(s) e / (2 (1 - e))` at most (Grüss' inequality), and never out of its
//!   range. For distances up to 1:256 and 16 bits, `e` is at most `2^-9 (1 + 2^-8)`: 1/16 texel of 64.
//! - Rows are drawn in [pieces](super::pieces) that are within a tolerance of the exact values at their ends.
//! - Interpolated `W` are whole numbers again: half of one is at most 1/8 texel of 64 where `W` is 256.
//! - Quotients are rounded to whole units, and so are steps within a piece: two units more at most.

use core::iter::repeat;

use crate::{
    PixelRect, Triangle,
    attribute::{
        AttributeSink, Attributes,
        affine::depth,
        pieces::{Pieces, Values},
        plane::Planes,
        quotients::Quotients,
        walk::{Oriented, walk},
        word::Word,
    },
};

/// A vertex is not in front of the eye: its distance is 0 or less. Clip by the near plane before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NotInFront {
    /// Which of the three.
    pub vertex: usize,
}

impl core::fmt::Display for NotInFront {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "vertex {} is not in front of the eye", self.vertex)
    }
}

impl core::error::Error for NotInFront {}

/// A triangle with `N` attributes that vary linearly over the triangle in space, as it is seen.
///
/// Values are any `i32` in `-2^21..=2^21`, clamped to that; coordinates in a texture, say, in 1/256 texel. Distances
/// are positive, in any unit: only their ratios count.
///
/// ```text
///     4, w 1                      6, w 3
///       *----------- + -----------*
///                    4.5, not 5: what is further away is seen smaller
/// ```
///
/// The value at a pixel centre is within the tolerance of the exact one, 1/4 texel unless told otherwise, and what the
/// vertices' distances lose in 16 bits: for 64 texels and distances of 1:256 together less than 1/2 texel. For distances of
/// 1:r it is at most `range e / (2 (1 - e))` with `e = r / 2^15`, so beyond 1:4096 cut the triangle nearer to the eye.
///
/// # Errors
///
/// [`NotInFront`] where a distance is 0 or less.
///
/// # Cost
///
/// `N` divisions of 32 bits for up to 64 pixels, or as many as are near enough. Two instructions for each attribute and pixel. No
/// division but one for the area sets up the planes, whatever their size.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Perspective, Triangle, Vertex, prelude::*};
///
/// // In 1/256, from 4 at the distance 1 to 6 at the distance 3. The middle is pixel 4's centre.
/// let triangle = Triangle::new(Vertex::pixel(0, 0), Vertex::pixel(8, 0), Vertex::pixel(0, 8));
/// let seen = Perspective::new(triangle, [[4 * 256], [6 * 256], [4 * 256]], [1, 3, 1])?;
/// let mut display = MockDisplay::new();
/// seen.shaded(|[s]| Gray8::new((s / 16) as u8)).draw(&mut display).unwrap();
/// // 4.5 in sixteenths.
/// assert_eq!(display.get_pixel(Point::new(4, 0)), Some(Gray8::new(72)));
/// # Ok::<(), spanfill::NotInFront>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Perspective<const N: usize> {
    triangle: Triangle,
    /// The values less their bases, times `inverses`.
    numerators: [[i32; N]; 3],
    inverses: [i32; 3],
    values: Values<N>,
}

/// Bits of the largest `W`, at most.
const INVERSE_BITS: u32 = 16;
/// What no value is off by anyway.
const HIGHEST_TOLERANCE: u32 = (1 << 22) - 1;
/// How far values may be from 0.
const VALUE_REACH: i32 = 1 << 21;

impl<const N: usize> Perspective<N> {
    /// A triangle with the values and the distance of each of its vertices.
    ///
    /// # Errors
    ///
    /// A distance of 0 or less.
    pub fn new(triangle: Triangle, values: [[i32; N]; 3], distances: [i32; 3]) -> Result<Self, NotInFront> {
        if let Some(vertex) = distances.iter().position(|w| *w <= 0) {
            return Err(NotInFront { vertex });
        }
        let values = values.map(|values| values.map(|value| value.clamp(-VALUE_REACH, VALUE_REACH)));
        let [a, b, c] = &values;
        let mut bases = [0; N];
        let mut ranges = [0; N];
        for ((base, range), ((a, b), c)) in bases.iter_mut().zip(&mut ranges).zip(a.iter().zip(b).zip(c)) {
            *base = *a.min(b).min(c);
            *range = a.max(b).max(c) - *base;
        }
        let range = ranges.iter().copied().max().unwrap_or(0).unsigned_abs();
        // Products of a value and an inverse have 30 bits at most.
        let bits = (30 - (u32::BITS - range.leading_zeros())).min(INVERSE_BITS);
        let [w0, w1, w2] = distances.map(i32::cast_unsigned);
        let nearest = u64::from(w0.min(w1).min(w2));
        let scale = ((1_u64 << bits) - 1) * nearest;
        let inverses = [w0, w1, w2].map(|w| {
            let w = u64::from(w.max(1));
            i32::try_from((scale + w / 2) / w).unwrap_or(1).max(1)
        });
        let mut numerators = values;
        for (numerators, inverse) in numerators.iter_mut().zip(inverses) {
            for (numerator, base) in numerators.iter_mut().zip(bases) {
                *numerator = numerator.wrapping_sub(base).wrapping_mul(inverse);
            }
        }
        Ok(Self { triangle, numerators, inverses, values: Values { bases, ranges, tolerance: 64 } })
    }

    /// The same, with pieces that are off by at most so many units; 0 divides at every pixel. Pieces begin where the
    /// clip lets them: only with 0 is no value changed by where a drawing is cut.
    #[inline]
    pub const fn tolerance(self, units: u32) -> Self {
        let tolerance = if units < HIGHEST_TOLERANCE { units } else { HIGHEST_TOLERANCE };
        Self { values: Values { tolerance, ..self.values }, ..self }
    }
}

impl<const N: usize> Attributes<N> for Perspective<N> {
    #[inline]
    fn triangle(&self) -> &Triangle {
        &self.triangle
    }

    #[inline]
    fn interpolate<S: AttributeSink<N>>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        walk(
            &self.triangle,
            clip,
            &mut Quotients::of(&oriented, &self.numerators, &self.inverses),
            |span, quotients| {
                let pieces = Pieces::new(&self.values, quotients, &span);
                sink.span(span, pieces, repeat(0))
            },
        )
    }

    #[inline]
    fn interpolate_with_depth<S: AttributeSink<N>>(
        &self,
        depths: [u16; 3],
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        match oriented.near() {
            Some(area) => self.rows_with_depth(&oriented, area, depths, clip, sink),
            None => self.rows_with_depth(&oriented, oriented.area, depths, clip, sink),
        }
    }
}

impl<const N: usize> Perspective<N> {
    #[inline]
    fn rows_with_depth<W: Word, S: AttributeSink<N>>(
        &self,
        oriented: &Oriented,
        area: W,
        depths: [u16; 3],
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let depths = oriented.ordered(&depths).map(|depth| [i32::from(depth)]);
        let mut planes =
            (Quotients::of(oriented, &self.numerators, &self.inverses), Planes::new(&oriented.vertices, &depths, area));
        walk(&self.triangle, clip, &mut planes, |span, (quotients, depths)| {
            let pieces = Pieces::new(&self.values, quotients, &span);
            sink.span(span, pieces, depths.to_the_right().map(depth))
        })
    }
}
