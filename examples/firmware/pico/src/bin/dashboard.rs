//! A gauge with a needle, a plot, icons and text, drawn on the display itself: no RAM but the stack.
#![cfg_attr(target_os = "none", no_std, no_main)]

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use spanfill_pico::dashboard::{self, Dashboard};

spanfill_pico::main!(draw);

fn draw<D: DrawTarget<Color = Rgb565>>(lcd: &mut D) -> Result<(), D::Error> {
    dashboard::draw(lcd, &Dashboard::new(62))
}
