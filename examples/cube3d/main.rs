//! The scene of `scene.rs` as an animation: `cargo run --release --example cube3d -- docs/cube3d.gif`.

mod scene;

use std::{convert::Infallible, fs::File, path::PathBuf, time::Instant};

use clap::Parser;
use embedded_graphics::{
    Pixel,
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use image::{
    Delay, Frame as Picture, RgbaImage,
    codecs::gif::{GifEncoder, Repeat},
};
use spanfill::{DepthBuffer, PixelRows};

#[derive(Parser)]
#[command(about = "Draws a textured cube and a lit ring, and saves them as an animation")]
struct Cli {
    /// The GIF to write
    out: PathBuf,
    /// Pixels
    #[arg(long, default_value_t = 200)]
    width: usize,
    /// Pixels
    #[arg(long, default_value_t = 150)]
    height: usize,
    /// Every how many frames one is shown
    #[arg(long, default_value_t = 2)]
    every: usize,
}

/// A frame in memory.
struct Frame {
    width: usize,
    pixels: Vec<Rgb565>,
}

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        Size::new(self.width as u32, (self.pixels.len() / self.width) as u32)
    }
}

impl PixelRows for Frame {
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        let (x, y) = (usize::try_from(start.x).ok()?, usize::try_from(start.y).ok()?);
        self.pixels.chunks_mut(self.width).nth(y)?.get_mut(x..)
    }
}

impl DrawTarget for Frame {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            if let Some([pixel, ..]) = self.row_from(point) {
                *pixel = colour;
            }
        }
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let Cli { out, width, height, every } = Cli::parse();
    let area = Rectangle::new(Point::zero(), Size::new(width as u32, height as u32));
    let (mut frame, mut memory) =
        (Frame { width, pixels: vec![Rgb565::BLACK; width * height] }, vec![0; width * height]);
    let mut gif = GifEncoder::new_with_speed(File::create(&out)?, 10);
    gif.set_repeat(Repeat::Infinite)?;
    let (mut drawing, mut triangles) = (0.0, 0);
    for index in (0..scene::FRAMES).step_by(every.max(1)) {
        frame.pixels.fill(Rgb565::new(2, 5, 4));
        let mut depths = DepthBuffer::new(area, width, &mut memory)?;
        let started = Instant::now();
        triangles += scene::draw(&mut frame, &mut depths, index);
        drawing += started.elapsed().as_secs_f64();
        let pixels = frame.pixels.iter().flat_map(|colour| {
            let colour = Rgb888::from(*colour);
            [colour.r(), colour.g(), colour.b(), 255]
        });
        let picture = RgbaImage::from_raw(width as u32, height as u32, pixels.collect()).ok_or("as many pixels")?;
        gif.encode_frame(Picture::from_parts(picture, 0, 0, Delay::from_numer_denom_ms(50 * every as u32, 1)))?;
    }
    let frames = scene::FRAMES as usize / every.max(1);
    println!("{} triangles and {:.3} ms a frame", triangles as usize / frames, drawing * 1000.0 / frames as f64);
    Ok(())
}
