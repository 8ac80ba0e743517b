//! The tables beside the charts.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use std::{error::Error, fs, path::Path};

use crate::measure::{Entry, Tally};

/// The columns of a table of errors.
pub(crate) const ERRORS: [&str; 15] = [
    "method",
    "option",
    "scene",
    "of",
    "shapes",
    "pixels",
    "missing",
    "extra",
    "doubled",
    "moved",
    "visited",
    "outside",
    "refused",
    "levels_mean",
    "levels_worst",
];

/// The columns of a table of times.
pub(crate) const TIMES: [&str; 4] = ["method", "option", "scene", "ns_per_pixel"];

/// The columns of the firmware's table of instructions.
pub(crate) const CORTEX_M4: [&str; 7] = ["core", "family", "method", "option", "scene", "shapes", "instructions"];

/// A row of a table of errors: the same on every machine.
pub(crate) fn error_row(entry: &Entry, scene: &str, shapes: usize, tally: &Tally) -> Vec<String> {
    let mean = tally.levels / (tally.pixels.max(1)) as f64;
    let counts = [
        tally.pixels,
        tally.missing,
        tally.extra,
        tally.doubled,
        tally.moved,
        tally.visited,
        tally.outside,
        tally.refused,
    ];
    let names = [entry.method, entry.option, scene, entry.aim.name()].map(String::from);
    let counts = counts.map(|count| count.to_string());
    let levels = [mean, tally.worst].map(|levels| format!("{levels:.3}"));
    names.into_iter().chain([shapes.to_string()]).chain(counts).chain(levels).collect()
}

/// A table as text.
pub(crate) fn table(columns: &[&str], rows: &[Vec<String>]) -> Result<String, Box<dyn Error>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns)?;
    for row in rows {
        writer.write_record(row)?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// The rows of a table in a file, which must have these columns.
pub(crate) fn read(path: &Path, columns: &[&str]) -> Result<Vec<Vec<String>>, Box<dyn Error>> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    if reader.headers()?.iter().ne(columns.iter().copied()) {
        return Err(format!("{} has other columns than {columns:?}", path.display()).into());
    }
    let rows = reader.records().map(|record| Ok(record?.iter().map(String::from).collect()));
    rows.collect()
}
