//! Four samples on a grid that is rotated, so that no two lie on one line or in one column.
//!
//! ```text
//!    +---------+
//!    |    .    |      in 1/8 pixel: (3, 1), (7, 3), (1, 5), (5, 7)
//!    |        .|      an upright or level edge that moves changes one sample at a time:
//!    |.        |      five shades with four samples, where 2 x 2 has three
//!    |     .   |
//!    +---------+
//! ```

use crate::{
    FragmentSink, PixelRect,
    methods::antialias::{
        Error, Outline,
        sampled::{self, SampleColumn, SampleLine},
    },
};

const LINES: [SampleLine<'static>; 4] = [
    SampleLine { y: 32, x: 3 * 32, weights: &[1] },
    SampleLine { y: 3 * 32, x: 7 * 32, weights: &[1] },
    SampleLine { y: 5 * 32, x: 32, weights: &[1] },
    SampleLine { y: 7 * 32, x: 5 * 32, weights: &[1] },
];

/// Draws an outline by four samples a pixel.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    columns: &mut [SampleColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    sampled::draw(outline, &LINES, columns, clip, sink)
}
