//! Makes the drawings of the bench: every curve flattened, every stroke outlined, in 1/256 pixel, for 320 x 240 pixels.
//!
//! `make-drawings SOURCES OUT`, where SOURCES is the folder that `fetch.sh` fills, and OUT is `benches/drawings`.

mod encode;
mod font;
mod map;
mod outline;
mod svg;

use std::{
    env,
    error::Error,
    fs,
    path::{Path, PathBuf},
};

use kurbo::{Affine, Rect};

use crate::outline::Shape;

type Outcome<T> = Result<T, Box<dyn Error>>;

const WIDTH: f64 = 320.0;
const HEIGHT: f64 = 240.0;

fn main() -> Outcome<()> {
    let [sources, out] = <[PathBuf; 2]>::try_from(env::args_os().skip(1).map(PathBuf::from).collect::<Vec<_>>())
        .map_err(|_| "usage: make-drawings SOURCES OUT")?;
    let save = |name: &str, shapes: Vec<Shape>| -> Outcome<()> {
        let vertices: usize = shapes.iter().flat_map(|shape| &shape.contours).map(Vec::len).sum();
        let bytes = encode::encode(&shapes);
        println!("{name}: {} shapes, {vertices} vertices, {} bytes", shapes.len(), bytes.len());
        Ok(fs::write(out.join(name).with_extension("bin"), bytes)?)
    };

    save("countries", map::countries(&sources.join("countries-110m.json"))?)?;
    save("coast", map::coast(&sources.join("land-50m.json"))?)?;
    save("icons", icons(&sources.join("mdi"), svg::Parts::Fills)?)?;
    save("stroked-icons", icons(&sources.join("lucide"), svg::Parts::FillsAndStrokes)?)?;
    save("peeps", peeps(&sources.join("peeps"))?)?;
    let world = svg::read(&sources.join("world.svg"))?;
    let fit = fit(Rect::new(0.0, 0.0, 800.0, 424.0), Rect::new(0.0, 0.0, WIDTH, HEIGHT));
    save("stroked-world", svg::shapes(&world, fit, svg::Parts::FillsAndStrokes))?;
    save("gauge", svg::shapes(&svg::read(&sources.join("gauge.svg"))?, Affine::IDENTITY, svg::Parts::FillsAndStrokes))?;
    save("text", font::paragraph(&sources.join("DejaVuSans.ttf"))?)?;
    Ok(())
}

/// Scales `from` into the middle of `to`.
fn fit(from: Rect, to: Rect) -> Affine {
    let scale = (to.width() / from.width()).min(to.height() / from.height());
    Affine::translate(to.center().to_vec2()) * Affine::scale(scale) * Affine::translate(-from.center().to_vec2())
}

const ICON_PX: f64 = 24.0;
const COLUMNS: usize = 13;
const ROWS: usize = 10;
const PAGES: usize = 2;

/// Two pages of icons, of all that there are as many as fit, from everywhere in the alphabet; the second page lies over
/// the first.
fn icons(folder: &Path, parts: svg::Parts) -> Outcome<Vec<Shape>> {
    const COLOURS: [[u8; 3]; 2] = [[0x1f, 0x6f, 0xeb], [0xd2, 0x69, 0x1e]];
    let files = files(folder)?;
    let count = COLUMNS * ROWS * PAGES;
    let chosen = (0..count).map(|index| &files[index * files.len() / count]);
    let mut shapes = Vec::new();
    for (index, file) in chosen.enumerate() {
        let (page, cell) = (index / (COLUMNS * ROWS), index % (COLUMNS * ROWS));
        let (column, row) = ((cell % COLUMNS) as f64, (cell / COLUMNS) as f64);
        let place = Affine::translate((column * ICON_PX + 8.0 * page as f64, row * ICON_PX));
        let icon = svg::shapes(&svg::read(file)?, place, parts);
        shapes.extend(icon.into_iter().map(|shape| Shape { rgb: COLOURS[page], ..shape }));
    }
    Ok(shapes)
}

/// Twelve people in three rows.
fn peeps(folder: &Path) -> Outcome<Vec<Shape>> {
    const CELL_PX: f64 = 80.0;
    let mut shapes = Vec::new();
    for (index, file) in files(folder)?.iter().enumerate() {
        let (column, row) = ((index % 4) as f64, (index / 4) as f64);
        let cell = Rect::from_origin_size((column * CELL_PX, row * CELL_PX), (CELL_PX, CELL_PX));
        shapes.extend(svg::shapes(
            &svg::read(file)?,
            fit(Rect::new(0.0, 0.0, 704.0, 704.0), cell),
            svg::Parts::FillsAndStrokes,
        ));
    }
    Ok(shapes)
}

/// In the order of their names.
fn files(folder: &Path) -> Outcome<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<Outcome<Vec<_>>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == "svg"));
    files.sort();
    Ok(files)
}
