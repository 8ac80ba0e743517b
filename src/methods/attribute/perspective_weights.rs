//! Perspective-correct weights: `f_i = e_i / w_i`, divided by their sum.
//!
//! Source: the lecture notes "Rasterization", "Barycentric Perspective-Correct Interpolation Coordinates", after
//! Akenine-Möller and Hasselgren.
//!
//! ```text
//! alpha = f0 / (f0 + f1 + f2)      beta = f1 / (f0 + f1 + f2)      gamma = f2 / (f0 + f1 + f2)
//! s = alpha s0 + beta s1 + gamma s2
//! ```
//!
//! The same s as from s/w and 1/w, without a setup for each attribute, at three multiplications an attribute and pixel.
//! The area cancels and is never needed.

use crate::{FragmentSink, PixelRect};

use super::{super::number::Real, Corner, channels, plane::Setup};

/// Fills the triangle; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn perspective_weights<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let [w0, w1, w2] = corners.map(|corner| R::ONE / corner.w);
    let channels = channels(corners);
    setup.scan::<N, 0, S>(&[], clip, sink, |[e0, e1, e2], []| {
        let (f0, f1, f2) = (e0 * w0, e1 * w1, e2 * w2);
        let one_over_sum = R::ONE / (f0 + f1 + f2);
        let (alpha, beta, gamma) = (f0 * one_over_sum, f1 * one_over_sum, f2 * one_over_sum);
        (channels.map(|[s0, s1, s2]| (alpha * s0 + beta * s1 + gamma * s2).round()), 0)
    })
}
