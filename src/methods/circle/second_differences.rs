//! The midpoint circle by second differences: what is added to `d` is not worked out but stepped, too.
//!
//! With `deltaE = 2 x + 3` and `deltaSE = 2 (x - y) + 5`, one step changes
//!
//! ```text
//!          deltaE    deltaSE
//!   E       + 2        + 2        three additions a step, no multiplication
//!   SE      + 2        + 4
//! ```

use crate::{
    FragmentSink, PixelRect,
    methods::circle::{
        far,
        octant::{LONGEST_WALK, Plot, Style},
    },
};

/// Draws a circle [xc, yc, r].
///
/// # Errors
///
/// The sink's.
pub fn circle<S: FragmentSink>(circle: [i32; 3], style: Style, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [_, _, r] = circle;
    if r > LONGEST_WALK {
        return far::circle(circle, style, clip, sink);
    }
    let mut plot = Plot::new(circle, style, clip, sink);
    let (mut x, mut y, mut d) = (0_i32, r, 1_i32.wrapping_sub(r));
    let mut delta_e = 3_i32;
    let mut delta_se = 5_i32.wrapping_sub(r.wrapping_mul(2));
    plot.axes(r)?;
    while y > x {
        if d < 0 {
            d = d.wrapping_add(delta_e);
            delta_se = delta_se.wrapping_add(2);
        } else {
            d = d.wrapping_add(delta_se);
            delta_se = delta_se.wrapping_add(4);
            y -= 1;
        }
        delta_e = delta_e.wrapping_add(2);
        x += 1;
        plot.eight(x, y)?;
    }
    plot.finish()
}
