//! A display on the host.

use std::{env, fs, path::PathBuf};

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

use crate::SCREEN;

/// Draws, and saves the picture: to the file that the program is told, or to one named after it. What ends in `.rgb565` has the
/// pixels as they go to a display, anything else is a PNG.
pub fn run(name: &str, draw: impl FnOnce(&mut SimulatorDisplay<Rgb565>)) {
    let mut lcd = SimulatorDisplay::new(SCREEN);
    draw(&mut lcd);
    let file = env::args_os().nth(1).map_or_else(|| PathBuf::from(format!("{name}.png")), PathBuf::from);
    if file.extension().is_some_and(|extension| extension == "rgb565") {
        fs::write(&file, lcd.to_be_bytes()).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    } else {
        let picture = lcd.to_rgb_output_image(&OutputSettings::default());
        picture.save_png(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
    println!("{}", file.display());
}
