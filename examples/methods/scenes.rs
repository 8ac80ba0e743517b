//! What the methods are measured on, as plain integers: 1/256 pixel, 256 to the pixel, on a screen of 320 x 240.
//!
//! Taken in by `#[path]`, hence `no_std`; the firmware counts the first shapes of the scenes that the host measures. The same
//! shapes everywhere and for ever.
//!
//! | scene | what |
//! |---|---|
//! | typical | random vertices in boxes of 50 px |
//! | on pixels | the same, vertices on pixel centres, as integer coordinates have them: ties are frequent |
//! | small | boxes of 5 px |
//! | slivers | 100 px long, 1/256 to 2 px wide |
//! | large | boxes as large as the screen |
//! | off-screen | vertices up to 1500 px away, some of the shape on the screen |

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use crate::random::Random;
use crate::variants::{HEIGHT, WIDTH};

/// A point in 1/256 pixel.
pub(crate) type Point = [i32; 2];

const ONE: i32 = 256;

/// The scenes of triangles: name, how many.
pub(crate) const TRIANGLES: [(&str, usize); 6] =
    [("typical", 40), ("on pixels", 40), ("small", 120), ("slivers", 40), ("large", 12), ("off-screen", 24)];

/// A triangle of a scene.
pub(crate) fn triangle(scene: &str, index: usize) -> [Point; 3] {
    let mut random = seeded(0x7121, scene, index);
    let on_pixel = |[x, y]: Point| [(x & -ONE) + ONE / 2, (y & -ONE) + ONE / 2];
    match scene {
        "on pixels" => points(&mut random, 50).map(on_pixel),
        "small" => points(&mut random, 5),
        "slivers" => sliver(&mut random),
        "large" => points(&mut random, HEIGHT),
        "off-screen" => around_screen(&mut random),
        _ => points(&mut random, 50),
    }
}

/// What varies across a triangle: attributes at each vertex, w in 1/65536, depth.
pub(crate) type Varying = ([[i32; 4]; 3], [i32; 3], [u16; 3]);

/// Colours, a perspective of up to 1 : 8, and depths, for the triangle of a scene.
pub(crate) fn varying(scene: &str, index: usize) -> Varying {
    let mut random = seeded(0xC010, scene, index);
    let attributes = core::array::from_fn(|_| core::array::from_fn(|_| random.below(256)));
    let w = core::array::from_fn(|_| 65536 + random.below(7 * 65536));
    let depth = core::array::from_fn(|_| random.below(65536) as u16);
    (attributes, w, depth)
}

/// The scenes of meshes, and how many of each.
pub(crate) const MESHES: [(&str, usize); 4] = [("fan", 6), ("mesh", 4), ("mesh on pixels", 4), ("slivers", 6)];

/// The triangles of a mesh.
pub(crate) const MESH_TRIANGLES: usize = 32;

/// Triangles that share edges: around a vertex, or two for each square of a bent grid, or a band of slivers.
pub(crate) fn mesh(scene: &str, index: usize) -> [[Point; 3]; MESH_TRIANGLES] {
    let mut random = seeded(0x3E54, scene, index);
    let middle = [(60 + random.below(200)) * ONE, (60 + random.below(120)) * ONE];
    if scene == "fan" {
        let hub = centre(middle);
        let rim: [Point; MESH_TRIANGLES] = core::array::from_fn(|at| {
            let [cos, sin] = direction(at * 64 / MESH_TRIANGLES);
            let radius = (20 + random.below(30)) * ONE;
            centre([hub[0] + radius * cos / 64, hub[1] + radius * sin / 64])
        });
        return core::array::from_fn(|at| [hub, rim[at], rim[(at + 1) % MESH_TRIANGLES]]);
    }
    if scene == "slivers" {
        // Up and down between two lines, half a pixel on at each step.
        let place = |at: usize, jitter: i32| {
            let x = middle[0] + at as i32 * ONE / 2 + jitter;
            if at.is_multiple_of(2) { [x, middle[1] - 40 * ONE] } else { [x, middle[1] + 40 * ONE + jitter] }
        };
        let jitters: [i32; MESH_TRIANGLES + 2] = core::array::from_fn(|_| random.below(64));
        return core::array::from_fn(|at| [0, 1, 2].map(|corner| place(at + corner, jitters[at + corner])));
    }
    // Squares of 12 px, corners moved by up to 4.
    let vertices: [[Point; 5]; 5] = core::array::from_fn(|row| {
        core::array::from_fn(|column| {
            let place =
                |from: i32, at: usize, random: &mut Random| from + (at as i32 * 12 - 24) * ONE + random.below(8 * ONE);
            let vertex = [place(middle[0], column, &mut random), place(middle[1], row, &mut random)];
            if scene == "mesh on pixels" { centre(vertex) } else { vertex }
        })
    });
    core::array::from_fn(|at| {
        let (row, column) = (at / 8, at / 2 % 4);
        let [a, b] = [vertices[row][column], vertices[row + 1][column + 1]];
        if at.is_multiple_of(2) { [a, b, vertices[row][column + 1]] } else { [a, b, vertices[row + 1][column]] }
    })
}

/// The scenes of lines.
pub(crate) const LINES: [(&str, usize); 5] =
    [("typical", 40), ("short", 120), ("long", 24), ("nearly level", 40), ("off-screen", 24)];

/// A line of a scene, between whole pixels.
pub(crate) fn line(scene: &str, index: usize) -> [Point; 2] {
    let mut random = seeded(0x0011, scene, index);
    let box_px = match scene {
        "short" => 8,
        "long" => HEIGHT,
        "off-screen" => {
            let [a, b, _] = around_screen(&mut random);
            return [a, b].map(|end| end.map(|at| at >> 8));
        }
        _ => 80,
    };
    let [a, mut b] = points(&mut random, box_px);
    if scene == "nearly level" {
        // A slope of at most 1/20, in either direction, level or steep.
        let [dx, dy] = [b[0] - a[0], (b[1] - a[1]) / 20];
        b = if index.is_multiple_of(2) { [a[0] + dx, a[1] + dy] } else { [a[0] + dy, a[1] + dx] };
    }
    [a, b].map(|end| end.map(|at| at >> 8))
}

/// The scenes of circles.
pub(crate) const CIRCLES: [(&str, usize); 4] = [("typical", 24), ("small", 60), ("large", 8), ("off-screen", 16)];

/// A circle of a scene, around a whole pixel, with a radius of whole pixels: x, y, radius.
pub(crate) fn circle(scene: &str, index: usize) -> [i32; 3] {
    let mut random = seeded(0xC12C, scene, index);
    let [x, y] = [random.below(WIDTH), random.below(HEIGHT)];
    let inside = |at: i32, radius: i32, size: i32| radius + at * (size - 1 - 2 * radius).max(1) / size;
    let (x, y, radius) = match scene {
        "small" => {
            let radius = 1 + random.below(6);
            (inside(x, radius, WIDTH), inside(y, radius, HEIGHT), radius)
        }
        "large" => {
            let radius = 60 + random.below(58);
            (inside(x, radius, WIDTH), inside(y, radius, HEIGHT), radius)
        }
        "off-screen" => (x * 3 - WIDTH, y, 40 + random.below(400)),
        _ => {
            let radius = 8 + random.below(40);
            (inside(x, radius, WIDTH), inside(y, radius, HEIGHT), radius)
        }
    };
    [x, y, radius]
}

/// The scenes of meshes that become small: two triangles for each square of so many 1/256 px.
pub(crate) const SPECKS: [(&str, i32); 5] = [
    ("squares of 16 px", 4096),
    ("squares of 4 px", 1024),
    ("squares of 2 px", 512),
    ("squares of 1 px", 256),
    ("squares of 1/2 px", 128),
];

/// How many squares a mesh of specks has in each direction.
pub(crate) const SPECKS_ACROSS: usize = 12;

/// A triangle of a mesh of specks: corners are moved by up to a quarter of a square.
pub(crate) fn speck(square: i32, index: usize) -> [Point; 3] {
    let corner = |row: usize, column: usize| {
        let mut random = Random::new((square as u64) << 32 | (row * 64 + column) as u64);
        [column, row].map(|at| 10 * ONE + at as i32 * square + random.below(square / 2) - square / 4)
    };
    let (row, column) = (index / 2 / SPECKS_ACROSS, index / 2 % SPECKS_ACROSS);
    let [a, b] = [corner(row, column), corner(row + 1, column + 1)];
    if index.is_multiple_of(2) { [a, b, corner(row, column + 1)] } else { [a, b, corner(row + 1, column)] }
}

/// The scenes of polygons that are made here; real drawings come on top.
pub(crate) const POLYGONS: [(&str, usize); 6] =
    [("typical", 16), ("on pixels", 16), ("small", 60), ("slivers", 20), ("large", 6), ("self-intersecting", 16)];

/// How many vertices [`polygon`] has at most.
pub(crate) const MOST_VERTICES: usize = 24;

/// A polygon of a scene: as many of `vertices` as are said.
pub(crate) fn polygon(scene: &str, index: usize, vertices: &mut [Point; MOST_VERTICES]) -> usize {
    let mut random = seeded(0x9017, scene, index);
    let (count, box_px) = match scene {
        "small" => (5, 6),
        "slivers" => (4, 0),
        "large" => (MOST_VERTICES, HEIGHT),
        "self-intersecting" => (9, 80),
        _ => (12, 60),
    };
    if scene == "slivers" {
        let [a, b, c] = sliver(&mut random);
        vertices[..4].copy_from_slice(&[a, c, b, [c[0] + (b[0] - a[0]) / 8, c[1] + (b[1] - a[1]) / 8]]);
        return 4;
    }
    let corner = [random.below(WIDTH + 1 - box_px), random.below(HEIGHT + 1 - box_px)];
    for (at, vertex) in vertices.iter_mut().take(count).enumerate() {
        *vertex = if scene == "self-intersecting" {
            corner.map(|px| px * ONE + random.below(box_px * ONE))
        } else {
            // Around the middle of the box, in turn far and near.
            let least = if at.is_multiple_of(2) { 70 } else { 30 };
            let radius = box_px * ONE / 2 * (least + random.below(30)) / 100;
            let [cos, sin] = direction(at * 64 / count);
            [
                corner[0] * ONE + box_px * ONE / 2 + radius * cos / 64,
                corner[1] * ONE + box_px * ONE / 2 + radius * sin / 64,
            ]
        };
        if scene == "on pixels" {
            *vertex = centre(*vertex);
        }
    }
    count
}

/// 64 times the cosine and the sine of 64ths of a turn, roughly: a diamond with bent sides.
fn direction(angle: usize) -> [i32; 2] {
    let wave = |angle: usize| {
        let at = (angle % 64) as i32;
        let rise = |at: i32| at * (32 - at) / 4;
        if at < 32 { rise(at) } else { -rise(at - 32) }
    };
    [wave(angle + 16), wave(angle)]
}

/// The centre of the pixel that holds a point.
pub(crate) fn centre([x, y]: Point) -> Point {
    [(x & -ONE) + ONE / 2, (y & -ONE) + ONE / 2]
}

/// Points of a square box that lies on the screen.
fn points<const N: usize>(random: &mut Random, box_px: i32) -> [Point; N] {
    let corner = [random.below(WIDTH + 1 - box_px), random.below(HEIGHT + 1 - box_px)];
    core::array::from_fn(|_| corner.map(|px| px * ONE + random.below(box_px * ONE)))
}

/// A triangle of 100 px, in any direction, with a base of 1/256 to 2 px, small ones as frequent as large ones.
fn sliver(random: &mut Random) -> [Point; 3] {
    let [cos, sin] = direction(random.below(64) as usize);
    let middle = [WIDTH * ONE / 2 + random.below(90 * ONE), HEIGHT * ONE / 2 + random.below(60 * ONE)];
    let middle = [middle[0] - 45 * ONE, middle[1] - 30 * ONE];
    let magnitude = 1 + random.below(9);
    let width = 1 + random.below(1 << magnitude);
    let along = |to: i32| [middle[0] + to * cos / 64, middle[1] + to * sin / 64];
    let start = along(-50 * ONE);
    let across = if cos.abs() > sin.abs() { [0, width] } else { [width, 0] };
    [start, along(50 * ONE), [start[0] + across[0], start[1] + across[1]]]
}

/// Three points up to 1500 px away from the screen, in three directions: some of the triangle is on the screen.
fn around_screen(random: &mut Random) -> [Point; 3] {
    let turn = random.below(64) as usize;
    core::array::from_fn(|corner| {
        let [cos, sin] = direction(turn + 21 * corner + random.below(8) as usize);
        let far = (200 + random.below(1300)) * ONE;
        [WIDTH * ONE / 2 + far * cos / 64 + random.below(ONE), HEIGHT * ONE / 2 + far * sin / 64 + random.below(ONE)]
    })
}

fn seeded(kind: u64, scene: &str, index: usize) -> Random {
    let name = scene.bytes().fold(0_u64, |hash, byte| hash.wrapping_mul(31).wrapping_add(byte.into()));
    Random::new(kind.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (name << 20) ^ index as u64)
}
