//! Over a background that is known.

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point};

use crate::blend::{Blend, Mix};

/// Blends over a background of one colour, on targets that cannot be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Over<C>(pub C);

impl<C: Mix, D: DrawTarget<Color = C>> Blend<D> for Over<C> {
    #[inline]
    fn everywhere(&self, colour: C, alpha: u8) -> Option<C> {
        Some(colour.over(self.0, alpha))
    }

    #[inline]
    fn at(&self, _: &D, _: Point, colour: C, alpha: u8) -> Option<C> {
        Some(colour.over(self.0, alpha))
    }
}
