//! One colour: the average of the vertices'.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT), `FlatTri`: with the sum a of a channel,
//! `a = (a + a + 3) / 6`, which is a third of it, rounded to the nearest.

use crate::{FragmentSink, PixelRect};

use super::{super::number::Real, Corner, plane::Setup};

/// The average of three colours, for channels of 0 and more.
#[inline]
pub fn average<const N: usize>([c0, c1, c2]: [&[i32; N]; 3]) -> [i32; N] {
    let mut channels = *c0;
    for (channel, (c1, c2)) in channels.iter_mut().zip(c1.iter().zip(c2)) {
        let sum = channel.wrapping_add(*c1).wrapping_add(*c2);
        *channel = sum.wrapping_add(sum).wrapping_add(3) / 6;
    }
    channels
}

/// Fills the triangle with it.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn flat<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let [c0, c1, c2] = corners;
    let colour = average([&c0.attributes, &c1.attributes, &c2.attributes]);
    setup.scan::<N, 0, S>(&[], clip, sink, |_, []| (colour, 0))
}
