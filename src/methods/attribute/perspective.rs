//! Perspective-correct interpolation: s/w and 1/w are planes over the screen, s is their quotient.
//!
//! Source: the lecture notes "Rasterization", "Perspective-Correct Interpolation Coordinates"; Heckbert and Moreton,
//! *Interpolation for polygon texture mapping and shading*, 1991; Blinn, *Hyperbolic interpolation*, 1992.
//!
//! ```text
//! s = InterpolatedValue(s/w) / InterpolatedValue(1/w)       s/w from 4/1 to 6/3, middle 3
//!                                                           1/w from 1/1 to 1/3, middle 2/3, so s is 4.5, not 5
//! ```
//!
//! A division a pixel, for all attributes together. With w at 0 nothing here is finite, and what is drawn is not
//! meant: such a triangle is to be clipped first.

use crate::{FragmentSink, PixelRect};

use super::{super::number::Real, Corner, channels, plane::Setup};

/// Fills the triangle; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn perspective<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let [w0, w1, w2] = corners.map(|corner| R::ONE / corner.w);
    let over_w = channels(corners).map(|[s0, s1, s2]| setup.plane([s0 * w0, s1 * w1, s2 * w2]));
    let one_over_w = setup.plane([w0, w1, w2]);
    setup.scan_both(&over_w, &[one_over_w], clip, sink, |_, values, [one_over_w]| {
        let w = R::ONE / one_over_w;
        (values.map(|value| (value * w).round()), 0)
    })
}
