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

/// Edges below this height (32768 pixels) are stepped; taller ones are divided afresh on every row.
///
/// A stepped edge keeps a remainder in `0..D`, `D = 256 dy`, and between two rows `-D..D`, in an `i32`.
pub(crate) const STEPPED_HEIGHT: u32 = 1 << 23;
const _: () = assert!((STEPPED_HEIGHT as i64 - 1) * (ONE as i64) < 1 << 31);

/// Edges that move by more columns a row (all there are) are divided afresh, too: their next step may leave `i32`.
pub(crate) const STEPPED_COLUMNS: u32 = 1 << 24;

/// How far from the origin (8192 pixels) the narrow zone reaches: there edges that start on a visible row are set up in
/// `i32`.
///
/// `dx` and `dy` are then at most 2^22. The remainder begins as `(128 - b) dy - t rem` with `0 <= b < 256`,
/// `-128 <= t <= 256` and `0 <= rem < dy`: in `-383 dy..=256 dy`. A line's first boundary may be `128 dx` from its end.
pub(crate) const NARROW_REACH: i32 = 1 << 21;
const _: () = assert!(2 * NARROW_REACH as i64 * 383 < 1 << 31);
const _: () = assert!(256 * (2 * NARROW_REACH as i64) < 1 << 31);
const _: () = assert!(NARROW_REACH as i64 + 128 * (2 * NARROW_REACH as i64) < 1 << 31);
const _: () = assert!(2 * (NARROW_REACH as u32) < STEPPED_HEIGHT);

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
