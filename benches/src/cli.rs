//! What the command line says.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use crate::{row::scene_from, scenes::Scene, suite::SuiteArgs, variant::Variant};

/// What spanfill costs, side by side with other libraries and the bare filling of the same pixels.
///
/// Without a command: checks that the variants draw what they should, times all of them in turns, and prints the
/// processor, the compiler, the versions, tables in Markdown, without anti-aliasing and with it, and which of the
/// project's bars are reached. It takes a few minutes, and says on stderr how far it is.
///
/// Paths are relative to where you are; from the repository's root, everything that is kept is renewed by
///
///   cargo run --release --manifest-path benches/Cargo.toml -- --csv --readme docs/PERFORMANCE.md \
///     --chart docs/speed.svg --chart-aa docs/accuracy.svg
#[derive(Debug, Parser)]
#[command(name = "spanfill-benches", version, max_term_width = 110, args_conflicts_with_subcommands = true)]
#[command(subcommand_negates_reqs = true, verbatim_doc_comment)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,

    #[command(flatten)]
    pub(crate) measure: Measure,
}

#[derive(Debug, Args)]
pub(crate) struct Measure {
    /// Measure only these, with commas between them: triangle-10, circle-5, ... [default: all]
    #[arg(long, value_name = "SCENES", value_parser = scene_from, value_delimiter = ',')]
    pub(crate) scenes: Vec<Scene>,

    /// How many turns each variant has; its best one counts
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) rounds: u32,

    /// How long a turn takes, about, in microseconds
    #[arg(long, value_name = "US", default_value_t = 500)]
    pub(crate) turn_us: u64,

    /// Count instructions in place of time: runs everything under valgrind, which has to be installed
    #[arg(long)]
    pub(crate) instructions: bool,

    /// Save the rows as CSV, and beside it a .md with all that is printed [default FILE, in benches/record/<target>:
    /// <date>.csv, or <date>-instructions.csv]
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    pub(crate) csv: Option<Option<PathBuf>>,

    /// Replace what stands between <!-- bench:begin --> and <!-- bench:end --> in this file, and between
    /// <!-- bench-aa:begin --> and <!-- bench-aa:end -->
    #[arg(long, value_name = "FILE")]
    pub(crate) readme: Option<PathBuf>,

    /// Draw the chart of speed without anti-aliasing into this SVG file
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) chart: Option<PathBuf>,

    /// Draw the chart of speed and accuracy with anti-aliasing into this SVG file
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) chart_aa: Option<PathBuf>,

    /// Exit with status 1 when a bar is not reached
    #[arg(long, conflicts_with = "instructions")]
    pub(crate) check: bool,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Time whole pictures of real drawings, and how that grows with the vertices: half a minute
    Drawings(GalleryArgs),
    /// Time framebuffers and bands: fills beside `slice::fill`, clears, scenes in bands beside the same at once
    Frames {
        /// How many turns each has; its best one counts
        #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..))]
        rounds: u32,
    },
    /// Time the bundled map with its strokes, and strokes of many samples, against resvg
    Strokes,
    /// Hold `render` against resvg on the files of resvg's test suite
    Suite(SuiteArgs),
    /// Draw with one variant and nothing else, for a profiler
    Profile {
        /// A scene (triangle-10, circle-5, ...) or a drawing (coast, text/4, ...)
        #[arg(value_name = "SCENE_OR_DRAWING")]
        name: String,
        /// spanfill, spanfill-aa, ...
        variant: Variant,
        /// How many shapes to draw, or how many pictures of a drawing [default: 1000, or 1]
        #[arg(long, value_name = "N")]
        shapes: Option<usize>,
    },
    /// Draw the chart of speed again from rows that were saved
    Chart(Redraw),
    /// Draw the chart of speed and accuracy again from rows that were saved
    ChartAa(Redraw),
}

#[derive(Debug, Args)]
pub(crate) struct GalleryArgs {
    /// Only these: countries, noisy-chart-2000, ...; coast/4 is the coast with every edge cut in four [default: all]
    #[arg(value_name = "DRAWING")]
    pub(crate) names: Vec<String>,

    /// Only by these, with commas between them: spanfill-aa, vello-cpu-baseline, ... [default: all]
    #[arg(long, value_name = "VARIANTS", value_delimiter = ',')]
    pub(crate) variants: Vec<Variant>,

    /// Not how the times grow when edges are cut, and no question for the scratch
    #[arg(long)]
    pub(crate) no_growth: bool,

    /// Compare each shape's coverage with the exact area, and print the errors: ten seconds more
    #[arg(long)]
    pub(crate) errors: bool,

    /// How many turns each variant has at most; its best one counts
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(3..))]
    pub(crate) rounds: u32,

    /// How long each variant draws each drawing, in milliseconds; but three turns at least
    #[arg(long, value_name = "MS", default_value_t = 100)]
    pub(crate) budget_ms: u64,

    /// Count instructions in place of time: runs everything under valgrind, which has to be installed
    #[arg(long)]
    pub(crate) instructions: bool,

    /// Save the rows as CSV, and beside it a .md with all that is printed [default FILE, in benches/record/<target>:
    /// <date>-drawings.csv, or <date>-drawings-instructions.csv]
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    pub(crate) csv: Option<Option<PathBuf>>,

    /// Replace what stands between <!-- bench-drawings:begin --> and <!-- bench-drawings:end --> in this file
    #[arg(long, value_name = "FILE")]
    pub(crate) readme: Option<PathBuf>,

    /// Save what each variant's picture shows, as <drawing>-<variant>.ppm
    #[arg(long, value_name = "FOLDER")]
    pub(crate) pictures: Option<PathBuf>,

    /// Exit with status 1 when a bar is not reached
    #[arg(long, conflicts_with = "instructions")]
    pub(crate) check: bool,
}

impl GalleryArgs {
    pub(crate) fn growth(&self) -> bool {
        !self.no_growth
    }
}

#[derive(Debug, Args)]
pub(crate) struct Redraw {
    /// What --csv saved
    #[arg(value_name = "ROWS.csv")]
    pub(crate) rows: PathBuf,

    #[arg(value_name = "CHART.svg")]
    pub(crate) chart: PathBuf,
}
