//! What spanfill costs, side by side with its peers: `--help` tells how to ask, `benches/README.md` what is measured.

mod accuracy;
mod accuracy_chart;
mod agreement;
mod bars;
mod callgrind;
mod chart;
mod cli;
mod drawing;
#[path = "../drawings/mod.rs"]
mod drawings;
mod environment;
mod exact;
mod frames;
mod gallery;
mod lineup;
mod picture;
mod readme;
mod row;
#[path = "../scenes/mod.rs"]
mod scenes;
mod strokes;
mod suite;
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
    cli::{Cli, Command, Measure, Redraw},
    drawing::Drawing,
    environment::Environment,
    readme::Document,
    row::{Difference, Row, Rows, Unit, full_name, scene_from},
    scenes::Scene,
    timing::Turns,
    variant::Variant,
};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match &cli.command {
        None => measure(&cli.measure),
        Some(Command::Drawings(args)) => gallery::measure(args),
        Some(Command::Frames { rounds }) => {
            print!("{}\n{}", Environment::new(), frames::report(*rounds));
            Ok(ExitCode::SUCCESS)
        }
        Some(Command::Strokes) => strokes::measure(),
        Some(Command::Suite(args)) => suite::run(args),
        Some(Command::Profile { name, variant, shapes }) => profile(name, *variant, *shapes),
        Some(Command::Chart(redraw)) => redraw_as(redraw, chart::svg),
        Some(Command::ChartAa(redraw)) => redraw_as(redraw, accuracy_chart::svg),
    };
    result.unwrap_or_else(|error| {
        eprintln!("spanfill-benches: {error}");
        ExitCode::FAILURE
    })
}

type Outcome = Result<ExitCode, Box<dyn Error>>;

fn profile(name: &str, variant: Variant, shapes: Option<usize>) -> Outcome {
    match scene_from(name) {
        Ok(scene) => callgrind::profile(scene, variant, shapes.unwrap_or(1000))?,
        Err(scenes) => {
            gallery::profile(name, variant, shapes.unwrap_or(1)).map_err(|error| format!("{scenes}\n{error}"))?
        }
    }
    Ok(ExitCode::SUCCESS)
}

type Svg = Result<String, Box<dyn Error>>;

fn redraw_as(Redraw { rows, chart }: &Redraw, svg: fn(&Rows) -> Svg) -> Outcome {
    let text = fs::read_to_string(rows).map_err(|error| format!("{}: {error}", rows.display()))?;
    let rows: Rows = text.parse().map_err(|error| format!("{}: {error}", rows.display()))?;
    save(chart, svg(&rows)?)?;
    Ok(ExitCode::SUCCESS)
}

fn measure(args: &Measure) -> Outcome {
    let scenes = if args.scenes.is_empty() { Scene::ALL.to_vec() } else { args.scenes.clone() };
    // Read before the minute of measuring, so that a wrong name is known at once.
    let readme = args
        .readme
        .as_deref()
        .map(|path| Document::read(path, &[readme::ALIASED, readme::ANTI_ALIASED]))
        .transpose()?;
    let environment = Environment::new();

    let mut entries = entries(&scenes)?;
    if args.instructions {
        count_instructions(&mut entries)?;
    } else {
        time(&mut entries, args.rounds, Duration::from_micros(args.turn_us));
    }
    let unit = if args.instructions { Unit::Instructions } else { Unit::Nanoseconds };
    let rows = Rows { unit, rows: entries };

    let table = table::aliased(&rows);
    let tables_aa = table::anti_aliased(&rows);
    // The bars are about time.
    let verdicts = if args.instructions { Vec::new() } else { bars::verdicts(&rows) };
    let mut report = format!("{environment}\n{table}\n{tables_aa}");
    if !verdicts.is_empty() {
        let lines: Vec<String> = verdicts.iter().map(|verdict| format!("    {verdict}\n")).collect();
        report += &format!("\n{}", lines.concat());
    }
    print!("{report}");

    if let Some(csv) = &args.csv {
        let csv = csv.clone().unwrap_or_else(|| default_csv(&environment, unit));
        save(&csv, rows.to_string())?;
        save(&csv.with_extension("md"), &report)?;
    }
    if let Some(readme) = readme {
        readme.save(&[&format!("{table}\n{environment}"), &tables_aa])?;
    }
    if let Some(chart) = &args.chart {
        save(chart, chart::svg(&rows)?)?;
    }
    if let Some(chart) = &args.chart_aa {
        save(chart, accuracy_chart::svg(&rows)?)?;
    }
    let is_failed = args.check && verdicts.iter().any(|verdict| !verdict.is_reached());
    Ok(if is_failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Each scene by each variant that has it, not measured yet, and how far its pixels are from what they should be.
fn entries(scenes: &[Scene]) -> Result<Vec<Row>, String> {
    let mut entries = Vec::new();
    for &scene in scenes {
        eprintln!("checking the pixels of {}", full_name(scene));
        add_aliased(&mut entries, scene)?;
        add_anti_aliased(&mut entries, scene)?;
    }
    Ok(entries)
}

fn add_aliased(entries: &mut Vec<Row>, scene: Scene) -> Result<(), String> {
    let mut reference = lineup::drawing(scene, Variant::Spanfill).expect("spanfill draws every scene");
    for variant in Variant::ALIASED {
        let Some(mut drawing) = lineup::drawing(scene, variant) else { continue };
        let difference = agreement::difference(&mut *reference, &mut *drawing);
        if variant == Variant::Floor && difference != Difference::default() {
            return Err(format!("{}: the floor has other pixels than spanfill", full_name(scene)));
        }
        entries.push(Row { scene, variant, cost: f64::NAN, difference });
    }
    Ok(())
}

fn add_anti_aliased(entries: &mut Vec<Row>, scene: Scene) -> Result<(), String> {
    let (variants, mut drawings): (Vec<Variant>, Vec<Box<dyn Drawing>>) = Variant::ANTI_ALIASED
        .into_iter()
        .filter_map(|variant| Some((variant, lineup::judged(scene, variant)?)))
        .unzip();
    let errors = accuracy::errors(scene, &mut drawings);
    for (variant, difference) in variants.into_iter().zip(errors) {
        lineup::check_frames(scene, variant, accuracy::COMPARED)
            .map_err(|error| format!("{}: {error}", full_name(scene)))?;
        entries.push(Row { scene, variant, cost: f64::NAN, difference });
    }
    Ok(())
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
const fn counted_shapes(scene: Scene) -> usize {
    match scene {
        Scene::Triangles(_) | Scene::Circles(_) | Scene::Lines(_) => 1000,
        Scene::Stars(_) | Scene::Concave64(_) => 256,
    }
}

fn count_instructions(entries: &mut [Row]) -> Result<(), String> {
    for row in entries {
        eprintln!("counting {} by {}", full_name(row.scene), row.variant);
        row.cost = callgrind::instructions(&full_name(row.scene), row.variant, counted_shapes(row.scene))?;
    }
    Ok(())
}

fn default_csv(environment: &Environment, unit: Unit) -> PathBuf {
    environment.record(match unit {
        Unit::Nanoseconds => "",
        Unit::Instructions => "-instructions",
    })
}

fn save(path: &Path, content: impl AsRef<[u8]>) -> Result<(), String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(path, content))
        .map_err(|error| format!("{}: {error}", path.display()))?;
    eprintln!("{} written", path.display());
    Ok(())
}
