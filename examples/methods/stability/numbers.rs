//! Where numbers fail before anything is drawn.

use super::report::Report;

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
