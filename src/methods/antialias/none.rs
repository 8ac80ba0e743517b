//! No anti-aliasing: a pixel is inside when its centre is.

use crate::{
    FragmentSink, PixelRect,
    methods::antialias::{Error, Outline, Side, grid, sampled::SampleColumn},
};

/// Draws an outline by one sample a pixel.
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
    grid::draw(outline, Side::One, columns, clip, sink)
}
