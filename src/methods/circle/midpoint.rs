//! The midpoint circle: the sign of `F(x, y) = x^2 + y^2 - r^2` between two pixels says which of them is nearer.
//!
//! ```text
//!       P---E             d = F(x + 1, y - 1/2)
//!        \  M   F < 0:    E,  d += 2 x + 3
//!         SE    F >= 0:   SE, d += 2 (x - y) + 5
//!
//!       d0 = F(1, r - 1/2) = 5/4 - r
//! ```
//!
//! Two pixels are never equally near: `r^2 - x^2` is whole, and `(y - 1/2)^2` is a quarter off. For the same reason it
//! does not matter whether `d0` has the quarter. `d` stays above `-2 r`, so that 32 bits do for any radius below 2^30, and
//! the 24 bits of an `f32` for one below 2^22.

use crate::{
    FragmentSink, PixelRect,
    methods::circle::{
        far,
        octant::{LONGEST_WALK, Plot, Style},
    },
};

/// The decision variable, as it begins and as it goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Decision {
    /// `5/4 - r`, as derived, in `f32`.
    Derived,
    /// `5 / 4 - r`, as printed: a quotient of integers, kept in an `f32`.
    Printed,
    /// `1 - r`, in integers.
    Integer,
    /// As printed where the second increment lost its last term: `2 (x - y)`.
    WithoutFive,
}

/// Draws a circle [xc, yc, r].
///
/// # Errors
///
/// The sink's.
pub fn circle<S: FragmentSink>(
    circle: [i32; 3],
    decision: Decision,
    style: Style,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [_, _, r] = circle;
    if r > LONGEST_WALK {
        return far::circle(circle, style, clip, sink);
    }
    let mut plot = Plot::new(circle, style, clip, sink);
    let printed = 5_i32 / 4;
    match decision {
        Decision::Derived => in_float(5.0 / 4.0 - r as f32, r, &mut plot)?,
        Decision::Printed => in_float(printed.wrapping_sub(r) as f32, r, &mut plot)?,
        Decision::Integer => in_integers(1_i32.wrapping_sub(r), 5, r, &mut plot)?,
        Decision::WithoutFive => in_integers(printed.wrapping_sub(r), 0, r, &mut plot)?,
    }
    plot.finish()
}

fn in_float<S: FragmentSink>(d0: f32, r: i32, plot: &mut Plot<'_, S>) -> Result<(), S::Error> {
    let (mut x, mut y, mut d) = (0_i32, r, d0);
    plot.axes(r)?;
    while y > x {
        if d < 0.0 {
            d += (2 * x + 3) as f32;
        } else {
            d += (2 * (x - y) + 5) as f32;
            y -= 1;
        }
        x += 1;
        plot.eight(x, y)?;
    }
    Ok(())
}

fn in_integers<S: FragmentSink>(d0: i32, five: i32, r: i32, plot: &mut Plot<'_, S>) -> Result<(), S::Error> {
    let (mut x, mut y, mut d) = (0_i32, r, d0);
    plot.axes(r)?;
    while y > x {
        if d < 0 {
            d = d.wrapping_add(2 * x + 3);
        } else {
            d = d.wrapping_add(2 * (x - y) + five);
            y -= 1;
        }
        x += 1;
        plot.eight(x, y)?;
    }
    Ok(())
}
