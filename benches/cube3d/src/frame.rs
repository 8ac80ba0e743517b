//! A frame in memory, for everybody the same.

use std::convert::Infallible;

use embedded_graphics::{Pixel, pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use spanfill::PixelRows;

#[derive(Debug, Clone)]
pub(crate) struct Frame {
    pub(crate) width: usize,
    pub(crate) pixels: Vec<Rgb565>,
}

impl Frame {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self { width, pixels: vec![Rgb565::BLACK; width * height] }
    }

    pub(crate) fn height(&self) -> usize {
        self.pixels.len() / self.width
    }
}

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height() as u32)
    }
}

impl PixelRows for Frame {
    #[inline(always)]
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        let (x, y) = (start.x as usize, start.y as usize);
        if x >= self.width {
            return None;
        }
        self.pixels.get_mut(y * self.width + x..(y + 1) * self.width)
    }
}

impl DrawTarget for Frame {
    type Color = Rgb565;
    type Error = Infallible;

    #[inline(always)]
    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            if let Some([pixel, ..]) = self.row_from(point) {
                *pixel = colour;
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let mut colours = colours.into_iter();
        for y in area.rows() {
            let Some(row) = self.row_from(Point::new(area.top_left.x, y)) else { continue };
            let width = row.len().min(area.size.width as usize);
            for (pixel, colour) in row[..width].iter_mut().zip(&mut colours) {
                *pixel = colour;
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        for y in area.rows() {
            if let Some(row) = self.row_from(Point::new(area.top_left.x, y)) {
                row[..area.size.width as usize].fill(colour);
            }
        }
        Ok(())
    }
}
