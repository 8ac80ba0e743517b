//! A circle by 8-way symmetry: a root in each column of an eighth.
//!
//! x goes from 1 while it is less than y; where they meet, the diagonal has four points in place of eight. In the octant
//! the circle is flatter than a diagonal, so that nearest pixels leave no gap.

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
    let root = |x: i32| rounding.pixel(functions.sqrt(r2.wrapping_sub(x.wrapping_mul(x)) as f32));
    plot.axes(r)?;
    let mut x = 1;
    let mut y = root(x);
    while x < y {
        plot.eight(x, y)?;
        x += 1;
        y = root(x);
    }
    if x == y {
        match style {
            Style::Outline => plot.four(x, y)?,
            Style::Filled => plot.eight(x, y)?,
        }
    }
    plot.finish()
}
