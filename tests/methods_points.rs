//! Points and small triangles against the exact rule.

#[path = "methods/canvas.rs"]
mod canvas;
mod oracle;
#[path = "methods/records.rs"]
mod records;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use canvas::{Drawn, assert_complete};
use oracle::{Belongs, Rng, rect};
use records::Table;
use spanfill::{
    Fragment, FragmentSink, PixelRect, Triangle, Vertex,
    methods::points::vertex::{self, Rounding},
};
use variants::{SCREEN, Variant, points::POINTS};

type Mesh = [[Vertex; 3]];

#[test]
fn every_method_has_its_variants() {
    assert_complete("points", POINTS);
}

fn variant(method: &str, option: &str) -> &'static Variant<Mesh> {
    POINTS.iter().find(|variant| (variant.method, variant.option) == (method, option)).unwrap()
}

const WINDOW: PixelRect = PixelRect { rows: 4..40, columns: 4..40 };

/// A square of 32 x 32 pixels as a mesh, of cells of `size` 1/256 pixel, each of two triangles; turned a little, and its
/// inner vertices shaken by up to a quarter of a cell.
fn mesh(size: i32) -> Vec<[Vertex; 3]> {
    let cells = 32 * 256 / size;
    let at = |column: i32, row: i32| {
        let inner = 0 < column && column < cells && 0 < row && row < cells;
        let mut rng = Rng::new(0x3E5, u64::from((column * 4096 + row) as u32));
        let mut shaken = || if inner { rng.int(-i64::from(size) / 4..=i64::from(size) / 4) as i32 } else { 0 };
        Vertex::from_bits(6 * 256 + column * size + shaken() + 37, 6 * 256 + row * size + shaken() - 21)
    };
    let mut mesh = Vec::new();
    for (row, column) in (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column))) {
        let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
        mesh.extend([[a, b, c], [a, c, d]]);
    }
    mesh
}

/// The sizes of cells, from 8 pixels down to an eighth of one.
const SIZES: [i32; 7] = [2048, 1024, 512, 256, 128, 64, 32];

#[test]
fn errors_are_those_recorded() {
    let mut table = Table::new(&[
        "method",
        "option",
        "cells of 1/256 px",
        "triangles",
        "pixels",
        "missing",
        "extra",
        "doubled",
        "visited",
    ]);
    for variant in POINTS {
        for size in SIZES {
            let mesh = mesh(size);
            let drawn = Drawn::new(variant, &mesh, &WINDOW).unwrap();
            // The outline of the mesh is a square, whatever lies within.
            let square = rect(6..39, 6..39);
            let has = |x: i32, y: i32| {
                let centre = |pixel: i32, offset: i32| 256 * pixel + 128 - 6 * 256 - offset;
                (0..32 * 256).contains(&centre(x, 37)) && (0..32 * 256).contains(&centre(y, -21))
            };
            let (mut pixels, mut missing, mut extra, mut doubled) = (0, 0, 0, 0);
            for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
                assert!(!has(x, y) || square.columns.contains(&x) && square.rows.contains(&y) || y == 5);
                pixels += usize::from(has(x, y));
                missing += usize::from(has(x, y) && *count == 0);
                extra += usize::from(!has(x, y) && *count > 0);
                doubled += usize::from(*count > 1);
            }
            let numbers = [size as usize, mesh.len(), pixels, missing, extra, doubled, drawn.visited as usize];
            let names = [variant.method, variant.option].map(str::to_owned);
            table.row([&names[..], &numbers.map(|number| number.to_string())].concat());
        }
    }
    records::compare("points", &table.text());
}

/// Triangles of any size: each pixel as often as the exact rule has it in one of them.
#[test]
fn triangles_are_the_rule() {
    let mut covered = 0;
    for case in 0..400 {
        let mut rng = Rng::new(0x9015, case);
        let reach = 1 << rng.int(4..=12);
        let step = rng.pick(&[1, 64, 128]);
        let mut vertex = || {
            let mut at = || ((5632 + rng.int(-reach..=reach)) / step * step) as i32;
            Vertex::from_bits(at(), at())
        };
        let mesh = [[(); 3].map(|()| vertex()), [(); 3].map(|()| vertex())];
        for variant in [variant("triangles", ""), variant("spanfill", "")] {
            let drawn = Drawn::new(variant, &mesh, &WINDOW).unwrap();
            for ((x, y), count) in drawn.pixels().zip(&drawn.counts) {
                let expected = mesh.iter().filter(|vertices| Triangle::from_vertices(**vertices).has(x, y)).count();
                assert_eq!(usize::from(*count), expected, "case {case}, {}: {mesh:?} at ({x}, {y})", variant.method);
                covered += usize::from(*count);
            }
        }
    }
    assert!(covered > 10_000);
}

/// What is below the threshold both ways is one pixel, and only that.
#[test]
fn the_crossover_is_at_the_threshold() {
    let triangle = |size: i32| {
        [[Vertex::from_bits(2560, 2560), Vertex::from_bits(2560 + size, 2560), Vertex::from_bits(2560, 2560 + size)]]
    };
    for (option, threshold) in [("below 1/2 px", 128), ("below 1 px", 256), ("below 2 px", 512)] {
        let draw = |method, option, size| Drawn::new(variant(method, option), &triangle(size), &WINDOW).unwrap().counts;
        let crossover = |size| draw("triangles against points", option, size);
        assert_eq!(crossover(threshold - 1), draw("triangles as points", "", threshold - 1), "{option}");
        assert_eq!(crossover(threshold), draw("triangles", "", threshold), "{option}");
        assert_eq!(crossover(threshold - 1).iter().sum::<u16>(), 1);
    }
}

#[derive(Debug, Default)]
struct Pixels(Vec<(i32, i32)>);

impl FragmentSink for Pixels {
    type Error = std::convert::Infallible;

    fn fragment(&mut self, Fragment { x, y, .. }: Fragment) -> Result<(), Self::Error> {
        self.0.push((x, y));
        Ok(())
    }
}

/// `Math.Round` goes to the even number: of vertices half a pixel apart, pixels get three and one in turns.
#[test]
fn math_round_prefers_even_pixels() {
    let draw = |rounding| {
        let mut pixels = Pixels::default();
        for half in 0..16 {
            vertex::draw([f64::from(half) / 2.0, 1.0], rounding, &SCREEN, &mut pixels).unwrap();
        }
        (0..8).map(|x| pixels.0.iter().filter(|pixel| pixel.0 == x).count()).collect::<Vec<_>>()
    };
    assert_eq!(draw(Rounding::MathRound), [2, 1, 3, 1, 3, 1, 3, 1]);
    assert_eq!(draw(Rounding::Floor), [2; 8]);
}

/// Floats that are no numbers, infinite, or beyond what an `i32` holds, and vertices at the ends of the range.
#[test]
fn bad_points_end() {
    let floats = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -0.0, 1e-300, 3e9];
    for (x, y) in floats.iter().flat_map(|x| floats.iter().map(move |y| (*x, *y))) {
        for rounding in [Rounding::MathRound, Rounding::Floor] {
            let mut pixels = Pixels::default();
            vertex::draw([x, y], rounding, &SCREEN, &mut pixels).unwrap();
            assert!(pixels.0.iter().all(|pixel| *pixel == (0, 0)));
        }
    }
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 2560, i32::MAX];
    for case in 0..200 {
        let mut rng = Rng::new(0xBAD, case);
        let mut vertex = || Vertex::from_bits(rng.pick(&ends), rng.pick(&ends));
        let mesh = [[(); 3].map(|()| vertex()), [(); 3].map(|()| vertex())];
        for variant in POINTS {
            for window in [rect(0..40, 0..30), rect(0..1, 0..1), rect(150..170, 3..3)] {
                Drawn::new(variant, &mesh, &window).unwrap();
            }
        }
    }
    for variant in POINTS {
        Drawn::new(variant, &[], &SCREEN).unwrap();
    }
}
