//! As `no_panic`, for what varies: attributes, paints, mosaics and splats have no panic path, or this would not link.

#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Gray4, Gray8, Rgb565},
    prelude::*,
    primitives::Rectangle,
};
use spanfill::{
    Affine, Barycentric, Circle, ConicalGradient, DepthBuffer, DepthTest, Filter, Fragment, FragmentSink, Gouraud,
    Hatch, InPlace, LinearGradient, Masked, Mosaic, MosaicCell, Over, Painted, Pattern, Perspective, PixelRect,
    PixelRows, Polygon, RadialGradient, Solid, Spread, Stop, Stops, Texture, Tile, Triangle, Vertex, Wrap, average,
    prelude::*,
    splat::{Model, Node, Refinement, Sphere, Splat, Squares, View, normal},
};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[allow(unsafe_code, reason = "declared, never defined: that is the point")]
    unsafe extern "C" {
        safe fn the_library_has_a_panic_path() -> !;
    }
    the_library_has_a_panic_path()
}

/// A display of unknown size and place that can be read.
struct Display(Rectangle, [Rgb565; 64]);

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
}

/// A picture of unknown size.
#[derive(Clone, Copy)]
struct Picture(Size);

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        self.0
    }
}

impl GetPixel for Picture {
    type Color = Rgb565;

    fn pixel(&self, point: Point) -> Option<Rgb565> {
        black_box(point);
        black_box(None)
    }
}

impl PixelRows for Display {
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        self.1.get_mut(black_box(start.x) as usize..)
    }
}

struct Fragments;

impl<const N: usize> FragmentSink<N> for Fragments {
    type Error = u8;

    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), u8> {
        black_box(fragment);
        black_box(Ok(()))
    }
}

/// Values that the compiler does not know.
fn unknown<T: Copy>(value: T) -> T {
    black_box(value)
}

fn attributes(display: &mut Display, memory: &mut [u16]) {
    let vertex = || Vertex::from_bits(unknown(0), unknown(0));
    let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
    let clip = PixelRect::from(unknown(Rectangle::zero()));
    let colours = unknown([Rgb565::RED; 3]);
    black_box(average(colours));
    let Ok(()) = Gouraud::new(triangle, colours).draw(display);
    let Ok(()) = Gouraud::new(triangle, colours).draw_on(display);
    let Ok(()) = Gouraud::packed(triangle, colours).draw(display);
    let Ok(()) = Gouraud::packed(triangle, colours).draw_on(display);
    let Ok(mut depths) = DepthBuffer::new(unknown(Rectangle::zero()), unknown(0), memory) else { return };
    depths.clear(unknown(0));
    black_box(depths.get(unknown(Point::zero())));
    let Ok(texture) = Texture::new(unknown(Picture(Size::zero())), Wrap::Clamp, Filter::Bilinear) else {
        return;
    };
    let texel = move |at: [i32; 2]| texture.sample(at).unwrap_or(Rgb565::RED);
    let values = unknown([[0; 2]; 3]);
    let affine = Affine::new(triangle, values);
    let _ = black_box(affine.fragments(&clip, &mut Fragments));
    affine.shaded(texel).draw_on(display);
    let Ok(()) = affine.shaded(texel).draw(display);
    let test = unknown(DepthTest::LESS);
    affine.shaded(texel).depth_tested(unknown([0; 3]), test).draw_on(display, &mut depths);
    let Ok(()) = affine.shaded(texel).depth_tested(unknown([0; 3]), test).draw(display, &mut depths);
    let Ok(seen) = Perspective::new(triangle, values, unknown([1; 3])) else { return };
    let seen = seen.tolerance(unknown(0));
    let _ = black_box(seen.fragments(&clip, &mut Fragments));
    let Ok(()) = seen.shaded(texel).draw(display);
    seen.shaded(texel).depth_tested(unknown([0; 3]), test).draw_on(display, &mut depths);
    if let Some(barycentric) = Barycentric::new(&triangle) {
        black_box(barycentric.contains(vertex()));
        black_box(barycentric.weights_at(vertex()).mix(unknown([0; 3])));
    }
}

fn paints(display: &mut Display, cells: &mut [MosaicCell<3>]) {
    let vertex = || Vertex::from_bits(unknown(0), unknown(0));
    let circle = Circle::new(vertex(), unknown(5));
    let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
    let stops = unknown([Stop::new(0, Rgb565::RED), Stop::new(9, Rgb565::BLUE)]);
    let Ok(stops) = Stops::new(&stops, unknown(Spread::Reflect)) else { return };
    let stops = if unknown(true) { stops.dithered() } else { stops };
    let linear = LinearGradient::new(vertex(), vertex(), stops);
    let radial = RadialGradient::new(vertex(), unknown(3), stops);
    let conical = ConicalGradient::new(vertex(), unknown(3), stops);
    let Ok(()) = circle.painted(linear).draw(display);
    circle.painted(radial).draw_on(display);
    let Ok(()) = circle.painted(conical).antialiased(InPlace).draw_on(display);
    let Ok(()) = circle.painted(Hatch::new(Hatch::CROSS, Rgb565::RED, Rgb565::BLUE)).draw(display);
    let focal = RadialGradient::elliptical(vertex(), [vertex(), vertex()], stops).with_focus(vertex(), unknown(5));
    circle.painted(focal).draw_on(display);
    let corners = unknown([Vertex::from_bits(0, 0); 5]);
    let Ok(polygon) = Polygon::new(&corners).coverage_with::<6>() else { return };
    let masked = Masked::new(polygon, Solid(Gray8::new(unknown(7))));
    let Ok(()) = Painted::new(masked, linear).antialiased(InPlace).draw_on(display);
    let _ = black_box(Mosaic::new(Tile::new(polygon, linear)).draw_on(display, Over(Rgb565::RED), cells));
    if let Ok(pattern) = Pattern::new(unknown(Picture(Size::zero())), unknown(Point::zero())) {
        let Ok(()) = circle.painted(pattern).draw(display);
    }
    let gouraud = Gouraud::new(triangle, unknown([Rgb565::RED; 3])).paint();
    let mosaic = Mosaic::new(Tile::new(circle, Solid(unknown(Rgb565::RED)))).with(Tile::new(triangle, gouraud));
    let _ = black_box(mosaic.draw_on(display, Over(Rgb565::RED), cells));
}

fn splats(display: &mut Display, memory: &mut [u16], bytes: &[u8]) {
    let Ok(mut depths) = DepthBuffer::new(unknown(Rectangle::zero()), unknown(0), memory) else { return };
    let Ok(model) = Model::new(bytes) else { return };
    let Ok(view) = View::new(unknown([0; 3]), unknown([[0; 3]; 3]), unknown([0; 2]), unknown(1), unknown(1)) else {
        return;
    };
    let screen = PixelRect::from(unknown(Rectangle::zero()));
    black_box((model.check().is_ok(), model.threshold_for(&view, &screen, unknown(7)).is_ok()));
    let mut squares = Squares::new(display, &mut depths, |splat: &Splat| splat.colour);
    let refinement = Refinement { threshold: unknown(0), budget: unknown(0) };
    let _ = black_box(model.draw(&view, &screen, refinement, &mut squares));
    let sphere = Sphere { centre: unknown([0; 3]), radius: unknown(0) };
    black_box((sphere.child(unknown(0)), sphere.encode(&unknown(sphere)), normal(unknown(0))));
    black_box(Node::from_bytes(unknown([0; 6])).to_bytes());
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let mut display = Display(unknown(Rectangle::zero()), [Rgb565::RED; 64]);
    let _ = unknown(Gray4::WHITE);
    let mut memory = [0; 64];
    attributes(&mut display, black_box(&mut memory));
    paints(&mut display, black_box(&mut [MosaicCell::EMPTY; 8]));
    splats(&mut display, black_box(&mut [0; 64]), black_box(&[]));
    loop {
        black_box(());
    }
}
