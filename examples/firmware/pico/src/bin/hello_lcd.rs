//! The first thing on a display: `cargo run --bin hello_lcd` saves a picture, with `--target thumbv6m-none-eabi` it is firmware.
#![cfg_attr(target_os = "none", no_std, no_main)]

use embedded_graphics::{
    mono_font::MonoTextStyle, mono_font::ascii::FONT_10X20, pixelcolor::Rgb565, prelude::*, text::Text,
};
use spanfill::{Circle, Over, Triangle, prelude::*};

spanfill_pico::main!(hello);

fn hello<D: DrawTarget<Color = Rgb565>>(lcd: &mut D) -> Result<(), D::Error> {
    let (sky, sun, hill) = (Rgb565::new(4, 12, 16), Rgb565::CSS_GOLD, Rgb565::CSS_SEA_GREEN);
    lcd.clear(sky)?;
    Circle::new(Point::new(230, 80), 40).antialiased(sun, Over(sky)).draw(lcd)?;
    Triangle::new(Point::new(-40, 240), Point::new(120, 90), Point::new(300, 240))
        .antialiased(hill, Over(sky))
        .draw(lcd)?;
    Text::new("Hello, LCD!", Point::new(20, 40), MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE)).draw(lcd)?;
    Ok(())
}
