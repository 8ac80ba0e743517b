//! Draws every method of `spanfill::methods` with every option: `cargo run --release --example gallery`.

#[path = "../methods/canvas.rs"]
mod canvas;
#[path = "../../benches/drawings/mod.rs"]
mod drawings;
#[path = "../methods/families.rs"]
mod families;
#[path = "../methods/gallery.rs"]
mod gallery;
#[path = "../methods/measure/mod.rs"]
mod measure;
#[path = "../../tests/oracle/mod.rs"]
mod oracle;
#[path = "../methods/panel.rs"]
mod panel;
#[path = "../../benches/scenes/random.rs"]
mod random;
#[path = "../methods/scenes.rs"]
mod scenes;
#[path = "../methods/variants/mod.rs"]
mod variants;

use std::{error::Error, fs, path::PathBuf};

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};

/// Draws every method of the literature with every option: a picture for each family, and a list of what was drawn.
///
/// A panel shows the same small scene by one method. Each square is a pixel. Blue is right; full red is a pixel too
/// many, hollow red is one that is missing, purple came twice, yellow is moved by another rule for ties. Where coverage
/// or colour varies, a red dot says how far it is off.
#[derive(Debug, Parser)]
struct Cli {
    /// The folder for the pictures and `index.csv`
    #[arg(default_value = "docs/gallery")]
    out: PathBuf,
    /// Only families whose name contains this; the list is not written then
    #[arg(long)]
    family: Option<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let cli = Cli::parse();
    fs::create_dir_all(&cli.out)?;
    let wanted = cli.family.as_deref().unwrap_or("");
    let suites: Vec<_> = families::suites().into_iter().filter(|suite| suite.family.contains(wanted)).collect();
    if suites.is_empty() {
        return Err(format!("no family's name contains '{wanted}'").into());
    }
    let progress = ProgressBar::new(suites.iter().map(|suite| suite.entries.len() as u64).sum());
    progress.set_style(ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")?);
    let mut index = Vec::new();
    for (family, panels) in gallery::by_family(&suites, |entry| {
        progress.inc(1);
        progress.set_message(entry.label());
    }) {
        let name = format!("{}.png", families::slug(family));
        gallery::draw(family, &panels).save(&cli.out.join(&name))?;
        index.extend(panels.iter().map(|panel| panel.row(family, &name)));
    }
    progress.finish_and_clear();
    if cli.family.is_none() {
        fs::write(cli.out.join("index.csv"), gallery::index(&index)?)?;
    }
    println!("{} panels are in {}", index.len(), cli.out.display());
    Ok(())
}
