//! The same in bands of eight rows, 5 KiB: what lies below something else never shows, and every pixel goes over the bus once.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use spanfill::{Bands, Circle, FrameError, InPlace, MsbFirst, Rows, buffer_size, prelude::*};
use spanfill_pico::{
    BACKGROUND, SCREEN,
    dashboard::{self, Dashboard},
};

spanfill_pico::main!(draw);

type Packed = Rows<MsbFirst>;

fn draw<D: DrawTarget<Color = Rgb565>>(lcd: &mut D) -> Result<(), FrameError<Infallible, D::Error>> {
    let mut band = [0; buffer_size::<Rgb565, Packed>(320, 8)];
    let mut bands =
        Bands::<Rgb565, Packed, _, 1>::new([&mut band[..]], SCREEN, BACKGROUND).map_err(|_| FrameError::NoBuffer)?;
    let dashboard = Dashboard::new(62);
    bands.draw(
        |band| {
            dashboard::draw(band, &dashboard)?;
            // A band can be read: glass over everything.
            Circle::new(Point::new(230, 110), 60).antialiased(Rgb565::WHITE, InPlace).opacity(60).draw_on(band)
        },
        |band| band.show(lcd),
    )
}
