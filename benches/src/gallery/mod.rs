//! Real drawings: what a whole picture costs each library, and how that grows with the number of vertices.

mod bars;
mod errors;
mod growth;
mod painters;
mod row;
mod table;
mod timing;

use std::{
    ops::RangeInclusive,
    path::{Path, PathBuf},
    process::ExitCode,
    time::Duration,
};

use crate::{
    Outcome, callgrind,
    cli::GalleryArgs,
    drawings::{self, DRAWINGS, Drawing, noisy_chart},
    environment::Environment,
    gallery::{
        painters::{Painter, painter},
        row::{Row, Rows},
        timing::Turn,
    },
    readme,
    row::Unit,
    save,
    scenes::{FRAME_HEIGHT, FRAME_WIDTH},
    variant::Variant,
};

/// A drawing that is measured.
#[derive(Debug)]
pub(crate) struct Subject {
    pub(crate) name: String,
    pub(crate) drawing: Drawing,
}

/// Those that draw real drawings, in the order of the table.
pub(crate) const VARIANTS: [Variant; 8] = [
    Variant::AntiAliased,
    Variant::VelloBaseline,
    Variant::Vello,
    Variant::TinySkiaAntiAliased,
    Variant::Mask,
    Variant::Zeno,
    Variant::Aliased,
    Variant::TinySkia,
];

/// Those whose growth is looked at.
const GROWING: [Variant; 3] = [Variant::AntiAliased, Variant::VelloBaseline, Variant::Zeno];

/// Every edge is cut in so many.
pub(crate) const CUTS: [i32; 2] = [4, 16];

/// The charts of noise that stand in the table, and, with the last, in the rows of growth.
pub(crate) const SAMPLES: [i32; 4] = [500, 2_000, 4_000, 16_000];

/// Every drawing's name, in the order of the table.
pub(crate) fn names() -> Vec<String> {
    let charts = SAMPLES.map(|samples| format!("{NOISY}{samples}"));
    DRAWINGS.iter().map(|(name, _)| (*name).to_owned()).chain(charts).collect()
}

pub(crate) const NOISY: &str = "noisy-chart-";

/// Drawings with so many vertices that only their growth is looked at.
fn is_for_growth(name: &str) -> bool {
    name.contains('/') || name == format!("{NOISY}{}", SAMPLES[3])
}

impl Subject {
    /// One of [`names`], or such a name and how many edges are in place of each: `coast/4`.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let (whole, parts) = match name.split_once('/') {
            None => (name, 1),
            Some((whole, parts)) => (whole, number(parts, 1..=64)?),
        };
        let drawing = match whole.strip_prefix(NOISY) {
            Some(samples) => noisy_chart(number(samples, 2..=1_000_000)?),
            None => DRAWINGS
                .iter()
                .find(|(name, _)| *name == whole)
                .map(|(_, bytes)| drawings::load(bytes))
                .ok_or_else(|| format!("no drawing is called {whole}; there are {}", names().join(", ")))?,
        };
        let drawing = if parts == 1 { drawing } else { drawing.cut(parts) };
        Ok(Self { name: name.to_owned(), drawing })
    }
}

fn number(text: &str, range: RangeInclusive<i32>) -> Result<i32, String> {
    let number = text.parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| format!("{text} is not a number from {} to {}", range.start(), range.end()))
}

pub(crate) fn measure(args: &GalleryArgs) -> Outcome {
    let names = if args.names.is_empty() { names() } else { args.names.clone() };
    let document = args.readme.as_deref().map(|path| readme::Document::read(path, &[readme::DRAWINGS])).transpose()?;
    let environment = Environment::new();

    let mut rows =
        Rows { unit: if args.instructions { Unit::Instructions } else { Unit::Nanoseconds }, rows: Vec::new() };
    for name in &names {
        let subject = Subject::named(name)?;
        if is_for_growth(name) && !args.growth() && args.names.is_empty() {
            continue;
        }
        let all: &[Variant] = if is_for_growth(name) { &GROWING } else { &VARIANTS };
        let variants = if args.variants.is_empty() { all } else { &args.variants };
        cost(&mut rows, &subject, variants, args)?;
        if args.growth() {
            let variants: Vec<Variant> = GROWING.into_iter().filter(|variant| variants.contains(variant)).collect();
            for parts in CUTS {
                // The chart of noise grows by its samples.
                if !is_for_growth(name) && !name.starts_with(NOISY) {
                    cost(&mut rows, &Subject::named(&format!("{name}/{parts}"))?, &variants, args)?;
                }
            }
        }
    }
    let queries =
        if args.growth() && args.names.is_empty() && !args.instructions { growth::queries() } else { Vec::new() };

    let tables = [table::costs(&rows), table::growth(&rows, &queries), table::errors(&rows)];
    let tables: Vec<&str> = tables.iter().map(|table| &**table).filter(|table| !table.is_empty()).collect();
    let tables = tables.join("\n");
    let verdicts = if args.instructions { Vec::new() } else { bars::verdicts(&rows, &queries) };
    let bars: String = verdicts.iter().map(|verdict| format!("    {verdict}\n")).collect();
    let report = format!("{environment}\n{tables}\n{bars}");
    print!("{report}");

    if let Some(csv) = &args.csv {
        let csv = csv.clone().unwrap_or_else(|| default_csv(&environment, rows.unit));
        save(&csv, rows.to_string())?;
        save(&csv.with_extension("md"), &report)?;
    }
    if let Some(document) = document {
        document.save(&[&format!("{tables}\n{environment}")])?;
    }
    let is_failed = args.check && verdicts.iter().any(|verdict| !verdict.is_reached());
    Ok(if is_failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Adds what the subject costs each of the variants, which take turns.
fn cost(rows: &mut Rows, subject: &Subject, variants: &[Variant], args: &GalleryArgs) -> Result<(), String> {
    let vertices = subject.drawing.vertices();
    eprintln!("{}: {} shapes, {vertices} vertices", subject.name, subject.drawing.shapes.len());
    let mut painters = Vec::new();
    for &variant in variants {
        let missing = || format!("{variant} draws no real drawings; there are {}", Variant::list(&VARIANTS));
        painters.push((variant, painter(&subject.drawing, variant).ok_or_else(missing)?));
    }
    check_pictures(subject, &mut painters)?;
    if let Some(folder) = &args.pictures {
        save_pictures(folder, &subject.name, &painters)?;
    }
    let errors = if args.errors && !is_for_growth(&subject.name) {
        let mut painters: Vec<&mut dyn Painter> = painters.iter_mut().map(|(_, painter)| &mut **painter as _).collect();
        errors::errors(&subject.drawing, &mut painters)
    } else {
        vec![None; variants.len()]
    };
    let costs = if args.instructions {
        let count = |variant: &Variant| callgrind::instructions(&subject.name, *variant, 1);
        variants.iter().map(count).collect::<Result<Vec<f64>, String>>()?
    } else {
        let budget = Duration::from_millis(args.budget_ms);
        let mut turns: Vec<Turn> = painters.into_iter().map(|(_, painter)| Turn::new(painter, budget)).collect();
        for _ in 0..args.rounds {
            turns.iter_mut().for_each(Turn::take);
        }
        turns.iter().map(Turn::best_ns).collect()
    };
    for ((&variant, cost), error) in variants.iter().zip(costs).zip(errors) {
        rows.rows.push(Row { drawing: subject.name.clone(), vertices, variant, cost, error });
    }
    Ok(())
}

fn save_pictures(folder: &Path, name: &str, painters: &[(Variant, Box<dyn Painter>)]) -> Result<(), String> {
    for (variant, painter) in painters {
        let Some(pixels) = painter.pixels() else { continue };
        let mut ppm = format!("P6 {FRAME_WIDTH} {FRAME_HEIGHT} 255\n").into_bytes();
        ppm.extend(pixels.as_flattened());
        save(&folder.join(format!("{}-{variant}.ppm", name.replace('/', "-cut-"))), &ppm)?;
    }
    Ok(())
}

/// All must draw the same, whoever is to be measured: five and six bits a channel where others have eight, and pixels that
/// are covered or not where others blend, are what may differ.
fn check_pictures(subject: &Subject, painters: &mut [(Variant, Box<dyn Painter>)]) -> Result<(), String> {
    let differences = differences(&subject.drawing, painters);
    for ((variant, _), difference) in painters.iter().zip(differences) {
        let is_aliased = matches!(variant, Variant::Aliased | Variant::TinySkia);
        let most = if is_aliased { 24.0 } else { 8.0 };
        if let Some(difference) = difference.filter(|difference| *difference > most) {
            return Err(format!("{}: {variant} is {difference:.1} of 255 from spanfill-aa", subject.name));
        }
    }
    Ok(())
}

/// How far each picture is from spanfill's, which is anti-aliased: the mean over all pixels and channels, in 255ths.
fn differences(drawing: &Drawing, painters: &mut [(Variant, Box<dyn Painter>)]) -> Vec<Option<f64>> {
    let mut reference = painter(drawing, Variant::AntiAliased).expect("spanfill draws everything");
    reference.paint();
    let reference = reference.pixels().expect("it is a picture");
    let difference = |painter: &mut dyn Painter| {
        painter.paint();
        let pixels = painter.pixels()?;
        let channels = pixels.as_flattened().iter().zip(reference.as_flattened());
        let sum: u64 = channels.map(|(one, other)| u64::from(one.abs_diff(*other))).sum();
        Some(sum as f64 / reference.as_flattened().len() as f64)
    };
    painters.iter_mut().map(|(_, painter)| difference(&mut **painter)).collect()
}

/// For a profiler: paints as often as is asked for, within [`callgrind::measured`].
pub(crate) fn profile(name: &str, variant: Variant, times: usize) -> Result<(), String> {
    let subject = Subject::named(name)?;
    let missing = || format!("{variant} draws no real drawings; there are {}", Variant::list(&VARIANTS));
    let mut painter = painter(&subject.drawing, variant).ok_or_else(missing)?;
    painter.paint();
    callgrind::measured(&mut || (0..times).for_each(|_| painter.paint()));
    Ok(())
}

fn default_csv(environment: &Environment, unit: Unit) -> PathBuf {
    environment.record(match unit {
        Unit::Nanoseconds => "-drawings",
        Unit::Instructions => "-drawings-instructions",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is not read to its end is not a drawing, and what lies nowhere near the picture is not for it.
    #[test]
    fn drawings_are_whole_and_on_the_picture() {
        for (name, bytes) in DRAWINGS {
            let drawing = drawings::load(bytes);
            let vertices = drawing.shapes.iter().flat_map(|shape| shape.contours.iter().flatten());
            assert!(vertices.clone().count() > 1000, "{name}");
            for &[x, y] in vertices {
                assert!(
                    (-320 * 256..640 * 256).contains(&x) && (-240 * 256..480 * 256).contains(&y),
                    "{name}: {x}, {y}"
                );
            }
            for contour in drawing.shapes.iter().flat_map(|shape| &shape.contours) {
                assert!(contour.len() > 2, "{name}");
            }
            let readers = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/drawings/README.md"));
            let listed = readers.expect("it is there").replace(',', "");
            let sizes = format!("| {} | {} | {} |", drawing.shapes.len(), drawing.vertices(), bytes.len());
            assert!(listed.contains(&sizes), "{name} has {sizes}");
        }
    }

    #[test]
    fn what_is_cut_is_the_same_picture() {
        let whole = Subject::named("gauge").expect("there is one").drawing;
        let cut = Subject::named("gauge/4").expect("there is one").drawing;
        // The shortest of a curve's edges have fewer parts.
        assert!((whole.vertices() * 7 / 2..=whole.vertices() * 4).contains(&cut.vertices()));
        let painters = &mut [(Variant::AntiAliased, painter(&cut, Variant::AntiAliased).expect("it is drawn"))];
        // An edge's parts are off by half of 1/256 pixel at most.
        assert!(differences(&whole, painters)[0].expect("it is a picture") < 0.1);
    }

    #[test]
    fn everybody_draws_the_same_pictures() {
        for name in ["gauge", "icons"] {
            let subject = Subject::named(name).expect("there is one");
            let mut painters: Vec<_> = VARIANTS
                .iter()
                .map(|&variant| (variant, painter(&subject.drawing, variant).expect("it is drawn")))
                .collect();
            assert_eq!(check_pictures(&subject, &mut painters), Ok(()));
        }
    }

    /// By both: strokes that cross themselves, and letters with holes.
    #[test]
    fn coverage_is_the_area_rounded_once() {
        for name in ["gauge", "text"] {
            let subject = Subject::named(name).expect("there is one");
            let mut mask = painter(&subject.drawing, Variant::Mask).expect("it is drawn");
            let errors = errors::errors(&subject.drawing, &mut [&mut *mask]);
            let error = errors[0].expect("a mask has coverage");
            assert!((0.4..0.51).contains(&error.max) && (0.1..0.3).contains(&error.mean), "{name}: {error:?}");
        }
    }
}
