//! Gupta and Sproull's anti-aliased line: Bresenham's steps, and for each of three pixels in a column its distance from
//! the line, looked up in a table of a conical filter.
//!
//! In the first octant, with `v` the height of the line over the pixel that Bresenham chooses, and with the reciprocal
//! of `2 sqrt(dx^2 + dy^2)` taken once:
//!
//! ```text
//!                 distance along the normal
//!   y + 1     2 dx (1 - v) / (2 sqrt(dx^2 + dy^2))
//!   y         2 dx v       / (2 sqrt(dx^2 + dy^2))       2 dx v = d + dx where d < 0, d - dx otherwise
//!   y - 1     2 dx (1 + v) / (2 sqrt(dx^2 + dy^2))
//! ```
//!
//! A line one pixel wide whose middle is at distance `t` from the middle of a cone of radius 1 and volume 1 holds, with
//! `w = sqrt(1 - s^2)`,
//!
//! ```text
//!   F(t) = integral from t - 1/2 to t + 1/2 of   3/pi (w - s^2 ln((1 + w) / s))   ds
//! ```
//!
//! of it, which is what [`CONE`] says. That is another filter than the area of the pixel, wider and softer: a line
//! through pixel centres has 0.78 of full intensity. It is right by its own measure, and 18/255 off by that of exact areas in
//! the mean. The ends, which the paper gives tables of their own, are whole columns here, as in textbooks.

use micromath::F32Ext;

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::line::{
        bresenham::{Decision, East},
        display::{display, passed, steps_within},
    },
};

/// `F(i / 16)` in 255ths; 0 from 3/2 pixels on.
pub const CONE: [u8; 25] =
    [199, 198, 194, 188, 179, 169, 156, 142, 128, 112, 98, 84, 70, 58, 47, 37, 28, 21, 14, 9, 5, 3, 1, 0, 0];

/// Whose square root.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Root {
    /// libm's, right to the last bit.
    Libm,
    /// micromath's, a few per cent off.
    Micromath,
}

impl Root {
    pub(in crate::methods) fn sqrt(self, value: f32) -> f32 {
        match self {
            Self::Libm => libm::sqrtf(value),
            Self::Micromath => F32Ext::sqrt(value),
        }
    }
}

/// Draws between whole pixels in the first octant, 0 <= y2 - y1 <= x2 - x1.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [[x1, y1], [x2, y2]]: [[i32; 2]; 2],
    root: Root,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (dx, dy) = (x2.wrapping_sub(x1), y2.wrapping_sub(y1));
    let visible = steps_within(x1, false, dx.max(0), &clip.columns);
    if visible.is_empty() {
        return Ok(());
    }
    let length = root.sqrt(dx as f32 * dx as f32 + dy as f32 * dy as f32);
    let inv_denom = if length > 0.0 { 1.0 / (2.0 * length) } else { 0.0 };
    let two_dx_inv_denom = 2.0 * dx as f32 * inv_denom;
    let mut decision = Decision::new(dx, dy, East::BelowZero);
    let passed = passed(visible.start);
    let mut y = y1.wrapping_add(decision.pass(passed));
    let mut two_v_dx = 0_i32;
    for k in passed..visible.end {
        if k >= visible.start {
            let x = x1.wrapping_add_unsigned(k);
            let distance = two_v_dx as f32 * inv_denom;
            intensify(x, y, distance, clip, sink)?;
            if length > 0.0 {
                intensify(x, y.wrapping_add(1), two_dx_inv_denom - distance, clip, sink)?;
                intensify(x, y.wrapping_sub(1), two_dx_inv_denom + distance, clip, sink)?;
            }
        }
        let d = decision.d;
        let is_north_east = decision.step();
        two_v_dx = if is_north_east { d.wrapping_sub(dx) } else { d.wrapping_add(dx) };
        y = y.wrapping_add(is_north_east.into());
    }
    Ok(())
}

/// `IntensifyPixel`: what the cone around a pixel holds of a line at a distance.
#[inline(always)]
fn intensify<S: FragmentSink>(x: i32, y: i32, distance: f32, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let index = (distance.abs() * 16.0 + 0.5) as usize;
    let intensity = CONE.get(index).copied().unwrap_or(0);
    display(Fragment::covered(x, y, intensity), clip, sink)
}
