//! How fast spanfill must at least be on real drawings, and how its times may grow.

use std::fmt;

use crate::{
    gallery::{NOISY, growth::Query, row::Rows},
    variant::Variant,
};

/// At most this of vello_cpu's time at its baseline.
const PART_OF_VELLO: f64 = 1.0;
/// Where strokes cross themselves.
const PART_OF_VELLO_CROSSING: f64 = 1.4;
const CROSSING: [&str; 2] = ["stroked-icons", "stroked-world"];
/// On the chart of noise.
const PART_OF_VELLO_NOISY: f64 = 2.0;
/// As the geometric mean of all.
const MEAN_PART_OF_VELLO: f64 = 0.8;
/// Without anti-aliasing, as the geometric mean of all.
const MEAN_PART_OF_TINY_SKIA: f64 = 0.6;
/// The largest error, in 255ths: rounded once, and a little for where the exact area is not exact.
const ERROR: f64 = 0.52;
/// What grows in proportion may be so much off it: vello_cpu's is.
const LINEAR: f64 = 1.1;
/// Four times the work, in n log n, and a little for what a cache no longer holds.
const QUERY_GROWTH: f64 = 5.0;

/// A bar and what was measured.
#[derive(Debug, Clone)]
pub(crate) struct Verdict {
    what: String,
    at_most: f64,
    measured: f64,
}

impl Verdict {
    pub(crate) fn is_reached(&self) -> bool {
        self.measured <= self.at_most
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, at_most, measured } = self;
        let verdict = if self.is_reached() { "reached" } else { "NOT reached" };
        write!(f, "{what:<66} at most {at_most:>5.2}: {measured:>6.2}, {verdict}")
    }
}

/// The bars for what was measured.
pub(super) fn verdicts(rows: &Rows, queries: &[Query]) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    let mut add = |what: String, at_most: f64, measured: Option<f64>| {
        verdicts.extend(measured.map(|measured| Verdict { what, at_most, measured }));
    };
    let drawings = rows.drawings();
    for name in &drawings {
        let ratio = rows.ratio(name, Variant::AntiAliased, Variant::VelloBaseline);
        add(format!("{name}: spanfill-aa / vello-cpu-baseline"), part_of_vello(name), ratio);
    }
    for name in &drawings {
        let error = rows.get(name, Variant::Mask).and_then(|row| row.error);
        add(format!("{name}: largest error of spanfill's coverage, in 255ths"), ERROR, error.map(|error| error.max));
    }
    // A single drawing is no mean.
    if drawings.len() > 1 {
        let mean = rows.mean_ratio(&drawings, Variant::AntiAliased, Variant::VelloBaseline);
        add("all, geometric mean: spanfill-aa / vello-cpu-baseline".into(), MEAN_PART_OF_VELLO, mean);
        let mean = rows.mean_ratio(&drawings, Variant::Aliased, Variant::TinySkia);
        add("all, geometric mean: spanfill-aliased / tiny-skia".into(), MEAN_PART_OF_TINY_SKIA, mean);
    }

    for (from, to) in rows.growths() {
        if let Some((cost, vertices)) = rows.growth(&from, &to, Variant::AntiAliased) {
            // More samples of noise are as much more work; a cut edge is the same edge.
            let at_most = if to.contains('/') { vertices } else { vertices * LINEAR };
            add(format!("{to}: growth of spanfill-aa from {from}"), at_most, Some(cost));
        }
        if to.contains('/') {
            let ratio = rows.ratio(&to, Variant::AntiAliased, Variant::VelloBaseline);
            add(format!("{to}: spanfill-aa / vello-cpu-baseline"), 1.0, ratio);
        }
    }
    for pair in queries.windows(2) {
        let growth = pair[1].sorted_ns / pair[0].sorted_ns;
        let what = format!("coverage_edges_in: growth from {} to {} vertices", pair[0].vertices, pair[1].vertices);
        add(what, QUERY_GROWTH, Some(growth));
    }
    verdicts
}

fn part_of_vello(name: &str) -> f64 {
    if name.starts_with(NOISY) {
        PART_OF_VELLO_NOISY
    } else if CROSSING.contains(&name) {
        PART_OF_VELLO_CROSSING
    } else {
        PART_OF_VELLO
    }
}
