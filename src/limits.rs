//! The numbers everything rests on, each with its proof.
//!
//! Coordinates are `I24F8` bits: every `i32` is legal. `dx`, `dy` are differences of two of them: below 2^32 in
//! magnitude. `D = 256 dy` is the denominator of a boundary column (see `edge`).

/// Bits behind the binary point of a coordinate.
pub(crate) const SUBPIXEL_BITS: u32 = 8;

/// Sub-pixels to the pixel.
pub(crate) const ONE: i32 = 1 << SUBPIXEL_BITS;

/// From a pixel's edge to its centre.
pub(crate) const HALF: i32 = ONE / 2;

/// Edges below this height (65536 pixels) are stepped; taller ones are divided afresh on every row.
///
/// A stepped edge keeps a remainder in `0..D` in 32 bits: `256 dy < 2^32`.
pub(crate) const STEPPED_HEIGHT: u32 = 1 << 24;
const _: () = assert!((STEPPED_HEIGHT as u64 - 1) * (ONE as u64) < 1 << 32);

/// Edges below this height and width (16384 pixels) that start on a visible row are set up in `i32`.
///
/// The numerator is `(b - 128) dy + t rem` with `0 <= b < 256`, `|t| <= 256`, `|rem| < dy`: at most `384 dy` in
/// magnitude. One more `D` is added while it is normalized: `640 dy < 2^31` is not needed, as the sign is that of the
/// smaller operand, but holds up to 13107 pixels; the sum never grows past its larger operand.
pub(crate) const NARROW_EXTENT: u32 = 1 << 22;
const _: () = assert!((NARROW_EXTENT as i64) * 384 < 1 << 31);
const _: () = assert!(NARROW_EXTENT <= STEPPED_HEIGHT);

/// Circles up to this radius (2048 pixels) are stepped in `i32`; larger ones take a square root a row.
///
/// With local columns and rows of at most `R/256 + 1` in magnitude, the largest value the stepper meets is
/// `2 * 128 (R/256 + 2)^2 + 2 * 128 (R/256 + 2) + R^2/512`, and the smallest is `-R^2/512 - 129`.
pub(crate) const STEPPED_RADIUS: i32 = 1 << 19;
const _: () = {
    let radius = STEPPED_RADIUS as i64;
    let reach = radius / ONE as i64 + 2;
    assert!(256 * reach * reach + 256 * reach + radius * radius / 512 < 1 << 31);
};
