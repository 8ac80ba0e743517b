//! What a scene draws on.

use core::{convert::Infallible, fmt};

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    framebuffer::{Framebuffer, FramebufferError, Layout, PackedColor, Pages, Rows, Surface, Values, impl_in_place},
    span::BlockSink,
    target::{Canvas, PixelRows},
};

/// A part of the screen in memory: a draw target whose bounding box is that part, in the screen's coordinates. What is drawn
/// outside is cut.
///
/// It is readable, and takes what a [`Framebuffer`] takes.
pub struct Band<'b, C: PixelColor, L: Layout<C>> {
    frame: Framebuffer<C, L, &'b mut [L::Unit]>,
    top_left: Point,
}

impl<'b, C: PixelColor, L: Layout<C>> Band<'b, C, L> {
    /// A band for a part of the screen. The memory stays as it is; what of it is not needed is left alone.
    ///
    /// # Errors
    ///
    /// As of [`Framebuffer::new`].
    #[inline]
    pub fn new(units: &'b mut [L::Unit], part: &Rectangle) -> Result<Self, FramebufferError> {
        let frame = Framebuffer::new(units, part.size)?;
        Ok(Self { frame, top_left: part.top_left })
    }

    /// The memory of its pixels, line by line without gaps, as it goes to the display.
    #[inline]
    pub fn units(&self) -> &[L::Unit] {
        self.frame.units().get(..self.frame.needed()).unwrap_or_default()
    }

    /// Shows it on a target, where it belongs: one `fill_contiguous`, so one address window.
    ///
    /// # Errors
    ///
    /// The target's.
    #[inline]
    pub fn show<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.frame.show(self.top_left, target)
    }

    /// All of its memory in one colour, with the bits that are no pixels.
    #[inline(never)]
    pub(super) fn start(&mut self, background: C) {
        self.surface().clear_whole(background);
    }

    #[inline(always)]
    fn surface(&mut self) -> Surface<'_, C, L> {
        self.frame.surface_at(self.top_left)
    }
}

impl<C: PixelColor, L: Layout<C>> Dimensions for Band<'_, C, L> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(self.top_left, self.frame.grid().size())
    }
}

impl<C: PixelColor, L: Layout<C>> DrawTarget for Band<'_, C, L> {
    type Color = C;
    type Error = Infallible;

    #[inline]
    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.surface().draw_iter(pixels);
        Ok(())
    }

    #[inline]
    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colours: I) -> Result<(), Infallible> {
        self.surface().fill_contiguous(area, colours);
        Ok(())
    }

    /// In firmware one copy serves all that is drawn.
    #[cfg_attr(target_os = "none", inline(never))]
    #[cfg_attr(not(target_os = "none"), inline)]
    fn fill_solid(&mut self, area: &Rectangle, colour: C) -> Result<(), Infallible> {
        self.surface().fill_solid(area, colour);
        Ok(())
    }

    #[inline(never)]
    fn clear(&mut self, colour: C) -> Result<(), Infallible> {
        self.surface().clear(colour);
        Ok(())
    }
}

impl<C: PixelColor, L: Layout<C>> Canvas for Band<'_, C, L> {
    const IS_PART: bool = true;

    #[inline]
    fn solid(&mut self, colour: C) -> impl BlockSink<Error = Infallible> {
        self.surface().solid(colour)
    }
}

impl<C: PixelColor, L: Layout<C>> GetPixel for Band<'_, C, L> {
    type Color = C;

    #[inline]
    fn pixel(&self, point: Point) -> Option<C> {
        // What lies before the first is a huge unsigned number.
        let column = point.x.wrapping_sub(self.top_left.x).cast_unsigned();
        self.frame.get(column, point.y.wrapping_sub(self.top_left.y).cast_unsigned())
    }
}

impl<C: PixelColor> PixelRows for Band<'_, C, Values>
where
    Values: Layout<C, Unit = C>,
{
    #[inline]
    fn row_from(&mut self, start: Point) -> Option<&mut [C]> {
        self.surface().row_from(start)
    }
}

impl_in_place!(('b, C, O) Band<'b, C, Rows<O>>, Rows<O>, ());
impl_in_place!(('b, C, O) Band<'b, C, Pages<O>>, Pages<O>, ());

impl<C: PixelColor, L: Layout<C>> fmt::Debug for Band<'_, C, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Band").field(&self.bounding_box()).finish()
    }
}
