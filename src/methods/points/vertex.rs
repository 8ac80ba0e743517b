//! A vertex as a pixel: `setPixel((int) Math.Round(x), (int) Math.Round(y))`.

use crate::{FragmentSink, PixelRect, methods::line::display::display_pixel};

/// Which pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// `Math.Round`: the nearest whole number, from exactly between two the even one.
    MathRound,
    /// `floor`: the pixel that holds the vertex.
    Floor,
}

/// Draws a vertex in pixels; NaN is 0, as in a cast.
///
/// # Errors
///
/// The sink's.
pub fn draw<S: FragmentSink>(
    vertex: [f64; 2],
    rounding: Rounding,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [x, y] = vertex.map(|at| match rounding {
        Rounding::MathRound => libm::rint(at) as i32,
        Rounding::Floor => libm::floor(at) as i32,
    });
    display_pixel(x, y, clip, sink)
}
