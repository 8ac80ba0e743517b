//! Gouraud shading by barycentric weights, a quotient each at every pixel.
//!
//! Source: the lecture notes "Triangles" (barycentric coordinates): `c = alpha c0 + beta c1 + gamma c2`; the weights by
//! edge functions from the notes "Rasterization": `alpha = e0 / (2 area)`.
//!
//! Multiplications by weights cost three a channel and pixel where a plane costs an addition; nothing accumulates but
//! the edge functions.

use crate::{FragmentSink, PixelRect};

use super::{super::number::Real, Corner, channels, plane::Setup};

/// Fills the triangle; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn gouraud_barycentric<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let channels = channels(corners);
    setup.scan::<N, 0, S>(&[], clip, sink, |e, []| {
        let [alpha, beta, gamma] = e.map(|value| value * setup.scale);
        (channels.map(|[c0, c1, c2]| (alpha * c0 + beta * c1 + gamma * c2).round()), 0)
    })
}
