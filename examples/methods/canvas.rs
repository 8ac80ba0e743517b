//! A picture in memory, and as a PNG of few colours: the same bytes on every machine.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use std::{collections::HashMap, convert::Infallible, fs, io, path::Path};

use embedded_graphics::{
    geometry::{OriginDimensions, Size as PixelSize},
    image::GetPixel,
    mono_font::{MonoFont, MonoTextStyle, ascii::FONT_5X8, ascii::FONT_6X10, ascii::FONT_6X13_BOLD},
    pixelcolor::Rgb888,
    prelude::{Dimensions, DrawTarget, Drawable, Pixel, Point, RgbColor},
    primitives::Rectangle,
    text::{Baseline, Text},
};
use spanfill::{AntiAlias, Line, ReadBack, Vertex};

/// An opaque picture.
#[derive(Debug, Clone)]
pub(crate) struct Canvas {
    width: i32,
    height: i32,
    pixels: Vec<Rgb888>,
}

/// The text sizes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Size {
    Tiny,
    Small,
    Title,
}

impl Size {
    fn font(self) -> &'static MonoFont<'static> {
        match self {
            Self::Tiny => &FONT_5X8,
            Self::Small => &FONT_6X10,
            Self::Title => &FONT_6X13_BOLD,
        }
    }

    /// The advance of a letter.
    pub(crate) fn advance(self) -> i32 {
        self.font().character_size.width as i32
    }
}

impl Canvas {
    pub(crate) fn new(width: i32, height: i32, background: Rgb888) -> Self {
        Self { width, height, pixels: vec![background; (width * height) as usize] }
    }

    pub(crate) fn rect(&mut self, left: i32, top: i32, width: i32, height: i32, colour: Rgb888) {
        let size = PixelSize::new(width.max(0).unsigned_abs(), height.max(0).unsigned_abs());
        let Ok(()) = self.fill_solid(&Rectangle::new(Point::new(left, top), size), colour);
    }

    pub(crate) fn text(&mut self, text: &str, left: i32, top: i32, size: Size, colour: Rgb888) {
        let style = MonoTextStyle::new(size.font(), colour);
        let Ok(_) = Text::with_baseline(text, Point::new(left, top), style, Baseline::Top).draw(self);
    }

    /// An anti-aliased line of width 1 between points in pixels of this canvas.
    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), colour: Rgb888) {
        let line = Line::new(Vertex::new(from.0, from.1), Vertex::new(to.0, to.1));
        let Ok(()) = line.antialiased(colour, ReadBack).draw_on(self);
    }

    /// The bytes of a PNG with a palette; colours come to 5 bits a channel where they are too many.
    pub(crate) fn png(&self) -> Vec<u8> {
        let colours = |drop: u8| -> (Vec<[u8; 3]>, Vec<u8>) {
            let mask = u8::MAX << drop;
            let mut places = HashMap::new();
            let mut palette = Vec::new();
            let indices = self.pixels.iter().map(|colour| {
                let key = [colour.r() & mask, colour.g() & mask, colour.b() & mask];
                let place = *places.entry(key).or_insert_with(|| {
                    palette.push([colour.r(), colour.g(), colour.b()]);
                    palette.len() - 1
                });
                u8::try_from(place).unwrap_or(0)
            });
            let indices = indices.collect();
            (palette, indices)
        };
        let (palette, indices) = (0..8).map(colours).find(|(palette, _)| palette.len() <= 256).expect("one bit is few");
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width.unsigned_abs(), self.height.unsigned_abs());
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_palette(palette.concat());
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_compression(png::Compression::High);
        let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&indices));
        written.expect("memory takes every byte");
        bytes
    }

    pub(crate) fn save(&self, path: &Path) -> io::Result<()> {
        fs::write(path, self.png())
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> PixelSize {
        PixelSize::new(self.width.unsigned_abs(), self.height.unsigned_abs())
    }
}

impl GetPixel for Canvas {
    type Color = Rgb888;

    fn pixel(&self, point: Point) -> Option<Rgb888> {
        let is_inside = self.bounding_box().contains(point);
        is_inside.then(|| self.pixels[(point.y * self.width + point.x) as usize])
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let bounds = self.bounding_box();
        for Pixel(point, colour) in pixels.into_iter().filter(|Pixel(point, _)| bounds.contains(*point)) {
            self.pixels[(point.y * self.width + point.x) as usize] = colour;
        }
        Ok(())
    }
}
