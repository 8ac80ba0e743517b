//! What the charts show: the tables' rows, added up over scenes.

use std::{collections::BTreeMap, error::Error, path::Path};

use crate::{
    csv_files::{CORTEX_M4, ERRORS, TIMES, read},
    families::{GALLERY, slug},
    measure::{Aim, Entry, Suite},
    plot::{Frame, Mark, svg},
};

/// The firmware's table.
const CORTEX_M4_FILE: &str = "cortex-m4.csv";

/// A method, an option, a scene.
type Key = (String, String, String);

/// The charts of a family as SVG, with their files' names.
pub(crate) fn charts(family: &str, suites: &[Suite], folder: &Path) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let errors = by_key(read(&folder.join(format!("{}-errors.csv", slug(family))), &ERRORS)?, 0);
    let times = by_key(read(&folder.join(format!("{}-times.csv", slug(family))), &TIMES)?, 0);
    let counts = folder.join(CORTEX_M4_FILE);
    let counts = if counts.exists() { read(&counts, &CORTEX_M4)? } else { Vec::new() };
    let mut kinds: Vec<(&str, Aim)> =
        suites.iter().flat_map(|suite| suite.entries.iter().map(|entry| (suite.part, entry.aim))).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let mut charts = Vec::new();
    for (part, aim) in &kinds {
        let name = if part.is_empty() { aim.name() } else { part };
        let suffix = if kinds.len() > 1 { format!("-{name}") } else { String::new() };
        let title = if kinds.len() > 1 && name != family { format!("{family}, {name}") } else { family.into() };
        let suites: Vec<&Suite> = suites.iter().filter(|suite| suite.part == *part).collect();
        let suites = &suites[..];
        let nanoseconds = |entry: &Entry, scene: &str| number(&times, entry, scene, TIMES.len() - 1);
        let marks = marks(suites, *aim, &errors, &nanoseconds);
        if marks.is_empty() {
            continue;
        }
        let frame = Frame {
            title: format!("{}: what a pixel costs, and what is wrong", capital(&title)),
            note: "filled: on the front; ring: what spanfill ships; curves join options that are numbers".into(),
            cost: "nanoseconds a pixel of the oracle's picture (host; geometric mean of the scenes)",
            error: error_name(*aim),
            zero: "none",
        };
        charts.push((format!("{}{suffix}.svg", slug(family)), svg(&frame, &marks)?));
        for (core, name) in [("soft", "without"), ("hard", "with")] {
            let rows = counts.iter().filter(|row| row[0] == core && row[1] == family).cloned().collect();
            let rows = by_key(rows, 2);
            let instructions = |entry: &Entry, scene: &str| {
                let shapes = number(&rows, entry, scene, SHAPES)? as usize;
                Some(number(&rows, entry, scene, SHAPES + 1)? / first_pixels(suites, entry, scene, shapes))
            };
            let marks = self::marks(suites, *aim, &errors, &instructions);
            if !marks.is_empty() {
                let frame = Frame {
                    cost: "instructions a pixel of the picture (Cortex-M4 in QEMU; geometric mean of the scenes)",
                    note: format!("Cortex-M4 {name} its float unit; {}", frame.note),
                    ..frame.clone()
                };
                charts.push((format!("{}{suffix}-cortex-m4-{core}.svg", slug(family)), svg(&frame, &marks)?));
            }
        }
        if family == "triangle: traversal" {
            let visited = visits(suites, &errors, &nanoseconds);
            let frame = Frame {
                title: "Triangle traversal: pixels looked at, and what a pixel costs".into(),
                note: "every pixel's place in the scenes of triangles, added up".into(),
                cost: "pixels looked at for each pixel covered",
                error: "nanoseconds a pixel",
                zero: "",
            };
            charts.push((format!("{}-visited.svg", slug(family)), svg(&frame, &visited)?));
        }
    }
    Ok(charts)
}

/// The column of the firmware's table that says how many shapes of a scene were drawn.
const SHAPES: usize = 5;

/// The pixels of a scene's first shapes by the oracle.
fn first_pixels(suites: &[&Suite], entry: &Entry, scene: &str, shapes: usize) -> f64 {
    let has = |suite: &&&Suite| suite.entries.iter().any(|other| std::ptr::eq(other, entry));
    let Some(suite) = suites.iter().find(has) else { return f64::NAN };
    let Some(scene) = suite.scenes.iter().position(|(name, _)| *name == scene) else { return f64::NAN };
    let pixels: u64 =
        (0..shapes.min(suite.scenes[scene].1)).map(|shape| suite.truth(scene, shape, entry.aim).pixels()).sum();
    pixels.max(1) as f64
}

fn error_name(aim: Aim) -> &'static str {
    match aim {
        Aim::Fill => {
            "wrong pixels (missing, extra, twice), share of the oracle's; ties that another rule moves are not counted"
        }
        Aim::Outline => "wrong pixels (missing, extra, twice), share of the oracle's outline; ties are not counted",
        Aim::Coverage => "coverage: how far a pixel is off in the mean, in 255ths",
        Aim::Attributes | Aim::Perspective => "attribute: how far a pixel is off in the mean, in its own unit",
        Aim::Depth => "depth: how far a pixel is off in the mean, in 65535ths",
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn by_key(rows: Vec<Vec<String>>, at: usize) -> BTreeMap<Key, Vec<String>> {
    rows.into_iter().map(|row| ((row[at].clone(), row[at + 1].clone(), row[at + 2].clone()), row)).collect()
}

fn number(rows: &BTreeMap<Key, Vec<String>>, entry: &Entry, scene: &str, column: usize) -> Option<f64> {
    rows.get(&(entry.method.into(), entry.option.into(), scene.into()))?.get(column)?.parse().ok()
}

fn column(name: &str) -> usize {
    ERRORS.iter().position(|column| *column == name).expect("a column of the table")
}

/// A mark for every method and option with this aim of which both numbers are known.
fn marks(
    suites: &[&Suite],
    aim: Aim,
    errors: &BTreeMap<Key, Vec<String>>,
    cost: &dyn Fn(&Entry, &str) -> Option<f64>,
) -> Vec<Mark> {
    let mut marks = Vec::new();
    for suite in suites {
        for entry in suite.entries.iter().filter(|entry| entry.aim == aim) {
            let (mut logarithms, mut scenes, mut wrong, mut pixels) = (0.0, 0.0, 0.0, 0.0);
            for (scene, _) in suite.scenes.iter().filter(|(name, _)| *name != GALLERY) {
                let Some(cost) = cost(entry, scene).filter(|cost| *cost > 0.0) else { continue };
                let of = |name: &str| number(errors, entry, scene, column(name)).unwrap_or(0.0);
                if of("refused") == of("shapes") {
                    continue;
                }
                logarithms += cost.ln();
                scenes += 1.0;
                pixels += of("pixels");
                wrong += if aim.is_of_levels() {
                    of("levels_mean") * of("pixels")
                } else {
                    of("missing") + of("extra") + of("doubled")
                };
            }
            if scenes > 0.0 {
                marks.push(Mark {
                    method: entry.method.into(),
                    option: entry.option.into(),
                    cost: f64::exp(logarithms / scenes),
                    error: wrong / f64::max(pixels, 1.0),
                    is_shipped: entry.is_shipped(),
                });
            }
        }
    }
    marks
}

/// Pixels looked at for each pixel covered, against time.
fn visits(
    suites: &[&Suite],
    errors: &BTreeMap<Key, Vec<String>>,
    cost: &dyn Fn(&Entry, &str) -> Option<f64>,
) -> Vec<Mark> {
    let time = marks(suites, Aim::Fill, errors, cost);
    let visited = |entry: &Entry, scenes: &[(&'static str, usize)]| {
        let sum = |name: &str| -> f64 {
            scenes.iter().filter_map(|(scene, _)| number(errors, entry, scene, column(name))).sum()
        };
        sum("visited") / sum("pixels").max(1.0)
    };
    let entries = suites.iter().flat_map(|suite| suite.entries.iter().map(|entry| visited(entry, &suite.scenes)));
    let marks = time.into_iter().zip(entries);
    marks
        .filter(|(_, visited)| *visited > 0.0)
        .map(|(mark, visited)| Mark { error: mark.cost, cost: visited, ..mark })
        .collect()
}
