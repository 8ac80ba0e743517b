//! What a segment leaves of one column to its right.
//!
//! Distances and heights within a pixel have 24 bits behind the point, areas too.

/// Bits behind the binary point.
pub(super) const CELL_BITS: u32 = 24;

/// A whole pixel's area, its side and its height.
pub(crate) const FULL: i32 = 1 << CELL_BITS;

/// The same.
pub(super) const WHOLE: u32 = FULL.unsigned_abs();

/// The column of an x in 2^-32 pixel.
#[inline]
pub(super) fn column_of(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let column = (x >> 32) as i32;
    column
}

/// How far an x in 2^-32 pixel is within its column.
#[inline]
pub(super) fn within(x: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the lower half")]
    let part = x as u32;
    part >> (32 - CELL_BITS)
}

/// Between the column's left side and a segment: `twice_x`, the sum of the distances at its two ends, is below 2^25, its height
/// `dy` at most 2^24.
#[inline]
pub(super) fn trapezoid(twice_x: u32, dy: u32) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let area = ((u64::from(twice_x << 7) * u64::from(dy)) >> 32) as u32;
    area
}
