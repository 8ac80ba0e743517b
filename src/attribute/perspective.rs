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
//! - Between two exact values `h` pixels apart, with `W0` and `W1`, a linear interpolation is off by at most
//!
//!   ```text
//!     |s1 - s0| |sqrt(r) - 1| / (sqrt(r) + 1)  <=  |s1 - s0| |W1 - W0| / (4 min(W0, W1)),   r = W1 / W0
//!   ```
//!
//!   Along a row, `ds/dx = K / W^2` with one `K`, so over pieces of `h` pixels it is at most `h^2 |ds/dx| |dW/dx| / (4 W)`,
//!   both taken at the end of the row whose `W` is less. All pieces of a row have the largest `h` for which that stays
//!   within the tolerance, 64 at most: a division a row, and one for each attribute and piece.
//! - Interpolated `W` are whole numbers again: half of one is at most 1/8 texel of 64 where `W` is 256.
//! - Quotients are rounded to whole units, and steps within a piece to `2^-8` of one: two units more at most.

use core::iter::repeat;

use crate::{
    PixelRect, Span, Triangle,
    attribute::{
        AttributeRow, AttributeSink, Attributes,
        affine::depth,
        binary::{BinaryPlanes, Product, low_word},
        plane::{Planes, Word},
        walk::{Follow, Oriented, walk},
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
    /// The values less `bases`, times `inverses`.
    numerators: [[i32; N]; 3],
    bases: [i32; N],
    /// The largest value of each, less its base.
    ranges: [i32; N],
    inverses: [i32; 3],
    tolerance: u32,
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
        Ok(Self { triangle, numerators, bases, ranges, inverses, tolerance: 64 })
    }

    /// The same, with pieces that are off by at most so many units; 0 divides at every pixel. Pieces begin where the
    /// clip lets them: only with 0 is no value changed by where a drawing is cut.
    #[inline]
    pub const fn tolerance(self, units: u32) -> Self {
        Self { tolerance: if units < HIGHEST_TOLERANCE { units } else { HIGHEST_TOLERANCE }, ..self }
    }

    #[inline(always)]
    fn quotients(&self, oriented: &Oriented) -> Quotients<N> {
        let (numerators, inverses) = (oriented.ordered(&self.numerators), oriented.ordered(&self.inverses));
        let inverses = inverses.map(|inverse| [inverse]);
        // Numerators have 30 bits.
        if oriented.is_within(22) {
            Quotients::new::<i64>(oriented, &numerators, &inverses)
        } else {
            far(oriented, &numerators, &inverses)
        }
    }
}

/// Those of triangles of any size.
#[cold]
#[inline(never)]
fn far<const N: usize>(oriented: &Oriented, numerators: &[[i32; N]; 3], inverses: &[[i32; 1]; 3]) -> Quotients<N> {
    Quotients::new::<i128>(oriented, numerators, inverses)
}

/// The planes of a triangle at a row, and a column there.
#[derive(Debug)]
struct Quotients<const N: usize> {
    numerators: BinaryPlanes<N>,
    inverse: BinaryPlanes<1>,
    row: i32,
    column: i32,
}

impl<const N: usize> Quotients<N> {
    #[inline(always)]
    fn new<P: Product>(oriented: &Oriented, numerators: &[[i32; N]; 3], inverses: &[[i32; 1]; 3]) -> Self {
        let mut numerators = BinaryPlanes::new::<P>(oriented, numerators);
        let mut inverse = BinaryPlanes::new::<P>(oriented, inverses);
        // To the nearest by taking the upper word.
        for at in numerators.at.iter_mut().chain(&mut inverse.at) {
            *at = at.wrapping_add(1 << 31);
        }
        Self { row: inverse.row(), column: inverse.column(), numerators, inverse }
    }
}

impl<const N: usize> Follow for Quotients<N> {
    /// Rows go down in the column of the first vertex.
    #[inline(always)]
    fn go_to(&mut self, row: i32, column: i32) {
        let rows = row.wrapping_sub(self.row);
        self.numerators.move_by(rows, 0);
        self.inverse.move_by(rows, 0);
        (self.row, self.column) = (row, column);
    }
}

/// The values of a span, piece by piece.
#[derive(Debug)]
struct Pieces<'p, const N: usize> {
    of: &'p Perspective<N>,
    quotients: &'p Quotients<N>,
    /// At the end of the current piece, which is the start of the next: the planes, and the exact values less the bases.
    numerators: [u64; N],
    inverse: u64,
    start: [i32; N],
    /// The exact values at the last centre.
    last: [i32; N],
    /// How many more centres the span has to the right of there.
    rest: u32,
    /// How long a piece is.
    length: u32,
    piece: Piece<N>,
}

/// Values in a line, with [`FRACTION`] bits more.
#[derive(Debug, Clone, Copy)]
struct Piece<const N: usize> {
    current: [i32; N],
    step: [i32; N],
    left: u32,
}

const FRACTION: u32 = 8;
/// Pieces have 64 pixels at most.
const LONGEST: u32 = 64;

impl<const N: usize> Piece<N> {
    #[inline(always)]
    fn next(&mut self) -> [i32; N] {
        let values = self.current.map(|value| value >> FRACTION);
        for (current, step) in self.current.iter_mut().zip(&self.step) {
            *current = current.wrapping_add(*step);
        }
        values
    }

    /// Past some that are left.
    fn after(mut self, count: usize) -> Self {
        let count = u32::try_from(count).unwrap_or(0);
        self.left = self.left.saturating_sub(count);
        for (current, step) in self.current.iter_mut().zip(&self.step) {
            *current = current.wrapping_add(step.wrapping_mul(count.cast_signed()));
        }
        self
    }
}

impl<const N: usize> Pieces<'_, N> {
    /// The next piece. The last one has the last centre, too.
    #[inline(always)]
    fn next_piece(&mut self) -> Piece<N> {
        let (mut end, mut length, mut left) = (self.last, self.rest, self.rest.wrapping_add(1));
        if self.rest > self.length {
            length = self.length;
            left = length;
            (self.numerators, self.inverse) = self.quotients.advanced(self.numerators, self.inverse, length);
            end = quotients(&self.numerators, weight(self.inverse), &self.of.ranges);
        }
        let mut piece = Piece { current: self.start, step: end, left };
        for ((current, step), base) in piece.current.iter_mut().zip(&mut piece.step).zip(&self.of.bases) {
            *step = ((*step - *current) << FRACTION) / length.cast_signed().max(1);
            *current = (current.wrapping_add(*base) << FRACTION) + (1 << (FRACTION - 1));
        }
        self.start = end;
        self.rest = self.rest.wrapping_sub(length);
        piece
    }

    /// Goes on in the current piece, or with the next one, as far as it goes. Returns what is left.
    #[inline(always)]
    fn write_piece<'t, T>(&mut self, into: &'t mut [T], write: &mut impl FnMut(&mut T, [i32; N])) -> &'t mut [T] {
        let mut piece = self.piece;
        if piece.left == 0 {
            piece = self.next_piece();
        }
        let left = usize::try_from(piece.left).unwrap_or(1);
        let length = left.min(into.len());
        let Some((now, later)) = into.split_at_mut_checked(length) else { return &mut [] };
        self.piece.left = 0;
        if length < left {
            self.piece = piece.after(length);
        }
        write_line(piece.current, piece.step, now, write);
        later
    }
}

/// Out of line: next to everything else, there are no registers left for it.
#[inline(never)]
fn write_line<T, const N: usize>(
    current: [i32; N],
    step: [i32; N],
    into: &mut [T],
    write: &mut impl FnMut(&mut T, [i32; N]),
) {
    let mut values = current;
    for item in into {
        write(item, values.map(|value| value >> FRACTION));
        for (value, step) in values.iter_mut().zip(&step) {
            *value = value.wrapping_add(*step);
        }
    }
}

/// The whole part of a plane's value.
#[inline(always)]
fn whole(value: u64) -> i32 {
    low_word(value >> 32).cast_signed()
}

/// `W`, which is not 0.
#[inline(always)]
fn weight(inverse: u64) -> u32 {
    whole(inverse).max(1).cast_unsigned()
}

/// To the nearest. Numerators are below 2^30 at a centre inside; next to an edge they may be a little below 0. As `w` was
/// rounded, too, a quotient could go beyond the largest value.
#[inline(always)]
fn quotients<const N: usize>(numerators: &[u64; N], w: u32, ranges: &[i32; N]) -> [i32; N] {
    let w = w.max(1);
    let mut quotients = *ranges;
    for (quotient, numerator) in quotients.iter_mut().zip(numerators) {
        let numerator = whole(*numerator).max(0).cast_unsigned();
        *quotient = (numerator.wrapping_add(w / 2) / w).cast_signed().min(*quotient);
    }
    quotients
}

impl<const N: usize> Iterator for Pieces<'_, N> {
    type Item = [i32; N];

    #[inline]
    fn next(&mut self) -> Option<[i32; N]> {
        if self.piece.left == 0 {
            self.piece = self.next_piece();
        }
        self.piece.left -= 1;
        Some(self.piece.next())
    }
}

impl<const N: usize> AttributeRow<N> for Pieces<'_, N> {
    #[inline(always)]
    fn write<T>(&mut self, into: &mut [T], mut write: impl FnMut(&mut T, [i32; N])) {
        let mut rest = into;
        while !rest.is_empty() {
            rest = self.write_piece(rest, &mut write);
        }
    }
}

impl<const N: usize> Quotients<N> {
    #[inline(always)]
    fn pieces<'p>(&'p self, of: &'p Perspective<N>, span: &Span) -> Pieces<'p, N> {
        let numerators = self.numerators.at_column(self.column);
        let [inverse] = self.inverse.at_column(self.column);
        let first = weight(inverse);
        let start = quotients(&numerators, first, &of.ranges);
        let rest = span.columns.end.wrapping_sub(span.columns.start).cast_unsigned().saturating_sub(1);
        let (mut last, mut length) = (start, 1);
        if rest > 0 {
            let (numerators, inverse) = self.advanced(numerators, inverse, rest);
            let w = weight(inverse);
            last = quotients(&numerators, w, &of.ranges);
            let (farthest, w) = if first <= w { (&start, first) } else { (&last, w) };
            length = self.length(of.tolerance, farthest, w);
        }
        let piece = Piece { current: [0; N], step: [0; N], left: 0 };
        Pieces { of, quotients: self, numerators, inverse, start, last, rest, length, piece }
    }

    /// The planes so many columns to the right.
    #[inline(always)]
    fn advanced(&self, mut numerators: [u64; N], inverse: u64, columns: u32) -> ([u64; N], u64) {
        let advanced = |at: u64, step: u64| at.wrapping_add(step.wrapping_mul(columns.into()));
        for (numerator, step) in numerators.iter_mut().zip(&self.numerators.right) {
            *numerator = advanced(*numerator, *step);
        }
        let [inverse_step] = self.inverse.right;
        (numerators, advanced(inverse, inverse_step))
    }

    /// How long a piece may be in a row whose least `W` is this, with these values: see the module.
    #[inline(always)]
    fn length(&self, tolerance: u32, values: &[i32; N], w: u32) -> u32 {
        let [inverse_step] = self.inverse.right;
        // In 1/256: between two centres inside, `W` changes by less than 2^16, and `s W` by less than 2^30.
        let change = low_word(inverse_step >> 24).cast_signed();
        let mut slope = 0;
        for (step, value) in self.numerators.right.iter().zip(values) {
            let through = low_word((i64::from(*value).wrapping_mul(change.into()) >> 8).cast_unsigned());
            slope = slope.max(whole(*step).wrapping_sub(through.cast_signed()).unsigned_abs());
        }
        let change = change.unsigned_abs().wrapping_add(1);
        // Values are whole numbers, and so off by a half.
        let slope = slope.wrapping_add(change >> 8).wrapping_add(2);
        let error = u64::from(slope).wrapping_mul(change.into());
        let bound = u64::from(w.wrapping_mul(w)).wrapping_mul(u64::from(tolerance << 10));
        // The largest h of h^2 error <= bound.
        // In 20 bits, which leaves twelve for the quotient.
        let unit = (u64::BITS - 20).saturating_sub(error.leading_zeros());
        let error = low_word(error >> unit).wrapping_add(1);
        let square = u32::try_from(bound >> unit).unwrap_or(u32::MAX) / error.max(1);
        if square >= LONGEST * LONGEST {
            return LONGEST;
        }
        // A chord of the root, below it.
        let log2 = (31 - (square | 1).leading_zeros()) / 2;
        let power = 1 << log2;
        power + ((square.saturating_sub(power << log2) * 85) >> (8 + log2))
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
        walk(&self.triangle, clip, &mut self.quotients(&oriented), |span, quotients| {
            let pieces = quotients.pieces(self, &span);
            sink.span(span, pieces, repeat(0))
        })
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
        let mut planes = (self.quotients(oriented), Planes::new(&oriented.vertices, &depths, area));
        walk(&self.triangle, clip, &mut planes, |span, (quotients, depths)| {
            let pieces = quotients.pieces(self, &span);
            sink.span(span, pieces, depths.to_the_right().map(depth))
        })
    }
}
