//! What is said of the methods of the literature is what they do: pictures, tables, charts and stability report are those of
//! this source, and have every method with every option.
//!
//! When a method has become better or worse, or is new, these make them anew:
//!
//! ```sh
//! cargo run --release --example gallery
//! cargo run --release --example chart
//! cargo run --release --example stability
//! examples/firmware/run.sh methods --csv docs/charts/cortex-m4.csv
//! ```

#[path = "../examples/methods/canvas.rs"]
mod canvas;
#[path = "../examples/methods/csv_files.rs"]
mod csv_files;
#[path = "../benches/drawings/mod.rs"]
mod drawings;
#[path = "../examples/methods/families.rs"]
mod families;
#[path = "../examples/methods/gallery.rs"]
mod gallery;
#[path = "../examples/methods/measure/mod.rs"]
mod measure;
mod oracle;
#[path = "../examples/methods/panel.rs"]
mod panel;
#[path = "../benches/scenes/random.rs"]
mod random;
#[path = "../examples/methods/scenes.rs"]
mod scenes;
#[path = "../examples/methods/stability/mod.rs"]
mod stability;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use csv_files::{CORTEX_M4, ERRORS, TIMES, error_row, read};
use families::{GALLERY, slug, suites};
use measure::{Suite, new_picture};
use spanfill::methods::FAMILIES;

fn docs(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(name)
}

/// Every method with every option, by family, and what the crate ships.
fn listed() -> BTreeMap<&'static str, BTreeSet<(String, String)>> {
    let of_family = |family: &'static spanfill::methods::Family| {
        let pairs =
            family.methods.iter().flat_map(|method| method.options.iter().map(move |option| (method.name, *option)));
        (family.name, pairs.map(|(method, option)| (method.to_owned(), option.to_owned())).collect())
    };
    FAMILIES.iter().map(of_family).collect()
}

/// Method and option of each row, and the rows' other columns for those who need them.
fn pairs(rows: &[Vec<String>], at: usize) -> BTreeSet<(String, String)> {
    rows.iter().map(|row| (row[at].clone(), row[at + 1].clone())).collect()
}

fn of_family(suites: &[Suite], family: &str) -> BTreeSet<(String, String)> {
    let entries = suites.iter().filter(|suite| suite.family == family).flat_map(|suite| &suite.entries);
    entries.map(|entry| (entry.method.to_owned(), entry.option.to_owned())).collect()
}

/// Fails with what one set has and the other lacks; what is shipped may be on both sides or not.
fn assert_same(what: &str, wanted: &BTreeSet<(String, String)>, found: &BTreeSet<(String, String)>) {
    let is_shipped = |pair: &&(String, String)| pair.0 == "spanfill";
    let missing: Vec<_> = wanted.difference(found).filter(|pair| !is_shipped(pair)).collect();
    let unknown: Vec<_> = found.difference(wanted).filter(|pair| !is_shipped(pair)).collect();
    assert!(missing.is_empty() && unknown.is_empty(), "{what} lacks {missing:?} and has {unknown:?} too many");
}

#[test]
fn every_method_and_option_is_a_variant() {
    let suites = suites();
    for (family, wanted) in listed() {
        let drawn = of_family(&suites, family);
        assert_same(family, &wanted, &drawn);
        assert!(!drawn.is_empty(), "{family} has no method");
    }
}

#[test]
fn every_method_and_option_is_in_the_gallery() {
    let rows = read(&docs("gallery/index.csv"), &gallery::INDEX).unwrap();
    for (family, wanted) in listed() {
        let of_family: Vec<_> = rows.iter().filter(|row| row[0] == family).cloned().collect();
        assert_same(&format!("the gallery of {family}"), &wanted, &pairs(&of_family, 1));
        assert!(of_family.iter().any(|row| row[1] == "spanfill"), "the gallery of {family} lacks what is shipped");
        for row in &of_family {
            let size = fs::metadata(docs("gallery").join(&row[4])).expect("the picture").len();
            assert!(size < 150_000, "{} has {size} bytes", row[4]);
        }
    }
}

#[test]
fn the_gallery_is_that_of_this_source() {
    for (family, panels) in gallery::by_family(&suites(), |_| {}) {
        let name = format!("{}.png", slug(family));
        let committed = fs::read(docs("gallery").join(&name)).expect("a picture of each family");
        assert!(gallery::draw(family, &panels).png() == committed, "{name} is not what the methods draw");
    }
}

#[test]
fn every_method_and_option_is_in_the_tables() {
    let suites = suites();
    for (family, wanted) in listed() {
        for (kind, columns) in [("errors", &ERRORS[..]), ("times", &TIMES[..])] {
            let name = format!("charts/{}-{kind}.csv", slug(family));
            let rows = read(&docs(&name), columns).unwrap();
            assert_same(&name, &wanted, &pairs(&rows, 0));
            let scenes = suites
                .iter()
                .filter(|suite| suite.family == family)
                .map(|suite| suite.entries.len() * suite.scenes.len());
            assert_eq!(rows.len(), scenes.sum::<usize>(), "{name} has not a row for each method on each scene");
        }
        let rows = read(&docs("charts/cortex-m4.csv"), &CORTEX_M4).unwrap();
        for core in ["soft", "hard"] {
            let rows: Vec<_> = rows.iter().filter(|row| row[0] == core && row[1] == family).cloned().collect();
            assert_same(&format!("cortex-m4.csv ({core}) of {family}"), &wanted, &pairs(&rows, 2));
        }
    }
}

#[test]
fn every_method_and_option_has_its_mark() {
    let charts: Vec<(String, String)> = fs::read_dir(docs("charts"))
        .expect("the charts")
        .map(|file| file.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
        .map(|path| {
            (path.file_name().unwrap().to_str().unwrap().to_owned(), text_of(&fs::read_to_string(&path).unwrap()))
        })
        .collect();
    let suites = suites();
    for (family, _) in listed() {
        for entry in suites.iter().filter(|suite| suite.family == family).flat_map(|suite| &suite.entries) {
            for (kind, is_of_kind) in [("host", false), ("Cortex-M4", true)] {
                let is_chart = |name: &str| name.starts_with(&slug(family)) && name.contains("cortex-m4") == is_of_kind;
                let label = format!("\n{}\n", entry.label());
                let has_mark = charts.iter().any(|(name, text)| is_chart(name) && text.contains(&label));
                assert!(has_mark, "no {kind} chart of {family} has a mark for {}", entry.label());
            }
        }
    }
}

/// The lines of an SVG, with its entities as what they stand for.
fn text_of(svg: &str) -> String {
    svg.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&apos;", "'").replace("&amp;", "&")
}

/// Scenes of which every shape is drawn again here: the rest takes minutes.
const PINNED_SHAPES: usize = 60;

#[test]
fn errors_are_those_of_the_tables() {
    let suites = suites();
    let work: Vec<(&Suite, usize, usize)> = suites
        .iter()
        .flat_map(|suite| (0..suite.entries.len()).map(move |entry| (suite, entry)))
        .flat_map(|(suite, entry)| (0..suite.scenes.len()).map(move |scene| (suite, entry, scene)))
        .filter(|(suite, entry, scene)| {
            let (name, shapes) = suite.scenes[*scene];
            // Each method on the gallery's scene and on another, in turn.
            name == GALLERY || (shapes <= PINNED_SHAPES && entry % suite.scenes.len() == *scene)
        })
        .collect();
    let tables: BTreeMap<&str, Vec<Vec<String>>> = suites
        .iter()
        .map(|suite| {
            (suite.family, read(&docs(&format!("charts/{}-errors.csv", slug(suite.family))), &ERRORS).unwrap())
        })
        .collect();
    let check = |work: &[(&Suite, usize, usize)]| -> Vec<String> {
        let mut picture = new_picture();
        let mut differing = Vec::new();
        for &(suite, entry, scene) in work {
            let (entry, (name, shapes)) = (&suite.entries[entry], suite.scenes[scene]);
            let row = error_row(entry, name, shapes, &suite.tally(entry, scene, shapes, &mut picture));
            // More than one suite of a family may have a scene of this name.
            if !tables[suite.family].contains(&row) {
                differing.push(format!("{}: {row:?} is not there", suite.family));
            }
        }
        differing
    };
    let (first, second) = work.split_at(work.len() / 2);
    let differing: Vec<String> = std::thread::scope(|scope| {
        let other = scope.spawn(|| check(second));
        let mut differing = check(first);
        differing.extend(other.join().expect("no check panics"));
        differing
    });
    assert!(differing.is_empty(), "columns {ERRORS:?}:\n{}", differing.join("\n"));
}

#[test]
fn the_stability_report_is_that_of_this_source() {
    let report = stability::report(|_| {});
    let committed = fs::read_to_string(docs("STABILITY.md")).expect("the report");
    let differing = report.text.lines().zip(committed.lines()).find(|(made, committed)| made != committed);
    assert!(report.text == committed, "the report differs, first in {differing:?}");
    for (name, _) in &report.pictures {
        assert!(docs("stability").join(name).exists(), "{name} is missing");
    }
}
