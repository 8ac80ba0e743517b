//! Perspective in pieces that are straight lines: between two exact values, an addition a pixel.
//!
//! Between two exact values `h` pixels apart, with `W0` and `W1`, a linear interpolation is off by at most
//!
//! ```text
//!   |s1 - s0| |sqrt(r) - 1| / (sqrt(r) + 1)  <=  |s1 - s0| |W1 - W0| / (4 min(W0, W1)),   r = W1 / W0
//! ```
//!
//! Along a row, `ds/dx = K / W^2` with one `K`, so over pieces of `h` pixels it is at most `h^2 |ds/dx| |dW/dx| / (4 W)`,
//! both taken at the end of the row whose `W` is less. All pieces of a row have the largest `h` for which that stays
//! within the tolerance, 64 at most: a division a row, and one for each attribute and piece. Steps within a piece are rounded to
//! `2^-8` of a unit.

use crate::{
    Span,
    attribute::{
        AttributeRow,
        binary::low_word,
        quotients::{Quotients, divided, weight, whole},
    },
};

/// What pieces have to know of the values of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Values<const N: usize> {
    pub(super) bases: [i32; N],
    /// The largest value of each, less its base.
    pub(super) ranges: [i32; N],
    /// What a value may be off.
    pub(super) tolerance: u32,
}

/// The values of a span, piece by piece.
#[derive(Debug)]
pub(super) struct Pieces<'p, const N: usize> {
    values: &'p Values<N>,
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

impl<'p, const N: usize> Pieces<'p, N> {
    #[inline(always)]
    pub(super) fn new(values: &'p Values<N>, quotients: &'p Quotients<N>, span: &Span) -> Self {
        let numerators = quotients.numerators.at_column(quotients.column);
        let [inverse] = quotients.inverse.at_column(quotients.column);
        let first = weight(inverse);
        let start = divided(&numerators, first, &values.ranges);
        let rest = span.columns.end.wrapping_sub(span.columns.start).cast_unsigned().saturating_sub(1);
        let (mut last, mut length) = (start, 1);
        if rest > 0 {
            let (numerators, inverse) = quotients.advanced(numerators, inverse, rest);
            let w = weight(inverse);
            last = divided(&numerators, w, &values.ranges);
            let (farthest, w) = if first <= w { (&start, first) } else { (&last, w) };
            length = piece_length(quotients, values.tolerance, farthest, w);
        }
        let piece = Piece { current: [0; N], step: [0; N], left: 0 };
        Self { values, quotients, numerators, inverse, start, last, rest, length, piece }
    }

    /// The next piece. The last one has the last centre, too.
    #[inline(always)]
    fn next_piece(&mut self) -> Piece<N> {
        let (mut end, mut length, mut left) = (self.last, self.rest, self.rest.wrapping_add(1));
        if self.rest > self.length {
            length = self.length;
            left = length;
            (self.numerators, self.inverse) = self.quotients.advanced(self.numerators, self.inverse, length);
            end = divided(&self.numerators, weight(self.inverse), &self.values.ranges);
        }
        let mut piece = Piece { current: self.start, step: end, left };
        for ((current, step), base) in piece.current.iter_mut().zip(&mut piece.step).zip(&self.values.bases) {
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

/// How long a piece may be in a row whose least `W` is this, with these values: see the module.
#[inline(always)]
fn piece_length<const N: usize>(quotients: &Quotients<N>, tolerance: u32, values: &[i32; N], w: u32) -> u32 {
    let [inverse_step] = quotients.inverse.right;
    // In 1/256: between two centres inside, `W` changes by less than 2^16, and `s W` by less than 2^30.
    let change = low_word(inverse_step >> 24).cast_signed();
    let mut slope = 0;
    for (step, value) in quotients.numerators.right.iter().zip(values) {
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
