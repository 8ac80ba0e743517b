//! The same scene drawn by embedded-graphics' `PrimitiveStyle` and by this crate's `Style`, aliased and anti-aliased.
//!
//! `cargo run --release --example migration -- docs/migration.png` writes the three side by side, each pixel four by
//! four, and prints how many pixels of each primitive differ from embedded-graphics'.

mod dashboard;
mod differences;

use std::env;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};

use dashboard::{BACKGROUND, Kind, SIZE, draw};

/// Between the three pictures.
const GAP: u32 = 4;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let png = env::args().nth(1).unwrap_or_else(|| String::from("migration.png"));
    let kinds = [Kind::EmbeddedGraphics, Kind::Aliased, Kind::AntiAliased];
    let width = kinds.len() as u32 * (SIZE.width + GAP) - GAP;
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(width, SIZE.height));
    for (index, kind) in (0..).zip(kinds) {
        let left = index * (SIZE.width + GAP) as i32;
        let mut panel = display.cropped(&Rectangle::new(Point::new(left, 0), SIZE));
        panel.fill_solid(&Rectangle::new(Point::zero(), SIZE), BACKGROUND)?;
        draw(kind, &mut panel)?;
    }
    let settings = OutputSettingsBuilder::new().scale(4).build();
    display.to_rgb_output_image(&settings).save_png(&png)?;
    println!("{png}: embedded-graphics, spanfill, spanfill anti-aliased\n");
    differences::print();
    Ok(())
}
