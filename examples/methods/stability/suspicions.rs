//! What looks wrong in lecture notes, run: what is wrong, and what only looks so.

use super::{
    circles, lines,
    report::{Report, first_failure},
    triangles,
};
use crate::measure::{Entry, Suite, Tally, new_picture};

/// What was run, and what came of it.
struct Suspicion {
    what: &'static str,
    run: String,
    found: String,
    is_wrong: bool,
}

pub(crate) fn report(report: &mut Report) {
    report.heading("Suspicions against the lecture notes");
    report.say(
        "*Rasterization* is the set of lecture notes with Bresenham's line, tie-breaks and backtracking; *6.837* is MIT's \
         Lecture 6, *CISC 440/640* Delaware's Lecture 13, both named Scan Converting Triangles; *guidelines* are those of the \
         lecture notes *Triangle Rasterization*. Each suspicion was run:",
    );
    let mut found = Vec::new();
    found.extend(of_lines());
    found.extend(of_circles());
    found.extend(of_triangles());
    let rows: Vec<Vec<String>> = found
        .into_iter()
        .map(|Suspicion { what, run, found, is_wrong }| {
            vec![what.into(), run, found, if is_wrong { "wrong" } else { "only looks wrong" }.into()]
        })
        .collect();
    report.table(&["suspicion", "what was run", "what came of it", "verdict"], &rows);
}

/// What an option makes of a scene.
fn tally(suite: &Suite, method: &str, option: &str, scene: &str) -> Tally {
    let scene = suite.scenes.iter().position(|(name, _)| *name == scene).expect("a scene of the suite");
    suite.tally(entry(suite, method, option), scene, usize::MAX, &mut new_picture())
}

fn entry<'a>(suite: &'a Suite, method: &str, option: &str) -> &'a Entry {
    let is_wanted = |entry: &&Entry| entry.method == method && entry.option == option;
    suite.entries.iter().find(is_wanted).unwrap_or_else(|| panic!("no {method}: {option}"))
}

fn wrong(tally: &Tally) -> String {
    format!(
        "{} missing, {} extra, {} twice, {} by another tie, of {}",
        tally.missing, tally.extra, tally.doubled, tally.moved, tally.pixels
    )
}

fn of_lines() -> Vec<Suspicion> {
    let suite = lines::suite();
    let [printed, derived] = ["d <= 0", "d < 0"].map(|option| tally(&suite, "Bresenham", option, "first octant"));
    let [dropped, kept] =
        ["nearest, xi < dx", "nearest, xi <= dx"].map(|option| tally(&suite, "y = mx + b", option, "first octant"));
    let floor = tally(&suite, "y = mx + b", "floor, xi <= dx", "first octant");
    let lines = suite.scenes.iter().find(|(name, _)| *name == "first octant").map_or(0, |(_, lines)| *lines);
    vec![
        Suspicion {
            what: "Rasterization: `d <= 0` in the code of Bresenham's line, `d < 0` in its derivation",
            run: format!("both on {lines} lines of the first octant"),
            found: format!("`d <= 0`: {}; `d < 0`: {}", wrong(&printed), wrong(&derived)),
            is_wrong: printed.wrong() + derived.wrong() > 0,
        },
        Suspicion {
            what: "Rasterization: `xi < dx` in the loop of y = mx + b",
            run: format!("rounded to the nearest, on the same {lines} lines"),
            found: format!("`xi < dx`: {}; `xi <= dx`: {}", wrong(&dropped), wrong(&kept)),
            is_wrong: dropped.wrong() > 0,
        },
        Suspicion {
            what: "Rasterization: `floor(yt)` where the nearest row is meant",
            run: "`xi <= dx`, on the same lines".into(),
            found: wrong(&floor),
            is_wrong: floor.wrong() > 0,
        },
    ]
}

fn of_circles() -> Vec<Suspicion> {
    let suite = circles::suite();
    let [cut, derived, without] = ["5 / 4 - r in integers, outline", "5/4 - r, outline", "without + 5, outline"]
        .map(|option| tally(&suite, "midpoint", option, "radii"));
    let four = tally(&suite, "4-way symmetry", "nearest, outline", "radii");
    let truncated = tally(&suite, "8-way symmetry", "truncated, outline", "radii");
    let apart = |tally: &Tally| tally.missing + tally.extra;
    vec![
        Suspicion {
            what: "Rasterization: `d = 5 / 4 - r`, which is 1 - r in integers",
            run: "the midpoint circle with both, radii 1 to 100".into(),
            found: format!("in integers: {}; with the quarter: {}", wrong(&cut), wrong(&derived)),
            is_wrong: apart(&cut) > 0,
        },
        Suspicion {
            what: "Rasterization: the listing of the midpoint circle ends `d + 2*(x - y) +`, without the 5",
            run: "without it, radii 1 to 100".into(),
            found: wrong(&without),
            is_wrong: apart(&without) > 0,
        },
        Suspicion {
            what: "Rasterization: gaps in outlines by 4-way symmetry",
            run: "with rounded roots, radii 1 to 100".into(),
            found: wrong(&four),
            is_wrong: four.missing > 0,
        },
        Suspicion {
            what: "Rasterization: `(int) sqrt(..)` for the nearest pixel",
            run: "8-way symmetry, radii 1 to 100".into(),
            found: wrong(&truncated),
            is_wrong: apart(&truncated) > 0,
        },
    ]
}

fn of_triangles() -> Vec<Suspicion> {
    let suite = triangles::suite("triangle: inside test");
    let [table, fixed] =
        ["six-entry table", "six-entry table, F = 12"].map(|option| tally(&suite, "bounding box", option, "equal x"));
    let [centres, wide, narrow] = ["centres", "(int) min to (int) (max + 1)", "(int) (min + .5) to (int) (max - .5)"]
        .map(|option| tally(&suite, "bounding box", option, "slivers"));
    let java = tally(&suite, "as printed", "FlatTri, Java", "slivers");
    let centred = tally(&suite, "samples", "centres", "slivers");
    let mut picture = new_picture();
    let (power, _) = first_failure(&suite, entry(&suite, "edge equations", "F = 12, 32 bits"), &mut picture);
    let (power_64, _) = first_failure(&suite, entry(&suite, "edge equations", "F = 12, 64 bits"), &mut picture);
    let named = |power: Option<usize>| power.map_or_else(|| "never".into(), |k| format!("2^{k} px away"));
    vec![
        Suspicion {
            what: "6.837: the six-entry table is read with index 6 or -1 where all x are equal and the truncated area is not zero",
            run: "200 triangles with equal x".into(),
            found: format!(
                "in f64: {} refused, {}; with 12 fraction bits, as printed: {} refused (an exception in Java), {}",
                table.refused,
                wrong(&table),
                fixed.refused,
                wrong(&fixed)
            ),
            is_wrong: table.refused + fixed.refused + table.wrong() + fixed.wrong() > 0,
        },
        Suspicion {
            what: "6.837: boxes from `(int) min` to `(int) (max + 1)` are a pixel too large",
            run: "the slivers".into(),
            found: format!("{} pixels looked at in place of {}; {}", wide.visited, centres.visited, wrong(&wide)),
            is_wrong: wide.wrong() > centres.wrong(),
        },
        Suspicion {
            what: "guidelines: boxes from `(int) (min + .5)` to `(int) (max - .5)` lose pixels",
            run: "the slivers".into(),
            found: format!("{} pixels looked at in place of {}; {}", narrow.visited, centres.visited, wrong(&narrow)),
            is_wrong: narrow.wrong() > centres.wrong(),
        },
        Suspicion {
            what: "6.837: samples lie at integer coordinates, not at the pixels' centres",
            run: "FlatTri as printed on the slivers, held against centres".into(),
            found: format!("{}; the same equations at centres: {}", wrong(&java), wrong(&centred)),
            is_wrong: java.wrong() > centred.wrong(),
        },
        Suspicion {
            what: "6.837: edge equations with 12 fraction bits leave 32 bits",
            run: "vertices 2^k px away, by words of 32 and 64 bits".into(),
            found: format!("32 bits: wrong from {}; 64 bits: {}", named(power), named(power_64)),
            is_wrong: power.is_some_and(|k| power_64.is_none_or(|other| k < other)),
        },
    ]
}
