//! A browser's canvas as a draw target: the bytes of an `ImageData`.

use core::convert::Infallible;

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};

use crate::variants::{HEIGHT, WIDTH};

/// The size of the page's canvases.
pub const SIZE: Size = Size::new(WIDTH as u32, HEIGHT as u32);

/// Red, green, blue and opacity of each pixel, row by row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Canvas {
    bytes: Vec<u8>,
}

impl Canvas {
    pub fn new() -> Self {
        Self { bytes: vec![255; 4 * (SIZE.width * SIZE.height) as usize] }
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The colour of the pixel that is `at` pixels behind the first one.
    pub fn set(&mut self, at: usize, colour: [u8; 3]) {
        self.bytes[4 * at..][..3].copy_from_slice(&colour);
    }
}

impl Default for Canvas {
    fn default() -> Self {
        Self::new()
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        SIZE
    }
}

fn bytes_of(colour: Rgb565) -> [u8; 4] {
    let colour = Rgb888::from(colour);
    [colour.r(), colour.g(), colour.b(), 255]
}

impl DrawTarget for Canvas {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let screen = self.bounding_box();
        for Pixel(point, colour) in pixels {
            if screen.contains(point) {
                let at = 4 * (point.y * WIDTH + point.x) as usize;
                self.bytes[at..at + 4].copy_from_slice(&bytes_of(colour));
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let Rectangle { top_left, size } = area.intersection(&self.bounding_box());
        let colour = bytes_of(colour);
        for y in top_left.y..top_left.y + size.height as i32 {
            let row = &mut self.bytes[4 * (y * WIDTH + top_left.x) as usize..][..4 * size.width as usize];
            row.as_chunks_mut().0.fill(colour);
        }
        Ok(())
    }
}
