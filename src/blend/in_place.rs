//! Over what the target's memory holds.

use core::hint::black_box;

use embedded_graphics_core::geometry::Point;

use crate::{
    blend::{Blend, Mix, lanes::fill},
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
/// A row is looked up once for each run and span. Where registers have 64 bits, the pixels of a run are mixed eight at a time
/// ([`Mix::over_eight`]); elsewhere one by one.
///
/// # Examples
///
/// See [`PixelRows`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct InPlace;

/// Eight narrow colours fill a register of 128 bits; a microcontroller would mix them one by one.
const IN_EIGHTS: bool = cfg!(target_pointer_width = "64");

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
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        let over = move |backdrop: C, alpha| colour.over(backdrop, alpha);
        if !IN_EIGHTS {
            Self::run_by(target, start, alphas, over);
            return Ok(());
        }
        let Some(row) = target.row_from(start) else { return Ok(()) };
        let (eights, rest) = row.as_chunks_mut::<8>();
        let mut left = alphas;
        for eight in eights {
            let Some((first, others)) = left.split_first_chunk() else {
                if !left.is_empty() {
                    let mut padded = [0; 8];
                    for (padded, alpha) in padded.iter_mut().zip(left) {
                        *padded = *alpha;
                    }
                    colour.over_eight(eight, &padded);
                }
                return Ok(());
            };
            colour.over_eight(eight, first);
            left = others;
        }
        mix_cut(rest, left, over);
        Ok(())
    }

    #[inline]
    fn fill(&self, target: &mut D, start: Point, width: u32, colour: C) -> Result<(), D::Error> {
        Self::fill_row(target, start, width, colour);
        Ok(())
    }
}

#[inline(always)]
fn mix<C: Copy>(row: &mut [C], alphas: &[u8], over: impl Fn(C, u8) -> C) {
    for (pixel, &alpha) in row.iter_mut().zip(alphas) {
        // See `ReadBack`: runs are too short to be unrolled.
        black_box(());
        *pixel = over(*pixel, alpha);
    }
}

/// Beside the target's right edge.
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
