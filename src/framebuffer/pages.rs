//! Pixels above each other in bytes.

use core::ops::Range;

use crate::framebuffer::{
    color::PackedColor,
    layout::{Layout, Order, Pages, Rows},
    rows::{pixel_mask, shift},
    words::fill_masked,
};

impl<C: PackedColor, O: Order> Layout<C> for Pages<O> {
    type Unit = u8;
    type Ink = u32;

    const LINE_ROWS: u32 = if C::BITS < 8 { 8 / C::BITS } else { 1 };
    const STEP: u32 = if C::BITS < 8 { 8 } else { C::BITS };

    #[inline(always)]
    fn get(bytes: &[u8], line: usize, column: usize, row: u32) -> Option<C> {
        if C::BITS >= 8 {
            return <Rows<O> as Layout<C>>::get(bytes, line, column, row);
        }
        let byte = *bytes.get(line + column)?;
        Some(C::from_bits(u32::from(byte >> shift::<C, O>(row as usize)) & pixel_mask::<C>()))
    }

    #[inline(always)]
    fn set(bytes: &mut [u8], line: usize, column: usize, row: u32, colour: C) {
        if C::BITS >= 8 {
            return <Rows<O> as Layout<C>>::set(bytes, line, column, row, colour);
        }
        if let Some(byte) = bytes.get_mut(line + column) {
            let shift = shift::<C, O>(row as usize);
            let ([mask, ..], [colour, ..]) = (pixel_mask::<C>().to_le_bytes(), colour.to_bits().to_le_bytes());
            *byte = *byte & !(mask << shift) | (colour << shift);
        }
    }

    #[inline(always)]
    fn ink(colour: C) -> u32 {
        <Rows<O> as Layout<C>>::ink(colour)
    }

    #[inline(always)]
    fn fill(bytes: &mut [u8], line: usize, columns: Range<usize>, rows: Range<u32>, ink: u32) {
        if C::BITS >= 8 {
            return <Rows<O> as Layout<C>>::fill(bytes, line, columns, rows, ink);
        }
        if let Some(bytes) = bytes.get_mut(line.wrapping_add(columns.start)..line.wrapping_add(columns.end)) {
            fill_masked(bytes, rows_mask::<O>(rows.start * C::BITS..rows.end * C::BITS), ink);
        }
    }
}

/// The bits of a page's rows, of which there is at least one: `bits` counts from the first row's on and ends at 8 at most.
#[inline(always)]
fn rows_mask<O: Order>(bits: Range<u32>) -> u8 {
    let (before, after) = (bits.start & 7, 8_u32.wrapping_sub(bits.end) & 7);
    if O::MSB_FIRST { (0xFF >> before) & (0xFF << after) } else { (0xFF << before) & (0xFF >> after) }
}
