//! A target in memory, of a part of a screen, with a border that must stay as it is.

use std::convert::Infallible;

use embedded_graphics::{image::GetPixel, prelude::*, primitives::Rectangle};
use spanfill::{PixelRect, PixelRows};

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Memory<C> {
    area: Rectangle,
    pixels: Vec<C>,
}

const BORDER: usize = 9;

impl<C: PixelColor> Memory<C> {
    pub(crate) fn new(window: &PixelRect, colour: impl Fn(u32) -> C) -> Self {
        let area = Rectangle::new(
            Point::new(window.columns.start, window.rows.start),
            Size::new(window.columns.len() as u32, window.rows.len() as u32),
        );
        let pixels = (window.columns.len() + BORDER) * window.rows.len() + BORDER;
        Self { area, pixels: (0..pixels as u32).map(colour).collect() }
    }

    fn index(&self, point: Point) -> Option<usize> {
        let stride = self.area.size.width as usize + BORDER;
        self.area.contains(point).then(|| {
            let place = point - self.area.top_left;
            BORDER + place.y as usize * stride + place.x as usize
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
