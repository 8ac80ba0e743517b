//! `y = mx + b`, worked out anew in each column.
//!
//! `m = dy / dx`, `b = y1 - m x1`, for `x1 < x2` and `m` from 0 to 1. In each column `yt = m xi + y1` is made a row.
//! A multiplication and a conversion a pixel, and right only to the 24 bits of an `f32`.

use crate::{
    FragmentSink, PixelRect,
    methods::line::display::{display_pixel, steps_within},
};

/// How `yt` becomes a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// `floor(yt)`, as printed.
    Floor,
    /// `floor(yt + 1/2)`.
    Nearest,
}

/// What becomes of the last column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Last {
    /// `xi < dx`, as printed.
    Dropped,
    /// `xi <= dx`. Of a vertical line, that is the only column, and its `m` is a division by 0: whatever row NaN is.
    Drawn,
}

/// Draws from (x1, y1) to (x2, y2): nothing if x1 > x2, and with gaps if the line is steep.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [[x1, y1], [x2, y2]]: [[i32; 2]; 2],
    rounding: Rounding,
    last: Last,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let dx = x2.wrapping_sub(x1);
    let dy = y2.wrapping_sub(y1);
    let m = dy as f32 / dx as f32;
    let last = match last {
        Last::Dropped => dx.saturating_sub(1),
        Last::Drawn => dx,
    };
    let half = match rounding {
        Rounding::Floor => 0.0,
        Rounding::Nearest => 0.5,
    };
    for xi in steps_within(x1, false, last, &clip.columns) {
        let yt = m * xi as f32 + y1 as f32;
        let yi = libm::floorf(yt + half);
        display_pixel(x1.wrapping_add_unsigned(xi), yi as i32, clip, sink)?;
    }
    Ok(())
}
