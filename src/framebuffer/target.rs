//! Framebuffers as draw targets.

use core::convert::Infallible;

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    framebuffer::{Framebuffer, Layout, Values},
    span::BlockSink,
    target::{Canvas, PixelRows},
};

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]>> OriginDimensions for Framebuffer<C, L, S> {
    #[inline]
    fn size(&self) -> Size {
        self.grid().size()
    }
}

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]> + AsMut<[L::Unit]>> DrawTarget for Framebuffer<C, L, S> {
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

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]> + AsMut<[L::Unit]>> Canvas for Framebuffer<C, L, S> {
    #[inline]
    fn solid(&mut self, colour: C) -> impl BlockSink<Error = Infallible> {
        self.surface().solid(colour)
    }
}

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]>> GetPixel for Framebuffer<C, L, S> {
    type Color = C;

    #[inline]
    fn pixel(&self, point: Point) -> Option<C> {
        // What is negative is a huge unsigned number.
        self.get(point.x.cast_unsigned(), point.y.cast_unsigned())
    }
}

impl<C: PixelColor, S: AsRef<[C]> + AsMut<[C]>> PixelRows for Framebuffer<C, Values, S>
where
    Values: Layout<C, Unit = C>,
{
    #[inline]
    fn row_from(&mut self, start: Point) -> Option<&mut [C]> {
        self.surface().row_from(start)
    }
}
