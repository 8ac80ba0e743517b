//! Proof by linking that framebuffers, bands and damage have no panic path, as `no_panic` is for the rest of the library.
//!
//! Futures are not here: that of an `async` function has a panic for whoever polls it after its end, put there by the compiler.
//!
//! `examples/firmware/run.sh build` links it; there is nothing to run.

#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use embedded_graphics::{
    image::{GetPixel, ImageDrawable},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use spanfill::{
    Band, Bands, BlockSink, Bounded, Canvas, Circle, Damage, Framebuffer, InPlace, Layout, LsbFirst, Mix, MsbFirst,
    PackedColor, Pages, ReadBack, Rows, Transfer, Transmit, Triangle, Values, Vertex, prelude::*,
};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[allow(unsafe_code, reason = "declared, never defined: that is the point")]
    unsafe extern "C" {
        safe fn the_library_has_a_panic_path() -> !;
    }
    the_library_has_a_panic_path()
}

/// A value that the compiler does not know.
fn any<T: Default>() -> T {
    black_box(T::default())
}

fn area() -> Rectangle {
    Rectangle::new(Point::new(any(), any()), Size::new(any(), any()))
}

/// Everything that can be drawn.
fn draw<C: PackedColor, D: Canvas<Color = C, Error = Infallible> + GetPixel<Color = C>>(target: &mut D) {
    let colour = || C::from_bits(any());
    let point = || Point::new(any(), any());
    let Ok(()) = target.clear(colour());
    let Ok(()) = target.fill_solid(&area(), colour());
    let Ok(()) = target.fill_contiguous(&area(), core::iter::repeat_with(colour).take(any()));
    let Ok(()) = target.draw_iter(core::iter::repeat_with(|| Pixel(point(), colour())).take(any()));
    let Ok(()) = target.solid(colour()).block(any::<i32>()..any(), any::<i32>()..any());
    let triangle = Triangle::new(point(), point(), point()).filled(colour());
    let Ok(()) = triangle.draw_on(target);
    let Ok(()) = Bounded::new(triangle).draw_on(target);
    let Ok(_) = Bounded::new(triangle).draw(target);
    black_box(target.pixel(point()));
}

fn frames<C, L>(units: &'static mut [u8])
where
    C: PackedColor + Mix,
    L: Layout<C, Unit = u8>,
{
    let size = || Size::new(any(), any());
    let Ok(mut frame) = Framebuffer::<C, L, _>::with_stride(&mut *units, size(), any()) else { return };
    draw(&mut frame);
    if let Some(mut view) = frame.view(&area()) {
        draw(&mut view);
    }
    let Ok(mut band) = Band::<C, L>::new(units, &area()) else { return };
    draw(&mut band);
    black_box(band.units());
}

/// DMA that is done when it is asked.
struct Dma<'u>(Option<&'u mut [u8]>);

impl<'u> Transmit<&'u mut [u8]> for Dma<'u> {
    type Transfer = Self;

    fn start(self, area: &Rectangle, buffer: &'u mut [u8], length: usize) -> Self {
        black_box((area, length));
        Self(Some(buffer))
    }
}

impl<'u> Transfer<&'u mut [u8]> for Dma<'u> {
    type Sender = Self;
    type Error = u8;

    fn wait(self) -> (Self, &'u mut [u8], Result<(), u8>) {
        (Self(None), self.0.unwrap_or_default(), black_box(Ok(())))
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let mut memory = [0_u8; 4096];
    let memory = black_box(&mut memory);
    #[allow(unsafe_code, reason = "never run")]
    let units = || unsafe { core::slice::from_raw_parts_mut(black_box(memory.as_ptr().cast_mut()), any()) };
    frames::<BinaryColor, Rows<MsbFirst>>(units());
    frames::<BinaryColor, Pages<LsbFirst>>(units());
    frames::<Gray2, Rows<LsbFirst>>(units());
    frames::<Gray4, Pages<MsbFirst>>(units());
    frames::<Gray8, Rows<MsbFirst>>(units());
    frames::<Rgb565, Rows<MsbFirst>>(units());
    frames::<Rgb888, Rows<LsbFirst>>(units());

    let mut pixels = [Rgb565::BLACK; 64];
    if let Ok(mut frame) = Framebuffer::<Rgb565, Values, _>::new(&mut pixels[..], Size::new(any(), any())) {
        draw(&mut frame);
        let circle = Circle::new(Vertex::from_bits(any(), any()), any::<i32>());
        let Ok(()) = circle.antialiased(Rgb565::RED, InPlace).draw_on(&mut frame);
        if let Ok(mut other) = Framebuffer::<Rgb565, Rows<MsbFirst>, _>::new(units(), Size::new(any(), any())) {
            let Ok(()) = circle.antialiased(Rgb565::RED, ReadBack).draw_on(&mut other);
            let Ok(()) = circle.antialiased(Rgb565::RED, InPlace).draw_on(&mut other);
            let Ok(()) = Bounded::new(circle.antialiased(Rgb565::RED, InPlace)).draw_on(&mut other);
            let Ok(()) = frame.draw_sub_image(&mut other, &area());
        }
    }

    let size = Size::new(any(), any());
    let Ok(bands) = Bands::<Rgb565, Rows<MsbFirst>, _, 2>::new([units(), units()], size, Rgb565::BLACK) else { stop() };
    let Ok(mut bands) = bands.with_rows(any()) else { stop() };
    let scene = |band: &mut Band<'_, Rgb565, Rows<MsbFirst>>| {
        black_box(band);
        black_box(Ok::<(), u8>(()))
    };
    let mut damage = Damage::<4>::new(size);
    damage.add(&area());
    damage.add_all();
    let _ = black_box(damage.redraw(|area| {
        bands.draw_area(area, scene, |band| {
            black_box(band.units());
            black_box(Ok::<(), u8>(()))
        })
    }));
    let (dma, drawn) = bands.draw_by_transfers(Dma(None), scene);
    let _ = black_box((dma.0, drawn));
    if let Some(buffer) = bands.take_buffer() {
        let _ = black_box(bands.give_back(buffer));
    }
    stop()
}

fn stop() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}
