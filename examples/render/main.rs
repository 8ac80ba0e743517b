//! Draws an SVG file with spanfill on a simulated display, and saves what it shows as a PNG file.
//!
//! `cargo run --release --example render` draws the bundled map of the world; `-- --help` tells the rest.

mod arcs;
mod cli;
mod display;
mod ellipse;
mod flatten;
mod gradient;
mod missing;
mod paint;
mod scene;
mod stroke;
mod svg;
mod transform;

use std::{
    error::Error,
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use clap::Parser;

use cli::{Aa, Args};
use scene::{Counts, Scene};
use stroke::Hairlines;

const BUNDLED: &str = include_str!("../assets/world.svg");

fn main() -> ExitCode {
    let args = match Args::try_parse() {
        Ok(args) => args,
        // Help was asked for, and goes to stdout.
        Err(error) if !error.use_stderr() => error.exit(),
        Err(error) => return failure(&first_line(&error)),
    };
    match run(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failure(&error.to_string()),
    }
}

fn failure(message: &str) -> ExitCode {
    eprintln!("render: {message}");
    ExitCode::FAILURE
}

/// What clap has to say, without its hints on the lines below.
fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    format!("{} (--help tells more)", line.trim_start_matches("error: "))
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let (name, source) = match &args.input {
        None => ("the bundled map".into(), BUNDLED.as_bytes().to_vec()),
        Some(path) => {
            let source = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
            (path.display().to_string(), source)
        }
    };
    let hairlines = if args.aa == Aa::None { Hairlines::OnePixel } else { Hairlines::AsWideAsTheyAre };
    let (scene, missing) =
        svg::scene_from(&source, args.size, hairlines).map_err(|error| format!("{name}: {error}"))?;
    let part = cli::part_of(scene.size, args.crop)?;
    let scale = args.scale.get();
    cli::check_size(part.size, scale)?;

    // Written beside the target and renamed: whatever fails, no broken PNG is left, and an older one stays.
    let output = &args.output;
    let unfinished = Unfinished::beside(output);
    let taken = display::render(&scene, args, &part, &unfinished.path)
        .and_then(|taken| Ok(fs::rename(&unfinished.path, output).map(|()| taken)?))
        .map_err(|error| format!("{}: {error}", output.display()))?;

    for kind in missing {
        eprintln!("render: not drawn yet: {kind}");
    }
    let (width, height) = (scene.size.width, scene.size.height);
    let edges = args.aa.name().map(|name| format!(", {name}")).unwrap_or_default();
    println!("{name} on a display of {width}x{height} pixels, {}{edges}: {}", args.color.name(), summary(&scene));
    println!("drawn in {:.3} ms, saved as {}", taken.as_secs_f64() * 1e3, output.display());
    Ok(())
}

fn summary(scene: &Scene) -> String {
    let Counts { triangles, polygons, circles, lines, contours, vertices } = scene.counts();
    format!(
        "{triangles} triangles, {polygons} polygons ({contours} contours, {vertices} vertices), {circles} circles, {lines} lines"
    )
}

/// A file that is removed unless it has been renamed.
struct Unfinished {
    path: PathBuf,
}

impl Unfinished {
    fn beside(target: &Path) -> Self {
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{}.unfinished", std::process::id()));
        Self { path: target.with_file_name(name) }
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // Nothing is there after a success, or when the folder cannot be written to.
        let _ = fs::remove_file(&self.path);
    }
}
