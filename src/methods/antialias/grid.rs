//! n x n samples, each for an equal share of the pixel: at the centres of the squares that n lines and columns cut it into.

use crate::{
    FragmentSink, PixelRect,
    methods::antialias::{
        Error, Outline,
        sampled::{self, MOST, SampleColumn, SampleLine},
    },
};

/// How many samples, or times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// n = 1: the pixel's centre alone.
    One = 1,
    /// n = 2.
    Two = 2,
    /// n = 4.
    Four = 4,
    /// n = 8.
    Eight = 8,
    /// n = 16.
    Sixteen = 16,
}

impl Side {
    pub(super) const fn get(self) -> u8 {
        self as u8
    }
}

/// Draws an outline by n x n samples a pixel.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    side: Side,
    columns: &mut [SampleColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    let n = side.get();
    let half = 128 / i64::from(n);
    let weights = [1; MOST];
    let weights = weights.get(..n.into()).unwrap_or(&weights);
    let mut lines = [SampleLine { y: 0, x: half, weights }; MOST];
    for (line, i) in lines.iter_mut().zip(0..) {
        line.y = (2 * i + 1) * half;
    }
    sampled::draw(outline, lines.get(..n.into()).unwrap_or(&lines), columns, clip, sink)
}
