//! A circle by 4-way symmetry: a root in each column of a quarter.
//!
//! `y = sqrt(r^2 - x^2)` for x = 1..r, and the same with either sign of both. Where y changes by more than a pixel from
//! column to column there are gaps. Filled, each column is drawn from -y to y.

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
    rounding: Rounding,
    style: Style,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [_, _, r] = circle;
    if r > LONGEST_WALK {
        return far::circle(circle, style, clip, sink);
    }
    let mut plot = Plot::new(circle, style, clip, sink);
    let r2 = r.wrapping_mul(r);
    match style {
        Style::Outline => {
            plot.pixel(0, r)?;
            plot.pixel(0, r.wrapping_neg())?;
        }
        Style::Filled => plot.column(0, r)?,
    }
    for x in 1..=r {
        let y = rounding.pixel(functions.sqrt(r2.wrapping_sub(x.wrapping_mul(x)) as f32));
        match style {
            Style::Outline => plot.four(x, y)?,
            Style::Filled => {
                plot.column(x, y)?;
                plot.column(-x, y)?;
            }
        }
    }
    Ok(())
}
