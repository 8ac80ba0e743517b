//! Over what the target shows.

use core::{hint::black_box, iter::once};

use embedded_graphics_core::{
    Pixel, draw_target::DrawTarget, geometry::Point, image::GetPixel, pixelcolor::PixelColor,
};

use crate::blend::{Blend, Mix};

/// Blends over what is there, on targets that can be read: framebuffers, bands.
///
/// Shapes may overlap in any order and opacity. A pixel that the target does not give stays as it is. What cannot be read, as
/// embedded-graphics-simulator's display, is shown a [`Framebuffer`](crate::Framebuffer) that can:
/// [`show`](crate::Framebuffer::show).
///
/// ```text
///   shown before    a   a   b    b    b
///   coverage        0   64  191  255  255
///   ReadBack        a   a+  b+   #    #        a+, b+ mixed with what was there, # the colour itself
/// ```
///
/// # Cost
///
/// One `pixel`, one [`over`](Mix::over) and one pixel written for each at the edges; spans in full colour are not read.
///
/// # Examples
///
/// embedded-graphics' `Framebuffer` can be read:
///
/// ```
/// use embedded_graphics::{
///     framebuffer::{Framebuffer, buffer_size},
///     image::GetPixel,
///     pixelcolor::{Rgb565, raw::LittleEndian},
///     prelude::*,
/// };
/// use spanfill::{Circle, ReadBack, prelude::*};
///
/// let mut frame =
///     Framebuffer::<Rgb565, _, LittleEndian, 40, 40, { buffer_size::<Rgb565>(40, 40) }>::new();
/// Circle::new(Point::new(15, 20), 9.5).antialiased(Rgb565::RED, ReadBack).draw_on(&mut frame)?;
/// Circle::new(Point::new(25, 20), 9.5).antialiased(Rgb565::BLUE, ReadBack).opacity(128).draw_on(&mut frame)?;
/// assert_eq!(frame.pixel(Point::new(10, 20)), Some(Rgb565::RED));
/// assert_eq!(frame.pixel(Point::new(20, 20)), Some(Rgb565::new(15, 0, 16)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct ReadBack;

impl ReadBack {
    /// Draws a run, each pixel by itself: what can be read is memory, where a pixel costs less than a window.
    #[inline(always)]
    pub(super) fn run_by<C: PixelColor, D: DrawTarget<Color = C> + GetPixel<Color = C>>(
        target: &mut D,
        start: Point,
        alphas: &[u8],
        mix: impl Fn(C, u8) -> C,
    ) -> Result<(), D::Error> {
        let mut point = start;
        for &alpha in alphas {
            match target.pixel(point) {
                Some(backdrop) => target.draw_iter(once(Pixel(point, mix(backdrop, alpha))))?,
                // Hardly ever within the bounding box. What the compiler cannot see through keeps it from unrolling the
                // loop: for runs of mostly one to three pixels that took a tenth more instructions (Cortex-M4) and
                // three times the code.
                None => black_box(()),
            }
            point.x = point.x.wrapping_add(1);
        }
        Ok(())
    }
}

impl<C: Mix, D: DrawTarget<Color = C> + GetPixel<Color = C>> Blend<D> for ReadBack {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        Self::run_by(target, start, alphas, move |backdrop, alpha| colour.over(backdrop, alpha))
    }
}
