//! A circle by its angle: `x = xc + r cos a`, `y = yc + r sin a`, one pixel of arc a step.
//!
//! With steps of 1/r neighbouring points are at most a pixel apart, so that an outline has no gaps, and some pixels twice;
//! it is thicker than a pixel where a point falls into a corner between two. Filled, the right half is walked from top to
//! bottom, and each row is as wide as the widest point in it.

use core::f32::consts::{FRAC_PI_2, TAU};

use crate::{
    FragmentSink, PixelRect,
    methods::circle::{
        far,
        functions::{Functions, Rounding},
        octant::{LONGEST_WALK, Plot, Style},
    },
};

/// Draws a circle [xc, yc, r].
///
/// # Errors
///
/// The sink's.
pub fn circle<S: FragmentSink>(
    circle: [i32; 3],
    functions: Functions,
    style: Style,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [_, _, r] = circle;
    // In an `f32`, angles are further apart than pixels long before.
    if r > LONGEST_WALK {
        return far::circle(circle, style, clip, sink);
    }
    let mut plot = Plot::new(circle, style, clip, sink);
    let radius = r.max(0) as f32;
    let step = 1.0 / radius.max(1.0);
    let point = |angle: f32| {
        let (sin, cos) = functions.sin_cos(angle);
        [Rounding::Nearest.pixel(radius * cos), Rounding::Nearest.pixel(radius * sin)]
    };
    match style {
        Style::Outline => {
            for i in 0..(TAU / step) as u32 + 1 {
                let [x, y] = point(i as f32 * step);
                plot.pixel(x, y)?;
            }
        }
        Style::Filled => {
            let mut widest = point(-FRAC_PI_2);
            for i in 1..=(2.0 * FRAC_PI_2 / step) as u32 + 1 {
                let [x, y] = point((i as f32 * step - FRAC_PI_2).min(FRAC_PI_2));
                if y == widest[1] {
                    widest[0] = widest[0].max(x);
                } else {
                    plot.row(widest[0], widest[1])?;
                    widest = [x, y];
                }
            }
            plot.row(widest[0], widest[1])?;
        }
    }
    Ok(())
}
