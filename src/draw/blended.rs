//! Coverage to a draw target, in one colour.

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point};

use crate::{
    blend::{Blend, PIECE, right_of},
    coverage::CoverageSink,
    span::Span,
};

/// A shape on its way to a target.
pub(super) struct BlendedFill<'t, D: DrawTarget, B> {
    pub(super) target: &'t mut D,
    pub(super) blend: B,
    pub(super) colour: D::Color,
    pub(super) opacity: u8,
}

/// Coverage let through, to the nearest 255th: 255 leaves the other as it is. See `mix_one` for the division.
#[inline(always)]
pub(crate) fn faded(coverage: u8, opacity: u8) -> u8 {
    let biased = u16::from(coverage) * u16::from(opacity) + 128;
    let [_, quotient] = (biased + (biased >> 8)).to_le_bytes();
    quotient
}

/// A run that is let through; apart, to keep what opaque shapes run in short and its values in registers.
#[inline(never)]
fn run_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    colour: D::Color,
    coverage: &[u8],
    opacity: u8,
) -> Result<(), D::Error> {
    let mut start = start;
    for piece in coverage.chunks(PIECE) {
        let mut alphas = [0; PIECE];
        for (alpha, coverage) in alphas.iter_mut().zip(piece) {
            *alpha = faded(*coverage, opacity);
        }
        blend.run(target, start, colour, alphas.get(..piece.len()).unwrap_or_default())?;
        start = right_of(start, piece.len());
    }
    Ok(())
}

/// A span that is let through, or covered in part.
#[inline(never)]
fn span_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    width: u32,
    colour: D::Color,
    alpha: u8,
) -> Result<(), D::Error> {
    blend.span(target, start, width, colour, alpha)
}

impl<D: DrawTarget, B: Blend<D>> CoverageSink for BlendedFill<'_, D, B> {
    type Error = D::Error;

    #[inline(always)]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), D::Error> {
        let Span { row, columns } = span;
        let start = Point::new(columns.start, row);
        let width = columns.end.wrapping_sub(columns.start).cast_unsigned();
        if coverage == 255 && self.opacity == 255 {
            self.blend.fill(self.target, start, width, self.colour)
        } else {
            span_faded(self.blend, self.target, start, width, self.colour, faded(coverage, self.opacity))
        }
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), D::Error> {
        let Self { ref mut target, blend, colour, opacity } = *self;
        let start = Point::new(column, row);
        if opacity == 255 {
            blend.run(target, start, colour, coverage)
        } else {
            run_faded(blend, *target, start, colour, coverage, opacity)
        }
    }
}
