//! The digital differential analyzer: `y += m` in place of a multiplication.
//!
//! ```text
//! case 1, 0 < m < 1:   x(i+1) = x(i) + 1,     y(i+1) = y(i) + m
//! case 2, m > 1:       x(i+1) = x(i) + 1/m,   y(i+1) = y(i) + 1
//! ```
//!
//! Each addition rounds to 24 bits of `y`, so that what is lost in a step grows with `y` and adds up: where `y` is below
//! 2^k, a step loses at most 2^(k-25), and n steps n times that. With 16 fraction bits it is the rounding of `m` that
//! adds up, to n/2^17. Lines are wrong from a length of some 2^11 and 2^10 pixels on (`tests/methods/line.txt`); where a
//! line passes exactly between two pixels, from the start.

use crate::{
    FragmentSink, PixelRect,
    methods::line::{
        by_transformation::{Octant, Transformed},
        display::{display_pixel, passed, steps_within},
    },
};

/// How `DisplayPixel(int, int)` takes a `float`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Conversion {
    /// C's own: the fraction is cut off, towards 0.
    Truncated,
    /// To the nearest pixel, halves down the screen.
    Nearest,
}

impl Conversion {
    fn pixel(self, y: f32) -> i32 {
        match self {
            Self::Truncated => y as i32,
            Self::Nearest => libm::floorf(y + 0.5) as i32,
        }
    }
}

/// The printed code, which is case 1 for `x1 <= x2`: steep lines have gaps, lines to the left are one pixel.
///
/// # Errors
///
/// The sink's.
pub fn as_printed<S: FragmentSink>(
    [[x1, y1], [x2, y2]]: [[i32; 2]; 2],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let dx = x2.wrapping_sub(x1);
    let dy = y2.wrapping_sub(y1);
    let m = dy as f32 / dx as f32;
    walk([x1, y1], dx.max(0), m, Conversion::Truncated, clip, sink)
}

/// Both cases, for lines in every direction: they are drawn from the end that comes first on the longer axis.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [start, end]: [[i32; 2]; 2],
    conversion: Conversion,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let dx = end[0].wrapping_sub(start[0]);
    let dy = end[1].wrapping_sub(start[1]);
    let m = dy as f32 / dx as f32;
    if dx.unsigned_abs() >= dy.unsigned_abs() {
        let first = if dx < 0 { end } else { start };
        walk(first, dx.saturating_abs(), m, conversion, clip, sink)
    } else {
        let [x, y] = if dy < 0 { end } else { start };
        let transposed = PixelRect { rows: clip.columns.clone(), columns: clip.rows.clone() };
        let mut sink = Transformed::new(Octant { transpose: true, ..Octant::FIRST }, sink);
        walk([y, x], dy.saturating_abs(), 1.0 / m, conversion, &transposed, &mut sink)
    }
}

/// Case 1: columns `x1` to `x1 + dx`.
fn walk<S: FragmentSink>(
    [x1, y1]: [i32; 2],
    dx: i32,
    m: f32,
    conversion: Conversion,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let visible = steps_within(x1, false, dx, &clip.columns);
    if visible.is_empty() {
        return Ok(());
    }
    let passed = passed(visible.start);
    let mut y = if passed == 0 { y1 as f32 } else { y1 as f32 + m * passed as f32 };
    for _ in passed..visible.start {
        y += m;
    }
    for k in visible {
        // The printed code draws (x1, y1) before it makes a float of it; up to 2^24 that is the same.
        display_pixel(x1.wrapping_add_unsigned(k), conversion.pixel(y), clip, sink)?;
        y += m;
    }
    Ok(())
}

/// Both cases with 16 bits behind the binary point, in 32: right for |y| < 2^15, nearest.
///
/// # Errors
///
/// The sink's.
pub fn fixed<S: FragmentSink>([start, end]: [[i32; 2]; 2], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let dx = end[0].wrapping_sub(start[0]);
    let dy = end[1].wrapping_sub(start[1]);
    if dx.unsigned_abs() >= dy.unsigned_abs() {
        let first = if dx < 0 { end } else { start };
        walk_fixed(first, dx, dy, clip, sink)
    } else {
        let [x, y] = if dy < 0 { end } else { start };
        let transposed = PixelRect { rows: clip.columns.clone(), columns: clip.rows.clone() };
        let mut sink = Transformed::new(Octant { transpose: true, ..Octant::FIRST }, sink);
        walk_fixed([y, x], dy, dx, &transposed, &mut sink)
    }
}

fn walk_fixed<S: FragmentSink>(
    [x1, y1]: [i32; 2],
    dx: i32,
    dy: i32,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    // |dy| <= |dx|: at most 2^16, but for a point.
    let m = ((i64::from(dy) << 16) + i64::from(dx) / 2).checked_div(i64::from(dx)).unwrap_or(0) as i32;
    let visible = steps_within(x1, false, dx.saturating_abs(), &clip.columns);
    let mut y = y1.wrapping_shl(16).wrapping_add(1 << 15).wrapping_add(m.wrapping_mul(visible.start.cast_signed()));
    for k in visible {
        display_pixel(x1.wrapping_add_unsigned(k), y >> 16, clip, sink)?;
        y = y.wrapping_add(m);
    }
    Ok(())
}
