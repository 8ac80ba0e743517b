//! The polygon methods of the literature: the list is complete, the exact ones are exact, and how often the others are
//! wrong is written down in `tests/methods/polygon.txt`. `BLESS=1` writes it anew.

mod oracle;
#[path = "methods/pictures.rs"]
mod pictures;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use std::{
    convert::Infallible,
    f64::consts::TAU,
    fmt::Write as _,
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::Path,
};

use oracle::{Belongs, Rng};
use pictures::picture;
use spanfill::{
    FillRule, FragmentSink, PixelRect, Vertex,
    methods::polygon::{Failure, METHODS, ear, fan, scan_line, seed},
};
use variants::{
    HEIGHT, Picture, SCREEN, Variant, WIDTH,
    polygon::{Outline, POLYGONS},
};

/// Contours of a test, as long as the program runs: a few hundred small ones.
fn outline(contours: Vec<Vec<[i32; 2]>>, even_odd: bool) -> Outline {
    let contours: Vec<&'static [[i32; 2]]> = contours.into_iter().map(|contour| &*contour.leak()).collect();
    Outline { contours: contours.leak(), even_odd }
}

fn rule_of(outline: &Outline) -> oracle::Outline {
    let vertices = |contour: &&[[i32; 2]]| contour.iter().map(|[x, y]| Vertex::from_bits(*x, *y)).collect();
    let rule = if outline.even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
    oracle::Outline::new(outline.contours.iter().map(vertices).collect(), rule)
}

const KINDS: [&str; 8] = ["convex", "star", "crossing", "holes", "lattice", "sliver", "screen", "far"];

/// A shape of a kind; all but the last two lie on the screen, within some 100 pixels.
fn shape(kind: &str, rng: &mut Rng) -> Outline {
    let centre = [rng.int(70..=250) * 256 + rng.int(0..=255), rng.int(70..=170) * 256 + rng.int(0..=255)];
    let at = |angle: f64, radius: f64| {
        [centre[0] as f64 + radius * angle.cos(), centre[1] as f64 + radius * angle.sin()].map(|c| c as i32)
    };
    let around = |rng: &mut Rng, count: i64, inner: i64, outer: i64| -> Vec<[i32; 2]> {
        let step = TAU / count as f64;
        (0..count).map(|i| at(step * i as f64, rng.int(inner * 256..=outer * 256) as f64)).collect()
    };
    let count = rng.int(3..=16);
    let even_odd = rng.one_in(2);
    let contours = match kind {
        "convex" => vec![around(rng, count, 55, 55)],
        "star" => vec![around(rng, count.max(5), 10, 60)],
        "crossing" => {
            let mut vertices = around(rng, count.max(4), 5, 60);
            rng.shuffle(&mut vertices);
            vec![vertices]
        }
        "holes" => {
            let mut hole = around(rng, count.max(5), 22, 28);
            let mut island = around(rng, 5, 8, 12);
            if !even_odd {
                hole.reverse();
            }
            island.rotate_left(1);
            vec![around(rng, count.max(5), 45, 60), hole, island]
        }
        // Centres, corners and middles of sides of pixels: vertices on scan lines, horizontal edges, ties.
        "lattice" => {
            let mut vertices = around(rng, count.max(5), 3, 20);
            vertices.iter_mut().flatten().for_each(|c| *c = *c / 128 * 128);
            vec![vertices]
        }
        "sliver" => {
            let [a, b] = [0.0, TAU / 2.0].map(|turn| at(rng.int(0..=628) as f64 / 100.0 + turn, 60.0 * 256.0));
            let c = [a[0] + rng.int(-300..=300) as i32, a[1] + rng.int(-300..=300) as i32];
            vec![vec![a, b, c]]
        }
        "screen" => {
            let mut corner = || [rng.int(-200..=520) * 256, rng.int(-200..=440) * 256].map(|c| c as i32 + 77);
            vec![vec![corner(), corner(), corner(), corner(), corner()]]
        }
        "far" => {
            let mut coordinate = |power: u32| rng.int(-(1 << power)..=1 << power) as i32;
            vec![(0..4).map(|i| [coordinate(14 + 4 * i), coordinate(14 + 4 * i)]).collect()]
        }
        _ => unreachable!("{kind}"),
    };
    outline(contours, even_odd)
}

/// How a variant's pictures differ from the rule's.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
struct Errors {
    refused: u32,
    covered: u64,
    missing: u64,
    extra: u64,
    doubled: u64,
}

impl Errors {
    fn is_exact(&self) -> bool {
        (self.refused, self.missing, self.extra, self.doubled) == (0, 0, 0, 0)
    }
}

fn draw(
    variant: &Variant<Outline>,
    outline: &Outline,
    clip: &PixelRect,
    picture: &mut Picture,
) -> Result<(), &'static str> {
    picture.count.fill(0);
    picture.outside = 0;
    let result = (variant.check)(outline, clip, picture);
    let name = || format!("{} {}, {outline:?}", variant.method, variant.option);
    assert_eq!(picture.outside, 0, "{}", name());
    if result.is_err() {
        assert!(picture.count.iter().all(|count| *count == 0), "drawn and refused: {}", name());
    }
    for (at, _) in picture.count.iter().enumerate().filter(|(_, count)| **count > 0) {
        let (x, y) = (at as i32 % WIDTH, at as i32 / WIDTH);
        assert!(clip.columns.contains(&x) && clip.rows.contains(&y), "({x}, {y}) is outside of the clip: {}", name());
    }
    result
}

fn compare(picture: &Picture, expected: &[bool], errors: &mut Errors) {
    for (count, expected) in picture.count.iter().zip(expected) {
        errors.covered += u64::from(*expected);
        errors.missing += u64::from(*expected && *count == 0);
        errors.extra += u64::from(!*expected && *count > 0);
        errors.doubled += u64::from(count.saturating_sub(1));
    }
}

fn expected(outline: &Outline) -> Vec<bool> {
    let rule = rule_of(outline);
    let rows = (0..HEIGHT).map(|row| {
        let has = rule.has_in_row(row);
        (0..WIDTH).map(has).collect::<Vec<bool>>()
    });
    rows.collect::<Vec<_>>().concat()
}

/// The errors of every variant on each kind of shape.
fn measure(shapes: u64) -> Vec<(&'static Variant<Outline>, Vec<Errors>)> {
    let mut picture = picture();
    let mut all: Vec<_> = POLYGONS.iter().map(|variant| (variant, vec![Errors::default(); KINDS.len()])).collect();
    for (kind, name) in KINDS.into_iter().enumerate() {
        for case in 0..shapes {
            let outline = shape(name, &mut Rng::new(12, case));
            let expected = expected(&outline);
            for (variant, errors) in &mut all {
                match draw(variant, &outline, &SCREEN, &mut picture) {
                    Ok(()) => compare(&picture, &expected, &mut errors[kind]),
                    Err(_) => errors[kind].refused += 1,
                }
            }
        }
    }
    all
}

#[test]
fn every_method_and_option_is_a_variant() {
    let mut listed: Vec<(&str, &str)> = METHODS.iter().flat_map(|m| m.options.iter().map(|o| (m.name, *o))).collect();
    listed.push(("spanfill", ""));
    let variants: Vec<(&str, &str)> = POLYGONS.iter().map(|v| (v.method, v.option)).collect();
    assert_eq!(variants, listed);
    assert!(POLYGONS.iter().all(|variant| variant.family == "polygon"));
    assert!(METHODS.iter().all(|method| !method.source.is_empty()));
}

/// What is exact is asserted; what is not is as wrong as it was.
#[test]
fn exact_methods_are_exact_and_the_others_as_wrong_as_recorded() {
    let all = measure(40);
    for (variant, errors) in &all {
        let exact: &[&str] = match (variant.method, variant.option) {
            ("scan line", "exact") | ("spanfill", "") => &KINDS,
            ("convex fan", "top-left rule") => &["convex", "sliver"],
            // New vertices are rounded, others are not.
            ("ear clipping", "fixed") => &["convex", "star", "holes", "lattice", "sliver"],
            _ => &[],
        };
        for (kind, errors) in KINDS.iter().zip(errors) {
            assert!(
                errors.is_exact() || !exact.contains(kind),
                "{} {}, {kind}: {errors:?}",
                variant.method,
                variant.option
            );
        }
    }
    let mut text = String::from(
        "What the polygon methods get wrong on 40 shapes of each kind, seed 12, against the exact rule.\n\
         Generated by tests/methods_polygon.rs with BLESS=1.\n\n",
    );
    writeln!(
        text,
        "{:55}{:>10}{:>9}{:>9}{:>9}{:>9}",
        "method, option, kind", "pixels", "missing", "extra", "doubled", "refused"
    )
    .unwrap();
    for (variant, errors) in &all {
        for (kind, errors) in KINDS.iter().zip(errors) {
            let name = format!("{}, {}, {kind}", variant.method, variant.option);
            let Errors { refused, covered, missing, extra, doubled } = errors;
            writeln!(text, "{name:55}{covered:>10}{missing:>9}{extra:>9}{doubled:>9}{refused:>9}").unwrap();
        }
    }
    compare_with_recorded(&text);
}

fn compare_with_recorded(text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/methods/polygon.txt");
    if std::env::var_os("BLESS").is_some() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
    }
    let recorded = fs::read_to_string(&path).expect("BLESS=1 writes tests/methods/polygon.txt");
    for (new, old) in text.lines().zip(recorded.lines()) {
        assert_eq!(new, old, "better or worse than recorded; BLESS=1 writes {} anew", path.display());
    }
    assert_eq!(text, recorded);
}

/// All ways to grow from a seed reach the same pixels: the bounded stacks, too.
#[test]
fn all_seed_fills_fill_the_same() {
    let mut picture = picture();
    let groups: [&[(&str, &str)]; 2] = [
        &[
            ("seed fill by pixels", "4-connected"),
            ("seed fill by spans", "Smith"),
            ("seed fill by spans", "Heckbert"),
            ("seed fill with rescan", "1 entry"),
            ("seed fill with rescan", "4 entries"),
            ("seed fill with rescan", "16 entries"),
            ("seed fill with walk", "no entry"),
            ("seed fill with walk", "1 entry"),
            ("seed fill with walk", "16 entries"),
        ],
        &[("seed fill by pixels", "8-connected"), ("seed fill by spans", "Heckbert, 8-connected")],
    ];
    for kind in KINDS {
        for case in 0..10 {
            let outline = shape(kind, &mut Rng::new(13, case));
            for group in groups {
                let mut first = None;
                for (method, option) in group {
                    let variant = POLYGONS.iter().find(|v| (v.method, v.option) == (*method, *option)).unwrap();
                    assert_eq!(draw(variant, &outline, &SCREEN, &mut picture), Ok(()), "{method} {option}");
                    let count = first.get_or_insert_with(|| picture.count.to_vec());
                    assert!(picture.count.as_slice() == &**count, "{method} {option}, {kind} {case}");
                }
            }
        }
    }
}

/// Every quadrilateral on a grid of half pixels: coincident vertices, collinear ones, crossings, ties.
#[test]
fn every_quadrilateral_of_a_small_grid_is_exact() {
    const SIDE: i32 = 5;
    let points: Vec<[i32; 2]> = (0..SIDE * SIDE).map(|i| [i % SIDE * 128, i / SIDE * 128]).collect();
    let clip = PixelRect { rows: -1..4, columns: -1..4 };
    let mut slots = vec![scan_line::Edge::<scan_line::Exact>::EMPTY; 4];
    let mut corners = vec![ear::Corner::<i32>::EMPTY; 64];
    let (mut wrong_ears, mut wrong_simple_ears, mut quads) = (0, 0, 0);
    for case in 0..points.len().pow(3) {
        // By symmetry, one vertex may stay.
        let vertices = [[256, 256], points[case % 25], points[case / 25 % 25], points[case / 625]];
        let owned = vertices.map(|[x, y]| Vertex::from_bits(x, y));
        for rule in [FillRule::NonZero, FillRule::EvenOdd] {
            let expected = oracle::Grid::of_rule(&oracle::Outline::of(&owned, rule), &clip);
            let contours: &[&[[i32; 2]]] = &[&vertices];
            let mut counts = Counts(oracle::Grid::new(clip.clone()));
            scan_line::fill(contours, rule, &clip, &mut slots, &mut counts).unwrap();
            oracle::check_same(&counts.0, &expected, || format!("{vertices:?} {rule:?}"));
            let mut counts = Counts(oracle::Grid::new(clip.clone()));
            ear::fill(contours, rule, &clip, &mut corners, &mut counts).unwrap();
            quads += 1;
            if counts.0 != expected {
                wrong_ears += 1;
                let shared = (0..4).any(|i| (0..i).any(|j| vertices[i] == vertices[j]));
                wrong_simple_ears += i32::from(!shared);
            }
        }
    }
    println!("ears: {wrong_ears} of {quads} wrong, {wrong_simple_ears} without coincident vertices");
    assert!(wrong_ears == 0, "ears: {wrong_ears} of {quads} wrong, {wrong_simple_ears} without coincident vertices");
}

/// Counts fragments in a window.
struct Counts(oracle::Grid);

impl FragmentSink for Counts {
    type Error = Infallible;

    fn fragment(&mut self, fragment: spanfill::Fragment) -> Result<(), Infallible> {
        self.0.add(fragment.y, &(fragment.x..fragment.x + 1));
        Ok(())
    }
}

/// A part of the screen shows what the whole does; of what grows from a seed, only where the part holds all of it.
#[test]
fn a_clip_shows_a_part_of_the_same_picture() {
    let mut picture = picture();
    let clips = [
        PixelRect { rows: 100..101, columns: 0..WIDTH },
        PixelRect { rows: 0..HEIGHT, columns: 133..170 },
        PixelRect { rows: 90..150, columns: 100..200 },
        PixelRect { rows: 5..5, columns: 0..9 },
        #[allow(clippy::reversed_empty_ranges, reason = "legal, and empty")]
        PixelRect { rows: 9..5, columns: 30..20 },
    ];
    for variant in POLYGONS {
        // Floats and fixed point start in the clip's first row, where rounding is another.
        let same = matches!(
            (variant.method, variant.option),
            ("scan line", "exact") | ("convex fan" | "ear clipping" | "spanfill", _)
        );
        for (kind, clip) in KINDS.into_iter().flat_map(|kind| clips.iter().map(move |clip| (kind, clip))) {
            let outline = shape(kind, &mut Rng::new(14, 0));
            if draw(variant, &outline, &SCREEN, &mut picture).is_err() {
                continue;
            }
            let whole = picture.count.to_vec();
            assert_eq!(draw(variant, &outline, clip, &mut picture), Ok(()));
            if same {
                for (at, (whole, part)) in whole.iter().zip(&picture.count).enumerate() {
                    let (x, y) = (at as i32 % WIDTH, at as i32 / WIDTH);
                    let inside = clip.columns.contains(&x) && clip.rows.contains(&y);
                    let expected = if inside { *whole } else { 0 };
                    assert_eq!(
                        *part, expected,
                        "{} {}, {kind}, ({x}, {y}) in {clip:?}",
                        variant.method, variant.option
                    );
                }
            }
        }
    }
}

/// The ends of the range, degenerate and empty outlines: no method panics or runs for ever.
#[test]
fn nothing_panics_at_the_ends_of_the_range_or_on_nothing() {
    let ends = [i32::MIN, i32::MIN + 1, -(1 << 23), -129, -128, 0, 127, 128, 40_000, 1 << 23, i32::MAX - 1, i32::MAX];
    let mut shapes = vec![vec![], vec![vec![]], vec![vec![[5000, 5000]]], vec![vec![[5000, 5000]; 9], vec![]]];
    let mut rng = Rng::new(15, 0);
    for _ in 0..60 {
        let vertices = (0..rng.int(1..=7)).map(|_| [rng.pick(&ends), rng.pick(&ends)]).collect();
        shapes.push(vec![vertices, vec![[rng.pick(&ends), rng.pick(&ends)], [0, 0], [60_000, 40_000]]]);
    }
    let outlines: Vec<Outline> =
        shapes.into_iter().flat_map(|contours| [false, true].map(|rule| outline(contours.clone(), rule))).collect();
    let check = |variants: &[Variant<Outline>]| {
        let mut picture = picture();
        for outline in &outlines {
            for variant in variants {
                let drawn = catch_unwind(AssertUnwindSafe(|| draw(variant, outline, &SCREEN, &mut picture)));
                assert!(drawn.is_ok(), "{} {}, {outline:?}", variant.method, variant.option);
            }
        }
    };
    let (some, others) = POLYGONS.split_at(POLYGONS.len() / 2);
    std::thread::scope(|scope| {
        scope.spawn(|| check(some));
        check(others);
    });
}

#[test]
fn not_a_number_and_infinity_end_like_numbers() {
    let specials = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        0.0,
        -0.0,
        10.5,
        100.0,
        1e9,
    ];
    let clip = PixelRect { rows: 0..20, columns: 0..30 };
    let mut rng = Rng::new(16, 0);
    for _ in 0..4000 {
        let vertices: Vec<[f32; 2]> = (0..rng.int(3..=6)).map(|_| [rng.pick(&specials), rng.pick(&specials)]).collect();
        let contours: &[&[[f32; 2]]] = &[&vertices, &[[3.0, 2.0], [20.0, 9.0], [4.0, 18.0]]];
        for rule in [FillRule::NonZero, FillRule::EvenOdd] {
            let mut slots = [scan_line::Edge::<scan_line::Float>::EMPTY; 16];
            scan_line::fill(contours, rule, &clip, &mut slots, &mut Anything).unwrap();
            let mut slots = [scan_line::Edge::<scan_line::Closed>::EMPTY; 16];
            scan_line::fill(contours, rule, &clip, &mut slots, &mut Anything).unwrap();
            let mut corners = vec![ear::Corner::<f32>::EMPTY; 512];
            ear::fill(contours, rule, &clip, &mut corners, &mut Anything).unwrap();
        }
    }
}

/// Takes fragments within the small clip.
struct Anything;

impl FragmentSink for Anything {
    type Error = Infallible;

    fn fragment(&mut self, fragment: spanfill::Fragment) -> Result<(), Infallible> {
        assert!((0..30).contains(&fragment.x) && (0..20).contains(&fragment.y));
        Ok(())
    }
}

/// What is too small names what is enough, and with that it is.
#[test]
fn scratch_too_small_is_refused_and_what_was_named_is_enough() {
    struct Nothing;
    impl FragmentSink for Nothing {
        type Error = &'static str;

        fn fragment(&mut self, _: spanfill::Fragment) -> Result<(), &'static str> {
            Err("nothing is taken")
        }
    }
    fn needed<E: std::fmt::Debug>(result: Result<(), Failure<E>>, had: usize) -> usize {
        match result {
            Err(Failure::TooLittleScratch { needed, available }) => {
                assert!(available == had && needed > had, "{needed}, {available}");
                needed
            }
            other => panic!("{other:?}"),
        }
    }
    // A pentagram: five vertices, five crossings.
    let star: &[[i32; 2]] = &[[2560, 300], [4200, 5000], [300, 2100], [4900, 2100], [1000, 5000]];
    let stars = [star];
    let (contours, rule, clip) = (stars.as_slice(), FillRule::EvenOdd, PixelRect { rows: 0..24, columns: 0..24 });

    let mut slots = [scan_line::Edge::<scan_line::Exact>::EMPTY; 64];
    let enough = needed(scan_line::fill(contours, rule, &clip, &mut slots[..1], &mut Nothing), 1);
    // One of them is horizontal.
    assert_eq!(enough, 4);
    assert_eq!(
        scan_line::fill(contours, rule, &clip, &mut slots[..enough], &mut Nothing),
        Err(Failure::Sink("nothing is taken"))
    );

    let mut corners = [ear::Corner::<i32>::EMPTY; 64];
    let few = needed(ear::fill(contours, rule, &clip, &mut corners[..2], &mut Nothing), 2);
    let enough = needed(ear::fill(contours, rule, &clip, &mut corners[..few], &mut Nothing), few);
    assert_eq!(enough, 5 + 5 * 4 + 2);
    assert_eq!(
        ear::fill(contours, rule, &clip, &mut corners[..enough], &mut Nothing),
        Err(Failure::Sink("nothing is taken"))
    );

    let mut words = [0; 24];
    assert_eq!(
        seed::Canvas::new::<()>(&clip, &mut words[..3]).map(|_| ()),
        Err(Failure::TooLittleScratch { needed: 24, available: 3 })
    );
    let mut canvas = seed::Canvas::new::<()>(&clip, &mut words).unwrap();
    seed::draw(contours, seed::Touch::Sides, &mut canvas);
    let mut returns = [seed::Return::default(); 24 * 24];
    let centre = [10, 11];
    let enough = needed(seed::by_pixels(&mut canvas, centre, seed::Touch::Sides, &mut returns[..9], &mut Nothing), 9);
    assert_eq!(
        seed::by_pixels(&mut canvas, centre, seed::Touch::Sides, &mut returns[..enough], &mut Nothing),
        Err(Failure::Sink("nothing is taken"))
    );
    let mut entries = [seed::Entry::EMPTY; 512];
    let enough = needed(seed::by_seeds(&mut canvas, centre, &mut entries[..9], &mut Nothing), 9);
    assert_eq!(
        enough,
        needed(seed::by_spans(&mut canvas, centre, seed::Touch::Sides, &mut entries[..9], &mut Nothing), 9)
    );
    assert_eq!(
        seed::by_spans(&mut canvas, centre, seed::Touch::Sides, &mut entries[..enough], &mut Nothing),
        Err(Failure::Sink("nothing is taken"))
    );
    assert_eq!(fan::fill(contours, fan::Ties::Both, &clip, &mut Nothing), Err("nothing is taken"));
}
