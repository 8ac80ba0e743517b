//! The same triangles, cut, projected and culled once, drawn by each library in turn.

use std::{path::Path, time::Instant};

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};

use crate::{
    embedded_3dgfx::Embedded3dgfx,
    ours::Ours,
    retrofire::Retrofire,
    scene::{Camera, FRAMES, Projected, for_each_of_cube, for_each_of_ring},
};

pub(crate) const BACKGROUND: Rgb565 = Rgb565::new(2, 5, 4);

/// A triangle on the screen.
pub(crate) struct Seen {
    pub(crate) projected: Projected,
    pub(crate) is_textured: bool,
}

pub(crate) trait Library {
    /// Clears everything and draws.
    fn draw(&mut self, triangles: &[Seen]);

    fn picture(&self) -> Vec<Rgb565>;
}

fn triangles(size: Size, frame: u32, cube: bool, ring: bool) -> Vec<Seen> {
    let mut seen = Vec::new();
    let mut keep = |projected: &Projected, is_textured| {
        let Projected { triangle, varying, distances, depths } = *projected;
        seen.push(Seen { projected: Projected { triangle, varying, distances, depths }, is_textured });
    };
    if cube {
        for_each_of_cube(Camera::of(size), frame, |projected| keep(projected, true));
    }
    if ring {
        for_each_of_ring(Camera::of(size), frame, |projected| keep(projected, false));
    }
    seen
}

/// Whether all of a triangle is on the screen: retrofire has clipped it before.
fn is_on_screen(seen: &Seen, size: Size) -> bool {
    seen.projected.triangle.vertices.iter().all(|vertex| {
        let (x, y) = (vertex.x.to_num::<f64>(), vertex.y.to_num::<f64>());
        x >= 0.5 && y >= 0.5 && x <= f64::from(size.width) - 1.0 && y <= f64::from(size.height) - 1.0
    })
}

pub(crate) fn compare(picture: &Path, repeat: u32) -> Result<(), Box<dyn std::error::Error>> {
    let (width, height) = (320, 240);
    let size = Size::new(width as u32, height as u32);
    let mut libraries: [(&str, Box<dyn Library>); 3] = [
        ("spanfill", Box::new(Ours::new(width, height))),
        ("retrofire-core 0.4.0", Box::new(Retrofire::new(width, height))),
        ("embedded-3dgfx 0.7.2", Box::new(Embedded3dgfx::new(width, height))),
    ];
    println!("{width} x {height}, {FRAMES} frames; ms a frame, and times as long as spanfill\n");
    println!(
        "| scene | triangles a frame | {} |",
        libraries.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(" | ")
    );
    println!("|---|--:|--:|--:|--:|");
    for (name, cube, ring) in
        [("clearing alone", false, false), ("cube", true, false), ("ring", false, true), ("both", true, true)]
    {
        let frames: Vec<Vec<Seen>> = (0..FRAMES)
            .map(|frame| {
                let mut seen = triangles(size, frame, cube, ring);
                seen.retain(|seen| is_on_screen(seen, size));
                seen
            })
            .collect();
        let count = frames.iter().map(Vec::len).sum::<usize>() as f64 / f64::from(FRAMES);
        let mut best = [f64::INFINITY; 3];
        for _ in 0..repeat {
            for (best, (_, library)) in best.iter_mut().zip(&mut libraries) {
                let started = Instant::now();
                for frame in &frames {
                    library.draw(frame);
                }
                *best = best.min(started.elapsed().as_secs_f64() * 1000.0 / f64::from(FRAMES));
            }
        }
        let [ours, ..] = best;
        let cells: Vec<String> = best.iter().map(|ms| format!("{ms:.3} ({:.2})", ms / ours)).collect();
        println!("| {name} | {count:.0} | {} |", cells.join(" | "));
    }

    // A frame in which nothing is cut by the screen.
    let frame = (0..FRAMES)
        .find(|frame| triangles(size, *frame, true, true).iter().all(|seen| is_on_screen(seen, size)))
        .ok_or("every frame is cut by the screen")?;
    let seen = triangles(size, frame, true, true);
    let pictures = libraries.each_mut().map(|(_, library)| {
        library.draw(&seen);
        library.picture()
    });
    println!();
    for ((name, _), other) in libraries.iter().zip(&pictures).skip(1) {
        let [ours, ..] = &pictures;
        let background = |colour: &Rgb565| *colour == BACKGROUND;
        let outline = ours.iter().zip(other).filter(|(a, b)| background(a) != background(b)).count();
        let differ = ours.iter().zip(other).filter(|(a, b)| far(**a, **b) > 2).count();
        let drawn = ours.iter().filter(|colour| !background(colour)).count();
        println!(
            "{name}: of {drawn} pixels, {outline} are drawn by one alone, {differ} differ by more than two steps of a channel"
        );
    }
    let pixels: Vec<u8> = (0..height)
        .flat_map(|y| pictures.iter().flat_map(move |picture| picture[y * width..(y + 1) * width].to_vec()))
        .flat_map(|colour| {
            let colour = Rgb888::from(colour);
            [colour.r(), colour.g(), colour.b()]
        })
        .collect();
    image::save_buffer(picture, &pixels, 3 * width as u32, height as u32, image::ColorType::Rgb8)?;
    println!("frame {frame} of each, in that order: {}", picture.display());
    Ok(())
}

/// The largest difference of a channel, in steps of five bits.
fn far(a: Rgb565, b: Rgb565) -> u8 {
    a.r().abs_diff(b.r()).max(a.g().abs_diff(b.g()) / 2).max(a.b().abs_diff(b.b()))
}
