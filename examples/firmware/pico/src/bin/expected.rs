//! What the display must show, as the host draws it: one file a picture, RGB565, big-endian, row by row.

#![allow(missing_docs, reason = "a program")]

fn main() -> Result<(), Box<dyn std::error::Error>> {
    use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
    use spanfill::{Framebuffer, MsbFirst, Rows};
    use spanfill_pico::{BACKGROUND, Picture, SCREEN, dashboard, dashboard::Dashboard};

    let folder = std::path::PathBuf::from(std::env::args_os().nth(1).ok_or("expected FOLDER")?);
    let frame = || {
        let mut frame = Framebuffer::<Rgb565, Rows<MsbFirst>, _>::new(vec![0; 2 * 320 * 240], SCREEN)?;
        let Ok(()) = frame.clear(BACKGROUND);
        Ok::<_, spanfill::FramebufferError>(frame)
    };
    let dashboard = Dashboard::new(62);
    for picture in Picture::ALL {
        let mut ours = frame()?;
        let Ok(()) = picture.draw(&mut ours, &dashboard);
        std::fs::write(folder.join(format!("spanfill-{}", picture.name())), ours.units())?;
        let mut theirs = frame()?;
        if let Some(Ok(())) = picture.draw_by_embedded_graphics(&mut theirs, &dashboard) {
            std::fs::write(folder.join(format!("embedded-graphics-{}", picture.name())), theirs.units())?;
        }
    }
    let mut moved = frame()?;
    let Ok(()) = dashboard::draw(&mut moved, &Dashboard::new(65));
    std::fs::write(folder.join("spanfill-dashboard-moved"), moved.units())?;
    Ok(())
}
