//! A target in memory.

use std::convert::Infallible;

use embedded_graphics::{image::GetPixel, prelude::*, primitives::Rectangle};
use spanfill::PixelRows;

/// A frame, or a part of a screen, with a border of pixels that must stay as they are.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Memory<C> {
    area: Rectangle,
    pub(crate) pixels: Vec<C>,
}

const BORDER: usize = 9;

impl<C: PixelColor> Memory<C> {
    pub(crate) fn new(area: Rectangle, colour: impl Fn(u32) -> C) -> Self {
        let stride = area.size.width as usize + 2 * BORDER;
        let pixels = (0..(stride * area.size.height as usize) as u32).map(colour).collect();
        Self { area, pixels }
    }

    fn index(&self, point: Point) -> Option<usize> {
        let stride = self.area.size.width as usize + 2 * BORDER;
        self.area.contains(point).then(|| {
            let place = point - self.area.top_left;
            place.y as usize * stride + BORDER + place.x as usize
        })
    }
}

impl<C> Dimensions for Memory<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> DrawTarget for Memory<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            let index = self.index(point).expect("nothing is drawn outside");
            self.pixels[index] = colour;
        }
        Ok(())
    }
}

impl<C: PixelColor> GetPixel for Memory<C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.index(point).map(|index| self.pixels[index])
    }
}

impl<C: PixelColor> PixelRows for Memory<C> {
    fn row_from(&mut self, start: Point) -> Option<&mut [C]> {
        let index = self.index(start)?;
        let width = self.area.top_left.x + self.area.size.width as i32 - start.x;
        Some(&mut self.pixels[index..index + width as usize])
    }
}
