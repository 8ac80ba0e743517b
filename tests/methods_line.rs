//! The line methods of the literature against the exact rule.

#[path = "methods/canvas.rs"]
mod canvas;
mod oracle;
#[path = "methods/records.rs"]
mod records;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use std::f64::consts::PI;

use canvas::{Drawn, assert_complete};
use oracle::{Belongs, HasArea, Rng, rect};
use records::Table;
use spanfill::{
    FragmentSink, PixelRect, Shape,
    methods::line::{
        bresenham::{self, East},
        dda::{self, Conversion},
        gupta_sproull::CONE,
        slope_intercept::{self, Last, Rounding},
        wu,
    },
};
use variants::{
    SCREEN, Variant,
    line::{LINES, shipped},
};

type Ends = [[i32; 2]; 2];

#[test]
fn every_method_has_its_variants() {
    assert_complete("line", LINES);
}

fn variant(method: &str, option: &str) -> &'static Variant<Ends> {
    LINES.iter().find(|variant| (variant.method, variant.option) == (method, option)).unwrap()
}

/// Whether coverage, not pixels, is what it draws.
fn is_smooth(variant: &Variant<Ends>) -> bool {
    ["Wu", "Gupta-Sproull"].contains(&variant.method) || variant.option == "exact coverage"
}

/// Whether a line passes through the middle between two pixels in the step of this pixel, which is one of the two.
fn is_tied([[x1, y1], [x2, y2]]: Ends, x: i32, y: i32) -> bool {
    let (dx, dy) = (x2 - x1, y2 - y1);
    let across = 2 * dx * (y - y1) - 2 * dy * (x - x1);
    across != 0 && across.abs() == dx.abs().max(dy.abs())
}

fn is_first_octant([[x1, y1], [x2, y2]]: Ends) -> bool {
    let (dx, dy) = (x2 - x1, y2 - y1);
    0 <= dy && dy <= dx
}

/// How the pixels of a variant differ from those of the rule.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Wrong {
    /// Of the rule.
    pixels: usize,
    missing: usize,
    extra: usize,
    /// Of both, those that the line is as near to as to another.
    tied: usize,
    doubled: usize,
}

impl Wrong {
    fn add(&mut self, line: Ends, drawn: &Drawn) {
        let rule = shipped(line);
        for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
            let has = rule.has(x, y);
            let is_wrong = has != (*count > 0);
            self.pixels += usize::from(has);
            self.missing += usize::from(has && is_wrong);
            self.extra += usize::from(!has && is_wrong);
            self.tied += usize::from(is_wrong && is_tied(line, x, y));
            self.doubled += usize::from(*count > 1);
        }
    }
}

/// Ends in a window of 48 x 40 pixels, so that all lie in it.
const WINDOW: PixelRect = PixelRect { rows: 4..44, columns: 4..52 };

fn lines(first_octant: bool) -> Vec<Ends> {
    let mut rng = Rng::new(0x11E5, 0);
    let mut lines = Vec::new();
    while lines.len() < 2000 {
        let mut end = || [rng.int(6..=49) as i32, rng.int(6..=41) as i32];
        let line = [end(), end()];
        if !first_octant || is_first_octant(line) {
            lines.push(line);
        }
    }
    lines
}

fn wrong(variant: &Variant<Ends>, lines: &[Ends]) -> Wrong {
    let mut wrong = Wrong::default();
    for line in lines {
        wrong.add(*line, &Drawn::new(variant, line, &WINDOW).unwrap());
    }
    wrong
}

/// The exact area of each pixel of the window, in 255ths.
fn areas(line: Ends) -> Vec<f64> {
    let near = |at: usize| (line[0][at].min(line[1][at]) - 2)..(line[0][at].max(line[1][at]) + 3);
    let (rows, columns) = (near(1), near(0));
    let row_of = |row: i32| {
        let mut areas = vec![0.0; WINDOW.columns.len()];
        let within = columns.start.max(WINDOW.columns.start)..columns.end.min(WINDOW.columns.end);
        let start = (within.start - WINDOW.columns.start) as usize;
        for (to, area) in areas[start..].iter_mut().zip(shipped(line).areas_in_row(row, &within)) {
            *to = 255.0 * area.value;
        }
        areas
    };
    WINDOW
        .rows
        .flat_map(|row| if rows.contains(&row) { row_of(row) } else { vec![0.0; WINDOW.columns.len()] })
        .collect()
}

/// The worst and the mean error, in 255ths, of pixels that have any of either.
fn smooth_errors(variant: &Variant<Ends>, lines: &[(Ends, Vec<f64>)]) -> (f64, f64) {
    let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0);
    for (line, areas) in lines {
        let drawn = Drawn::new(variant, line, &WINDOW).unwrap();
        for (coverage, area) in drawn.coverage.iter().zip(areas) {
            let error = (f64::from(*coverage) - area).abs();
            worst = worst.max(error);
            if *coverage > 0 || *area > 0.0 {
                (sum, count) = (sum + error, count + 1);
            }
        }
    }
    (worst, sum / f64::from(count))
}

#[test]
fn errors_are_those_recorded() {
    let mut table =
        Table::new(&["method", "option", "lines", "pixels", "missing", "extra", "of these tied", "doubled"]);
    let mut smooth = Table::new(&["method", "option", "lines", "worst of 255", "mean of 255"]);
    for (name, first_octant) in [("any", false), ("first octant", true)] {
        let lines = lines(first_octant);
        // A point covers nothing of any pixel.
        let with_areas: Vec<_> =
            lines.iter().filter(|line| line[0] != line[1]).map(|line| (*line, areas(*line))).collect();
        for variant in LINES {
            let names = [variant.method, variant.option, name].map(str::to_owned);
            if is_smooth(variant) {
                let (worst, mean) = smooth_errors(variant, &with_areas);
                smooth.row([&names[..], &[format!("{worst:.1}"), format!("{mean:.2}")]].concat());
            } else {
                let Wrong { pixels, missing, extra, tied, doubled } = wrong(variant, &lines);
                let numbers = [pixels, missing, extra, tied, doubled].map(|number| number.to_string());
                table.row([&names[..], &numbers[..]].concat());
            }
        }
    }
    records::compare("line", &format!("{}\n{}\n{}", table.text(), smooth.text(), drift().text()));
}

/// Every line between pixels of an 11 x 11 window, from its middle, in every direction: exact.
#[test]
fn exact_methods_are_the_rule_on_all_small_lines() {
    let window = rect(0..15, 0..15);
    let everywhere = [variant("Bresenham, directly", "ties down and right"), variant("spanfill", "")];
    let in_first_octant = [variant("Bresenham", "d < 0"), variant("Bresenham, by transformation", "d < 0")];
    let first_is_tied_down = variant("Bresenham, directly", "d < 0");
    let mut lines = 0;
    for index in 0..13 * 13 * 13 * 13 {
        let at = |power: u32| index / 13_i32.pow(power) % 13 + 1;
        let line = [[at(0), at(1)], [at(2), at(3)]];
        let mut exact: Vec<_> = everywhere.to_vec();
        if is_first_octant(line) {
            exact.extend(in_first_octant);
            exact.push(first_is_tied_down);
        }
        for variant in exact {
            let mut wrong = Wrong::default();
            wrong.add(line, &Drawn::new(variant, &line, &window).unwrap());
            let perfect = Wrong { pixels: wrong.pixels, ..Wrong::default() };
            assert_eq!(wrong, perfect, "{}, {}: {line:?}", variant.method, variant.option);
        }
        lines += 1;
    }
    assert_eq!(lines, 28561);
}

/// Lines that leave the screen, of up to 2^23 pixels: the clip changes nothing, and errors do not add up in integers.
#[test]
fn exact_methods_are_the_rule_on_long_lines() {
    let mut rng = Rng::new(0x10E6, 0);
    let mut drawn_pixels = 0;
    for case in 0..600 {
        let reach = 1 << rng.int(6..=22);
        let middle = [rng.int(100..=140), rng.int(100..=140)];
        let away = [rng.int(-reach..=reach), rng.int(-reach..=reach)];
        let other = [rng.int(-9..=9), rng.int(-9..=9)];
        let line = [
            [(middle[0] + away[0]) as i32, (middle[1] + away[1]) as i32],
            [(middle[0] - away[0] + other[0]) as i32, (middle[1] - away[1] + other[1]) as i32],
        ];
        let window = rect(90..150, 95..145);
        let mut exact = vec![variant("Bresenham, directly", "ties down and right")];
        if is_first_octant(line) {
            exact.push(variant("Bresenham", "d < 0"));
        }
        for variant in exact {
            let drawn = Drawn::new(variant, &line, &window).unwrap();
            for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
                assert_eq!(*count, u16::from(shipped(line).has(x, y)), "case {case}: {line:?} at ({x}, {y})");
                drawn_pixels += usize::from(*count);
            }
        }
    }
    assert!(drawn_pixels > 10_000);
}

/// `d <= 0` and `d < 0` differ where the line passes exactly between two pixels, and nowhere else.
#[test]
fn the_decision_at_zero_moves_only_ties() {
    for (option, is_exact) in [("d <= 0", false), ("d < 0", true)] {
        let wrong = wrong(variant("Bresenham", option), &lines(true));
        assert_eq!(wrong.missing + wrong.extra, wrong.tied, "{option}");
        assert_eq!(wrong.tied == 0, is_exact, "{option}");
    }
    // And in all directions, each method that is called nearest differs by ties alone.
    for (method, option) in [
        ("Bresenham, by transformation", "d <= 0"),
        ("Bresenham, by transformation", "d < 0"),
        ("Bresenham, directly", "d < 0"),
    ] {
        let wrong = wrong(variant(method, option), &lines(false));
        assert_eq!(wrong.missing + wrong.extra, wrong.tied, "{method}, {option}");
        assert!(wrong.tied > 0);
    }
}

/// `xi < dx`: of each line, the last column.
#[test]
fn less_than_dx_loses_the_last_pixel() {
    for line in lines(true) {
        let rows = |option| Drawn::new(variant("y = mx + b", option), &line, &WINDOW).unwrap();
        let (short, whole) = (rows("nearest, xi < dx"), rows("nearest, xi <= dx"));
        let lost: Vec<_> =
            whole.pixels().zip(whole.counts.iter().zip(&short.counts)).filter(|(_, (a, b))| a != b).collect();
        // A point has no slope: its only column is at whatever row a NaN is.
        let expected = if line[0] == line[1] { vec![] } else { vec![(line[1][0], line[1][1])] };
        assert_eq!(lost.iter().map(|(at, _)| *at).collect::<Vec<_>>(), expected, "{line:?}");
    }
}

/// `floor` for nearest: the row above wherever the line is past the middle.
#[test]
fn floor_takes_the_row_above_past_the_middle() {
    for line in lines(true) {
        let [[x1, y1], [x2, y2]] = line;
        let (dx, dy) = (x2 - x1, y2 - y1);
        let drawn = Drawn::new(variant("y = mx + b", "floor, xi < dx"), &line, &WINDOW).unwrap();
        let mut rows = 0;
        for ((x, y), _) in drawn.pixels().zip(&drawn.counts).filter(|(_, count)| **count > 0) {
            // In `f32`, a multiple of dy / dx that is whole may come out just below.
            let (row, rest) = ((dy * (x - x1)).div_euclid(dx), (dy * (x - x1)).rem_euclid(dx));
            assert!(y == y1 + row || rest == 0 && y == y1 + row - 1, "{line:?} at ({x}, {y})");
            rows += 1;
        }
        assert_eq!(rows, dx);
    }
}

/// Truncation and `floor` differ above the screen: two rows of the line are drawn as row 0.
#[test]
fn truncation_draws_row_zero_twice() {
    let line = [[10, -10], [50, 10]];
    let columns_in_row_0 = |conversion| {
        let mut count = Count::default();
        dda::line(line, conversion, &SCREEN, &mut count).unwrap();
        count.columns_in_row_0
    };
    assert_eq!(columns_in_row_0(Conversion::Truncated), 3);
    assert_eq!(columns_in_row_0(Conversion::Nearest), 2);
}

#[derive(Debug, Default)]
struct Count {
    columns_in_row_0: usize,
    all: usize,
}

impl FragmentSink for Count {
    type Error = std::convert::Infallible;

    fn fragment(&mut self, fragment: spanfill::Fragment) -> Result<(), Self::Error> {
        self.columns_in_row_0 += usize::from(fragment.y == 0);
        self.all += 1;
        Ok(())
    }
}

/// The smallest power of two of a line's length from which on a method draws a pixel that is not the nearest, near its
/// end; 64 lines of each length up to 2^22.
fn first_wrong_length(variant: &Variant<Ends>) -> Option<u32> {
    (4..=22).find(|power| {
        (0..64).any(|case| {
            let mut rng = Rng::new(0xD81F7, case);
            let length = 1_i64 << power;
            // Odd, so that no column is tied.
            let dx = length - 1 - 2 * rng.int(0..=length / 8);
            let dy = rng.int(0..=dx);
            let line = [[(150 - dx) as i32, (100 - dy) as i32], [150, 100]];
            let drawn = Drawn::new(variant, &line, &rect(140..151, 80..101)).unwrap();
            let mut pixels = drawn.pixels().zip(&drawn.counts);
            pixels.any(|((x, y), count)| (*count > 0) != shipped(line).has(x, y))
        })
    })
}

/// What adds up drifts; what is exact does not.
fn drift() -> Table {
    let mut table = Table::new(&["method", "option", "wrong from a length of"]);
    for variant in LINES.iter().filter(|variant| !is_smooth(variant)) {
        let length = first_wrong_length(variant).map_or("-".to_owned(), |power| format!("2^{power}"));
        table.row(vec![variant.method.to_owned(), variant.option.to_owned(), length]);
    }
    table
}

#[test]
fn integers_do_not_drift() {
    for (method, option) in [("Bresenham", "d < 0"), ("Bresenham, directly", "ties down and right"), ("spanfill", "")] {
        assert_eq!(first_wrong_length(variant(method, option)), None, "{method}, {option}");
    }
}

/// The decision variable, from `2 dy - 2 dx` to `2 dy`, leaves 32 bits with lines of more than 2^30 pixels.
#[test]
fn the_decision_wraps() {
    let nearest = |[[x1, y1], [x2, y2]]: Ends, x: i32| {
        let [x1, y1, x2, y2, x] = [x1, y1, x2, y2, x].map(i128::from);
        y1 + (2 * (x - x1) * (y2 - y1) + (x2 - x1)).div_euclid(2 * (x2 - x1))
    };
    for (dx, dy, is_right) in
        [((1 << 30) - 1, 1 << 29, true), (i32::MAX, 1 << 29, false), (i32::MAX, 1_500_000_000, false)]
    {
        let line = [[-dx / 2, -dy / 2], [dx - dx / 2, dy - dy / 2]];
        let drawn = Drawn::new(variant("Bresenham", "d < 0"), &line, &rect(0..100, 0..100)).unwrap();
        let mut pixels = drawn.pixels().zip(&drawn.counts);
        let all_right = pixels.all(|((x, y), count)| (*count > 0) == (nearest(line, x) == i128::from(y)));
        assert_eq!(all_right, is_right, "{dx}, {dy}");
    }
}

/// The table of the conical filter is the integral that it stands for.
#[test]
fn the_cone_is_integrated() {
    let chord = |s: f64| {
        let w = (1.0 - s * s).max(0.0).sqrt();
        let logarithm = if s.abs() > 0.0 && w > 0.0 { s * s * ((1.0 + w) / s.abs()).ln() } else { 0.0 };
        3.0 / PI * (w - logarithm)
    };
    let steps = 100_000;
    for (index, entry) in CONE.iter().enumerate() {
        let start = index as f64 / 16.0 - 0.5;
        let sum: f64 = (0..steps).map(|step| chord(start + (f64::from(step) + 0.5) / f64::from(steps))).sum();
        assert_eq!(f64::from(*entry), (255.0 * sum / f64::from(steps)).round(), "{index}");
    }
}

/// Wu's two ends: the same picture from either, and the first and last pixel wholly covered.
#[test]
fn wu_is_symmetric() {
    for line in lines(false) {
        let [start, end] = line;
        let both = variant("Wu", "16 bits, from both ends");
        let drawn = Drawn::new(both, &line, &WINDOW).unwrap();
        let at = |[x, y]: [i32; 2]| drawn.coverage[((y - WINDOW.rows.start) * 48 + x - WINDOW.columns.start) as usize];
        assert_eq!((at(start), at(end)), (255, 255), "{line:?}");
    }
}

/// Coordinates at the ends of the range, all pairs of them: each method ends, within the clip.
#[test]
fn bad_lines_end() {
    let ends = [i32::MIN, i32::MIN + 1, -(1 << 30), -1, 0, 7, 160, 1 << 30, i32::MAX - 1, i32::MAX];
    let windows = [SCREEN, rect(0..1, 0..1), rect(150..170, 3..3)];
    for variant in LINES {
        for (x1, y1) in ends.iter().flat_map(|x| ends.iter().map(move |y| (*x, *y))) {
            for (x2, y2) in
                [(i32::MIN, i32::MAX), (i32::MAX, i32::MAX), (i32::MAX, 0), (5, i32::MIN), (x1, y1), (160, 120)]
            {
                for window in &windows {
                    Drawn::new(variant, &[[x1, y1], [x2, y2]], window).unwrap();
                }
            }
        }
    }
}

/// Floats that are no numbers, infinite, or beyond what an `i32` holds.
#[test]
fn bad_floats_end() {
    let floats = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, f32::MIN_POSITIVE, -0.0, 12.5, 3e9];
    let mut fragments = 0;
    for a in floats {
        for b in floats {
            for line in [
                [[a, b], [1.0, 2.0]],
                [[1.0, 2.0], [a, b]],
                [[a, 1.0], [b, 2.0]],
                [[1.0, a], [2.0, b]],
                [[a, a], [b, b]],
            ] {
                let mut count = Count::default();
                wu::between_pixels(line, &SCREEN, &mut count).unwrap();
                fragments += count.all;
            }
        }
    }
    assert!(fragments > 0);
}

/// Clips at the ends of the range, which no screen has.
#[test]
fn bad_clips_end() {
    let ranges = [i32::MIN..i32::MIN + 3, i32::MAX - 3..i32::MAX, -3..3, 5..5];
    for rows in &ranges {
        for columns in &ranges {
            let clip = PixelRect { rows: rows.clone(), columns: columns.clone() };
            for line in
                [[[i32::MIN, i32::MIN], [i32::MAX, i32::MAX]], [[i32::MAX, -5], [i32::MIN, 5]], [[0, 0], [0, 0]]]
            {
                let mut count = Count::default();
                slope_intercept::line(line, Rounding::Nearest, Last::Drawn, &clip, &mut count).unwrap();
                bresenham::line(line, East::AtZero, &clip, &mut count).unwrap();
                dda::line(line, Conversion::Nearest, &clip, &mut count).unwrap();
                shipped(line).spans(&clip, &mut variants::line::Fragments(&mut count)).unwrap();
            }
        }
    }
}
