//! Where numbers fail before anything is drawn.

use super::report::Report;
use crate::random::Random;

pub(crate) fn report(report: &mut Report) {
    report.heading("Loss of precision: the derivative of the sine");
    report.say(
        "The table of *6.837 Lecture 6: Scan Converting Triangles* (MIT), \"Loss of Precision\", in `f32`: the central \
         difference of the sine at 0.1. The smaller h, the better, until the difference of nearly equal numbers has no \
         digits left: the best is h = 0.001, and from 1e-9 on x + h is x. `=`: every printed digit is the lecture's.",
    );
    let rows: Vec<Vec<String>> = sine_table()
        .into_iter()
        .zip(PRINTED)
        .map(|(row, printed)| {
            let same = if row[1..] == printed.map(String::from) { "=" } else { "differs" };
            row.into_iter().chain([same.into()]).collect()
        })
        .collect();
    report.table(&["i", "h", "dydx", "rel. error", "printed"], &rows);
    constants(report);
}

/// How far C puts an edge of 10 px that is 2^k px from the origin, at worst of 200: in pixels, by `f32`.
fn constants(report: &mut Report) {
    report.heading("Loss of precision: C, by all formulas");
    report.say(
        "Edges of some 10 px, 2^k px from the origin, all in `f32`: how far the worst of 200 edges is moved at the middle of \
         itself, in pixels, by `C = x0 y1 - x1 y0`, by one vertex, by the average of both, and by differences without C. The \
         notes are right about the first: its products are as large as the square of the distance, and so is what they lose. \
         The others lose as much as A x has digits too many: a thousandth of that. The average is no better than one \
         vertex. Only differences lose nothing, as long as the coordinates themselves are exact.",
    );
    let rows: Vec<Vec<String>> = (6..=14)
        .map(|k| {
            let worst = constants_at(k);
            [k.to_string()].into_iter().chain(worst.map(|worst| format!("{worst:.6}"))).collect()
        })
        .collect();
    report.table(&["k", "cross product", "one vertex", "averaged", "differences"], &rows);
}

fn constants_at(k: i32) -> [f64; 4] {
    let mut worst = [0.0_f64; 4];
    for index in 0..200 {
        let mut random = Random::new(0xC0_57A7 + index);
        let far = 256 << k;
        let start = [far + random.below(far / 4), far + random.below(far / 4)];
        let end = [start[0] + 1280 + random.below(1280), start[1] + 1280 + random.below(1280)];
        // In 1/256 px all of this is exact.
        let [x0, y0, x1, y1] = [start[0], start[1], end[0], end[1]].map(|at| at as f32 / 256.0);
        let at = [(i64::from(start[0]) + i64::from(end[0])) / 512, (i64::from(start[1]) + i64::from(end[1])) / 512];
        let p = at.map(|pixel| 256 * pixel + 128);
        let (px, py) = (p[0] as f32 / 256.0, p[1] as f32 / 256.0);
        let [sx, sy, ex, ey] = [start[0], start[1], end[0], end[1]].map(i64::from);
        // A x + B y + C of the notes is the negative of this.
        let exact = ((ey - sy) * (p[0] - sx) - (ex - sx) * (p[1] - sy)) as f64 / -65536.0;
        let length = f64::from((x1 - x0).hypot(y1 - y0));
        let (a, b) = (y0 - y1, x1 - x0);
        let values = [
            a * px + b * py + (x0 * y1 - x1 * y0),
            a * px + b * py + (-a * x0 - b * y0),
            a * px + b * py + -0.5 * (a * (x0 + x1) + b * (y0 + y1)),
            a * (px - x0) + b * (py - y0),
        ];
        for (worst, value) in worst.iter_mut().zip(values) {
            *worst = worst.max((f64::from(value) - exact).abs() / length);
        }
    }
    worst
}

/// What the lecture prints.
const PRINTED: [[&str; 3]; 15] = [
    ["10.0", "-0.054130327", "-105.440216"],
    ["1.0", "0.83726716", "-15.8529"],
    ["0.1", "0.99334663", "-0.1665868"],
    ["0.01", "0.9949874", "-0.0016833"],
    ["9.999999E-4", "0.9950065", "2.3362527E-4"],
    ["9.999999E-5", "0.9949879", "-0.0016353768"],
    ["9.999999E-6", "0.99502516", "0.0021086177"],
    ["9.999999E-7", "0.9946526", "-0.035331327"],
    ["9.999999E-8", "0.9313227", "-6.400122"],
    ["9.999999E-9", "0.7450581", "-25.120102"],
    ["9.999999E-10", "0.0", "-100.0"],
    ["9.999999E-11", "0.0", "-100.0"],
    ["9.999999E-12", "0.0", "-100.0"],
    ["9.999999E-13", "0.0", "-100.0"],
    ["9.999999E-14", "0.0", "-100.0"],
];

/// The same computed: each operation in `f32`, the sine and the cosine in `f64` and rounded, as Java's.
pub(crate) fn sine_table() -> Vec<Vec<String>> {
    let x = 0.1_f32;
    let sine = |x: f32| libm::sin(f64::from(x)) as f32;
    let correct = libm::cos(f64::from(x)) as f32;
    let mut h = 10.0_f32;
    let mut rows = Vec::new();
    for i in 0..15 {
        let dydx = (sine(x + h) - sine(x - h)) / (2.0 * h);
        let error = 100.0 * (dydx - correct) / correct;
        rows.push(vec![i.to_string(), as_java(h), as_java(dydx), as_java(error)]);
        h /= 10.0;
    }
    rows
}

/// The shortest decimal number that is this one, as Java writes it.
fn as_java(value: f32) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        let text = format!("{value:E}");
        let (digits, exponent) = text.split_once('E').unwrap_or((&text, "0"));
        let point = if digits.contains('.') { "" } else { ".0" };
        return format!("{digits}{point}E{exponent}");
    }
    let text = format!("{value}");
    if text.contains('.') { text } else { format!("{text}.0") }
}
