//! What the page's canvases must show, as the host draws it: one file a picture, red, green, blue, opacity.

use std::{env, fs, path::PathBuf};

use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use spanfill::{Framebuffer, MsbFirst, Rows};
use spanfill_web::{
    canvas::SIZE,
    catalogue,
    dashboard::{self, Dashboard},
    page::Page,
    subject::{KINDS, Subject},
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(env::args_os().nth(1).ok_or("expected FOLDER")?);
    // Not by the page's canvas, but by what a firmware has: a packed framebuffer.
    for value in [0, 37, 62, 100] {
        for library in ["spanfill", "embedded-graphics"] {
            let bytes = vec![0; 2 * (SIZE.width * SIZE.height) as usize];
            let mut frame = Framebuffer::<Rgb565, Rows<MsbFirst>, _>::new(bytes, SIZE)?;
            let dashboard = Dashboard::new(value);
            let Ok(()) = match library {
                "spanfill" => dashboard::draw(&mut frame, &dashboard),
                _ => dashboard::draw_by_embedded_graphics(&mut frame, &dashboard),
            };
            let pixels = frame.bounding_box().points().filter_map(|point| frame.pixel(point)).map(Rgb888::from);
            let bytes: Vec<u8> = pixels.flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b(), 255]).collect();
            fs::write(folder.join(format!("dashboard-{library}-{value}")), bytes)?;
        }
    }
    let mut page = Page::default();
    for kind in 0..KINDS.len() {
        let subject = Subject::new(kind, &[]).ok_or("a kind that is none")?;
        for ([family, method, option], choice) in catalogue::choices() {
            if page.draw(&subject, &choice) {
                fs::write(folder.join(format!("{kind}-{family}-{method}-{option}")), page.canvas().bytes())?;
            }
        }
    }
    Ok(())
}
