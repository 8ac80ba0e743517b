//! 4 x 4 samples that count for more the nearer they are to the pixel's centre.
//!
//! ```text
//!     1 2 2 1
//!     2 3 3 2      of 32
//!     2 3 3 2
//!     1 2 2 1
//! ```

use crate::{
    FragmentSink, PixelRect,
    methods::antialias::{
        Error, Outline,
        sampled::{self, SampleColumn, SampleLine},
    },
};

const OUTER: &[u8] = &[1, 2, 2, 1];
const INNER: &[u8] = &[2, 3, 3, 2];

const LINES: [SampleLine<'static>; 4] = [
    SampleLine { y: 32, x: 32, weights: OUTER },
    SampleLine { y: 3 * 32, x: 32, weights: INNER },
    SampleLine { y: 5 * 32, x: 32, weights: INNER },
    SampleLine { y: 7 * 32, x: 32, weights: OUTER },
];

/// Draws an outline by weighted samples.
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
