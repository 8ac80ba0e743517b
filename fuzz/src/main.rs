//! Runs the fuzz targets with nothing but Rust: random inputs, and those before with some bytes changed.

use std::{
    io::{IsTerminal as _, stderr},
    path::PathBuf,
    process::ExitCode,
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use clap::{Parser, builder::PossibleValuesParser, builder::TypedValueParser as _};
use indicatif::{ProgressBar, ProgressStyle};
use spanfill_fuzz::{Target, worst};

/// Draws outlines of all kinds and holds them against an exact oracle.
///
/// A failure is printed with the smallest outline that still fails, as Rust code, and with its bytes. With the same seed,
/// the same outlines come in the same order.
///
/// areas   small shapes, anti-aliased: each pixel's coverage is the exact area, rounded once
/// clips   shapes of up to two hundred edges: the same in parts and with any scratch, an error with too little
/// blends  blended in memory, they are those that are read back and blended pixel by pixel
/// pixels  without anti-aliasing: no pixel is wrong
#[derive(Debug, Parser)]
#[command(name = "spanfill-fuzz", version, max_term_width = 110, verbatim_doc_comment)]
struct Cli {
    /// For how long, if there is no number of outlines [default: 60]
    #[arg(long, value_name = "S")]
    seconds: Option<u64>,

    /// How many outlines, on all targets together
    #[arg(long, value_name = "N")]
    outlines: Option<u64>,

    /// Only these, with commas between them [default: all]
    #[arg(long = "target", value_name = "TARGETS", value_delimiter = ',', value_parser = target_parser())]
    targets: Vec<Target>,

    /// Where to start; printed at the start [default: the time]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,

    /// Check one input and nothing else: its bytes in hexadecimal, as a failure prints them
    #[arg(long, value_name = "HEX", conflicts_with_all = ["seconds", "outlines", "seed"])]
    input: Option<String>,

    /// The same from a file, as cargo-fuzz saves them
    #[arg(long, value_name = "FILE", conflicts_with_all = ["seconds", "outlines", "seed", "input"])]
    file: Option<PathBuf>,
}

fn target_parser() -> impl clap::builder::TypedValueParser<Value = Target> {
    PossibleValuesParser::new(["areas", "clips", "blends", "pixels"])
        .map(|name| Target::ALL.into_iter().find(|target| target.to_string() == name).expect("one of them"))
}

/// SplitMix64.
#[derive(Debug)]
struct Rng(u64);

impl Rng {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        ((u128::from(self.bits()) * end as u128) >> 64) as usize
    }
}

/// So many outlines are drawn on a target before the next has its turn.
fn outlines_in_turn(target: Target) -> u64 {
    match target {
        Target::Areas => 600,
        Target::Clips => 100,
        Target::Blends => 50,
        Target::Pixels => 2000,
    }
}
/// Inputs that showed an outline, to be changed.
const KEPT: usize = 512;

/// A target and what it has seen.
struct Run {
    target: Target,
    rng: Rng,
    kept: Vec<Vec<u8>>,
    input: Vec<u8>,
    outlines: u64,
    mixed: u64,
    time: Duration,
}

impl Run {
    fn new(target: Target, seed: u64) -> Self {
        let rng = Rng(seed ^ (target as u64 + 1).wrapping_mul(0xd134_2543_de82_ef95));
        Self { target, rng, kept: Vec::new(), input: Vec::new(), outlines: 0, mixed: 0, time: Duration::ZERO }
    }

    /// New bytes, or, half the time, some of an input before changed.
    fn next_input(&mut self) {
        let Self { rng, kept, input, .. } = self;
        input.clear();
        if !kept.is_empty() && rng.below(2) == 0 {
            input.extend_from_slice(&kept[rng.below(kept.len())]);
            for _ in 0..=rng.below(4) {
                let (at, bits) = (rng.below(input.len()), rng.bits());
                match bits % 5 {
                    0 => input[at] ^= 1 << ((bits >> 8) % 8),
                    1 => input[at] = (bits >> 8) as u8,
                    2 => input[at] = [0, 1, 127, 128, 254, 255][(bits >> 8) as usize % 6],
                    3 => input[at] = input[at].wrapping_add(1),
                    _ => {
                        // The end of another.
                        let other = &kept[(bits >> 8) as usize % kept.len()];
                        input.truncate(at);
                        input.extend(other.iter().skip(at));
                    }
                }
                if input.is_empty() {
                    input.push(0);
                }
            }
        } else {
            let words = [8, 16, 24, 48][rng.below(4)];
            input.extend((0..words).flat_map(|_| rng.bits().to_le_bytes()));
        }
    }

    fn turn(&mut self, outlines: u64) -> Result<(), String> {
        let started = Instant::now();
        for _ in 0..outlines {
            self.next_input();
            let is_mixed = self.target.check(&self.input).map_err(|message| {
                let bytes: String = self.input.iter().map(|byte| format!("{byte:02x}")).collect();
                format!("{}: {message}\n\nagain by: --target {} --input {bytes}", self.target, self.target)
            })?;
            if is_mixed {
                self.mixed += 1;
                if self.kept.len() < KEPT {
                    self.kept.push(self.input.clone());
                } else if self.rng.below(16) == 0 {
                    let index = self.rng.below(KEPT);
                    self.kept[index].clone_from(&self.input);
                }
            }
        }
        self.outlines += outlines;
        self.time += started.elapsed();
        Ok(())
    }
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let targets = if cli.targets.is_empty() { Target::ALL.to_vec() } else { cli.targets.clone() };
    // The message of a failure has what a panic says.
    std::panic::set_hook(Box::new(|_| {}));
    let outcome = match input_of(&cli) {
        Ok(Some(input)) => targets.iter().try_for_each(|target| target.check(&input).map(|_| ())),
        Ok(None) => run(&cli, &targets),
        Err(message) => Err(message),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn input_of(cli: &Cli) -> Result<Option<Vec<u8>>, String> {
    if let Some(path) = &cli.file {
        return std::fs::read(path).map(Some).map_err(|error| format!("{}: {error}", path.display()));
    }
    let Some(text) = &cli.input else { return Ok(None) };
    let byte = |pair: &[u8]| std::str::from_utf8(pair).ok().and_then(|pair| u8::from_str_radix(pair, 16).ok());
    let bytes: Option<Vec<u8>> = text.as_bytes().chunks(2).map(byte).collect();
    bytes.map(Some).ok_or_else(|| "--input: an even number of hexadecimal digits is needed".to_owned())
}

fn run(cli: &Cli, targets: &[Target]) -> Result<(), String> {
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
    let seed = cli.seed.unwrap_or_else(now);
    let most = cli.outlines.unwrap_or(u64::MAX);
    let seconds = cli.seconds.or(cli.outlines.is_none().then_some(60));
    println!("seed {seed}");
    let started = Instant::now();
    let mut progress = Progress::new(cli.outlines, seconds);
    let mut runs: Vec<Run> = targets.iter().map(|target| Run::new(*target, seed)).collect();
    let mut outlines = 0;
    'all: loop {
        for run in &mut runs {
            let elapsed = started.elapsed();
            if outlines >= most || seconds.is_some_and(|seconds| elapsed.as_secs() >= seconds) {
                break 'all;
            }
            let turn = outlines_in_turn(run.target).min(most - outlines);
            run.turn(turn)?;
            outlines += turn;
            progress.note(outlines, elapsed);
        }
    }
    progress.finish();
    println!("| target | outlines | of which show an outline | us each |\n|---|--:|--:|--:|");
    for Run { target, outlines, mixed, time, .. } in &runs {
        let (share, each) = (100 * mixed / outlines.max(&1), time.as_secs_f64() * 1e6 / (*outlines).max(1) as f64);
        println!("| {target} | {outlines} | {share} % | {each:.2} |");
    }
    println!("\nnothing wrong with {outlines} outlines in {:.0} s", started.elapsed().as_secs_f64());
    for (name, error) in worst() {
        println!("{name}: off by {error:.4} of 255 at most");
    }
    Ok(())
}

/// A bar on a terminal, else a line a minute.
struct Progress {
    bar: ProgressBar,
    is_by_outlines: bool,
    /// Minutes that have been told.
    told: u64,
}

impl Progress {
    fn new(outlines: Option<u64>, seconds: Option<u64>) -> Self {
        let is_by_outlines = outlines.is_some();
        let length = outlines.or(seconds).unwrap_or_default();
        let bar = if stderr().is_terminal() { ProgressBar::new(length) } else { ProgressBar::hidden() };
        bar.set_style(ProgressStyle::with_template("{wide_bar} {msg} {eta}").expect("a template"));
        Self { bar, is_by_outlines, told: 0 }
    }

    fn note(&mut self, outlines: u64, elapsed: Duration) {
        self.bar.set_position(if self.is_by_outlines { outlines } else { elapsed.as_secs() });
        if self.bar.is_hidden() && elapsed.as_secs() / 60 > self.told {
            self.told = elapsed.as_secs() / 60;
            let errors: Vec<String> = worst().iter().map(|(name, error)| format!("{name} {error:.4}")).collect();
            eprintln!("{outlines} outlines, {} min; off by at most: {}", self.told, errors.join(", "));
        } else if !self.bar.is_hidden() {
            self.bar.set_message(format!("{outlines} outlines"));
        }
    }

    fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
