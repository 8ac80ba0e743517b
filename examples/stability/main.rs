//! Writes the stability report: `cargo run --release --example stability`.

#[path = "../methods/canvas.rs"]
mod canvas;
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
#[path = "../methods/stability/mod.rs"]
mod stability;
#[path = "../methods/variants/mod.rs"]
mod variants;

use std::{error::Error, fs, path::PathBuf};

use clap::Parser;
use indicatif::ProgressBar;

/// Draws every method of the literature where it is hardest, and writes what goes wrong: `STABILITY.md`, and pictures in
/// `stability/` beside it.
#[derive(Debug, Parser)]
struct Cli {
    /// The folder for the report
    #[arg(default_value = "docs")]
    out: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let cli = Cli::parse();
    let pictures = cli.out.join("stability");
    fs::create_dir_all(&pictures)?;
    let progress = ProgressBar::new_spinner();
    progress.enable_steady_tick(std::time::Duration::from_millis(200));
    // A method that panics is a line of the report.
    std::panic::set_hook(Box::new(|_| {}));
    let report = stability::report(|part| progress.set_message(part.to_owned()));
    progress.finish_and_clear();
    for (name, picture) in &report.pictures {
        picture.save(&pictures.join(name))?;
    }
    fs::write(cli.out.join("STABILITY.md"), &report.text)?;
    println!("{} with {} pictures", cli.out.join("STABILITY.md").display(), report.pictures.len());
    Ok(())
}
