//! Each triangle as one point: the pixel that holds its centroid.

use crate::{FragmentSink, PixelRect, Vertex, methods::line::display::display_pixel};

/// Draws the pixel that holds the centroid of a triangle.
///
/// # Errors
///
/// The sink's.
pub fn draw<S: FragmentSink>(triangle: &[Vertex; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [x, y] = [triangle.map(|vertex| vertex.x), triangle.map(|vertex| vertex.y)].map(|coordinates| {
        let sum: i64 = coordinates.iter().map(|coordinate| i64::from(coordinate.to_bits())).sum();
        sum.div_euclid(3 * 256) as i32
    });
    display_pixel(x, y, clip, sink)
}
