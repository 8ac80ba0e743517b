//! The circle methods of the literature against the nearest pixels.

#[path = "methods/canvas.rs"]
mod canvas;
mod oracle;
#[path = "methods/records.rs"]
mod records;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use canvas::{Drawn, assert_complete};
use oracle::{Belongs, Rng, rect, ring::Ring};
use records::Table;
use spanfill::{
    Fragment, FragmentSink, PixelRect,
    methods::circle::{
        far,
        functions::{Functions, Rounding},
        midpoint::{self, Decision},
        ngon,
        octant::Style,
        symmetry4, symmetry8,
    },
};
use variants::{
    SCREEN, Variant,
    circle::{CIRCLES, shipped},
};

#[test]
fn every_method_has_its_variants() {
    assert_complete("circle", CIRCLES);
}

fn variant(method: &str, option: &str) -> &'static Variant<[i32; 3]> {
    CIRCLES.iter().find(|variant| (variant.method, variant.option) == (method, option)).unwrap()
}

fn is_filled(variant: &Variant<[i32; 3]>) -> bool {
    variant.option.ends_with("filled")
}

fn ring([x, y, r]: [i32; 3]) -> Ring {
    Ring { center: [x.into(), y.into()], radius: r.into() }
}

#[test]
fn the_farthest_pixel_of_a_row_is_found() {
    for r in 0..=60 {
        let ring = ring([0, 0, r]);
        for (x, y) in (-1..=r + 2).flat_map(|x| (-1..=r + 2).map(move |y| (x, y))) {
            assert_eq!(ring.holds(x, y), ring.holds_by_search(x, y), "r = {r} at ({x}, {y})");
        }
    }
}

/// A circle in the middle of the screen, and what holds it with a pixel around.
fn circle(r: i32) -> ([i32; 3], PixelRect) {
    ([160, 120, r], rect(158 - r..163 + r, 118 - r..123 + r))
}

/// The radii that are counted.
const RADII: std::ops::RangeInclusive<i32> = 0..=100;

#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Wrong {
    pixels: usize,
    missing: usize,
    extra: usize,
    doubled: usize,
}

fn wrong(drawn: &Drawn, has: impl Fn(i32, i32) -> bool) -> Wrong {
    let mut wrong = Wrong::default();
    for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
        let has = has(x, y);
        wrong.pixels += usize::from(has);
        wrong.missing += usize::from(has && *count == 0);
        wrong.extra += usize::from(!has && *count > 0);
        wrong.doubled += usize::from(*count > 1);
    }
    wrong
}

/// Whether an outline has a hole: whether one gets, by steps along rows and columns, from the centre to the corner.
fn has_gap(drawn: &Drawn) -> bool {
    let (width, height) = (drawn.window.columns.len(), drawn.window.rows.len());
    let mut seen = vec![false; width * height];
    let mut waiting = vec![(width / 2, height / 2)];
    while let Some((x, y)) = waiting.pop() {
        let at = y * width + x;
        if drawn.counts[at] > 0 || seen[at] {
            continue;
        }
        if x == 0 || y == 0 || x == width - 1 || y == height - 1 {
            return true;
        }
        seen[at] = true;
        waiting.extend([(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]);
    }
    false
}

fn sum(a: Wrong, b: Wrong) -> Wrong {
    Wrong {
        pixels: a.pixels + b.pixels,
        missing: a.missing + b.missing,
        extra: a.extra + b.extra,
        doubled: a.doubled + b.doubled,
    }
}

#[test]
fn errors_are_those_recorded() {
    let mut outlines = Table::new(&["method", "option", "pixels", "missing", "extra", "doubled", "circles with a gap"]);
    let mut filled = Table::new(&[
        "method",
        "option",
        "pixels",
        "missing",
        "extra",
        "doubled",
        "off r + 1/2",
        "off x^2 + y^2 <= r^2",
    ]);
    for variant in CIRCLES {
        let (mut all, mut gaps, mut off_shipped, mut off_closed) = (Wrong::default(), 0, 0, 0);
        for r in RADII {
            let (circle, window) = circle(r);
            let drawn = Drawn::new(variant, &circle, &window).unwrap();
            if is_filled(variant) {
                all = sum(all, wrong(&drawn, |x, y| ring(circle).holds(x, y)));
                let by = |has: &dyn Fn(i32, i32) -> bool| {
                    let wrong = wrong(&drawn, has);
                    wrong.missing + wrong.extra
                };
                off_shipped += by(&|x, y| shipped(circle).has(x, y));
                off_closed += by(&|x, y| (x - 160).pow(2) + (y - 120).pow(2) <= r * r);
            } else {
                all = sum(all, wrong(&drawn, |x, y| ring(circle).has(x, y)));
                gaps += usize::from(r > 0 && has_gap(&drawn));
            }
        }
        let Wrong { pixels, missing, extra, doubled } = all;
        let names = [variant.method, variant.option].map(str::to_owned);
        let numbers = [pixels, missing, extra, doubled].map(|number| number.to_string());
        if is_filled(variant) {
            let others = [off_shipped, off_closed].map(|number: usize| number.to_string());
            filled.row([&names[..], &numbers[..], &others[..]].concat());
        } else {
            outlines.row([&names[..], &numbers[..], &[gaps.to_string()]].concat());
        }
    }
    records::compare("circle", &format!("{}\n{}\n{}", outlines.text(), filled.text(), sagitta().text()));
}

/// How far the outline of an n-gon is from the circle, of three sizes: pixels wrong, of those of the outline.
fn sagitta() -> Table {
    let mut table = Table::new(&["method", "option", "r = 10", "r = 40", "r = 100"]);
    for variant in CIRCLES.iter().filter(|variant| variant.method == "n-gon") {
        let mut row = vec![variant.method.to_owned(), variant.option.to_owned()];
        for r in [10, 40, 100] {
            let (circle, window) = circle(r);
            let drawn = Drawn::new(variant, &circle, &window).unwrap();
            let ring = ring(circle);
            let filled = is_filled(variant);
            let wrong = wrong(&drawn, |x, y| if filled { ring.holds(x, y) } else { ring.has(x, y) });
            row.push((wrong.missing + wrong.extra).to_string());
        }
        table.row(row);
    }
    table
}

/// The methods that are right.
fn exact() -> Vec<&'static Variant<[i32; 3]>> {
    let methods = ["5/4 - r", "5 / 4 - r in integers", "1 - r"].map(|option| ("midpoint", option));
    let others = [("8-way symmetry", "nearest"), ("second differences", "")];
    methods
        .iter()
        .chain(&others)
        .flat_map(|(method, option)| {
            ["outline", "filled"].map(|style| {
                let option = if option.is_empty() { style.to_owned() } else { format!("{option}, {style}") };
                variant(method, &option)
            })
        })
        .collect()
}

#[test]
fn exact_methods_are_the_nearest_pixels() {
    for r in 0..=112 {
        let (circle, window) = circle(r);
        for variant in exact() {
            let drawn = Drawn::new(variant, &circle, &window).unwrap();
            let ring = ring(circle);
            let filled = is_filled(variant);
            let wrong = wrong(&drawn, |x, y| if filled { ring.holds(x, y) } else { ring.has(x, y) });
            assert_eq!((wrong.missing, wrong.extra), (0, 0), "{}, {}: r = {r}", variant.method, variant.option);
            assert!(!filled || wrong.doubled == 0, "{}, {}: r = {r}", variant.method, variant.option);
        }
    }
}

/// Circles much larger than the screen, looked at where they pass through it.
#[test]
fn exact_methods_are_the_nearest_pixels_of_large_circles() {
    let mut rng = Rng::new(0xC14C1E, 0);
    let mut seen = 0;
    for case in 0..150 {
        let bits = rng.int(8..=15);
        let r = rng.int(100..=1 << bits) as i32;
        let x = rng.int(-i64::from(r)..=r.into());
        let y = (i64::from(r) * i64::from(r) - x * x).isqrt() * rng.pick(&[1, -1]);
        let (x, y) = if rng.one_in(2) { (x, y) } else { (y, x) };
        let circle = [(160 - x) as i32, (120 - y) as i32, r];
        let window = rect(145..175, 110..130);
        // Roots in an `f32` round from there on.
        for variant in exact().into_iter().filter(|variant| r < 2072 || variant.method != "8-way symmetry") {
            let drawn = Drawn::new(variant, &circle, &window).unwrap();
            let ring = ring(circle);
            for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
                let has = if is_filled(variant) { ring.holds(x, y) } else { ring.has(x, y) };
                assert_eq!(
                    *count > 0,
                    has,
                    "case {case}, {}, {}: {circle:?} at ({x}, {y})",
                    variant.method,
                    variant.option
                );
                seen += usize::from(has && !is_filled(variant));
            }
        }
    }
    assert!(seen > 10_000);
}

/// What is drawn of circles that are too large to be walked.
#[test]
fn far_circles_are_the_nearest_pixels() {
    let mut rng = Rng::new(0xFA4, 0);
    for case in 0..400 {
        let r = if case < 200 { rng.int(0..=40) } else { rng.int(1 << 16..=i64::from(i32::MAX)) };
        let x = rng.int(-r..=r);
        let y = (r * r - x * x).isqrt() * rng.pick(&[1, -1]);
        let center = [160 - x, 120 - y].map(|at| at.clamp(i32::MIN.into(), i32::MAX.into()) as i32);
        let circle = [center[0], center[1], r as i32];
        let mut pixels = Pixels::default();
        let clip = rect(150..170, 110..130);
        far::circle(circle, Style::Outline, &clip, &mut pixels).unwrap();
        for (x, y) in clip.rows.clone().flat_map(|row| clip.columns.clone().map(move |column| (column, row))) {
            assert_eq!(pixels.0.contains(&(x, y)), ring(circle).has(x, y), "{circle:?} at ({x}, {y})");
        }
    }
}

/// Fragments, in their order.
#[derive(Debug, Default, PartialEq)]
struct Pixels(Vec<(i32, i32)>);

impl FragmentSink for Pixels {
    type Error = std::convert::Infallible;

    fn fragment(&mut self, Fragment { x, y, .. }: Fragment) -> Result<(), Self::Error> {
        self.0.push((x, y));
        Ok(())
    }
}

/// A clip that sees the first octant's end of a circle around (0, 0).
fn octant(r: i32, draw: impl Fn(&PixelRect, &mut Pixels)) -> Pixels {
    let mut pixels = Pixels::default();
    let diagonal = (f64::from(r) * 0.5_f64.sqrt()) as i32;
    draw(&rect(0..diagonal + 1, diagonal..r + 2), &mut pixels);
    pixels.0.retain(|(x, y)| x <= y);
    pixels.0.sort_unstable();
    pixels.0.dedup();
    pixels
}

/// `5 / 4 - r` in integers is `1 - r`, and draws the same circles as `5/4 - r`.
#[test]
fn a_quarter_more_or_less_does_not_matter() {
    for r in (0..4000).chain((4000..=1 << 16).step_by(4093)) {
        let draw = |decision| {
            octant(r, |clip, pixels| midpoint::circle([0, 0, r], decision, Style::Outline, clip, pixels).unwrap())
        };
        let integer = draw(Decision::Integer);
        assert_eq!(draw(Decision::Printed), integer, "r = {r}");
        assert_eq!(draw(Decision::Derived), integer, "r = {r}");
    }
}

/// The smallest radius at which a method's octant is not the nearest pixels.
fn first_wrong(radii: impl Iterator<Item = i32>, draw: impl Fn(i32, &PixelRect, &mut Pixels)) -> Option<i32> {
    radii.into_iter().find(|r| {
        let drawn = octant(*r, |clip, pixels| draw(*r, clip, pixels));
        let right = octant(*r, |clip, pixels| far::circle([0, 0, *r], Style::Outline, clip, pixels).unwrap());
        drawn != right
    })
}

/// The `+ 5` that a listing lacks: without it, circles are wrong from a radius of 6 on.
#[test]
fn the_five_is_needed() {
    let draw = |decision| {
        first_wrong(0..200, move |r, clip, pixels| {
            midpoint::circle([0, 0, r], decision, Style::Outline, clip, pixels).unwrap();
        })
    };
    assert_eq!(draw(Decision::WithoutFive), Some(6));
    assert_eq!(draw(Decision::Integer), None);
}

/// Roots that round: `sqrt(y^2 + y)`, which is just below `y + 1/2`, comes out there; squares leave 24 bits, and 32.
#[test]
fn roots_round() {
    let nearest = |r: i32, clip: &PixelRect, pixels: &mut Pixels| {
        let (functions, rounding) = (Functions::Libm, Rounding::Nearest);
        symmetry8::circle([0, 0, r], functions, rounding, Style::Outline, clip, pixels).unwrap();
    };
    assert_eq!(first_wrong(0..6000, nearest), Some(2072));
    let cut_off = |r: i32, clip: &PixelRect, pixels: &mut Pixels| {
        let (functions, rounding) = (Functions::Libm, Rounding::Truncated);
        symmetry8::circle([0, 0, r], functions, rounding, Style::Outline, clip, pixels).unwrap();
    };
    let count = |r| octant(r, |clip, pixels| cut_off(r, clip, pixels)).0.len();
    assert!(count(46_340) > 30_000 && count(46_341) < 10_000, "{} and {}", count(46_340), count(46_341));
    // Cut off, a square less one that becomes a square is a pixel too far out.
    let first_rounded_up = (1..6000_i32).find(|r| {
        (1..*r).any(|x| {
            let square = r * r - x * x;
            (square as f32).sqrt() as i32 != square.isqrt()
        })
    });
    assert_eq!(first_rounded_up, Some(4097));
}

/// Filled by columns and cut off, 4-way symmetry is the closed disc.
#[test]
fn truncated_roots_fill_the_closed_disc() {
    for r in 0..=112 {
        let (circle, window) = circle(r);
        let drawn = Drawn::new(variant("4-way symmetry", "truncated, filled"), &circle, &window).unwrap();
        let wrong = wrong(&drawn, |x, y| (x - 160).pow(2) + (y - 120).pow(2) <= r * r);
        assert_eq!((wrong.missing, wrong.extra, wrong.doubled), (0, 0, 0), "r = {r}");
    }
}

/// 4-way symmetry has gaps from a radius on, and nothing else that is nearest does.
#[test]
fn only_4_way_outlines_have_gaps() {
    let gaps = |method, option| {
        (1..=100)
            .filter(|r| {
                let (circle, window) = circle(*r);
                has_gap(&Drawn::new(variant(method, option), &circle, &window).unwrap())
            })
            .collect::<Vec<i32>>()
    };
    assert_eq!(gaps("4-way symmetry", "truncated, outline"), (3..=100).collect::<Vec<_>>());
    assert_eq!(gaps("8-way symmetry", "nearest, outline"), Vec::<i32>::new());
    assert_eq!(gaps("midpoint", "1 - r, outline"), Vec::<i32>::new());
    assert_eq!(gaps("parametric", "libm, outline"), Vec::<i32>::new());
}

/// With enough vertices a polygon is as good as the circle, and with more it is no worse.
#[test]
fn more_vertices_are_better() {
    let (circle, window) = circle(100);
    let errors = [8, 16, 32, 64, 128].map(|n| {
        let drawn = Drawn::new(variant("n-gon", &format!("n = {n}, filled")), &circle, &window).unwrap();
        let wrong = wrong(&drawn, |x, y| shipped(circle).has(x, y));
        wrong.missing + wrong.extra
    });
    assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
}

/// Coordinates and radii at the ends of the range: each method ends, within the clip.
#[test]
fn bad_circles_end() {
    let numbers = [i32::MIN, i32::MIN + 1, -(1 << 20), -7, 0, 5, 160, 46_341, 1 << 20, i32::MAX - 1, i32::MAX];
    for variant in CIRCLES {
        for r in numbers {
            for (x, y) in
                [(i32::MIN, 0), (i32::MAX, i32::MAX), (160, 120), (160, -r.saturating_abs()), (r.saturating_sub(9), 77)]
            {
                for window in [SCREEN, rect(0..1, 0..1), rect(150..170, 3..3)] {
                    Drawn::new(variant, &[x, y, r], &window).unwrap();
                }
            }
        }
    }
}

/// Clips at the ends of the range.
#[test]
fn bad_clips_end() {
    let ranges = [i32::MIN..i32::MIN + 3, i32::MAX - 3..i32::MAX, -3..3, 5..5];
    for (rows, columns) in ranges.iter().flat_map(|rows| ranges.iter().map(move |columns| (rows, columns))) {
        let clip = PixelRect { rows: rows.clone(), columns: columns.clone() };
        for circle in
            [[i32::MIN, i32::MIN, i32::MAX], [i32::MAX, 0, 40], [i32::MAX, i32::MIN, 1 << 20], [0, 0, i32::MAX]]
        {
            for style in [Style::Outline, Style::Filled] {
                let mut pixels = Pixels::default();
                midpoint::circle(circle, Decision::Integer, style, &clip, &mut pixels).unwrap();
                symmetry4::circle(circle, Functions::Micromath, Rounding::Nearest, style, &clip, &mut pixels).unwrap();
                ngon::circle::<16, _>(circle, style, &clip, &mut pixels).unwrap();
                let inside = pixels.0.iter().all(|(x, y)| clip.columns.contains(x) && clip.rows.contains(y));
                assert!(inside, "{circle:?} in {clip:?}");
            }
        }
    }
}
