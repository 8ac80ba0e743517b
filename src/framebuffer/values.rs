//! Pixels as values of their colour.

use core::{hint::black_box, ops::Range};

use embedded_graphics_core::pixelcolor::PixelColor;

use crate::framebuffer::layout::{Layout, Values};

impl<C: PixelColor + core::fmt::Debug + 'static> Layout<C> for Values {
    type Unit = C;
    type Ink = C;

    const LINE_ROWS: u32 = 1;
    const STEP: u32 = 8;

    #[inline(always)]
    fn get(pixels: &[C], line: usize, column: usize, _: u32) -> Option<C> {
        pixels.get(line + column).copied()
    }

    #[inline(always)]
    fn set(pixels: &mut [C], line: usize, column: usize, _: u32, colour: C) {
        if let Some(pixel) = pixels.get_mut(line + column) {
            *pixel = colour;
        }
    }

    #[inline(always)]
    fn ink(colour: C) -> C {
        colour
    }

    #[inline(always)]
    fn fill(pixels: &mut [C], line: usize, columns: Range<usize>, _: Range<u32>, colour: C) {
        if let Some(pixels) = pixels.get_mut(line.wrapping_add(columns.start)..line.wrapping_add(columns.end)) {
            fill(pixels, colour);
        }
    }
}

/// From both ends, as bytes are: see `words`.
#[inline(never)]
fn fill<C: Copy>(pixels: &mut [C], colour: C) {
    if let Some(last) = pixels.last_chunk_mut::<8>() {
        last.fill(colour);
        let (many, rest) = pixels.as_chunks_mut::<32>();
        for piece in many {
            black_box(());
            piece.fill(colour);
        }
        for eight in rest.as_chunks_mut::<8>().0 {
            black_box(());
            eight.fill(colour);
        }
    } else if let Some(last) = pixels.last_chunk_mut::<4>() {
        last.fill(colour);
        if let Some(first) = pixels.first_chunk_mut::<4>() {
            first.fill(colour);
        }
    } else {
        match pixels {
            [first] => *first = colour,
            [first, second] => [*first, *second] = [colour; 2],
            [first, second, third] => [*first, *second, *third] = [colour; 3],
            _ => {}
        }
    }
}
