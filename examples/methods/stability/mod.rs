//! The stability report: every method by adversarial cases.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

mod attributes;
mod circles;
mod coverage;
mod lines;
mod numbers;
mod polygons;
mod report;
mod shared;
mod suspicions;
mod triangles;

pub(crate) use report::Report;

/// The whole report.
pub(crate) fn report(mut progress: impl FnMut(&str)) -> Report {
    let mut report = Report::default();
    report.text.push_str(HEAD);
    type Part = fn(&mut Report);
    let parts: [(&str, Part); 9] = [
        ("triangles", triangles::report),
        ("shared edges", shared::report),
        ("attributes", attributes::report),
        ("lines", lines::report),
        ("circles", circles::report),
        ("polygons", polygons::report),
        ("anti-aliasing", coverage::report),
        ("numbers", numbers::report),
        ("suspicions", suspicions::report),
    ];
    for (name, part) in parts {
        progress(name);
        part(&mut report);
    }
    report
}

const HEAD: &str = "\
<!-- Made by `cargo run --release --example stability`; `cargo test --test methods` holds it against the code. -->
# Where methods fail

Every method of `spanfill::methods` is drawn where it is hardest, and held against the exact oracle of the tests, which
shares no code with the crate. Each case says what goes wrong, how often, and shows the worst of it: blue is right, full
red is a pixel too many, hollow red one that is missing, purple one that came twice, yellow one that only another rule
for ties moves, a red dot how far a value is off. `spanfill` is what the crate ships.

[`METHODS.md`](METHODS.md) says which method to choose; the [gallery](gallery) shows each on an easy scene.
";
