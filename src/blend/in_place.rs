//! Over what the target's memory holds.

use core::hint::black_box;

use embedded_graphics_core::geometry::Point;

use crate::{
    blend::{
        Blend, Mix,
        lanes::{fill, fill_eights},
    },
    target::PixelRows,
};

/// Blends over what is there, in the memory of the target: [`ReadBack`](crate::ReadBack) for targets that have
/// [`PixelRows`], to the same pixels, in less time. A [`Framebuffer`](crate::Framebuffer) or a [`Band`](crate::Band) of packed
/// pixels takes it, too.
///
/// ```text
///   shown before    a   a   b    b    b
///   coverage        0   64  191  255  255
///   InPlace         a   a+  b+   #    #        a+, b+ mixed with what was there, # the colour itself
/// ```
///
/// # Cost
///
/// A row is looked up once for each run and span. Where registers have 64 bits, pixels at the edges are mixed eight at a time
/// ([`Mix::over_eight`], [`Mix::over_eights`]), four on either side of a span; elsewhere one by one.
///
/// # Examples
///
/// See [`PixelRows`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct InPlace;

impl InPlace {
    /// Draws a run, each pixel by itself.
    #[inline(always)]
    pub(super) fn run_by<C: Copy, D: PixelRows<Color = C>>(
        target: &mut D,
        start: Point,
        alphas: &[u8],
        over: impl Fn(C, u8) -> C,
    ) {
        if let Some(row) = target.row_from(start) {
            match row.get_mut(..alphas.len()) {
                Some(row) => mix(row, alphas, over),
                None => mix_cut(row, alphas, over),
            }
        }
    }

    #[inline(always)]
    pub(super) fn fill_row<C: Copy, D: PixelRows<Color = C>>(target: &mut D, start: Point, width: u32, colour: C) {
        if let Some(row) = target.row_from(start) {
            let width = usize::try_from(width).unwrap_or(usize::MAX);
            match row.get_mut(..width) {
                Some(row) => fill(row, colour),
                None => fill_cut(row, colour),
            }
        }
    }
}

impl<C: Mix, D: PixelRows<Color = C>> Blend<D> for InPlace {
    /// Eight narrow colours fill a register of 128 bits; a microcontroller would mix them one by one.
    const EIGHTS: bool = cfg!(target_pointer_width = "64");

    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        Self::run_by(target, start, alphas, move |backdrop, alpha| colour.over(backdrop, alpha));
        Ok(())
    }

    #[inline(always)]
    fn eights(&self, target: &mut D, start: Point, colour: C, alphas: &[[u8; 8]]) -> Result<(), D::Error> {
        let Some(row) = target.row_from(start) else { return Ok(()) };
        if let [alphas] = alphas
            && let Some(eight) = row.first_chunk_mut()
        {
            colour.over_eight(eight, alphas);
            return Ok(());
        }
        let (eights, rest) = row.as_chunks_mut();
        colour.over_eights(eights, alphas);
        if let Some(alphas) = alphas.get(eights.len()) {
            mix_cut(rest, alphas, move |backdrop, alpha| colour.over(backdrop, alpha));
        }
        Ok(())
    }

    #[inline(always)]
    fn span_with_sides(
        &self,
        target: &mut D,
        start: Point,
        width: u32,
        colour: C,
        sides: &[u8; 8],
    ) -> Result<(), D::Error> {
        let row = target.row_from(start);
        let width = usize::try_from(width).unwrap_or(usize::MAX);
        if let Some(row) = row.and_then(|row| row.get_mut(..width))
            && let [a, b, c, d, .., e, f, g, h] = row
        {
            let mut eight = [*a, *b, *c, *d, *e, *f, *g, *h];
            fill_eights(row, colour);
            mix_sides(&mut eight, colour, sides);
            if let [a, b, c, d, .., e, f, g, h] = row {
                [*a, *b, *c, *d, *e, *f, *g, *h] = eight;
            }
        }
        Ok(())
    }

    #[inline]
    fn fill(&self, target: &mut D, start: Point, width: u32, colour: C) -> Result<(), D::Error> {
        Self::fill_row(target, start, width, colour);
        Ok(())
    }
}

/// Both sides of a span, which are not next to each other: out of line, or the compiler mixes them in two registers, half full.
#[inline(never)]
fn mix_sides<C: Mix>(backdrops: &mut [C; 8], colour: C, alphas: &[u8; 8]) {
    colour.over_eight(backdrops, alphas);
}

#[inline(always)]
fn mix<C: Copy>(row: &mut [C], alphas: &[u8], over: impl Fn(C, u8) -> C) {
    for (pixel, &alpha) in row.iter_mut().zip(alphas) {
        // See `ReadBack`: runs are too short to be unrolled.
        black_box(());
        *pixel = over(*pixel, alpha);
    }
}

/// What the target's right edge cuts, as nothing of a shape is but the empty end of an eight.
#[cold]
#[inline(never)]
fn mix_cut<C: Copy>(row: &mut [C], alphas: &[u8], over: impl Fn(C, u8) -> C) {
    mix(row, alphas, over);
}

#[cold]
#[inline(never)]
fn fill_cut<C: Copy>(row: &mut [C], colour: C) {
    fill(row, colour);
}
