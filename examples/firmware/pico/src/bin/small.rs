//! An anti-aliased dashboard of 320 x 240 pixels in less than 8 KiB of RAM: one band, the driver's buffer, and the stack, which
//! `run.mjs` paints and measures.

#![no_std]
#![no_main]
#![allow(missing_docs, reason = "a program")]

use embedded_graphics::pixelcolor::Rgb565;
use panic_halt as _;
use rp2040_hal::entry;
use spanfill::{Bands, MsbFirst, Rows, buffer_size};
use spanfill_pico::{BACKGROUND, Picture, SCREEN, board, board::say, dashboard::Dashboard};

type Packed = Rows<MsbFirst>;

static mut BAND: [u8; buffer_size::<Rgb565, Packed>(320, 4)] = [0; 2560];

#[entry]
fn main() -> ! {
    #[allow(unsafe_code, reason = "taken here, once")]
    let band = unsafe { &mut *(&raw mut BAND) };
    let mut driver = [0; 64];
    let board::Board { bus, mut select, mut command, mut reset, mut timer, mut words, .. } = board::start();
    let words = &mut words;
    let dashboard = Dashboard::new(62);
    let mut lcd = board::lcd(&bus, &mut select, &mut command, &mut reset, &mut timer, &mut driver);
    let mut bands = Bands::<Rgb565, Packed, _, 1>::new([&mut band[..]], SCREEN, BACKGROUND).expect("a line at least");
    for picture in [Picture::SmoothStar, Picture::Dashboard] {
        say(words, "begin bands", picture.name());
        let _ = bands.draw(|band| picture.draw(band, &dashboard), |band| band.show(&mut lcd));
        say(words, "end", "");
    }
    say(words, "done", "");
    loop {
        cortex_m::asm::wfi();
    }
}
