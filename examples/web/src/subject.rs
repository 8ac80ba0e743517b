//! What is drawn: one shape whose vertices can be moved, or a scene of triangles.

use std::f64::consts::TAU;

use spanfill::Vertex;

use crate::variants::{HEIGHT, WIDTH, antialias, attribute::Shaded, polygon::Outline};

/// A point in 1/256 pixel.
pub type At = [i32; 2];

/// Something to draw.
#[derive(Debug, Clone)]
pub struct Subject {
    pub geometry: Geometry,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// With colours at their vertices.
    Triangles(Vec<Shaded>),
    /// Between whole pixels.
    Line([At; 2]),
    /// Around a whole pixel: x, y, radius.
    Circle([i32; 3]),
    Star,
}

/// The kinds of subjects: what they are called, and the vertices that can be moved, in 1/256 pixel.
pub const KINDS: [(&str, &[At]); 8] = [
    ("the simple scene", &[]),
    ("the complicated scene", &[]),
    ("a triangle", &[[20_600, 9_300], [67_000, 24_000], [31_500, 52_700]]),
    ("a sliver", &[[9_000, 14_100], [73_800, 41_500], [71_000, 41_000]]),
    ("triangles that share edges", &[[41_088, 30_848]]),
    ("a line", &[[15_488, 16_512], [66_176, 42_368]]),
    ("a circle", &[[41_088, 30_848], [61_568, 30_848]]),
    ("a star", &[]),
];

pub const SIMPLE: usize = 0;
pub const COMPLICATED: usize = 1;

impl Subject {
    /// One of [`KINDS`]: a vertex that is missing is where it is by default.
    pub fn new(kind: usize, moved: &[At]) -> Option<Self> {
        let (_, defaults) = KINDS.get(kind)?;
        let point = |index: usize| moved.get(index).or(defaults.get(index)).copied().unwrap_or_default();
        let geometry = match kind {
            SIMPLE | 4 => {
                Geometry::Triangles(fan(if kind == SIMPLE { [160 * 256 + 128, 120 * 256 + 128] } else { point(0) }))
            }
            COMPLICATED => Geometry::Triangles(sheet()),
            2 | 3 => Geometry::Triangles(vec![coloured([0, 1, 2].map(point), [0.45, 0.55, 0.7].map(Some))]),
            5 => Geometry::Line([0, 1].map(|index| point(index).map(pixel))),
            6 => {
                let ([x, y], rim) = (point(0).map(pixel), point(1).map(pixel));
                let radius = f64::from(rim[0] - x).hypot(f64::from(rim[1] - y)).round() as i32;
                Geometry::Circle([x, y, radius.clamp(1, 400)])
            }
            _ => Geometry::Star,
        };
        Some(Self { geometry })
    }

    /// The true outline, in 1/256 pixel: what of it is closed is closed.
    pub fn outline(&self, is_antialiased: bool) -> Vec<Vec<At>> {
        let middle = |[x, y]: At| [256 * x + 128, 256 * y + 128];
        match &self.geometry {
            Geometry::Triangles(triangles) => triangles.iter().map(|triangle| closed(&triangle.vertices)).collect(),
            Geometry::Line(ends) if is_antialiased => {
                let corners = antialias::rectangle(ends.map(|[x, y]| Vertex::pixel(x, y)));
                vec![closed(&corners.map(|corner| [corner.x.to_bits(), corner.y.to_bits()]))]
            }
            Geometry::Line(ends) => vec![ends.map(middle).to_vec()],
            Geometry::Circle([x, y, radius]) => {
                let [x, y] = middle([*x, *y]).map(f64::from);
                let radius = 256.0 * f64::from(*radius);
                let at = |step: i32| {
                    let (sin, cos) = (f64::from(step) * TAU / 720.0).sin_cos();
                    [(x + radius * cos).round() as i32, (y + radius * sin).round() as i32]
                };
                vec![(0..=720).map(at).collect()]
            }
            Geometry::Star => vec![closed(&STAR)],
        }
    }
}

fn pixel(subpixels: i32) -> i32 {
    subpixels >> 8
}

fn closed(vertices: &[At]) -> Vec<At> {
    vertices.iter().chain(vertices.first()).copied().collect()
}

const STAR: [At; 5] = [[40_960, 3_600], [57_100, 54_100], [14_700, 22_700], [67_300, 22_900], [24_600, 53_800]];
const STAR_VERTICES: [Vertex; 5] = [
    Vertex::from_bits(STAR[0][0], STAR[0][1]),
    Vertex::from_bits(STAR[1][0], STAR[1][1]),
    Vertex::from_bits(STAR[2][0], STAR[2][1]),
    Vertex::from_bits(STAR[3][0], STAR[3][1]),
    Vertex::from_bits(STAR[4][0], STAR[4][1]),
];

/// The star for the methods that fill polygons, by the even-odd rule.
pub const STAR_OUTLINE: Outline = Outline { contours: &[&STAR], even_odd: true };
/// The same for those that smooth edges.
pub const STAR_CONTOURS: &[&[Vertex]] = &[&STAR_VERTICES];

/// Six triangles around a hub: the vertices of the rim lie on pixel centres, as in programs whose vertices are pixels.
fn fan(hub: At) -> Vec<Shaded> {
    const RIM: [[i32; 2]; 6] = [[270, 120], [216, 30], [104, 30], [50, 120], [104, 210], [216, 210]];
    let rim = |index: usize| RIM[index % 6].map(|at| 256 * at + 128);
    let hue = |index: usize| (index % 6) as f64 / 6.0;
    let triangle = |index: usize| {
        coloured([hub, rim(index), rim(index + 1)], [None, Some(hue(index)), Some(hue(index) + 1.0 / 6.0)])
    };
    (0..6).map(triangle).collect()
}

const COLUMNS: usize = 24;
const ROWS: usize = 16;

/// A bent sheet of 768 triangles; every other vertex lies on a pixel's centre.
fn sheet() -> Vec<Shaded> {
    let mut state = 0x2545_F491_u32;
    let mut random = |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((state >> 8) % below) as i32
    };
    let mut vertices = [[[0; 2]; COLUMNS + 1]; ROWS + 1];
    for (row, vertices) in vertices.iter_mut().enumerate() {
        for (column, vertex) in vertices.iter_mut().enumerate() {
            let spread = |index: usize, steps: usize, size: i32| (12 + index as i32 * (size - 25) / steps as i32) * 256;
            *vertex = [spread(column, COLUMNS, WIDTH), spread(row, ROWS, HEIGHT)];
            vertex.iter_mut().for_each(|at| *at += random(7 * 256) - 3 * 256);
            if (row + column) % 2 == 0 {
                vertex.iter_mut().for_each(|at| *at = (*at & -256) + 128);
            }
        }
    }
    let mut triangles = vec![];
    for (row, pair) in vertices.windows(2).enumerate() {
        for column in 0..COLUMNS {
            let hue = |row: usize, column: usize| {
                0.55 + 0.35 * (row as f64 * 0.5).sin() * (column as f64 * 0.4).cos() + column as f64 / 60.0
            };
            let (a, b) = ((pair[0][column], hue(row, column)), (pair[0][column + 1], hue(row, column + 1)));
            let (c, d) = ((pair[1][column], hue(row + 1, column)), (pair[1][column + 1], hue(row + 1, column + 1)));
            for [a, b, c] in [[a, b, d], [a, d, c]] {
                triangles.push(coloured([a.0, b.0, c.0], [a.1, b.1, c.1].map(Some)));
            }
        }
    }
    triangles
}

/// A triangle with hues at its vertices, 0 to 1 around the wheel, or nearly white; without perspective.
fn coloured(vertices: [At; 3], hues: [Option<f64>; 3]) -> Shaded {
    let attributes = hues.map(|hue| {
        let Some(hue) = hue else { return [250, 248, 240, 255] };
        let channel = |shift: f64| (140.0 + 110.0 * ((hue + shift) * TAU).cos()).round() as i32;
        [channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0), 255]
    });
    Shaded { vertices, attributes, w: [65536; 3], depth: [0, 30_000, 60_000] }
}
