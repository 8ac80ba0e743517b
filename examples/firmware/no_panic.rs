//! Proof by linking that the library has no panic path: this program calls all of it on values the compiler does not
//! know, and its panic handler needs a function that does not exist. If one panic were left in, it would not link.
//!
//! `examples/firmware/run.sh build` links it; there is nothing to run.

#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use spanfill::{
    ActiveEdge, ActiveEdges, BlockSink, Circle, FillRule, Line, PixelRect, Polygon, Shape, Span, SpanSink, Triangle,
    Turn, Vertex, prelude::*,
};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[allow(unsafe_code, reason = "declared, never defined: that is the point")]
    unsafe extern "C" {
        safe fn the_library_has_a_panic_path() -> !;
    }
    the_library_has_a_panic_path()
}

/// A display of unknown size and place.
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

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        black_box((area, colour));
        Ok(())
    }
}

/// Sinks that can fail.
struct Sink;

impl SpanSink for Sink {
    type Error = u8;

    fn span(&mut self, span: Span) -> Result<(), u8> {
        black_box(span);
        black_box(Ok(()))
    }
}

impl BlockSink for Sink {
    type Error = u8;

    fn block(&mut self, rows: core::ops::Range<i32>, columns: core::ops::Range<i32>) -> Result<(), u8> {
        black_box((rows, columns));
        black_box(Ok(()))
    }
}

fn push(shape: impl Shape, clip: &PixelRect, display: &mut Display) {
    black_box(shape.bounds());
    let _ = black_box(shape.spans(clip, &mut Sink));
    let _ = black_box(shape.blocks(clip, &mut Sink));
    let filled = shape.filled(Rgb565::RED);
    black_box(filled.bounding_box());
    let Ok(()) = filled.draw(display);
}

#[cortex_m_rt::entry]
fn main() -> ! {
    loop {
        let mut display = Display(black_box(Rectangle::zero()));
        let clip = &black_box(PixelRect { rows: 0..0, columns: 0..0 });
        let vertices = black_box([Vertex::from_bits(0, 0); 9]);
        let [a, b, c, ..] = vertices;
        let turn = Turn::from_degrees(black_box(0.0));

        push(Triangle::new(a, b, turn.about(c, a)), clip, &mut display);
        push(Line::new(a, Vertex::from(black_box(Point::zero()))), clip, &mut display);
        push(Circle::new(a, black_box(0)), clip, &mut display);
        push(Circle::new(Vertex::new(black_box(0.5_f32), black_box(1_i64)), black_box(0.0_f32)), clip, &mut display);

        let contours = [vertices.as_slice(), &vertices];
        let many = black_box(contours.as_slice());
        let mut edges = ActiveEdges::<8>::new();
        let mut slots = black_box([ActiveEdge::EMPTY; 16]);
        for polygon in [Polygon::new(&vertices), Polygon::with_contours(many).fill_rule(FillRule::EvenOdd)] {
            black_box(polygon.active_edges_at_most());
            if let Ok(polygon) = polygon.with_capacity::<8>() {
                push(polygon, clip, &mut display);
            }
            if let Ok(polygon) = polygon.in_scratch(edges.as_mut_slice()) {
                push(polygon, clip, &mut display);
            }
            match polygon.in_scratch(slots.get_mut(..black_box(16)).unwrap_or_default()) {
                Ok(polygon) => push(polygon, clip, &mut display),
                Err(error) => {
                    black_box(error);
                }
            }
        }
    }
}
