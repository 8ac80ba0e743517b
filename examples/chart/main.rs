//! Measures every method of `spanfill::methods` and charts cost against error: `cargo run --release --example chart`.

#[path = "../methods/csv_files.rs"]
mod csv_files;
#[path = "../../benches/drawings/mod.rs"]
mod drawings;
#[path = "../methods/families.rs"]
mod families;
mod labels;
mod marks;
#[path = "../methods/measure/mod.rs"]
mod measure;
#[path = "../../tests/oracle/mod.rs"]
mod oracle;
mod plot;
#[path = "../../benches/scenes/random.rs"]
mod random;
#[path = "../methods/scenes.rs"]
mod scenes;
mod timing;
#[path = "../methods/variants/mod.rs"]
mod variants;

use std::{
    collections::BTreeMap,
    error::Error,
    fs,
    path::PathBuf,
    sync::atomic::{AtomicUsize, Ordering::Relaxed},
    thread,
};

use clap::{Parser, ValueEnum};
use csv_files::{ERRORS, TIMES, error_row, table};
use indicatif::{ProgressBar, ProgressStyle};
use measure::{Suite, new_picture};

/// Measures every method of the literature on the same scenes, and charts what a pixel costs against how many are wrong.
///
/// Writes, for each family, NAME-errors.csv (the same on every machine), NAME-times.csv (nanoseconds on this one) and
/// NAME-*.svg. With the counts of `examples/firmware/run.sh methods --csv docs/charts/cortex-m4.csv` it draws the same
/// charts in instructions of a Cortex-M4. Times want a quiet machine.
#[derive(Debug, Parser)]
struct Cli {
    /// The folder for tables and charts
    #[arg(default_value = "docs/charts")]
    out: PathBuf,
    /// Only families whose name contains this
    #[arg(long, default_value = "")]
    family: String,
    /// Only this step; the charts are drawn from the tables that are there
    #[arg(long)]
    only: Option<Step>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Step {
    /// Hold every picture against the exact oracle
    Errors,
    /// Time every method
    Times,
    /// Draw the charts
    Charts,
}

type Done = Result<(), Box<dyn Error>>;

fn main() -> Done {
    let cli = Cli::parse();
    fs::create_dir_all(&cli.out)?;
    let mut families: BTreeMap<&'static str, Vec<Suite>> = BTreeMap::new();
    for suite in families::suites().into_iter().filter(|suite| suite.family.contains(&cli.family)) {
        families.entry(suite.family).or_default().push(suite);
    }
    if families.is_empty() {
        return Err(format!("no family's name contains '{}'", cli.family).into());
    }
    let does = |step| cli.only.is_none_or(|only| only == step);
    let measurements: usize = families.values().flatten().map(|suite| suite.entries.len() * suite.scenes.len()).sum();
    let steps = usize::from(does(Step::Errors)) + usize::from(does(Step::Times));
    let progress = ProgressBar::new((measurements * steps) as u64);
    progress.set_style(ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed} {msg}")?);
    for (family, suites) in &families {
        if progress.is_hidden() {
            // No terminal: a line for each family.
            eprintln!("{family}");
        }
        let file = |kind: &str| cli.out.join(format!("{}-{kind}", families::slug(family)));
        if does(Step::Errors) {
            fs::write(file("errors.csv"), errors(suites, &progress)?)?;
        }
        if does(Step::Times) {
            fs::write(file("times.csv"), times(suites, &progress)?)?;
        }
        if does(Step::Charts) {
            for (name, svg) in marks::charts(family, suites, &cli.out)? {
                fs::write(cli.out.join(&name), svg)?;
            }
        }
    }
    progress.finish_and_clear();
    Ok(())
}

/// Entries on all cores; rows in their order.
fn errors(suites: &[Suite], progress: &ProgressBar) -> Result<String, Box<dyn Error>> {
    let entries: Vec<_> =
        suites.iter().flat_map(|suite| suite.entries.iter().map(move |entry| (suite, entry))).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut picture = new_picture();
        let mut rows = Vec::new();
        while let Some((at, (suite, entry))) =
            Some(next.fetch_add(1, Relaxed)).and_then(|at| Some((at, entries.get(at)?)))
        {
            for (scene, (name, shapes)) in suite.scenes.iter().enumerate() {
                progress.set_message(format!("{}, {}: {name}", suite.family, entry.label()));
                let tally = suite.tally(entry, scene, *shapes, &mut picture);
                rows.push(((at, scene), error_row(entry, name, *shapes, &tally)));
                progress.inc(1);
            }
        }
        rows
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let mut rows: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("no worker panics")).collect()
    });
    rows.sort_unstable();
    table(&ERRORS, &rows.into_iter().map(|(_, row)| row).collect::<Vec<_>>())
}

fn times(suites: &[Suite], progress: &ProgressBar) -> Result<String, Box<dyn Error>> {
    let mut rows = Vec::new();
    let mut clock = timing::Clock::new();
    for suite in suites {
        for entry in &suite.entries {
            for (scene, (name, shapes)) in suite.scenes.iter().enumerate() {
                progress.set_message(format!("{}, {}: {name}", suite.family, entry.label()));
                let pixels: u64 = (0..*shapes).map(|shape| suite.truth(scene, shape, entry.aim).pixels()).sum();
                let nanoseconds = clock.nanoseconds(suite, entry, scene);
                let names = [entry.method, entry.option, name].map(String::from);
                rows.push(names.into_iter().chain([format!("{:.2}", nanoseconds / pixels.max(1) as f64)]).collect());
                progress.inc(1);
            }
        }
    }
    table(&TIMES, &rows)
}
