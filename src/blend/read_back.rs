//! Over what the target shows.

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, image::GetPixel};

use crate::blend::{Blend, Mix};

/// Blends over what is there, on targets that can be read: framebuffers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct ReadBack;

impl<C: Mix, D: DrawTarget<Color = C> + GetPixel<Color = C>> Blend<D> for ReadBack {
    #[inline]
    fn everywhere(&self, colour: C, alpha: u8) -> Option<C> {
        (alpha == 255).then_some(colour)
    }

    #[inline]
    fn at(&self, target: &D, point: Point, colour: C, alpha: u8) -> Option<C> {
        Some(colour.over(target.pixel(point)?, alpha))
    }
}
