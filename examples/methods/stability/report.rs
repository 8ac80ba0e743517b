//! A report in Markdown with pictures: for each case a table of what goes wrong with which method, and how large it is.

use std::{fmt::Write as _, ops::Range};

use crate::{
    canvas::{Canvas, Size},
    measure::{Entry, Suite, Tally, Verdict, new_picture, verdict},
    panel::{INK, PALE, PAPER, Panel},
    variants::{HEIGHT, Picture, WIDTH},
};

/// The report while it grows.
#[derive(Debug, Default)]
pub(crate) struct Report {
    pub(crate) text: String,
    /// File name and picture.
    pub(crate) pictures: Vec<(String, Canvas)>,
}

/// A method's picture of the shape that it is worst at, where it is wrong.
#[derive(Debug)]
pub(crate) struct Specimen {
    pub(crate) label: String,
    pub(crate) says: String,
    pub(crate) panel: Panel,
    pub(crate) outline: Vec<Vec<(f64, f64)>>,
}

const COLUMNS: i32 = 18;
const ROWS: i32 = 12;
const SCALE: i32 = 8;
/// So many pictures in one file at most: those of the methods that are worst.
const MOST: usize = 8;

impl Report {
    pub(crate) fn heading(&mut self, title: &str) {
        let _ = writeln!(self.text, "\n## {title}\n");
    }

    pub(crate) fn say(&mut self, text: &str) {
        let _ = writeln!(self.text, "{}\n", text.trim());
    }

    pub(crate) fn table(&mut self, columns: &[&str], rows: &[Vec<String>]) {
        let _ = writeln!(self.text, "| {} |", columns.join(" | "));
        let dashes: Vec<&str> = columns.iter().enumerate().map(|(at, _)| if at == 0 { "---" } else { "--:" }).collect();
        let _ = writeln!(self.text, "|{}|", dashes.join("|"));
        for row in rows {
            // What is code in a name would be Markdown.
            let cells: Vec<String> = row.iter().map(|cell| cell.replace('|', "\\|").replace('*', "\\*")).collect();
            let _ = writeln!(self.text, "| {} |", cells.join(" | "));
        }
        self.text.push('\n');
    }

    /// Puts specimens side by side into a file.
    pub(crate) fn picture(&mut self, name: &str, what: &str, specimens: &[Specimen]) {
        if specimens.is_empty() {
            return;
        }
        let file = format!("{name}.png");
        let _ = writeln!(self.text, "![{what}](stability/{file})\n");
        self.pictures.push((file, sheet(&specimens[..specimens.len().min(MOST)])));
    }
}

fn sheet(specimens: &[Specimen]) -> Canvas {
    let (width, height) = Panel::new(0..COLUMNS, 0..ROWS).size(SCALE);
    let (across, down) = (specimens.len().clamp(1, 4) as i32, specimens.len().div_ceil(4) as i32);
    let cell = (width + 16, height + 44);
    let mut canvas = Canvas::new(across * cell.0 + 8, down * cell.1 + 8, PAPER);
    for (place, specimen) in (0..).zip(specimens) {
        let (left, top) = (12 + place % 4 * cell.0, 8 + place / 4 * cell.1);
        specimen.panel.draw(&mut canvas, left, top, SCALE, &specimen.outline);
        let letters = (width / Size::Tiny.advance()) as usize;
        let cut = |text: &str, at: usize| text.chars().skip(at * letters).take(letters).collect::<String>();
        canvas.text(&cut(&specimen.label, 0), left, top + height + 3, Size::Tiny, INK);
        canvas.text(&cut(&specimen.label, 1), left, top + height + 12, Size::Tiny, INK);
        canvas.text(&cut(&specimen.says, 0), left, top + height + 22, Size::Tiny, PALE);
    }
    canvas
}

/// What a method makes of a scene, and the shape that it is worst at.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) label: String,
    pub(crate) is_shipped: bool,
    pub(crate) tally: Tally,
    pub(crate) worst: Option<Specimen>,
    /// How much is wrong in the worst shape.
    worst_by: f64,
}

/// Draws a scene by every method of a suite.
pub(crate) fn outcomes(suite: &Suite, scene: &str) -> Vec<Outcome> {
    let scene = suite.scenes.iter().position(|(name, _)| *name == scene).expect("a scene of the suite");
    let mut picture = new_picture();
    suite.entries.iter().map(|entry| outcome(suite, entry, scene, &mut picture)).collect()
}

fn outcome(suite: &Suite, entry: &Entry, scene: usize, picture: &mut Picture) -> Outcome {
    let mut outcome = Outcome {
        label: entry.label(),
        is_shipped: entry.is_shipped(),
        tally: Tally::default(),
        worst: None,
        worst_by: 0.0,
    };
    for shape in 0..suite.scenes[scene].1 {
        let truth = suite.truth(scene, shape, entry.aim);
        let drawn = suite.draw(entry, scene, shape, picture);
        let tally = match &drawn {
            Ok(()) => Tally::of(picture, truth),
            Err(_) => Tally { pixels: truth.pixels(), refused: 1, ..Tally::default() },
        };
        let by = if entry.aim.is_of_levels() { tally.worst } else { tally.wrong() as f64 };
        if by > outcome.worst_by {
            outcome.worst_by = by;
            let window = window_of(|at| match entry.aim.is_of_levels() {
                true => crate::measure::levels_off(picture, truth, at) >= by,
                false => !matches!(verdict(picture, truth, at), Verdict::Empty | Verdict::Right | Verdict::Moved),
            });
            let mut panel = Panel::new(window[0].clone(), window[1].clone());
            panel.add(picture, truth);
            let says = summary(&tally, entry.aim.is_of_levels());
            let outline = suite.outline(scene, shape);
            outcome.worst = Some(Specimen { label: entry.label(), says, panel, outline });
        }
        outcome.tally += tally;
    }
    outcome
}

/// A window with the first pixel for which something holds in its middle.
pub(crate) fn window_of(holds: impl Fn(usize) -> bool) -> [Range<i32>; 2] {
    let at = (0..(WIDTH * HEIGHT) as usize).find(|at| holds(*at)).unwrap_or(0) as i32;
    let [left, top] =
        [(at % WIDTH - COLUMNS / 2).clamp(0, WIDTH - COLUMNS), (at / WIDTH - ROWS / 2).clamp(0, HEIGHT - ROWS)];
    [left..left + COLUMNS, top..top + ROWS]
}

/// What is wrong, in a few words.
pub(crate) fn summary(tally: &Tally, is_of_levels: bool) -> String {
    let counts =
        [(tally.missing, "missing"), (tally.extra, "extra"), (tally.doubled, "twice"), (tally.refused, "refused")];
    let mut parts: Vec<String> =
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect();
    if is_of_levels && tally.worst > 0.0 {
        parts.push(format!("{:.1} off", tally.worst));
    }
    if parts.is_empty() { "none".into() } else { parts.join(", ") }
}

impl Report {
    /// A case with a table of wrong pixels: what is shipped first, then the worst first, then the names of the exact.
    pub(crate) fn pixels(&mut self, name: &str, what: &str, mut outcomes: Vec<Outcome>) {
        outcomes.sort_by(|a, b| {
            let key = |outcome: &Outcome| (outcome.is_shipped, outcome.tally.wrong() + outcome.tally.refused);
            key(b).cmp(&key(a)).then_with(|| a.label.cmp(&b.label))
        });
        // What is shipped is in more than one family.
        outcomes.dedup_by(|a, b| a.is_shipped && a.label == b.label);
        let (exact, wrong): (Vec<_>, Vec<_>) = outcomes
            .into_iter()
            .partition(|outcome| !outcome.is_shipped && outcome.tally.wrong() + outcome.tally.refused == 0);
        let row = |outcome: &Outcome| {
            let Tally { pixels, missing, extra, doubled, moved, refused, .. } = outcome.tally;
            let mut row = vec![outcome.label.clone()];
            row.extend([pixels, missing, extra, doubled, moved, refused].map(|count| count.to_string()));
            row
        };
        let columns = ["method", "pixels", "missing", "extra", "twice", "another tie", "refused"];
        self.table(&columns, &wrong.iter().map(row).collect::<Vec<_>>());
        self.no_others(&exact);
        let specimens: Vec<Specimen> = wrong.into_iter().filter_map(|outcome| outcome.worst).collect();
        self.picture(name, what, &specimens);
    }

    /// A case with a table of levels.
    pub(crate) fn levels(&mut self, name: &str, what: &str, unit: &str, mut outcomes: Vec<Outcome>) {
        outcomes.sort_by(|a, b| {
            b.is_shipped
                .cmp(&a.is_shipped)
                .then(b.tally.worst.total_cmp(&a.tally.worst))
                .then_with(|| a.label.cmp(&b.label))
        });
        let row = |outcome: &Outcome| {
            let Tally { pixels, levels, worst, refused, .. } = outcome.tally;
            let mean = levels / pixels.max(1) as f64;
            vec![
                outcome.label.clone(),
                pixels.to_string(),
                format!("{worst:.2}"),
                format!("{mean:.3}"),
                refused.to_string(),
            ]
        };
        let (worst, mean) = (format!("worst, {unit}"), format!("mean, {unit}"));
        let columns = ["method", "pixels", &worst, &mean, "refused"];
        self.table(&columns, &outcomes.iter().map(row).collect::<Vec<_>>());
        let shown = outcomes.into_iter().filter(|outcome| outcome.worst_by > 1.0);
        let specimens: Vec<Specimen> = shown.filter_map(|outcome| outcome.worst).collect();
        self.picture(name, what, &specimens);
    }

    fn no_others(&mut self, exact: &[Outcome]) {
        if !exact.is_empty() {
            let names: Vec<String> =
                exact.iter().map(|outcome| outcome.label.replace('|', "\\|").replace('*', "\\*")).collect();
            self.say(&format!("Nothing is wrong with {} others: {}.", names.len(), names.join("; ")));
        }
    }
}

/// The scenes named by powers of two.
pub(crate) const POWERS: [&str; 24] = [
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19", "20",
    "21", "22", "23",
];

impl Report {
    /// The power of two at which each method first fails, of the suites' scenes that are named by powers.
    pub(crate) fn powers(&mut self, suites: &[Suite]) {
        let mut picture = new_picture();
        let mut rows = Vec::new();
        for suite in suites {
            for entry in suite.entries.iter().filter(|entry| !entry.aim.is_of_levels()) {
                let (power, tally) = first_failure(suite, entry, &mut picture);
                let named = power.map_or_else(|| "-".into(), |k| k.to_string());
                let wrong = if power.is_some() { summary(&tally, false) } else { String::new() };
                let order = (!entry.is_shipped(), power.unwrap_or(usize::MAX));
                rows.push((order, vec![entry.label(), named, wrong]));
            }
        }
        rows.sort_by(|(a, a_row), (b, b_row)| a.cmp(b).then_with(|| a_row.cmp(b_row)));
        rows.dedup();
        let rows: Vec<Vec<String>> = rows.into_iter().map(|(_, row)| row).collect();
        self.table(&["method", "fails at k =", "what then"], &rows);
    }
}

/// The first power at which anything is wrong, and what.
pub(crate) fn first_failure(suite: &Suite, entry: &Entry, picture: &mut Picture) -> (Option<usize>, Tally) {
    for (k, name) in POWERS.iter().enumerate() {
        let Some(scene) = suite.scenes.iter().position(|(other, _)| other == name) else { continue };
        let tally = suite.tally(entry, scene, usize::MAX, picture);
        // What comes twice is no matter of size.
        if tally.missing + tally.extra + tally.refused > 0 {
            return (Some(k), tally);
        }
    }
    (None, Tally::default())
}
