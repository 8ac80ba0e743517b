//! One surface of more and more points: as triangles between them, and as splats.

use std::{f64::consts::PI, path::Path, time::Instant};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use spanfill::{
    Attributes as _, DepthBuffer, DepthTest, Gouraud, PixelRect, Triangle, Vertex,
    splat::{Model, Refinement, Splat, Squares, View},
};

use crate::{
    builder::build,
    chart,
    cloud::{UNIT, cloud, colour, height},
    frame::Frame,
};

const WIDTH: usize = 640;
const HEIGHT: usize = 480;
const BACKGROUND: Rgb565 = Rgb565::new(2, 4, 3);
const NEAR: i64 = 1 << 20;
const FOCAL: i64 = 560 * 256;
const MIDDLE: [i32; 2] = [WIDTH as i32 * 128, HEIGHT as i32 * 128];

/// What one way took for one number of points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    /// Of the picture, for each primitive that was drawn.
    pub(crate) pixels_each: f64,
    pub(crate) ms: f64,
    pub(crate) drawn: u32,
}

fn distance() -> i64 {
    (2.4 * UNIT) as i64
}

/// Lit from the upper left, behind the eye.
fn lit(colour: Rgb565, [x, y, z]: [i32; 3]) -> Rgb565 {
    let light = ((-x - y - 2 * z) * 6 / 16384).clamp(-2, 14) + 3;
    let part = |step: u8| (i32::from(step) * light / 16) as u8;
    Rgb565::new(part(colour.r()), part(colour.g()), part(colour.b()))
}

fn shade(splat: &Splat) -> Rgb565 {
    lit(splat.colour, splat.normal)
}

/// Circles of latitude with twice as many points as there are circles.
struct Mesh {
    circles: usize,
    points: Vec<([i32; 3], [i32; 3], Rgb565)>,
}

impl Mesh {
    fn new(circles: usize) -> Self {
        let at = |i: f64, j: f64| {
            let (latitude, longitude) = (PI * i / (circles - 1) as f64, PI * j / circles as f64);
            let (ring, z) = latitude.sin_cos();
            let direction = [ring * longitude.cos(), ring * longitude.sin(), z];
            direction.map(|part| part * height(direction))
        };
        let points = (0..circles * 2 * circles)
            .map(|index| {
                let (i, j) = ((index / (2 * circles)) as f64, (index % (2 * circles)) as f64);
                let here = at(i, j);
                let change = |di: f64, dj: f64| -> [f64; 3] {
                    let (from, to) = (at(i - di, j - dj), at(i + di, j + dj));
                    std::array::from_fn(|axis| to[axis] - from[axis])
                };
                let ([ax, ay, az], [bx, by, bz]) = (change(0.01, 0.0), change(0.0, 0.01));
                let normal = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
                let length = normal.iter().map(|part| part * part).sum::<f64>().sqrt().max(1e-30);
                let far = here.iter().map(|part| part * part).sum::<f64>().sqrt();
                (
                    here.map(|part| (part * UNIT) as i32),
                    normal.map(|part| (part / length * 16384.0) as i32),
                    colour(far),
                )
            })
            .collect();
        Self { circles, points }
    }

    /// How many triangles were drawn.
    fn draw(&self, frame: &mut Frame, depths: &mut DepthBuffer<'_>, seen: &mut Vec<(Vertex, u16, Rgb565)>) -> u32 {
        seen.clear();
        seen.extend(self.points.iter().map(|([x, y, z], normal, colour)| {
            let z = i64::from(*z) + distance();
            let on_screen = |part: i32, middle: i32| (i64::from(part) * FOCAL / z) as i32 + middle;
            let vertex = Vertex::from_bits(on_screen(*x, MIDDLE[0]), on_screen(*y, MIDDLE[1]));
            (vertex, (65535 - NEAR * 65535 / z) as u16, lit(*colour, *normal))
        }));
        let across = 2 * self.circles;
        let mut drawn = 0;
        for i in 0..self.circles - 1 {
            for j in 0..across {
                let next = (j + 1) % across;
                let corner = |i: usize, j: usize| seen[i * across + j];
                let (a, b, c, d) = (corner(i, j), corner(i, next), corner(i + 1, next), corner(i + 1, j));
                for corners in [[a, d, c], [a, c, b]] {
                    let [p, q, r] =
                        corners.map(|(vertex, _, _)| [vertex.x, vertex.y].map(|part| i64::from(part.to_bits())));
                    if (q[0] - p[0]) * (r[1] - p[1]) <= (r[0] - p[0]) * (q[1] - p[1]) {
                        continue;
                    }
                    let triangle = Triangle::from_vertices(corners.map(|(vertex, _, _)| vertex));
                    Gouraud::new(triangle, corners.map(|(_, _, colour)| colour))
                        .affine()
                        .shaded(|[r, g, b]: [i32; 3]| Rgb565::new(r as u8, g as u8, b as u8))
                        .depth_tested(corners.map(|(_, depth, _)| depth), DepthTest::LESS)
                        .draw_on(frame, depths);
                    drawn += 1;
                }
            }
        }
        drawn
    }
}

/// The fastest of some.
fn measure(
    repeat: u32,
    mut draw: impl FnMut(&mut Frame, &mut DepthBuffer<'_>) -> Result<u32, Box<dyn std::error::Error>>,
) -> Result<Measured, Box<dyn std::error::Error>> {
    let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
    let (mut frame, mut memory) = (Frame::new(WIDTH, HEIGHT), vec![0; WIDTH * HEIGHT]);
    let (mut best, mut drawn) = (f64::INFINITY, 0);
    for _ in 0..repeat {
        frame.pixels.fill(BACKGROUND);
        let mut depths = DepthBuffer::new(area, WIDTH, &mut memory)?;
        depths.clear(u16::MAX);
        let started = Instant::now();
        drawn = draw(&mut frame, &mut depths)?;
        best = best.min(started.elapsed().as_secs_f64() * 1000.0);
    }
    let covered = frame.pixels.iter().filter(|colour| **colour != BACKGROUND).count();
    Ok(Measured { pixels_each: covered as f64 / f64::from(drawn.max(1)), ms: best, drawn })
}

pub(crate) fn compare(file: &Path, repeat: u32) -> Result<(), Box<dyn std::error::Error>> {
    let eye = [0, 0, -i32::try_from(distance())?];
    let axes = [[16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
    let view = View::new(eye, axes, MIDDLE, i32::try_from(FOCAL)?, i32::try_from(NEAR)?)?;
    let screen = PixelRect { rows: 0..HEIGHT as i32, columns: 0..WIDTH as i32 };
    let mut lines: [(&str, Vec<Measured>); 3] =
        [("triangles", Vec::new()), ("splats, all of them", Vec::new()), ("splats, down to two pixels", Vec::new())];
    println!("| points | triangles | px each | ms | ns each | splats | px each | ms | ns each | down to 2 px | ms |");
    println!("|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for power in 3..=10 {
        let mesh = Mesh::new(1 << power);
        let mut seen = Vec::with_capacity(mesh.points.len());
        let triangles = measure(repeat, |frame, depths| Ok(mesh.draw(frame, depths, &mut seen)))?;
        let mut points = cloud(mesh.points.len());
        let bytes = build(&mut points);
        let model = Model::new(&bytes)?;
        let [all, pixels] = [0, 512].map(|threshold| {
            measure(repeat, |frame, depths| {
                let mut squares = Squares::new(frame, depths, shade);
                Ok(model.draw(&view, &screen, Refinement { threshold, budget: u32::MAX }, &mut squares)?)
            })
        });
        let (all, pixels) = (all?, pixels?);
        let cells = |m: &Measured| {
            let each = m.ms * 1e6 / f64::from(m.drawn.max(1));
            format!("{} | {:.2} | {:.2} | {each:.0}", m.drawn, m.pixels_each, m.ms)
        };
        println!(
            "| {} | {} | {} | {} | {:.2} |",
            mesh.points.len(),
            cells(&triangles),
            cells(&all),
            pixels.drawn,
            pixels.ms
        );
        for ((_, line), measured) in lines.iter_mut().zip([triangles, all, pixels]) {
            line.push(measured);
        }
    }
    std::fs::write(file, chart::svg(&lines)?)?;
    println!("\nsaved as {}", file.display());
    Ok(())
}
