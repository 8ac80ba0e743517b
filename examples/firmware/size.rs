//! One program for each thing that `examples/firmware/size.sh` measures: what it draws is named by the environment
//! variable `SPANFILL_SIZE` while it is built, words with spaces between them. Everything is compiled, whatever is
//! measured; what a program does not name is not in it.
//!
//! `stack` among the words makes a program that runs: it says how deep its stack went while it drew.

#![no_std]
#![no_main]

mod size_methods;
mod size_stack;
#[path = "../methods/variants/mod.rs"]
mod variants;

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use embedded_graphics::{
    geometry::Angle,
    image::GetPixel,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self as eg, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle, StyledDrawable},
};
use spanfill::{
    Blend, Circle, Cover, Dither, FillSegment, InPlace, Line, Linear, Over, PixelRows, Polygon, ReadBack, SeedFill,
    Shape, Triangle, Vertex,
    eg::{Style, StyleBuilder},
    prelude::*,
};

/// Whether the program is to draw something.
const fn draws(what: &str) -> bool {
    let (words, what) = (env!("SPANFILL_SIZE").as_bytes(), what.as_bytes());
    let (mut start, mut end) = (0, 0);
    while end <= words.len() {
        if end == words.len() || words[end] == b' ' {
            let mut same = end - start == what.len();
            let mut at = 0;
            while same && at < what.len() {
                same = words[start + at] == what[at];
                at += 1;
            }
            if same {
                return true;
            }
            start = end + 1;
        }
        end += 1;
    }
    false
}

/// No text: what a panic would print is not what is measured.
#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    if const { draws("stack") } {
        size_stack::fail();
    }
    loop {
        cortex_m::asm::nop();
    }
}

/// A target of which nothing is known but its size. What is drawn on it costs nothing.
struct Display(Rectangle);

impl Dimensions for Display {
    fn bounding_box(&self) -> Rectangle {
        self.0
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|pixel| {
            black_box(pixel);
        });
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        black_box(area);
        colours.into_iter().for_each(|colour| {
            black_box(colour);
        });
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        black_box((area, colour));
        Ok(())
    }
}

impl GetPixel for Display {
    type Color = Rgb565;

    fn pixel(&self, point: Point) -> Option<Rgb565> {
        black_box(point);
        black_box(None)
    }
}

impl PixelRows for Display {
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        black_box(start);
        black_box(None)
    }
}

const OUTLINE: &[Vertex] = &[
    Vertex::from_bits(40_000, 5_000),
    Vertex::from_bits(75_000, 60_000),
    Vertex::from_bits(5_000, 25_000),
    Vertex::from_bits(77_000, 26_000),
    Vertex::from_bits(9_000, 58_000),
];
/// What is measured is the code for any outline: the compiler does not get to see this one.
const POLYGON: Polygon<'static> = Polygon::new(OUTLINE);
const EDGES: usize = POLYGON.active_edges();
const COVERAGE_EDGES: usize = POLYGON.coverage_edges();

fn vertex(x: i32, y: i32) -> Vertex {
    black_box(Vertex::from_bits(x, y))
}

fn polygon() -> Polygon<'static> {
    Polygon::new(black_box(OUTLINE))
}

fn fill(shape: impl Shape, display: &mut Display) {
    let Ok(()) = shape.filled(black_box(Rgb565::RED)).draw(display);
}

fn cover<S: Cover + Copy>(shape: S, display: &mut Display) {
    blend(shape, Over(black_box(Rgb565::BLUE)), display);
}

fn blend<S: Cover + Copy>(shape: S, blend: impl Blend<Display>, display: &mut Display) {
    let Ok(()) = shape.antialiased(black_box(Rgb565::RED), blend).draw_on(display);
}

fn draw_shapes(display: &mut Display) {
    let triangle = Triangle::new(vertex(2_000, 3_000), vertex(70_000, 20_000), vertex(9_000, 55_000));
    let line = Line::new(vertex(1_000, 2_000), vertex(75_000, 50_000));
    let circle = Circle::from_bits(vertex(40_000, 30_000), black_box(20_000));
    if const { draws("triangle") } {
        fill(triangle, display);
    }
    if const { draws("line") } {
        fill(line, display);
    }
    if const { draws("circle") } {
        fill(circle, display);
    }
    if const { draws("polygon") } {
        if let Ok(polygon) = polygon().with_capacity::<EDGES>() {
            fill(polygon, display);
        }
    }
    if const { draws("triangle-aa") } {
        cover(triangle, display);
    }
    if const { draws("line-aa") } {
        cover(line, display);
    }
    if const { draws("circle-aa") } {
        cover(circle, display);
    }
    if const { draws("polygon-aa") } {
        if let Ok(polygon) = polygon().coverage_with::<COVERAGE_EDGES>() {
            cover(polygon, display);
        }
    }
    if const { draws("seed-fill") } {
        let mut stack = [FillSegment::EMPTY; 16];
        let seed = black_box(Point::new(160, 120));
        let _ = black_box(SeedFill::new(seed).draw(black_box(Rgb565::RED), display, &mut stack));
    }
    // The ways to mix, on the circle.
    if const { draws("blend-read-back") } {
        blend(circle, ReadBack, display);
    }
    if const { draws("blend-in-place") } {
        blend(circle, InPlace, display);
    }
    if const { draws("blend-dither") } {
        blend(circle, Dither, display);
    }
    if const { draws("blend-linear") } {
        blend(circle, Linear(Over(black_box(Rgb565::BLUE))), display);
    }
    if const { draws("blend-opacity") } {
        let blended = circle.antialiased(black_box(Rgb565::RED), Over(black_box(Rgb565::BLUE)));
        let Ok(()) = blended.opacity(black_box(100)).draw_on(display);
    }
}

/// embedded-graphics' primitives, filled and stroked: by itself, by the plug-in, and by the plug-in with anti-aliasing.
macro_rules! draw_primitives {
    ($display:expr, $($word:literal, $fill_too:literal => $primitive:expr;)*) => { $({
        if const { draws(concat!("theirs-", $word)) } {
            let builder = PrimitiveStyleBuilder::new().stroke_color(black_box(Rgb565::BLUE)).stroke_width(black_box(3));
            let style = if $fill_too { builder.fill_color(black_box(Rgb565::RED)).build() } else { builder.build() };
            let Ok(()) = $primitive.draw_styled(&style, $display);
        }
        if const { draws(concat!("plug-in-", $word)) } {
            let Ok(()) = $primitive.draw_styled(&plug_in_style($fill_too), $display);
        }
        if const { draws(concat!("plug-in-aa-", $word)) } {
            let style = plug_in_style($fill_too).antialiased(Over(black_box(Rgb565::BLACK)));
            let Ok(()) = $primitive.draw_styled(&style, $display);
        }
    })* };
}

fn plug_in_style(fill_too: bool) -> Style<Rgb565> {
    let builder = StyleBuilder::new().stroke_color(black_box(Rgb565::BLUE)).stroke_width(black_box(3));
    if fill_too { builder.fill_color(black_box(Rgb565::RED)).build() } else { builder.build() }
}

fn draw_with_embedded_graphics(display: &mut Display) {
    let point = |x, y| black_box(Point::new(x, y));
    let (corner, size) = (point(20, 30), black_box(Size::new(200, 150)));
    let angle = |degrees| black_box(Angle::from_degrees(degrees));
    let triangle = eg::Triangle::new(point(3, 4), point(250, 70), point(30, 220));
    let circle = eg::Circle::new(corner, black_box(150));
    let line = eg::Line::new(point(3, 4), point(300, 200));
    // The same that the crate's own shapes draw: filled in one colour, and lines of one pixel.
    if const { draws("theirs-triangle-filled") } {
        let Ok(()) = triangle.draw_styled(&PrimitiveStyle::with_fill(black_box(Rgb565::RED)), display);
    }
    if const { draws("theirs-circle-filled") } {
        let Ok(()) = circle.draw_styled(&PrimitiveStyle::with_fill(black_box(Rgb565::RED)), display);
    }
    if const { draws("theirs-line-thin") } {
        let Ok(()) = line.draw_styled(&PrimitiveStyle::with_stroke(black_box(Rgb565::RED), 1), display);
    }
    let points = black_box([Point::new(5, 5), Point::new(200, 30), Point::new(60, 200)]);
    draw_primitives! { display,
        "rectangle", true => Rectangle::new(corner, size);
        "rounded-rectangle", true => eg::RoundedRectangle::with_equal_corners(Rectangle::new(corner, size), black_box(Size::new(9, 9)));
        "circle", true => circle;
        "ellipse", true => eg::Ellipse::new(corner, size);
        "triangle", true => triangle;
        "line", false => line;
        "polyline", false => eg::Polyline::new(&points);
        "arc", false => eg::Arc::new(corner, black_box(150), angle(20.0), angle(250.0));
        "sector", true => eg::Sector::new(corner, black_box(150), angle(20.0), angle(250.0));
    }
}

fn draw() {
    let mut display = Display(black_box(Rectangle::new(Point::zero(), Size::new(320, 240))));
    draw_shapes(&mut display);
    draw_with_embedded_graphics(&mut display);
    size_methods::draw();
    black_box(&mut display);
}

#[cortex_m_rt::entry]
fn main() -> ! {
    if const { draws("stack") } {
        size_stack::run(draw);
    }
    draw();
    loop {
        cortex_m::asm::nop();
    }
}
