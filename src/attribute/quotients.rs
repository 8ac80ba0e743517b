//! The planes that perspective divides, and their quotients at a centre.

use crate::attribute::{
    binary::{BinaryPlanes, Product, low_word},
    walk::{Follow, Oriented},
};

/// The planes of a triangle at a row, and a column there.
#[derive(Debug)]
pub(super) struct Quotients<const N: usize> {
    pub(super) numerators: BinaryPlanes<N>,
    pub(super) inverse: BinaryPlanes<1>,
    row: i32,
    pub(super) column: i32,
}

impl<const N: usize> Quotients<N> {
    /// The planes of a triangle whose numerators have 30 bits.
    #[inline(always)]
    pub(super) fn of(oriented: &Oriented, numerators: &[[i32; N]; 3], inverses: &[i32; 3]) -> Self {
        let (numerators, inverses) = (oriented.ordered(numerators), oriented.ordered(inverses));
        let inverses = inverses.map(|inverse| [inverse]);
        if oriented.is_within(22) {
            Self::new::<i64>(oriented, &numerators, &inverses)
        } else {
            far(oriented, &numerators, &inverses)
        }
    }

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

    /// The planes so many columns to the right.
    #[inline(always)]
    pub(super) fn advanced(&self, mut numerators: [u64; N], inverse: u64, columns: u32) -> ([u64; N], u64) {
        let advanced = |at: u64, step: u64| at.wrapping_add(step.wrapping_mul(columns.into()));
        for (numerator, step) in numerators.iter_mut().zip(&self.numerators.right) {
            *numerator = advanced(*numerator, *step);
        }
        let [inverse_step] = self.inverse.right;
        (numerators, advanced(inverse, inverse_step))
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

/// Those of triangles of any size.
#[cold]
#[inline(never)]
fn far<const N: usize>(oriented: &Oriented, numerators: &[[i32; N]; 3], inverses: &[[i32; 1]; 3]) -> Quotients<N> {
    Quotients::new::<i128>(oriented, numerators, inverses)
}

/// The whole part of a plane's value.
#[inline(always)]
pub(super) fn whole(value: u64) -> i32 {
    low_word(value >> 32).cast_signed()
}

/// `W`, which is not 0.
#[inline(always)]
pub(super) fn weight(inverse: u64) -> u32 {
    whole(inverse).max(1).cast_unsigned()
}

/// To the nearest. Numerators are below 2^30 at a centre inside; next to an edge they may be a little below 0. As `w` was
/// rounded, too, a quotient could go beyond the largest value.
#[inline(always)]
pub(super) fn divided<const N: usize>(numerators: &[u64; N], w: u32, ranges: &[i32; N]) -> [i32; N] {
    let w = w.max(1);
    let mut quotients = *ranges;
    for (quotient, numerator) in quotients.iter_mut().zip(numerators) {
        let numerator = whole(*numerator).max(0).cast_unsigned();
        *quotient = (numerator.wrapping_add(w / 2) / w).cast_signed().min(*quotient);
    }
    quotients
}
