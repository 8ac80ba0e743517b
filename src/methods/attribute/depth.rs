//! Depth: a plane over the screen, as z/w is what projection leaves of it.
//!
//! Source: the lecture notes "Rasterization", "Fragment data" and "per-pixel depth"; "6.837 Lecture 6" (MIT): "we'll also
//! interpolate other parameters such as the depth at each point on the triangle".
//!
//! In integers, 16 bits of depth leave 15 for a fraction in a word of 32; with 12, a step is cut to 2^-12, and n
//! pixels are off by up to n / 4096 of a level. C is the depth at the origin, which of a small steep triangle may be
//! anything: where it leaves the word it saturates, and no depth of that triangle is right.

use crate::{FragmentSink, PixelRect};

use super::{
    super::number::{Fixed, Number, Real},
    Corner,
    plane::{Plane, Setup},
};

/// Fills the triangle; depths are rounded to the nearest and clamped to 16 bits.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn depth<R: Real, const N: usize, S: FragmentSink>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let plane = setup.plane(corners.map(|corner| R::from_integer(corner.depth.into())));
    setup.scan::<0, 1, S>(&[plane], clip, sink, |_, [z]| ([], clamped(z.round())))
}

/// The same with an accumulator of `F` fraction bits in 32 bits, which wraps; coverage is still in floats.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn depth_fixed<const F: u32, const N: usize, S: FragmentSink>(
    corners: &[Corner<f64, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let Plane { a, b, c } = setup.plane(corners.map(|corner| f64::from(corner.depth)));
    let [a, b, c] = [a, b, c].map(Fixed::<i32, F>::from_setup);
    let PixelRect { rows, columns } = setup.bounds(clip);
    let half = Fixed(1 << (F - 1));
    let mut start = Fixed::plane(a, b, c, columns.start, rows.start, true).plus(half);
    for y in rows {
        let mut z = start;
        for x in columns.clone() {
            sink.visit(x, y);
            if setup.edges.iter().all(|edge| edge.at(x, y) >= 0.0) {
                let depth = clamped(z.0 >> F);
                sink.fragment(crate::Fragment { x, y, coverage: 255, depth, attributes: [] })?;
            }
            z = z.plus(a);
        }
        start = start.plus(b);
    }
    Ok(())
}

#[inline(always)]
fn clamped(depth: i32) -> u16 {
    u16::try_from(depth.max(0)).unwrap_or(u16::MAX)
}
