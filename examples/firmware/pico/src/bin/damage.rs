//! A needle moves: only where it was and where it is now is drawn and sent again. The display tells the bytes.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::{convert::Infallible, fmt::Write as _};

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    text::Text,
};
use heapless::String;
use spanfill::{Bands, Damage, FrameError, MsbFirst, Rows, buffer_size, prelude::*};
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
    let mut damage = Damage::<4>::new(SCREEN);
    let mut needle = 20;
    let (mut frames, mut bytes) = (0, 0);
    damage.add_all();
    loop {
        let dashboard = Dashboard::new(needle);
        damage.redraw(|area| {
            bands.draw_area(
                area,
                |band| dashboard::draw(band, &dashboard),
                |band| {
                    bytes += band.units().len();
                    band.show(lcd)
                },
            )
        })?;
        if needle == 80 {
            break;
        }
        if frames == 0 {
            // All of it, once.
            bytes = 0;
        }
        frames += 1;
        for value in [needle, needle + 2] {
            damage.add(&dashboard::needle_shape(value).antialiased(BACKGROUND, spanfill::InPlace));
        }
        needle += 2;
    }
    let mut text = String::<64>::new();
    let _ = write!(text, "{} of {} bytes a frame", bytes / frames, buffer_size::<Rgb565, Packed>(320, 240));
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new(&text, Point::new(148, 236), style).draw(lcd).map_err(FrameError::Flush)?;
    Ok(())
}
