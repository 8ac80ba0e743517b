//! Triangles against points: what is smaller than a threshold both ways is a point, all else a triangle.

use crate::{
    FragmentSink, PixelRect, Vertex,
    methods::points::{mesh_points, mesh_triangles},
};

/// Draws a triangle, or the pixel that holds its centroid if its bounding box is below `threshold`, in 1/256 pixel, in
/// width and height.
///
/// # Errors
///
/// The sink's.
pub fn draw<S: FragmentSink>(
    triangle: &[Vertex; 3],
    threshold: u32,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let extent = |coordinates: [i32; 3]| {
        let low = coordinates.iter().copied().fold(i32::MAX, i32::min);
        let high = coordinates.iter().copied().fold(i32::MIN, i32::max);
        high.abs_diff(low)
    };
    let is_small =
        extent(triangle.map(|v| v.x.to_bits())) < threshold && extent(triangle.map(|v| v.y.to_bits())) < threshold;
    if is_small { mesh_points::draw(triangle, clip, sink) } else { mesh_triangles::draw(triangle, clip, sink) }
}
