//! The named roundings from sub-pixels to pixels.

use crate::limits::{HALF, ONE, SUBPIXEL_BITS};

/// The first pixel (column or row) whose centre is at or after `position`: `ceil((position - 128) / 256)`.
///
/// Written so that no position wraps.
#[inline]
pub(crate) const fn first_centre_at_or_after(position: i32) -> i32 {
    (position >> SUBPIXEL_BITS) + ((position & (ONE - 1)) > HALF) as i32
}

/// The same for positions outside the coordinate range.
#[inline]
pub(crate) const fn first_centre_at_or_after_wide(position: i64) -> i64 {
    (position - HALF as i64 + (ONE as i64 - 1)) >> SUBPIXEL_BITS
}

/// The pixel that holds `position`.
#[inline]
pub(crate) const fn pixel_holding(position: i32) -> i32 {
    position >> SUBPIXEL_BITS
}

/// The centre of a pixel, modulo 2^32: right for every pixel that a coordinate can name.
#[inline]
pub(crate) const fn centre(pixel: i32) -> i32 {
    pixel.wrapping_shl(SUBPIXEL_BITS).wrapping_add(HALF)
}
