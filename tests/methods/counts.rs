//! How often the methods are wrong, held against a file.

use std::{convert::Infallible, fmt::Write as _, fs, path::Path};

use spanfill::{
    Fragment, FragmentSink,
    methods::{
        number::{Fixed, Number, Real},
        triangle::{
            edge_equations::{Options, edge_equations},
            equation::Constant,
            orientation::Orientation,
        },
    },
};

use crate::{
    oracle::{Rng, rect},
    scenes::{Corners, SCENES, Truth, draw, index, name, picture, triangles, truth},
    shaded,
    variants::{
        SCREEN, Variant,
        triangle::{INSIDE, SHARED, TRAVERSAL},
    },
};

/// Holds a text against a file of the tests, or writes it.
fn check_file(file: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/methods").join(file);
    if std::env::var_os("BLESS").is_some_and(|value| value == "1") {
        fs::write(&path, text).unwrap();
    }
    let known = fs::read_to_string(&path).expect("BLESS=1 writes the file");
    for (number, (known, now)) in known.lines().zip(text.lines()).enumerate() {
        assert_eq!(known, now, "{file}:{}: BLESS=1 if that is better", number + 1);
    }
    assert_eq!(known.lines().count(), text.lines().count(), "{file}: BLESS=1");
}

#[derive(Debug, Default)]
struct Counts {
    missing: u32,
    extra: u32,
    ties: u32,
    doubled: u32,
    refused: u32,
    visited: u64,
}

/// How many triangles of each scene.
const TRIANGLES: u64 = 24;

fn count(variants: &[Variant<Corners>], text: &mut String) {
    for (scene, (scene_name, _)) in SCENES.iter().enumerate() {
        let triangles = triangles(scene, TRIANGLES);
        let truths: Vec<Vec<Truth>> = triangles
            .iter()
            .map(|v| {
                SCREEN.rows.flat_map(|y| SCREEN.columns.map(move |x| (x, y))).map(|(x, y)| truth(v, x, y)).collect()
            })
            .collect();
        let covered: usize = truths
            .iter()
            .map(|truth| truth.iter().filter(|truth| matches!(truth, Truth::Inside | Truth::TieInside)).count())
            .sum();
        writeln!(text, "\n{}, {scene_name}: {TRIANGLES} triangles of {covered} pixels", variants[0].family).unwrap();
        writeln!(text, "missing  extra   ties doubled refused  visited").unwrap();
        for variant in variants {
            let mut counts = Counts::default();
            for (v, truths) in triangles.iter().zip(&truths) {
                let mut picture = picture();
                counts.refused += u32::from(draw(variant, v, &SCREEN, &mut picture).is_err());
                counts.visited += picture.visited;
                for (count, truth) in picture.count.iter().zip(truths) {
                    let drawn = *count > 0;
                    counts.doubled += u32::from(*count > 1);
                    match truth {
                        Truth::Outside => counts.extra += u32::from(drawn),
                        Truth::Inside => counts.missing += u32::from(!drawn),
                        Truth::TieInside => counts.ties += u32::from(!drawn),
                        Truth::TieOutside => counts.ties += u32::from(drawn),
                    }
                }
            }
            let Counts { missing, extra, ties, doubled, refused, visited } = counts;
            let name = name(variant);
            writeln!(text, "{missing:7} {extra:6} {ties:6} {doubled:7} {refused:7} {visited:8}  {name}").unwrap();
        }
    }
}

/// A triangle of which an edge passes through a window, `2^power` px long.
fn through_window(rng: &mut Rng, power: u32) -> Corners {
    let length = 256_i64 << power;
    let mut point = || [rng.int(100 * 256..=164 * 256), rng.int(100 * 256..=164 * 256)];
    let ([x, y], [u, v]) = (point(), point());
    let mut part = || rng.int(-length..=length);
    let (dx, dy) = (part(), part());
    let third = [part(), part()];
    let corner = |x: i64, y: i64| [x, y].map(|value| i32::try_from(value).unwrap());
    [corner(x + dx, y + dy), corner(u - dx, v - dy), corner(third[0], third[1])]
}

/// The first power of two at which a method draws a pixel wrong that no tie rule moves, or refuses.
fn limits(variants: &[Variant<Corners>], text: &mut String) {
    let clip = rect(100..164, 100..164);
    let powers: Vec<Vec<(Corners, Vec<Truth>)>> = (4..=22)
        .map(|power| {
            let triangle = |case| {
                let v = through_window(&mut Rng::new(u64::from(power), case), power);
                let pixels = clip.rows.clone().flat_map(|y| clip.columns.clone().map(move |x| (x, y)));
                (v, pixels.map(|(x, y)| truth(&v, x, y)).collect())
            };
            (0..100).map(triangle).collect()
        })
        .collect();
    writeln!(
        text,
        "\n{}: triangles of 2^4 to 2^22 px, the first power at which one of 100 is wrong",
        variants[0].family
    )
    .unwrap();
    for variant in variants {
        let is_wrong = |(v, truths): &(Corners, Vec<Truth>)| {
            let mut picture = picture();
            let refused = draw(variant, v, &clip, &mut picture).is_err();
            let rows = clip.rows.clone().flat_map(|y| &picture.count[index(100, y)..index(164, y)]);
            refused
                || rows.zip(truths).any(|(count, truth)| match truth {
                    Truth::Outside => *count > 0,
                    Truth::Inside => *count == 0,
                    Truth::TieInside | Truth::TieOutside => false,
                })
        };
        let first = powers.iter().position(|triangles| triangles.iter().any(is_wrong));
        let first = first.map_or("none".to_owned(), |power| format!("2^{}", power + 4));
        writeln!(text, "{first:>5}  {}", name(variant)).unwrap();
    }
}

/// The pixels that come.
struct Drawn(Vec<(i32, i32)>);

impl FragmentSink for Drawn {
    type Error = Infallible;

    fn fragment(&mut self, fragment: Fragment) -> Result<(), Infallible> {
        self.0.push((fragment.x, fragment.y));
        Ok(())
    }
}

/// Wrong pixels of small triangles, by how far away they are: what cancels in C.
fn far<N: Number>(name: &str, options: Options, text: &mut String) {
    for power in (6..=18).step_by(2) {
        let mut wrong = 0;
        for case in 0..200 {
            let mut rng = Rng::new(0xFA4, case);
            let at = 1 << power;
            let v = [(); 3].map(|()| [(); 2].map(|()| 256 * at + rng.int(0..=8 * 256) as i32));
            let clip = rect(at..at + 8, at..at + 8);
            let mut drawn = Drawn(Vec::new());
            let corners = v.map(|vertex| vertex.map(N::Setup::from_subpixels));
            edge_equations::<N, _>(&corners, options, &clip, &mut drawn).expect("nothing to refuse");
            for y in clip.rows.clone() {
                for x in clip.columns.clone() {
                    wrong += u32::from(match truth(&v, x, y) {
                        Truth::Outside => drawn.0.contains(&(x, y)),
                        Truth::Inside => !drawn.0.contains(&(x, y)),
                        Truth::TieInside | Truth::TieOutside => false,
                    });
                }
            }
        }
        write!(text, "{wrong:6}").unwrap();
    }
    writeln!(text, "  {name}").unwrap();
}

/// The ways to C that the notes compare, and the one without.
fn cancellation(text: &mut String) {
    text.push_str(
        "\nwrong pixels of 200 triangles of at most 8 px, 2^6, 2^8 .. 2^18 px right of and below the origin\n",
    );
    for stepped in [true, false] {
        for (name, constant, orientation) in [
            ("cross product", Constant::CrossProduct, Orientation::SumOfCs),
            ("one vertex", Constant::OneVertex, Orientation::SumOfCs),
            ("averaged", Constant::Averaged, Orientation::SumOfCs),
            ("averaged, area by differences", Constant::Averaged, Orientation::Area),
            ("averaged, third vertex", Constant::Averaged, Orientation::ThirdVertex),
            ("differences", Constant::Differences, Orientation::Area),
        ] {
            let options = Options { constant, orientation, stepped, ..Options::USUAL };
            let way = if stepped { "stepped" } else { "at each pixel" };
            far::<f32>(&format!("f32, {name}, {way}"), options, text);
        }
    }
    far::<f64>("f64, averaged, stepped", Options::USUAL, text);
    far::<Fixed<i32, 12>>("F = 12, 32 bits, averaged, stepped", Options::USUAL, text);
    far::<Fixed<i64, 12>>("F = 12, 64 bits, averaged, stepped", Options::USUAL, text);
}

/// Meshes that fill a rectangle, whose pixels each are to be drawn once.
fn meshes() -> [(&'static str, Vec<Corners>); 3] {
    let grid = |seed: u64, shake: i64, step: i32| {
        let mut rng = Rng::new(seed, 0);
        let mut points = [[[0; 2]; 9]; 9];
        for (y, row) in (0..9).zip(&mut points) {
            for (x, point) in (0..9).zip(row) {
                let mut shaken = |at: i32| {
                    let inside = x % 8 != 0 && y % 8 != 0;
                    let by = if inside { rng.int(-shake..=shake) as i32 * step } else { 0 };
                    at + by
                };
                *point = [shaken(256 * 16 * (x + 1)), shaken(256 * 16 * (y + 1))];
            }
        }
        let quads = (0..8).flat_map(|y| (0..8).map(move |x| (x, y)));
        quads
            .flat_map(|(x, y): (usize, usize)| {
                let (a, b) = (points[y][x], points[y][x + 1]);
                let (c, d) = (points[y + 1][x], points[y + 1][x + 1]);
                [[a, b, d], [a, d, c]]
            })
            .collect::<Vec<_>>()
    };
    let rim: Vec<[i32; 2]> = (0..16)
        .flat_map(|step| [[16 + 8 * step, 16], [144, 16 + 8 * step], [144 - 8 * step, 144], [16, 144 - 8 * step]])
        .map(|[x, y]| [256 * x, 256 * y])
        .collect();
    // In order around: the four sides one after the other.
    let side = |side: usize| rim.iter().skip(side).step_by(4).copied();
    let rim: Vec<[i32; 2]> = (0..4).flat_map(side).collect();
    let hub = [256 * 70 + 128, 256 * 90 + 128];
    let fan = (0..rim.len()).map(|number| [hub, rim[number], rim[(number + 1) % rim.len()]]).collect();
    [("grid of half pixels", grid(5, 7, 128)), ("grid of slope 1", grid(5, 0, 1)), ("fan", fan)]
}

fn cracks(text: &mut String) {
    for (mesh_name, mesh) in meshes() {
        writeln!(text, "\nshared edges, {mesh_name}: {} triangles of {} pixels", mesh.len(), 128 * 128).unwrap();
        writeln!(text, " cracks overlaps").unwrap();
        for variant in SHARED {
            let mut picture = picture();
            draw(variant, &mesh, &SCREEN, &mut picture).expect("nothing to refuse");
            let pixels = || (16..144).flat_map(|y| &picture.count[index(16, y)..index(144, y)]);
            let cracks = pixels().filter(|count| **count == 0).count();
            let overlaps = pixels().filter(|count| **count > 1).count();
            writeln!(text, "{cracks:7} {overlaps:8}  {}", name(variant)).unwrap();
            let is_watertight =
                matches!(variant.method, "tie-break" | "spanfill") || variant.option.contains("then a second");
            assert!(!is_watertight || (cracks, overlaps) == (0, 0), "{} of {mesh_name}", name(variant));
        }
    }
}

#[test]
fn counts_are_as_they_were() {
    let mut text = String::from(
        "How often the methods of the literature for triangles are wrong. Made by tests/methods_triangle.rs with BLESS=1.\n\
         ties: pixels on the outline that another tie rule moves. refused: triangles. Without comment, pixels.\n",
    );
    count(INSIDE, &mut text);
    count(TRAVERSAL, &mut text);
    limits(INSIDE, &mut text);
    limits(TRAVERSAL, &mut text);
    cancellation(&mut text);
    cracks(&mut text);
    shaded::count(&mut text);
    check_file("triangle.txt", &text);
}
