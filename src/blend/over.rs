//! Over a background that is known.

use core::iter::once;

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::blend::{Blend, Mix};

/// Blends over a background of one colour, on targets that cannot be read.
///
/// The pixels at the edges are mixed with the background's colour, whatever the target shows there: where shapes
/// overlap in another colour, a seam of the background remains, unless the upper one has its own background.
///
/// ```text
///   coverage        0   64  191  255  255
///   Over(BLACK)     .   -   +    #    #        . not sent, - dark, + brighter, # the colour itself
/// ```
///
/// # Cost
///
/// One [`over`](Mix::over) a pixel. A display behind a bus gets a run of edge pixels in one address window, by
/// `fill_contiguous`, and pixels that are all alike by `fill_solid`.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, Over, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Circle::new(Point::new(20, 20), 9.5).antialiased(Gray8::WHITE, Over(Gray8::new(40))).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(20, 20)), Some(Gray8::WHITE));
/// assert_eq!(display.get_pixel(Point::new(40, 20)), None);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Over<C>(pub C);

impl<C: PixelColor> Over<C> {
    /// Draws a run whose colours depend on its alphas only.
    #[inline(always)]
    pub(super) fn run_by<D: DrawTarget<Color = C>>(
        target: &mut D,
        start: Point,
        alphas: &[u8],
        mix: impl Fn(u8) -> C,
    ) -> Result<(), D::Error> {
        if let [alpha] = *alphas {
            // The same to a bus, and no walk over a rectangle to a framebuffer: most runs are as short.
            return target.draw_iter(once(Pixel(start, mix(alpha))));
        }
        let size = Size::new(u32::try_from(alphas.len()).unwrap_or(u32::MAX), 1);
        target.fill_contiguous(&Rectangle::new(start, size), alphas.iter().map(|&alpha| mix(alpha)))
    }
}

impl<C: Mix, D: DrawTarget<Color = C>> Blend<D> for Over<C> {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        Self::run_by(target, start, alphas, move |alpha| colour.over(self.0, alpha))
    }

    #[inline]
    fn span(&self, target: &mut D, start: Point, width: u32, colour: C, alpha: u8) -> Result<(), D::Error> {
        target.fill_solid(&Rectangle::new(start, Size::new(width, 1)), colour.over(self.0, alpha))
    }
}
