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

use std::{panic::resume_unwind, thread};

pub(crate) use report::Report;

/// The whole report: its parts are made beside each other.
pub(crate) fn report(mut progress: impl FnMut(&str)) -> Report {
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
    let mut report = Report::default();
    report.text.push_str(HEAD);
    thread::scope(|scope| {
        let making = parts.map(|(name, part)| {
            let of_part = move || {
                let mut report = Report::default();
                part(&mut report);
                report
            };
            (name, scope.spawn(of_part))
        });
        for (name, part) in making {
            progress(name);
            let part = part.join().unwrap_or_else(|panic| resume_unwind(panic));
            report.text.push_str(&part.text);
            report.pictures.extend(part.pictures);
        }
    });
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
