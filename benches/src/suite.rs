//! The files of resvg's test suite that need nothing which `render` does not draw, drawn by both.
//!
//! The suite is not part of this repository: a clone of <https://github.com/linebender/resvg> has it. A pixel counts as
//! different when the other picture has nothing like it in the pixel itself or beside it, either way round: what
//! anti-aliasing and the thinnest lines make of an edge does not count.

use std::{
    error::Error,
    fs,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
};

use clap::Args;
use resvg::{
    tiny_skia::{Color, Pixmap, Transform},
    usvg::{Options, Tree},
};

#[derive(Debug, Args)]
pub(crate) struct SuiteArgs {
    /// The folder that has the suite's files: crates/resvg/tests/tests in a clone of resvg
    folder: PathBuf,

    /// The program that draws them
    #[arg(long, value_name = "PROGRAM", default_value = "target/release/examples/render")]
    render: PathBuf,

    /// The names of the files to draw, a line each; those that need nothing missing are written into it, if it is not there
    #[arg(long, value_name = "FILE", default_value = "benches/suite/files.txt")]
    list: PathBuf,

    /// The report, in Markdown
    #[arg(long, value_name = "FILE", default_value = "benches/suite/README.md")]
    report: PathBuf,
}

/// Channels that are no further apart are the same colour.
const SAME: u8 = 40;

/// A file in which no more pixels are different is the same.
const FEW: usize = 4;

pub(crate) fn run(args: &SuiteArgs) -> Result<ExitCode, Box<dyn Error>> {
    let known = fs::read_to_string(&args.list).ok();
    let names: Vec<String> = match &known {
        Some(list) => list.lines().map(str::to_owned).collect(),
        None => {
            let mut names = vec![];
            find(&args.folder, &args.folder, &mut names)?;
            names.sort();
            names
        }
    };
    let (mut compared, mut differing) = (vec![], vec![]);
    for name in &names {
        match compare(args, name)? {
            Outcome::Missing(_) if known.is_none() => {}
            Outcome::Missing(reason) => differing.push((name, reason)),
            Outcome::Pixels(pixels) => {
                compared.push(name.as_str());
                if pixels > FEW {
                    differing.push((name, format!("{pixels} pixels")));
                }
            }
        }
    }
    if known.is_none() {
        fs::write(&args.list, compared.join("\n") + "\n")?;
    }
    let rows: String = differing.iter().map(|(name, what)| format!("| {name} | {what} |\n")).collect();
    let report = format!(
        "# resvg's test suite\n\nOf {} files that need nothing which `examples/render` does not draw, {} differ from \
         resvg 0.49 by more than anti-aliasing and hairlines. `benches/src/suite.rs` says what counts; how to run it:\n\n\
         ```sh\ngit clone --depth 1 https://github.com/linebender/resvg target/resvg\n\
         cargo build --release --example render\n\
         cargo run --release --manifest-path benches/Cargo.toml -- suite target/resvg/crates/resvg/tests/tests\n```\n\n\
         A few pixels are the tips of corners, two pixels long in both. Beyond that: a curve whose end turns within less than \
         its stroke's width (`line-as-curve-2`, `control-points-clamping-1`) is what its ribs sweep over, where resvg cuts it \
         off; a clipped miter (`miter-clip`) is a bevel; dashes \
         that end at corners just so (`n-0`) have no corners at all here, and some there. What is left is `render`'s: a marker on a closed line back \
         (`orient=auto-on-M-L-Z`), and drawings that are stretched (`preserveAspectRatio=none`).\n\n\
         | file | what differs |\n|---|---|\n{rows}",
        compared.len(),
        differing.len()
    );
    fs::write(&args.report, report)?;
    println!("{} files compared, {} differ: {}", compared.len(), differing.len(), args.report.display());
    Ok(ExitCode::SUCCESS)
}

fn find(folder: &Path, root: &Path, names: &mut Vec<String>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            find(&path, root, names)?;
        } else if path.extension().is_some_and(|extension| extension == "svg") {
            names.push(path.strip_prefix(root)?.to_string_lossy().into_owned());
        }
    }
    Ok(())
}

enum Outcome {
    /// Why it cannot be compared.
    Missing(String),
    Pixels(usize),
}

fn compare(args: &SuiteArgs, name: &str) -> Result<Outcome, Box<dyn Error>> {
    let source = args.folder.join(name);
    let Ok(text) = fs::read_to_string(&source) else { return Ok(Outcome::Missing("no such file".into())) };
    let Ok(tree) = Tree::from_str(&text, &Options::default()) else {
        return Ok(Outcome::Missing("not parsed by resvg".into()));
    };
    let picture = std::env::temp_dir().join(format!("spanfill-suite-{}.png", std::process::id()));
    let drawn = Command::new(&args.render)
        .arg(&source)
        .arg(&picture)
        .args(["--aa", "exact", "--color", "rgb888"])
        .output()
        .map_err(|error| format!("{}: {error}", args.render.display()))?;
    if !drawn.status.success() || !drawn.stderr.is_empty() {
        let text = String::from_utf8_lossy(&drawn.stderr);
        return Ok(Outcome::Missing(text.lines().next().unwrap_or("fails").to_owned()));
    }
    let ours = Pixmap::load_png(&picture)?;
    fs::remove_file(&picture)?;
    let mut theirs = Pixmap::new(ours.width(), ours.height()).ok_or("no pixels")?;
    theirs.fill(Color::WHITE);
    resvg::render(&tree, Transform::identity(), &mut theirs.as_mut());
    Ok(Outcome::Pixels(unlike(&ours, &theirs) + unlike(&theirs, &ours)))
}

/// How many pixels have nothing like them in the other picture.
fn unlike(a: &Pixmap, b: &Pixmap) -> usize {
    let (width, height) = (a.width() as i32, a.height() as i32);
    let at =
        |picture: &Pixmap, x: i32, y: i32| picture.pixel(x as u32, y as u32).map(|p| [p.red(), p.green(), p.blue()]);
    let is_unlike = |x: i32, y: i32| {
        let pixel = at(a, x, y).unwrap_or_default();
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
        // Between the least and the most of what is there, as a mixture of both is.
        let near: Vec<[u8; 3]> = around
            .filter(|&(x, y)| (0..width).contains(&x) && (0..height).contains(&y))
            .filter_map(|(x, y)| at(b, x, y))
            .collect();
        (0..3).any(|channel| {
            let values = near.iter().map(|pixel| pixel[channel]);
            let (least, most) = (values.clone().min().unwrap_or(0), values.max().unwrap_or(255));
            pixel[channel].saturating_add(SAME) < least || pixel[channel] > most.saturating_add(SAME)
        })
    };
    (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).filter(|&(x, y)| is_unlike(x, y)).count()
}
