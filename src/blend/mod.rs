//! What colour results where a colour covers a pixel in part.

mod mix;
mod over;
mod read_back;

pub use mix::Mix;
pub use over::Over;
pub use read_back::ReadBack;

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point};

/// What colour results from this coverage of this colour here.
pub trait Blend<D: DrawTarget> {
    /// The colour that results at every point, if it is the same everywhere; asked once for a whole span.
    ///
    /// For `alpha` 255 it is the colour itself.
    fn everywhere(&self, colour: D::Color, alpha: u8) -> Option<D::Color>;

    /// The colour that results at one point; none leaves the pixel as it is.
    fn at(&self, target: &D, point: Point, colour: D::Color, alpha: u8) -> Option<D::Color>;
}
