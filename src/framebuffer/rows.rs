//! Pixels beside each other in bytes.

use core::ops::Range;

use crate::framebuffer::{
    color::PackedColor,
    layout::{Layout, Order, Rows},
    words::{fill, fill_threes},
};

impl<C: PackedColor, O: Order> Layout<C> for Rows<O> {
    type Unit = u8;
    /// The pixel as often as 32 bits have room for it; once at 24 bits.
    type Ink = u32;

    const LINE_ROWS: u32 = 1;
    const STEP: u32 = C::BITS;

    #[inline(always)]
    fn get(bytes: &[u8], line: usize, column: usize, _: u32) -> Option<C> {
        let start = line + column * C::BITS as usize / 8;
        Some(match C::BITS {
            8 => C::from_bits((*bytes.get(start)?).into()),
            16 => from_bytes::<C, O, 2>(*bytes.get(start..)?.first_chunk()?),
            24 => from_bytes::<C, O, 3>(*bytes.get(start..)?.first_chunk()?),
            32 => from_bytes::<C, O, 4>(*bytes.get(start..)?.first_chunk()?),
            _ => C::from_bits(u32::from(*bytes.get(start)? >> shift::<C, O>(column)) & pixel_mask::<C>()),
        })
    }

    #[inline(always)]
    fn set(bytes: &mut [u8], line: usize, column: usize, _: u32, colour: C) {
        let start = line + column * C::BITS as usize / 8;
        match C::BITS {
            16 => store::<2>(bytes, start, to_bytes::<C, O, 2>(colour)),
            24 => store::<3>(bytes, start, to_bytes::<C, O, 3>(colour)),
            32 => store::<4>(bytes, start, to_bytes::<C, O, 4>(colour)),
            bits => {
                if let Some(byte) = bytes.get_mut(start) {
                    let [colour, ..] = colour.to_bits().to_le_bytes();
                    *byte = if bits == 8 {
                        colour
                    } else {
                        let shift = shift::<C, O>(column);
                        let [mask, ..] = pixel_mask::<C>().to_le_bytes();
                        *byte & !(mask << shift) | (colour << shift)
                    };
                }
            }
        }
    }

    #[inline(always)]
    fn ink(colour: C) -> u32 {
        match C::BITS {
            16 => {
                let [a, b] = to_bytes::<C, O, 2>(colour);
                u32::from_ne_bytes([a, b, a, b])
            }
            32 => u32::from_ne_bytes(to_bytes::<C, O, 4>(colour)),
            24 => colour.to_bits(),
            // Ones at every pixel's lowest bit.
            _ => colour.to_bits() * (u32::MAX / pixel_mask::<C>()),
        }
    }

    #[inline(always)]
    fn fill(bytes: &mut [u8], line: usize, columns: Range<usize>, _: Range<u32>, ink: u32) {
        if C::BITS < 8 {
            return fill_bits::<C, O>(bytes, line, columns, ink);
        }
        let size = C::BITS as usize / 8;
        let place = |column: usize| line.wrapping_add(column.wrapping_mul(size));
        let range = place(columns.start)..place(columns.end);
        if let Some(bytes) = bytes.get_mut(range) {
            if C::BITS == 24 {
                fill_threes(bytes, to_bytes::<C, O, 3>(C::from_bits(ink)));
            } else {
                fill(bytes, ink);
            }
        }
    }

    #[inline(always)]
    fn change(bytes: &mut [u8], line: usize, columns: Range<usize>, row: u32, mut change: impl FnMut(C) -> C) {
        match C::BITS {
            16 => change_whole::<C, O, 2>(bytes, line, columns, change),
            24 => change_whole::<C, O, 3>(bytes, line, columns, change),
            32 => change_whole::<C, O, 4>(bytes, line, columns, change),
            _ => {
                for column in columns {
                    let Some(colour) = <Self as Layout<C>>::get(bytes, line, column, row) else { break };
                    <Self as Layout<C>>::set(bytes, line, column, row, change(colour));
                }
            }
        }
    }
}

/// The bits of a pixel, in the lowest place.
#[inline(always)]
pub(super) const fn pixel_mask<C: PackedColor>() -> u32 {
    u32::MAX >> (u32::BITS - C::BITS)
}

/// How far up a pixel of less than eight bits lies in its byte.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "below 8")]
pub(super) fn shift<C: PackedColor, O: Order>(place: usize) -> u32 {
    let place = place as u32 % (8 / C::BITS) * C::BITS;
    if O::MSB_FIRST { 8 - C::BITS - place } else { place }
}

/// The lowest bytes of a pixel, in the order of the memory.
#[inline(always)]
fn to_bytes<C: PackedColor, O: Order, const N: usize>(colour: C) -> [u8; N] {
    let mut bytes = colour.to_bits().to_le_bytes().first_chunk().copied().unwrap_or([0; N]);
    if O::MSB_FIRST {
        bytes.reverse();
    }
    bytes
}

#[inline(always)]
fn from_bytes<C: PackedColor, O: Order, const N: usize>(mut bytes: [u8; N]) -> C {
    if O::MSB_FIRST {
        bytes.reverse();
    }
    let mut bits = [0; 4];
    for (to, from) in bits.iter_mut().zip(bytes) {
        *to = from;
    }
    C::from_bits(u32::from_le_bytes(bits))
}

#[inline(always)]
fn store<const N: usize>(bytes: &mut [u8], start: usize, pixel: [u8; N]) {
    if let Some(place) = bytes.get_mut(start..).and_then(<[u8]>::first_chunk_mut) {
        *place = pixel;
    }
}

#[inline(always)]
fn change_whole<C: PackedColor, O: Order, const N: usize>(
    bytes: &mut [u8],
    line: usize,
    columns: Range<usize>,
    mut change: impl FnMut(C) -> C,
) {
    if let Some(bytes) = bytes.get_mut(line + columns.start * N..line + columns.end * N) {
        for pixel in bytes.as_chunks_mut().0 {
            *pixel = to_bytes::<C, O, N>(change(from_bytes::<C, O, N>(*pixel)));
        }
    }
}

/// Whole bytes by words, and a part of a byte at either end.
///
/// ```text
///   MsbFirst      . . . # # # # # | # # # # # # # # | # # . . . . . .
///   masks         0xFF >> 3                           !(0xFF >> 2)
/// ```
#[inline(always)]
fn fill_bits<C: PackedColor, O: Order>(bytes: &mut [u8], line: usize, columns: Range<usize>, ink: u32) {
    let bit = |column: usize| column.wrapping_mul(C::BITS as usize);
    let (start, end) = (bit(columns.start), bit(columns.end));
    let from = |bit: usize| if O::MSB_FIRST { 0xFF >> (bit % 8) } else { 0xFF << (bit % 8) };
    let (head, tail): (u8, u8) = (from(start), !from(end));
    let [byte, ..] = ink.to_ne_bytes();
    let put = |place: Option<&mut u8>, mask: u8| {
        if let Some(place) = place {
            *place = *place & !mask | byte & mask;
        }
    };
    let (mut first, last) = (line.wrapping_add(start / 8), line.wrapping_add(end / 8));
    if first == last {
        if start < end {
            put(bytes.get_mut(first), head & tail);
        }
        return;
    }
    if head != 0xFF {
        put(bytes.get_mut(first), head);
        first += 1;
    }
    if tail != 0 {
        put(bytes.get_mut(last), tail);
    }
    if let Some(whole) = bytes.get_mut(first..last) {
        fill(whole, ink);
    }
}
