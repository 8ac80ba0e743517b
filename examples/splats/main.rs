//! Models of points: builds one of any size from a formula, draws it at several budgets, and tells how fast.
//!
//! `cargo run --release --example splats -- --points 15000000 --pictures target/splats`

mod builder;
mod cloud;

use std::{convert::Infallible, path::PathBuf, time::Instant};

use clap::Parser;
use embedded_graphics::{
    Pixel,
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use spanfill::{
    DepthBuffer, PixelRect, PixelRows,
    splat::{Model, Refinement, Splat, Squares, View},
};

use builder::build;
use cloud::{UNIT, cloud};

#[derive(Parser)]
#[command(about = "Builds a model of points from a formula and draws it at several budgets")]
struct Cli {
    /// How many points the model has
    #[arg(long, default_value_t = 200_000)]
    points: usize,
    /// A file to keep the model in: read where it is there, written where not
    #[arg(long)]
    model: Option<PathBuf>,
    /// Splats to draw at most, each time; all of them at last
    #[arg(long, value_delimiter = ',', default_values_t = [130_712, 259_975, 1_017_149])]
    budgets: Vec<u32>,
    /// A folder for a picture of each, and one of the last four in half their size
    #[arg(long)]
    pictures: Option<PathBuf>,
    /// How often each is drawn; the fastest counts
    #[arg(long, default_value_t = 5)]
    repeat: u32,
}

const WIDTH: usize = 640;
const HEIGHT: usize = 480;

/// A frame in memory.
struct Frame(Vec<Rgb565>);

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl PixelRows for Frame {
    #[inline(always)]
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        let (x, y) = (start.x as usize, start.y as usize);
        if x >= WIDTH || y >= HEIGHT { None } else { self.0.get_mut(y * WIDTH + x..(y + 1) * WIDTH) }
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

/// Lit from the upper left, behind the eye.
fn shade(splat: &Splat) -> Rgb565 {
    let [x, y, z] = splat.normal;
    let light = ((-x - y - 2 * z) * 6 / 16384).clamp(-2, 14) + 3;
    let lit = |step: u8| (i32::from(step) * light / 16) as u8;
    Rgb565::new(lit(splat.colour.r()), lit(splat.colour.g()), lit(splat.colour.b()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cli = Cli::parse();
    let bytes = match &cli.model {
        Some(file) if file.exists() => std::fs::read(file)?,
        file => {
            let started = Instant::now();
            let mut points = cloud(cli.points);
            let bytes = build(&mut points);
            println!("built from {} points in {:.1} s", points.len(), started.elapsed().as_secs_f64());
            if let Some(file) = file {
                std::fs::write(file, &bytes)?;
            }
            bytes
        }
    };
    let model = Model::new(&bytes)?;
    let started = Instant::now();
    model.check()?;
    let each = bytes.len() as f64 / f64::from(model.nodes());
    println!("{} nodes, {each:.2} bytes each, checked in {:.2} s", model.nodes(), started.elapsed().as_secs_f64());

    // From the front, a little above.
    let distance = (2.4 * UNIT) as i32;
    let axes = [[16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
    let middle = [WIDTH as i32 * 128, HEIGHT as i32 * 128];
    let view = View::new([0, 0, -distance], axes, middle, 560 * 256, 1 << 20)?;
    let screen = PixelRect { rows: 0..HEIGHT as i32, columns: 0..WIDTH as i32 };
    let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
    let (mut frame, mut memory) = (Frame(vec![Rgb565::BLACK; WIDTH * HEIGHT]), vec![0; WIDTH * HEIGHT]);

    let mut pictures = Vec::new();
    println!("| splats | threshold, px | ms | million splats a second |\n|--:|--:|--:|--:|");
    for budget in cli.budgets.iter().copied().chain([u32::MAX]) {
        let threshold = if budget == u32::MAX { 0 } else { model.threshold_for(&view, &screen, budget)?.0 };
        let (mut drawn, mut best) = (0, f64::INFINITY);
        for _ in 0..cli.repeat {
            frame.0.fill(Rgb565::new(2, 4, 3));
            let mut depths = DepthBuffer::new(area, WIDTH, &mut memory)?;
            depths.clear(u16::MAX);
            let started = Instant::now();
            let mut squares = Squares::new(&mut frame, &mut depths, shade);
            drawn = model.draw(&view, &screen, Refinement { threshold, budget }, &mut squares)?;
            best = best.min(started.elapsed().as_secs_f64());
        }
        let rate = f64::from(drawn) / best / 1e6;
        println!("| {drawn} | {:.2} | {:.2} | {rate:.1} |", f64::from(threshold) / 256.0, best * 1000.0);
        if let Some(folder) = &cli.pictures {
            std::fs::create_dir_all(folder)?;
            let pixel = |colour: &Rgb565| {
                let colour = Rgb888::from(*colour);
                [colour.r(), colour.g(), colour.b()]
            };
            let pixels: Vec<u8> = frame.0.iter().flat_map(pixel).collect();
            let name = if budget == u32::MAX { "all.png".into() } else { format!("{budget}.png") };
            image::save_buffer(folder.join(name), &pixels, WIDTH as u32, HEIGHT as u32, image::ColorType::Rgb8)?;
            pictures.push(pixels);
        }
    }
    if let (Some(folder), Some(four)) = (&cli.pictures, pictures.last_chunk::<4>()) {
        let pixels = overview(four);
        let file = folder.join("overview.png");
        image::save_buffer(file, &pixels, WIDTH as u32, HEIGHT as u32, image::ColorType::Rgb8)?;
    }
    Ok(())
}

/// Four pictures in the place of one, each pixel the mean of four.
fn overview(pictures: &[Vec<u8>; 4]) -> Vec<u8> {
    let mut pixels = Vec::with_capacity(WIDTH * HEIGHT * 3);
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let picture = &pictures[2 * (y / (HEIGHT / 2)) + x / (WIDTH / 2)];
            let (x, y) = (x % (WIDTH / 2) * 2, y % (HEIGHT / 2) * 2);
            for channel in 0..3 {
                let at = |x: usize, y: usize| u16::from(picture[(y * WIDTH + x) * 3 + channel]);
                pixels.push(((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1) + 2) / 4) as u8);
            }
        }
    }
    pixels
}
