//! Gouraud shading by plane equations, in floats: an accumulator for each channel.
//!
//! Source: Gouraud, *Continuous shading of curved surfaces*, 1971; in this form the lecture notes "CISC 440/640 Lecture
//! 13: Scan Converting Triangles" (Delaware, 2015), `SmoothTri` in doubles. Screen space, so it is what those notes and
//! perspective disagree on: see [`perspective`](super::perspective).
//!
//! Two multiplications a channel and vertex, then an addition a channel and pixel. Accumulators round at each step, by
//! half a spacing of floats near 255: 2^-46 in `f64`, 2^-17 in `f32`.

use crate::{FragmentSink, PixelRect};

use super::{super::number::Real, Corner, channels, plane::Setup};

/// Fills the triangle; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn gouraud_planes<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let planes = channels(corners).map(|channel| setup.plane(channel));
    setup.scan(&planes, clip, sink, |_, values| (values.map(Real::round), 0))
}
