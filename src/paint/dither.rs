//! What a fraction of a channel's step is rounded by.

/// Added to a channel in 1/65536 of a step before its fraction is cut off: one half for the nearest step, or an
/// ordered dither (B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", 1973), in 64
/// shades that repeat every 8 x 8 pixels of the screen.
#[inline]
pub(super) fn rounding(dithered: bool, row: i32, column: i32) -> i32 {
    if !dithered {
        return 1 << 15;
    }
    // Each halving of the place, from the whole pattern down, says two bits, from the lowest up: those of `x ^ y` and y.
    let (x, y) = (column & 7, row & 7);
    let mut number = 0;
    for bit in 0..3 {
        number = 4 * number + 2 * (((x ^ y) >> bit) & 1) + ((y >> bit) & 1);
    }
    (2 * number + 1) << 9
}
