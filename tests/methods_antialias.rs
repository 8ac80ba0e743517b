//! The anti-aliasing of the literature against exact areas, and against every sample by itself.

#[path = "methods/canvas.rs"]
mod canvas;
mod oracle;
#[path = "methods/records.rs"]
mod records;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use std::{convert::Infallible, f64::consts::TAU};

use canvas::{Drawn, assert_complete};
use oracle::{
    Belongs, HasArea, Outline as OwnedOutline, Rng, random, rect,
    rule::{At, winding},
};
use records::Table;
use spanfill::{
    FillRule, Fragment, FragmentSink, Line, PixelRect, Vertex,
    methods::antialias::{
        Error, Outline, Side, accumulated, exact, grid,
        minified::{self, Sampling, Texture},
        ramp, rotated,
        sampled::SampleColumn,
        scene, weighted,
    },
    methods::line::gupta_sproull::Root,
};
use variants::{
    SCREEN, Variant,
    antialias::{ANTIALIAS, Scene, rectangle},
};

#[test]
fn every_method_has_its_variants() {
    assert_complete("anti-aliasing", ANTIALIAS);
}

fn variant(method: &str, option: &str) -> &'static Variant<Scene> {
    ANTIALIAS.iter().find(|variant| (variant.method, variant.option) == (method, option)).unwrap()
}

/// Scenes live as long as the program.
fn polygon(contours: &[Vec<Vertex>], fill_rule: FillRule) -> Scene {
    let contours: Vec<&'static [Vertex]> = contours.iter().map(|contour| &*contour.clone().leak()).collect();
    Scene::Polygon(contours.leak(), fill_rule)
}

const WINDOW: PixelRect = PixelRect { rows: 4..36, columns: 4..44 };

/// Of the window, in 1/256 pixel, in multiples of `step`.
fn vertex(rng: &mut Rng, step: i64) -> Vertex {
    let mut at = |pixels: &std::ops::Range<i32>| {
        let bits = 256 * i64::from(pixels.start + 1)..256 * i64::from(pixels.end - 1);
        rng.int(bits.start / step..=bits.end / step) * step
    };
    Vertex::from_bits(at(&WINDOW.columns) as i32, at(&WINDOW.rows) as i32)
}

/// Around the window's middle, by angle: of no edges that cross.
fn star(rng: &mut Rng) -> Vec<Vertex> {
    let count = rng.int(3..=12);
    let center = [24.0, 20.0];
    (0..count)
        .map(|index| {
            let angle = TAU * index as f64 / count as f64;
            let radius = rng.int(300..=3600) as f64 / 256.0;
            Vertex::new(center[0] + radius * angle.cos(), center[1] + radius * angle.sin())
        })
        .collect()
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Triangles,
    SmallTriangles,
    Stars,
    Overlaps,
    Lines,
}

const KINDS: [(&str, Kind); 5] = [
    ("triangles", Kind::Triangles),
    ("below 2 px", Kind::SmallTriangles),
    ("stars", Kind::Stars),
    ("overlaps", Kind::Overlaps),
    ("lines", Kind::Lines),
];

fn scene(kind: Kind, case: u64) -> Scene {
    let mut rng = Rng::new(0xAA, case);
    match kind {
        Kind::Triangles => Scene::Triangle([(); 3].map(|()| vertex(&mut rng, 1))),
        Kind::SmallTriangles => {
            let place = vertex(&mut rng, 1);
            let mut near = |at: i32| at + rng.int(-256..=256) as i32;
            Scene::Triangle([(); 3].map(|()| Vertex::from_bits(near(place.x.to_bits()), near(place.y.to_bits()))))
        }
        Kind::Stars => polygon(&[star(&mut rng)], random::fill_rule(&mut rng)),
        Kind::Overlaps => {
            let contours: Vec<Vec<Vertex>> =
                (0..rng.int(1..=2)).map(|_| (0..rng.int(4..=7)).map(|_| vertex(&mut rng, 1)).collect()).collect();
            polygon(&contours, random::fill_rule(&mut rng))
        }
        Kind::Lines => Scene::Line([(); 2].map(|()| vertex(&mut rng, 1))),
    }
}

/// The outline of a scene for the oracles.
fn outline(scene: &Scene) -> OwnedOutline {
    match scene {
        Scene::Triangle(vertices) => OwnedOutline::of(vertices, FillRule::NonZero),
        Scene::Line(ends) => OwnedOutline::of(&rectangle(*ends), FillRule::NonZero),
        Scene::Polygon(contours, fill_rule) => {
            OwnedOutline::new(contours.iter().map(|contour| contour.to_vec()).collect(), *fill_rule)
        }
        Scene::Texture { .. } => unreachable!(),
    }
}

/// The exact area of each pixel of the window, in 255ths.
fn areas(scene: &Scene) -> Vec<f64> {
    let row = |row: i32| match scene {
        Scene::Line([start, end]) => Line::new(*start, *end).areas_in_row(row, &WINDOW.columns),
        _ => outline(scene).areas_in_row(row, &WINDOW.columns),
    };
    WINDOW.rows.flat_map(row).map(|area| 255.0 * area.value).collect()
}

/// The worst and the mean error of pixels that have any coverage; none of a variant that draws no such scene.
fn errors(variant: &Variant<Scene>, scenes: &[(Scene, Vec<f64>)]) -> Option<(f64, f64)> {
    let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0);
    for (scene, areas) in scenes {
        let drawn = Drawn::new(variant, scene, &WINDOW)?;
        for (coverage, area) in drawn.coverage.iter().zip(areas) {
            let error = (f64::from(*coverage) - area).abs();
            worst = worst.max(error);
            if *coverage > 0 || *area > 0.0 {
                (sum, count) = (sum + error, count + 1);
            }
        }
    }
    Some((worst, sum / f64::from(count)))
}

fn scenes(kind: Kind) -> Vec<(Scene, Vec<f64>)> {
    let count = if matches!(kind, Kind::Stars | Kind::Overlaps) { 60 } else { 150 };
    (0..count).map(|case| scene(kind, case)).map(|scene| (scene, areas(&scene))).collect()
}

#[test]
fn errors_are_those_recorded() {
    let sets = KINDS.map(|(name, kind)| (name, scenes(kind)));
    let mut head = vec!["method".to_owned(), "option".to_owned()];
    for (name, _) in &sets {
        head.extend([format!("{name}: worst"), "mean".to_owned()]);
    }
    let mut table = Table::new(&head.iter().map(String::as_str).collect::<Vec<_>>());
    for variant in ANTIALIAS.iter().filter(|variant| variant.method != "minified texture") {
        let mut row = vec![variant.method.to_owned(), variant.option.to_owned()];
        for (_, scenes) in &sets {
            row.extend(match errors(variant, scenes) {
                Some((worst, mean)) => [format!("{worst:.1}"), format!("{mean:.2}")],
                None => ["-", "-"].map(str::to_owned),
            });
        }
        table.row(row);
    }
    records::compare("antialias", &format!("{}\n{}\n{}", table.text(), flicker().text(), textures().text()));
}

/// A square of 3/8 of a pixel that moves by sixteenths: the least and the most that it covers in all, of 36/255.
fn flicker() -> Table {
    let mut table = Table::new(&["method", "option", "least of 36", "most of 36"]);
    for variant in ANTIALIAS {
        let mut sums = Vec::new();
        for (x, y) in (0..16).flat_map(|x| (0..16).map(move |y| (16 * x, 16 * y))) {
            let corner = |right: i32, down: i32| Vertex::from_bits(2560 + x + 96 * right, 2560 + y + 96 * down);
            let contours = [[(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, down)| corner(right, down)).to_vec()];
            let Some(drawn) = Drawn::new(variant, &polygon(&contours, FillRule::NonZero), &WINDOW) else { continue };
            sums.push(drawn.coverage.iter().map(|coverage| u32::from(*coverage)).sum::<u32>());
        }
        if let (Some(least), Some(most)) = (sums.iter().min(), sums.iter().max()) {
            table.row(vec![variant.method.to_owned(), variant.option.to_owned(), least.to_string(), most.to_string()]);
        }
    }
    table
}

/// Grey squares of `side` texels.
fn checks(width: u16, height: u16, side: u16) -> &'static [u8] {
    let texels = (0..height)
        .flat_map(|y| (0..width).map(move |x| if (x / side + y / side).is_multiple_of(2) { 230 } else { 20 }));
    texels.collect::<Vec<u8>>().leak()
}

/// What a pixel of a minified texture holds, in `f64`, texel by texel.
fn texture_areas(texels: &[u8], [width, height]: [u16; 2], [columns, rows]: [u16; 2]) -> Vec<f64> {
    let overlap = |i: u16, pixels: u16, j: u16, count: u16| {
        let scale = f64::from(count) / f64::from(pixels);
        let (start, end) = (f64::from(i) * scale, f64::from(i + 1) * scale);
        (end.min(f64::from(j + 1)) - start.max(f64::from(j))).max(0.0) / scale
    };
    let mut averages = Vec::new();
    for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
        let mut sum = 0.0;
        for (j, i) in (0..height).flat_map(|j| (0..width).map(move |i| (j, i))) {
            let share = overlap(x, columns, i, width) * overlap(y, rows, j, height);
            sum += share * f64::from(texels[usize::from(j) * usize::from(width) + usize::from(i)]);
        }
        averages.push(sum);
    }
    averages
}

/// Checks of 1, 2, and 3 texels, made smaller by whole and other factors, as large as they are, and larger.
fn textures() -> Table {
    let mut table = Table::new(&["method", "option", "texels", "pixels", "checks", "worst", "mean"]);
    for option in ["point-sampled", "averaged"] {
        for (size, pixels, side) in [
            ([32, 32], [16, 16], 1),
            ([32, 32], [11, 9], 1),
            ([32, 32], [11, 9], 3),
            ([32, 32], [31, 31], 1),
            ([40, 24], [5, 24], 2),
            ([20, 20], [20, 20], 1),
            ([7, 5], [30, 20], 1),
        ] {
            let texels = checks(size[0], size[1], side);
            let scene = Scene::Texture { texels, size, corner: [8, 9], pixels };
            let drawn = Drawn::new(variant("minified texture", option), &scene, &WINDOW).unwrap();
            let window = rect(8..8 + i32::from(pixels[0]), 9..9 + i32::from(pixels[1]));
            let within = drawn
                .pixels()
                .zip(&drawn.coverage)
                .filter(|((x, y), _)| window.columns.contains(x) && window.rows.contains(y));
            let errors: Vec<f64> = within
                .zip(texture_areas(texels, size, pixels))
                .map(|((_, coverage), area)| (f64::from(*coverage) - area).abs())
                .collect();
            let worst = errors.iter().copied().fold(0.0, f64::max);
            let mean = errors.iter().sum::<f64>() / errors.len() as f64;
            let by = |[x, y]: [u16; 2]| format!("{x} x {y}");
            let names = ["minified texture".to_owned(), option.to_owned(), by(size), by(pixels), side.to_string()];
            table.row([&names[..], &[format!("{worst:.1}"), format!("{mean:.2}")]].concat());
        }
    }
    table
}

/// The samples of a pixel in 1/256 of it, and what each counts for.
fn samples(method: &str, option: &str) -> Option<Vec<(i64, i64, u32)>> {
    let grid = |n: i64, weight: fn(i64, i64) -> u32| {
        (0..n * n).map(|i| ((2 * (i % n) + 1) * 128 / n, (2 * (i / n) + 1) * 128 / n, weight(i / n, i % n))).collect()
    };
    let n = |option: &str| option.strip_prefix("n = ").and_then(|n| n.parse().ok());
    match (method, n(option)) {
        ("none", _) => Some(grid(1, |_, _| 1)),
        ("n x n samples" | "scene n times larger, averaged" | "spanfill", Some(n)) => Some(grid(n, |_, _| 1)),
        ("weighted 4 x 4", _) | ("spanfill", None) if option != "exact" => Some(grid(4, |line, column| {
            [[1, 2, 2, 1], [2, 3, 3, 2], [2, 3, 3, 2], [1, 2, 2, 1]][line as usize][column as usize]
        })),
        ("rotated grid", _) => Some(vec![(96, 32, 1), (224, 96, 1), (32, 160, 1), (160, 224, 1)]),
        _ => None,
    }
}

/// Every method that counts samples, against each sample by itself: outlines of every kind, with vertices on samples.
#[test]
fn samples_are_counted_exactly() {
    let window = rect(14..26, 12..22);
    let mut compared = 0;
    for case in 0..120 {
        let mut rng = Rng::new(0x5A3, case);
        let step = rng.pick(&[1, 8, 16, 128]);
        let contours: Vec<Vec<Vertex>> =
            (0..rng.int(1..=2)).map(|_| (0..rng.int(3..=6)).map(|_| vertex(&mut rng, step)).collect()).collect();
        let fill_rule = random::fill_rule(&mut rng);
        let scene = polygon(&contours, fill_rule);
        for variant in ANTIALIAS {
            let Some(samples) = samples(variant.method, variant.option) else { continue };
            let whole: u32 = samples.iter().map(|(.., weight)| weight).sum();
            let drawn = Drawn::new(variant, &scene, &window).unwrap();
            for ((x, y), coverage) in drawn.pixels().zip(&drawn.coverage) {
                let inside = samples.iter().filter(|(right, down, _)| {
                    let at = At { x: 256 * i64::from(x) + right, y: 256 * i64::from(y) + down };
                    let winding = winding(&contours, at);
                    if fill_rule == FillRule::NonZero { winding != 0 } else { winding & 1 == 1 }
                });
                let count: u32 = inside.map(|(.., weight)| weight).sum();
                let expected = (2 * 255 * count + whole) / (2 * whole);
                assert_eq!(
                    u32::from(*coverage),
                    expected,
                    "case {case}, {}, {}: ({x}, {y})",
                    variant.method,
                    variant.option
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 100_000);
}

const SIDES: [(&str, i64); 4] = [("n = 2", 2), ("n = 4", 4), ("n = 8", 8), ("n = 16", 16)];

/// The samples of a line that the line meets: the pixels of the exact rule in a picture n times larger.
#[test]
fn the_line_meets_the_samples_of_the_rule() {
    for case in 0..60 {
        let Scene::Line(ends) = scene(Kind::Lines, case) else { unreachable!() };
        for (option, n) in SIDES {
            let drawn =
                Drawn::new(variant("line's samples, met by the line", option), &Scene::Line(ends), &WINDOW).unwrap();
            let sample =
                |vertex: Vertex| [vertex.x, vertex.y].map(|at| (i64::from(at.to_bits()) * n).div_euclid(256) as i32);
            let [start, end] = ends.map(sample);
            let larger = Line::new(Vertex::pixel(start[0], start[1]), Vertex::pixel(end[0], end[1]));
            for ((x, y), coverage) in drawn.pixels().zip(&drawn.coverage) {
                let n = n as i32;
                let count = (0..n * n).filter(|i| larger.has(n * x + i % n, n * y + i / n)).count() as i32;
                assert_eq!(i32::from(*coverage), (2 * 255 * count + n) / (2 * n), "case {case}, {option}: ({x}, {y})");
            }
        }
    }
}

/// The samples of a line in the rectangle, by Lagrange's identity: `(p x d)^2 = |p|^2 |d|^2 - (p . d)^2`.
#[test]
fn the_rectangle_holds_the_samples_near_the_line() {
    for case in 0..60 {
        let Scene::Line(ends) = scene(Kind::Lines, case) else { unreachable!() };
        let [a, b] = ends.map(At::from);
        let d = [i128::from(b.x - a.x), i128::from(b.y - a.y)];
        let square = d[0] * d[0] + d[1] * d[1];
        for (option, n) in SIDES {
            let drawn =
                Drawn::new(variant("line's samples, in the rectangle", option), &Scene::Line(ends), &WINDOW).unwrap();
            for ((x, y), coverage) in drawn.pixels().zip(&drawn.coverage) {
                let holds = |i: &i64| {
                    let p = [
                        i128::from(256 * i64::from(x) + (2 * (i % n) + 1) * 128 / n - a.x),
                        i128::from(256 * i64::from(y) + (2 * (i / n) + 1) * 128 / n - a.y),
                    ];
                    let along = p[0] * d[0] + p[1] * d[1];
                    let across_square = (p[0] * p[0] + p[1] * p[1]) * square - along * along;
                    0 <= along && along <= square && across_square <= 128 * 128 * square
                };
                let count = (0..n * n).filter(holds).count() as i64;
                assert_eq!(
                    i64::from(*coverage),
                    (2 * 255 * count + n * n) / (2 * n * n),
                    "case {case}, {option}: ({x}, {y})"
                );
            }
        }
    }
}

/// Averages of textures are right to the rounding.
#[test]
fn averaged_textures_are_rounded_once() {
    for case in 0..40 {
        let mut rng = Rng::new(0x7E, case);
        let size = [rng.int(1..=24) as u16, rng.int(1..=24) as u16];
        let pixels = [rng.int(1..=24) as u16, rng.int(1..=24) as u16];
        let texels: Vec<u8> = (0..size[0] * size[1]).map(|_| rng.int(0..=255) as u8).collect();
        let texture = Texture::new(&texels, size[0], size[1]).unwrap();
        let mut greys = Coverage::new();
        minified::draw(&texture, [0, 0], pixels, Sampling::Averaged, &SCREEN, &mut greys).unwrap();
        for (index, area) in texture_areas(&texels, size, pixels).into_iter().enumerate() {
            let (x, y) = (index as i32 % i32::from(pixels[0]), index as i32 / i32::from(pixels[0]));
            let grey = greys.at(x, y);
            assert!((f64::from(grey) - area).abs() <= 0.5 + 1e-9, "case {case}: {grey} for {area}");
        }
    }
}

/// Coverage, as it came last.
struct Coverage(std::collections::BTreeMap<(i32, i32), u8>);

impl Coverage {
    fn new() -> Self {
        Self(std::collections::BTreeMap::new())
    }

    fn at(&self, x: i32, y: i32) -> u8 {
        self.0.get(&(x, y)).copied().unwrap_or(0)
    }
}

impl FragmentSink for Coverage {
    type Error = Infallible;

    fn fragment(&mut self, Fragment { x, y, coverage, .. }: Fragment) -> Result<(), Infallible> {
        self.0.insert((x, y), coverage);
        Ok(())
    }

    fn visit(&mut self, x: i32, y: i32) {
        self.0.entry((x, y)).or_insert(0);
    }
}

/// Areas added up are exact where nothing overlaps, and are not where something does.
#[test]
fn added_areas_are_exact_without_overlaps() {
    for (method, option, bound) in [
        ("exact area", "f64", 0.5 + 1e-6),
        ("exact area", "f32", 0.51),
        ("accumulated signed area", "f32", 0.51),
        // What is rounded on the way is less than 1/256 of a 255th.
        ("spanfill", "exact", 0.5 + 1.0 / 256.0),
    ] {
        for kind in [Kind::Triangles, Kind::SmallTriangles, Kind::Stars] {
            let (worst, _) = errors(variant(method, option), &scenes(kind)).unwrap();
            assert!(worst <= bound, "{method}, {option}, {kind:?}: {worst}");
        }
        let (worst, _) = errors(variant(method, option), &scenes(Kind::Overlaps)).unwrap();
        assert_eq!(worst <= bound, method == "spanfill", "{method}, {option}: {worst}");
    }
}

/// Two triangles that share an edge: drawn into one larger scene there is no seam, where coverage blended twice has one.
#[test]
fn a_larger_scene_has_no_seams() {
    let [a, b, c, d] = [(1500, 1400), (9000, 1700), (8700, 8000), (1300, 7600)].map(|(x, y)| Vertex::from_bits(x, y));
    let halves = [[a, b, c], [a, c, d]];
    let (mut bits, mut changes) = (vec![0; 1 << 16], vec![0; 1 << 12]);
    let mut larger = scene::Scene::new(Side::Four, &WINDOW, &mut bits, &mut changes).unwrap();
    let mut blended = vec![0.0; 40 * 32];
    for half in &halves {
        larger.draw(&Outline { contours: &[half], fill_rule: FillRule::NonZero });
        let drawn = Drawn::new(variant("n x n samples", "n = 4"), &Scene::Triangle(*half), &WINDOW).unwrap();
        for (value, coverage) in blended.iter_mut().zip(&drawn.coverage) {
            *value += (1.0 - *value) * f64::from(*coverage) / 255.0;
        }
    }
    let mut averaged = Coverage::new();
    larger.average(&mut averaged).unwrap();
    let whole =
        Drawn::new(variant("n x n samples", "n = 4"), &polygon(&[vec![a, b, c, d]], FillRule::NonZero), &WINDOW)
            .unwrap();
    let mut seam = 0;
    for (((x, y), coverage), blended) in whole.pixels().zip(&whole.coverage).zip(blended) {
        assert_eq!(averaged.at(x, y), *coverage, "({x}, {y})");
        seam += usize::from(f64::from(*coverage) - 255.0 * blended > 16.0);
    }
    assert!(seam > 20, "{seam}");
}

/// Too little scratch is told, and nothing is drawn or looked at.
#[test]
fn too_little_scratch_names_what_is_needed() {
    let triangle = [Vertex::new(5, 5), Vertex::new(25, 6), Vertex::new(7, 30)];
    let outline = Outline { contours: &[&triangle], fill_rule: FillRule::NonZero };
    let mut untouched = Coverage::new();
    let sink = &mut untouched;
    let expected = Err(Error::Scratch { needed: 20, available: 19 });
    let mut columns = [SampleColumn::EMPTY; 19];
    assert_eq!(grid::draw(&outline, Side::Four, &mut columns, &SCREEN, sink), expected);
    assert_eq!(rotated::draw(&outline, &mut columns, &SCREEN, sink), expected);
    assert_eq!(weighted::draw(&outline, &mut columns, &SCREEN, sink), expected);
    let columns = &mut [accumulated::AreaColumn::EMPTY; 19];
    assert_eq!(accumulated::draw(&outline, accumulated::Numbers::F32, columns, &SCREEN, sink), expected);
    let columns = &mut [exact::ExactColumn::EMPTY; 19];
    assert_eq!(exact::draw(&outline, exact::Numbers::F32, columns, &SCREEN, sink), expected);
    let columns = &mut [ramp::RampColumn::EMPTY; 21];
    let error = ramp::draw(&outline, Root::Libm, columns, &SCREEN, sink).unwrap_err();
    assert_eq!(error, Error::Scratch { needed: 22, available: 21 });
    assert_eq!(error.to_string(), "the method needs scratch of 22 slots, 21 available");
    assert!(untouched.0.is_empty());

    let [bytes, changes] = scene::Scene::needed(Side::Four, &WINDOW);
    assert_eq!([bytes, changes], [40 * 4 / 8 * 32 * 4, 40 * 4]);
    let error = scene::Scene::new(Side::Four, &WINDOW, &mut vec![0; bytes - 1], &mut vec![0; changes]).unwrap_err();
    assert_eq!(error, Error::Scratch { needed: bytes, available: bytes - 1 });
    let error = scene::Scene::new(Side::Four, &WINDOW, &mut vec![0; bytes], &mut vec![0; changes - 1]).unwrap_err();
    assert_eq!(error, Error::Scratch { needed: changes, available: changes - 1 });
    assert_eq!(Texture::new(&[0; 11], 4, 3), Err(Error::Scratch { needed: 12, available: 11 }));
}

/// Vertices at the ends of the range, outlines of no area and of no vertices, textures of nothing: each ends, in the clip.
#[test]
fn bad_scenes_end() {
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 2560, i32::MAX];
    let mut scenes =
        vec![polygon(&[], FillRule::NonZero), polygon(&[vec![], vec![Vertex::new(9, 9)]], FillRule::EvenOdd)];
    for case in 0..16 {
        let mut rng = Rng::new(0xBAD, case);
        let mut vertex = || Vertex::from_bits(rng.pick(&ends), rng.pick(&ends));
        let [a, b, c, d] = [(); 4].map(|()| vertex());
        scenes.extend([
            Scene::Triangle([a, b, c]),
            Scene::Triangle([a, a, b]),
            Scene::Line([a, b]),
            Scene::Line([a, a]),
        ]);
        scenes.push(polygon(&[vec![a, b, c, d, a, c]], FillRule::EvenOdd));
    }
    for (size, pixels) in [([0, 4], [5, 5]), ([4, 4], [0, 5]), ([1, 1], [65_535, 65_535]), ([300, 300], [1, 1])] {
        for corner in [[0, 0], [i32::MAX, i32::MIN], [i32::MIN, 7], [-60_000, -60_000]] {
            scenes.push(Scene::Texture { texels: checks(300, 300, 1), size, corner, pixels });
        }
    }
    let mut refused = 0;
    for variant in ANTIALIAS {
        for scene in &scenes {
            for window in [rect(0..40, 0..30), rect(0..1, 0..1), rect(150..170, 3..3)] {
                refused += usize::from(Drawn::new(variant, scene, &window).is_none());
            }
        }
    }
    for variant in ANTIALIAS {
        for scene in scenes.iter().step_by(20) {
            refused += usize::from(Drawn::new(variant, scene, &SCREEN).is_none());
        }
    }
    assert!(refused > 0);
    let texture = Scene::Texture { texels: &[1, 2, 3], size: [2, 2], corner: [0, 0], pixels: [4, 4] };
    assert!(Drawn::new(variant("minified texture", "averaged"), &texture, &SCREEN).is_none());
}

/// The clip changes no pixel.
#[test]
fn tiles_are_the_whole() {
    for (_, kind) in KINDS {
        for case in 0..6 {
            let scene = scene(kind, case);
            for variant in ANTIALIAS {
                let Some(whole) = Drawn::new(variant, &scene, &WINDOW) else { continue };
                let tiles = [rect(4..17, 4..20), rect(17..44, 4..20), rect(4..17, 20..36), rect(17..44, 20..36)];
                for tile in tiles {
                    let part = Drawn::new(variant, &scene, &tile).unwrap();
                    for ((x, y), coverage) in part.pixels().zip(&part.coverage) {
                        let expected = whole.coverage[((y - 4) * 40 + x - 4) as usize];
                        // What is added up in floats from the left of the clip is rounded differently.
                        let slack = u8::from(
                            variant.method == "accumulated signed area"
                                || variant.method == "exact area"
                                || variant.method == "distance ramp",
                        );
                        assert!(
                            coverage.abs_diff(expected) <= slack,
                            "{}, {}: {coverage} for {expected} at ({x}, {y}) of {scene:?}",
                            variant.method,
                            variant.option
                        );
                    }
                }
            }
        }
    }
}
