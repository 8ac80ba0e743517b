//! What spanfill costs, side by side with its peers: `--help` tells how to ask, `benches/README.md` what is measured.

mod agreement;
mod bars;
mod callgrind;
mod chart;
mod cli;
mod drawing;
mod environment;
mod lineup;
mod readme;
mod row;
#[path = "../scenes/mod.rs"]
mod scenes;
mod table;
mod timing;
mod variant;

use std::{
    error::Error,
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
    time::Duration,
};

use clap::Parser;

use crate::{
    cli::{Cli, Command, Measure},
    environment::{Environment, TARGET},
    row::{Difference, Row, Rows, Unit, full_name},
    scenes::Scene,
    timing::Turns,
    variant::Variant,
};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match &cli.command {
        None => measure(&cli.measure),
        Some(Command::Profile { scene, variant, shapes }) => profile(*scene, *variant, *shapes),
        Some(Command::Chart { rows, chart }) => redraw(rows, chart),
    };
    result.unwrap_or_else(|error| {
        eprintln!("spanfill-benches: {error}");
        ExitCode::FAILURE
    })
}

type Outcome = Result<ExitCode, Box<dyn Error>>;

fn profile(scene: Scene, variant: Variant, shapes: usize) -> Outcome {
    callgrind::profile(scene, variant, shapes)?;
    Ok(ExitCode::SUCCESS)
}

fn redraw(rows: &Path, chart: &Path) -> Outcome {
    let text = fs::read_to_string(rows).map_err(|error| format!("{}: {error}", rows.display()))?;
    let rows: Rows = text.parse().map_err(|error| format!("{}: {error}", rows.display()))?;
    save(chart, &chart::svg(&rows)?)?;
    Ok(ExitCode::SUCCESS)
}

fn measure(args: &Measure) -> Outcome {
    let scenes = if args.scenes.is_empty() { Scene::ALL.to_vec() } else { args.scenes.clone() };
    // Read before the minute of measuring, so that a wrong name is known at once.
    let readme = args.readme.as_deref().map(Readme::read).transpose()?;
    let environment = Environment::new();

    let mut entries = entries(&scenes)?;
    if args.instructions {
        count_instructions(&mut entries)?;
    } else {
        time(&mut entries, args.rounds, Duration::from_micros(args.turn_us));
    }
    let unit = if args.instructions { Unit::Instructions } else { Unit::Nanoseconds };
    let rows = Rows { unit, rows: entries };

    let table = table::markdown(&rows);
    // The bars are about time.
    let verdicts = if args.instructions { Vec::new() } else { bars::verdicts(&rows) };
    let mut report = format!("{environment}\n{table}");
    if !verdicts.is_empty() {
        let lines: Vec<String> = verdicts.iter().map(|verdict| format!("    {verdict}\n")).collect();
        report += &format!("\n{}", lines.concat());
    }
    print!("{report}");

    if let Some(csv) = &args.csv {
        let csv = csv.clone().unwrap_or_else(|| default_csv(&environment, unit));
        save(&csv, &rows.to_string())?;
        save(&csv.with_extension("md"), &report)?;
    }
    if let Some(readme) = readme {
        readme.save(&format!("{table}\n{environment}"))?;
    }
    if let Some(chart) = &args.chart {
        save(chart, &chart::svg(&rows)?)?;
    }
    let is_failed = args.check && verdicts.iter().any(|verdict| !verdict.is_reached());
    Ok(if is_failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Each scene by each variant that has it, not measured yet, and how much its pixels differ from spanfill's.
fn entries(scenes: &[Scene]) -> Result<Vec<Row>, String> {
    let mut entries = Vec::new();
    for &scene in scenes {
        eprintln!("checking the pixels of {}", full_name(scene));
        let mut reference = lineup::drawing(scene, Variant::Spanfill).expect("spanfill draws every scene");
        for variant in Variant::ALL {
            let Some(mut drawing) = lineup::drawing(scene, variant) else { continue };
            let difference = agreement::difference(&mut *reference, &mut *drawing);
            if variant == Variant::Floor && difference != Difference::default() {
                return Err(format!("{}: the floor has other pixels than spanfill", full_name(scene)));
            }
            entries.push(Row { scene, variant, cost: f64::NAN, difference });
        }
    }
    Ok(entries)
}

fn time(entries: &mut [Row], rounds: u32, turn: Duration) {
    eprintln!("timing, in {rounds} rounds");
    let drawing = |row: &Row| lineup::drawing(row.scene, row.variant).expect("it was drawn before");
    let mut turns: Vec<Turns> = entries.iter().map(|row| Turns::new(drawing(row), turn)).collect();
    for round in 1..=rounds {
        turns.iter_mut().for_each(Turns::take);
        if round.is_multiple_of(10) {
            eprintln!("round {round} of {rounds}");
        }
    }
    for (row, turn) in entries.iter_mut().zip(&turns) {
        row.cost = turn.best_ns();
    }
}

/// How many shapes are drawn under valgrind, which takes some fifty times as long.
const COUNTED_SHAPES: usize = 1000;

fn count_instructions(entries: &mut [Row]) -> Result<(), String> {
    for row in entries {
        eprintln!("counting {} by {}", full_name(row.scene), row.variant);
        row.cost = callgrind::instructions(row.scene, row.variant, COUNTED_SHAPES)?;
    }
    Ok(())
}

fn default_csv(environment: &Environment, unit: Unit) -> PathBuf {
    let suffix = match unit {
        Unit::Nanoseconds => "",
        Unit::Instructions => "-instructions",
    };
    let file = format!("{}{suffix}.csv", environment.date());
    Path::new(env!("CARGO_MANIFEST_DIR")).join("record").join(TARGET).join(file)
}

/// A README whose figures are to be replaced.
struct Readme<'a> {
    path: &'a Path,
    text: String,
}

impl<'a> Readme<'a> {
    fn read(path: &'a Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        readme::with_figures(&text, "").map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Self { path, text })
    }

    fn save(self, figures: &str) -> Result<(), String> {
        save(self.path, &readme::with_figures(&self.text, figures)?)
    }
}

fn save(path: &Path, text: &str) -> Result<(), String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(path, text))
        .map_err(|error| format!("{}: {error}", path.display()))?;
    eprintln!("{} written", path.display());
    Ok(())
}
