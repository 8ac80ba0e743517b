//! What colour results where a colour covers a pixel in part.

mod dither;
mod in_place;
mod lanes;
mod linear;
mod mix;
mod over;
mod read_back;
mod srgb;

pub use dither::Dither;
pub use in_place::InPlace;
pub use linear::{Linear, MixLinear};
pub use mix::Mix;
pub use over::Over;
pub use read_back::ReadBack;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

/// Draws one colour, more or less opaque, onto a target: how the edges of a shape are mixed with what is behind it.
///
/// | | the target must | what is behind | for |
/// |---|---|---|---|
/// | [`Over`] | only take pixels | one known colour | displays that cannot be read |
/// | [`ReadBack`] | have `GetPixel` | what it shows | framebuffers, bands |
/// | [`InPlace`] | have [`PixelRows`](crate::PixelRows) | what it shows | the same, faster |
/// | [`Dither`] | only take pixels | stays, pixel by pixel | one or two bits a pixel |
/// | [`Linear`] | as within it | as within it | [`Over`], [`ReadBack`] or [`InPlace`] as light adds up |
///
/// `alpha` is how opaque the colour is, in 255ths: how much of the pixel the shape covers, times its opacity. From 0,
/// which leaves what is behind as it is, to 255, the colour itself. [`AntiAliased`](crate::AntiAliased) fills what is
/// wholly covered and opaque by itself, without asking, and keeps to the target's bounding box.
///
/// A blend is a small value: it is copied to where the compiler can keep it in registers.
///
/// # Examples
///
/// One method is enough for any other background; here a sky that darkens upwards, row by row:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Blend, Over, Triangle, prelude::*};
///
/// #[derive(Clone, Copy)]
/// struct OverSky;
///
/// impl<D: DrawTarget<Color = Gray8>> Blend<D> for OverSky {
///     fn run(&self, target: &mut D, start: Point, colour: Gray8, alphas: &[u8]) -> Result<(), D::Error> {
///         let row = start.y.clamp(0, 63) as u8;
///         Over(Gray8::new(4 * row)).run(target, start, colour, alphas)
///     }
/// }
///
/// let mut display = MockDisplay::new();
/// let mountain = Triangle::new(Point::new(30, 8), Point::new(60, 50), Point::new(5, 45));
/// mountain.antialiased(Gray8::WHITE, OverSky).draw_on(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub trait Blend<D: DrawTarget>: Copy {
    /// Draws a pixel for each of `alphas`, of which there is at least one, from `start` to the right.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    fn run(&self, target: &mut D, start: Point, colour: D::Color, alphas: &[u8]) -> Result<(), D::Error>;

    /// Draws `width` pixels, of which there is at least one, in the colour itself, from `start` to the right.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    #[inline(always)]
    fn fill(&self, target: &mut D, start: Point, width: u32, colour: D::Color) -> Result<(), D::Error> {
        target.fill_solid(&Rectangle::new(start, Size::new(width, 1)), colour)
    }

    /// Draws `width` pixels, of which there is at least one, that are all alike, from `start` to the right.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    #[inline]
    fn span(&self, target: &mut D, start: Point, width: u32, colour: D::Color, alpha: u8) -> Result<(), D::Error> {
        let alphas = [alpha; PIECE];
        let mut start = start;
        let mut left = usize::try_from(width).unwrap_or(usize::MAX);
        while left > 0 {
            let piece = alphas.get(..left).unwrap_or(&alphas);
            self.run(target, start, colour, piece)?;
            start = right_of(start, piece.len());
            left -= piece.len();
        }
        Ok(())
    }
}

/// What does not go to a target in one piece goes in pieces of so many pixels.
pub(crate) const PIECE: usize = 32;

/// So many pixels to the right.
#[inline(always)]
pub(crate) fn right_of(point: Point, pixels: usize) -> Point {
    Point::new(point.x.wrapping_add_unsigned(u32::try_from(pixels).unwrap_or(0)), point.y)
}
