//! Targets in memory that fill where a shape is walked.

use embedded_graphics_core::draw_target::DrawTarget;

use crate::span::BlockSink;

/// A draw target in memory that takes the blocks of a shape without a call of `fill_solid` for each: what
/// [`Filled::draw_on`](crate::Filled::draw_on) draws on.
///
/// ```text
///   draw      shape -block-> fill_solid -clip-> rows of memory       any target
///   draw_on   shape -block-> rows of memory                          a canvas: the shape has been clipped already
/// ```
pub trait Canvas: DrawTarget {
    /// Whether it is one of many parts that a scene is drawn on, as a band: most shapes are not on it, and are compared with its
    /// rows before anything else.
    const IS_PART: bool = false;

    /// What fills blocks in a colour. They must lie inside the bounding box, as those of a shape do that is clipped to it; what
    /// others do to the target's pixels is not said.
    fn solid(&mut self, colour: Self::Color) -> impl BlockSink<Error = Self::Error>;
}
