//! The shapes that the oracle knows, in the methods' own form.

use std::{iter, ops::Range};

use spanfill::{Circle, FillRule, Line, Triangle, Vertex};

use super::{
    suite::{Aim, Subject},
    truth::{Truth, Wanted},
};
use crate::{
    oracle::{
        Belongs, HasArea, Outline,
        rule::{At, centre, cross},
    },
    variants::{self, WIDTH, antialias},
};

type Window = [Range<i32>; 2];

fn vertex([x, y]: [i32; 2]) -> Vertex {
    Vertex::from_bits(x, y)
}

/// Marks what belongs to a shape, and which of the pixels around it are ties.
fn fill(truth: &mut Truth, shape: &impl Belongs, [columns, rows]: &Window, is_tie: impl Fn(i32, i32) -> bool) {
    for row in rows.clone() {
        let has = shape.has_in_row(row);
        for column in columns.clone() {
            let wanted = &mut truth.wanted[(row * WIDTH + column) as usize];
            wanted.count += u16::from(has(column));
            wanted.is_tie |= is_tie(column, row);
        }
    }
}

/// Notes how much of each pixel is covered; those that are touched at all are wanted.
fn cover(truth: &mut Truth, shape: &impl HasArea, [columns, rows]: &Window) {
    truth.coverage = vec![0.0; truth.wanted.len()];
    for row in rows.clone() {
        for (area, column) in shape.areas_in_row(row, columns).iter().zip(columns.clone()) {
            let at = (row * WIDTH + column) as usize;
            truth.coverage[at] = area.value;
            // What is less than half a 255th may be left out or not.
            truth.wanted[at] = Wanted { count: u16::from(area.value > 0.5 / 255.0), is_tie: area.value < 1.0 / 255.0 };
        }
    }
}

/// Whether the centre of a pixel lies on a closed outline.
fn lies_on(vertices: &[[i32; 2]], column: i32, row: i32) -> bool {
    let p = centre(column, row);
    let following = vertices.iter().skip(1).chain(vertices.first());
    vertices.iter().zip(following).any(|(a, b)| {
        let (a, b) = (At::from(vertex(*a)), At::from(vertex(*b)));
        let within = |a: i64, b: i64, p: i64| a.min(b) <= p && p <= a.max(b);
        within(a.x, b.x, p.x) && within(a.y, b.y, p.y) && cross(a, b, p) == 0
    })
}

/// In pixels, for the eye.
fn in_pixels(vertices: &[[i32; 2]]) -> Vec<(f64, f64)> {
    vertices.iter().map(|[x, y]| (f64::from(*x) / 256.0, f64::from(*y) / 256.0)).collect()
}

/// The part of the window that a shape between these heights and columns can reach, a pixel around it included.
fn reach(window: &Window, points: impl Iterator<Item = [i32; 2]> + Clone) -> Window {
    let range = |axis: usize| {
        let least = points.clone().map(|point| point[axis] >> 8).min().unwrap_or(0).saturating_sub(1);
        let most = points.clone().map(|point| point[axis] >> 8).max().unwrap_or(0).saturating_add(2);
        least.max(window[axis].start).min(window[axis].end)..most.min(window[axis].end).max(window[axis].start)
    };
    [range(0), range(1)]
}

impl Subject for [[i32; 2]; 3] {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        let mut truth = Truth::new();
        let triangle = Triangle::from_vertices(self.map(vertex));
        let window = reach(window, self.iter().copied());
        match aim {
            Aim::Coverage => cover(&mut truth, &triangle, &window),
            _ => fill(&mut truth, &triangle, &window, |column, row| lies_on(self, column, row)),
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        vec![in_pixels(self)]
    }
}

/// Triangles that share edges: every pixel inside belongs to one of them.
#[derive(Debug, Clone)]
pub(crate) struct Mesh(pub(crate) Vec<[[i32; 2]; 3]>);

impl Subject for Mesh {
    type Drawn = [[[i32; 2]; 3]];

    fn parts(&self) -> impl Iterator<Item = &Self::Drawn> {
        iter::once(&self.0[..])
    }

    fn truth(&self, _: Aim, window: &Window) -> Truth {
        let mut truth = Truth::new();
        for triangle in &self.0 {
            let window = reach(window, triangle.iter().copied());
            // Not a tie: between triangles that share an edge somebody has to draw the pixel, and only one.
            fill(&mut truth, &Triangle::from_vertices(triangle.map(vertex)), &window, |_, _| false);
        }
        // But at the rim of the mesh.
        let edges = || self.0.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
        let is_same = |[a, b]: [[i32; 2]; 2], other: [[i32; 2]; 2]| other == [a, b] || other == [b, a];
        for edge in edges().filter(|edge| edges().filter(|other| is_same(*edge, *other)).count() == 1) {
            mark_ties(&mut truth, &[&edge], &reach(window, edge.into_iter()));
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        self.0.iter().map(|triangle| in_pixels(triangle)).collect()
    }
}

/// An outline that lasts, as the methods of polygons want it.
pub(crate) fn outline(contours: Vec<Vec<[i32; 2]>>, even_odd: bool) -> variants::polygon::Outline {
    let lasting = |contour: Vec<[i32; 2]>| -> &'static [[i32; 2]] { Vec::leak(contour) };
    let contours: Vec<&'static [[i32; 2]]> = contours.into_iter().map(lasting).collect();
    variants::polygon::Outline { contours: Vec::leak(contours), even_odd }
}

impl Subject for variants::polygon::Outline {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        let mut truth = Truth::new();
        let contours = self.contours.iter().map(|contour| contour.iter().copied().map(vertex).collect()).collect();
        let rule = if self.even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let polygon = Outline::new(contours, rule);
        let window = reach(window, self.contours.iter().flat_map(|contour| contour.iter().copied()));
        match aim {
            Aim::Coverage => cover(&mut truth, &polygon, &window),
            _ => {
                fill(&mut truth, &polygon, &window, |_, _| false);
                mark_ties(&mut truth, self.contours, &window);
            }
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        self.contours.iter().map(|contour| in_pixels(contour)).collect()
    }
}

/// Marks the pixels whose centres lie on a closed contour: edge by edge, row by row.
fn mark_ties(truth: &mut Truth, contours: &[&[[i32; 2]]], [columns, rows]: &Window) {
    for contour in contours {
        let following = contour.iter().skip(1).chain(contour.first());
        for (a, b) in contour.iter().zip(following) {
            for row in rows.clone() {
                let y = 256 * i64::from(row) + 128;
                let (ay, by) = (i64::from(a[1]), i64::from(b[1]));
                if y < ay.min(by) || y > ay.max(by) {
                    continue;
                }
                let (least, most) = (a[0].min(b[0]) >> 8, a[0].max(b[0]) >> 8);
                let places = if ay == by {
                    (least - 1).max(columns.start)..(most + 2).min(columns.end)
                } else {
                    // The one pixel that the edge meets here.
                    let (ax, bx) = (i64::from(a[0]), i64::from(b[0]));
                    let x = ax + ((y - ay) * (bx - ax)).div_euclid(by - ay);
                    let column = i32::try_from(x >> 8).unwrap_or(i32::MAX);
                    column.max(columns.start)..column.saturating_add(1).min(columns.end)
                };
                for column in places.filter(|column| lies_on(&[*a, *b], *column, row)) {
                    truth.wanted[(row * WIDTH + column) as usize].is_tie = true;
                }
            }
        }
    }
}

/// The same, each triangle drawn by itself: what a method without a rule for shared edges does.
#[derive(Debug, Clone)]
pub(crate) struct OneByOne(pub(crate) Mesh);

impl Subject for OneByOne {
    type Drawn = [[i32; 2]; 3];

    fn parts(&self) -> impl Iterator<Item = &Self::Drawn> {
        self.0.0.iter()
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        self.0.truth(aim, window)
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        self.0.outline()
    }
}

impl Subject for variants::attribute::Shaded {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        let mut truth = self.vertices.truth(Aim::Fill, window);
        truth.attributes = vec![[0.0; 4]; truth.wanted.len()];
        truth.channels = if aim == Aim::Depth { 1 } else { 4 };
        truth.is_depth = aim == Aim::Depth;
        let [a, b, c] = self.vertices.map(|point| At::from(vertex(point)));
        let [columns, rows] = reach(window, self.vertices.iter().copied());
        for (row, column) in rows.flat_map(|row| columns.clone().map(move |column| (row, column))) {
            let p = centre(column, row);
            // Barycentric weights, times twice the area; in perspective each is divided by w, here times the other two.
            let mut weights = [cross(b, c, p), cross(c, a, p), cross(a, b, p)];
            if aim == Aim::Perspective {
                let [w0, w1, w2] = self.w.map(i128::from);
                weights = [weights[0] * w1 * w2, weights[1] * w2 * w0, weights[2] * w0 * w1];
            }
            let sum: i128 = weights.iter().sum();
            let value = |values: [i32; 3]| {
                let weighted: i128 = weights.iter().zip(values).map(|(weight, value)| weight * i128::from(value)).sum();
                if sum == 0 { 0.0 } else { quotient(weighted, sum) }
            };
            let at = (row * WIDTH + column) as usize;
            truth.attributes[at] = if aim == Aim::Depth {
                [value(self.depth.map(i32::from)), 0.0, 0.0, 0.0]
            } else {
                [0, 1, 2, 3].map(|channel| value(self.attributes.map(|attributes| attributes[channel])))
            };
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        self.vertices.outline()
    }
}

/// To some 50 bits behind the point.
fn quotient(numerator: i128, denominator: i128) -> f64 {
    let whole = numerator.div_euclid(denominator);
    let rest = numerator.rem_euclid(denominator);
    whole as f64 + rest as f64 / denominator as f64
}

/// Lines between whole pixels.
impl Subject for [[i32; 2]; 2] {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        let mut truth = Truth::new();
        let [start, end] = *self;
        let line = Line::new(Vertex::pixel(start[0], start[1]), Vertex::pixel(end[0], end[1]));
        if aim == Aim::Coverage {
            let ends = self.map(|[x, y]| [x.saturating_mul(256), y.saturating_mul(256)]);
            let [columns, rows] = reach(window, ends.into_iter());
            let wider = |range: Range<i32>, most: i32| (range.start - 2).max(0)..(range.end + 2).min(most);
            cover(&mut truth, &line, &[wider(columns, window[0].end), wider(rows, window[1].end)]);
        } else {
            fill(&mut truth, &line, window, |column, row| is_halfway(*self, column, row));
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        vec![self.map(|[x, y]| (f64::from(x) + 0.5, f64::from(y) + 0.5)).to_vec()]
    }
}

/// Whether the line leads exactly between this pixel and one beside it, across the longer axis.
fn is_halfway([start, end]: [[i32; 2]; 2], column: i32, row: i32) -> bool {
    let at = |point: [i32; 2]| point.map(i64::from);
    let (a, b, p) = (at(start), at(end), [i64::from(column), i64::from(row)]);
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let (major, along, rise) = if dx.abs() >= dy.abs() { (0, dx, dy) } else { (1, dy, dx) };
    let between = a[major].min(b[major])..=a[major].max(b[major]);
    let off = (p[1 - major] - a[1 - major]) * along - (p[major] - a[major]) * rise;
    along != 0 && between.contains(&p[major]) && 2 * off.abs() == along.abs()
}

/// Circles around whole pixels: x, y, radius.
impl Subject for [i32; 3] {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, aim: Aim, [columns, rows]: &Window) -> Truth {
        let mut truth = Truth::new();
        let [x, y, radius] = self.map(i64::from);
        // Where the outline is: its half height in the columns of the octant, its half width in the rows of it.
        for (row, column) in rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column))) {
            let (dx, dy) = ((i64::from(column) - x).abs(), (i64::from(row) - y).abs());
            let (least, most) = (dx.min(dy), dx.max(dy));
            // 4 (r^2 - least^2) lies between the squares of 2 most - 1 and 2 most + 1: most is the nearest whole number.
            let square = 4 * (radius * radius - least * least);
            let is_nearest = square > (2 * most - 1) * (2 * most - 1) && square < (2 * most + 1) * (2 * most + 1);
            let is_outline = if most == 0 { radius == 0 } else { is_nearest };
            let wanted = &mut truth.wanted[(row * WIDTH + column) as usize];
            if aim == Aim::Outline {
                wanted.count = u16::from(is_outline);
            } else {
                let is_inside = square > (2 * most - 1) * (2 * most - 1) || most == 0;
                // Nearer than r + 1/2: the crate's rule, and a few pixels more than what ends with the outline.
                let is_near = 4 * (dx * dx + dy * dy) < (2 * radius + 1) * (2 * radius + 1);
                *wanted = Wanted { count: u16::from(is_near), is_tie: is_near != is_inside };
            }
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        let [x, y, radius] = self.map(f64::from);
        let at = |step: i32| {
            let angle = f64::from(step) * std::f64::consts::TAU / 64.0;
            (x + 0.5 + radius * libm::cos(angle), y + 0.5 + radius * libm::sin(angle))
        };
        vec![(0..64).map(at).collect()]
    }
}

/// What is drawn smooth.
impl Subject for antialias::Scene {
    type Drawn = Self;

    fn parts(&self) -> impl Iterator<Item = &Self> {
        iter::once(self)
    }

    fn truth(&self, _: Aim, window: &Window) -> Truth {
        let mut truth = Truth::new();
        let bits = |vertex: &Vertex| [vertex.x.to_bits(), vertex.y.to_bits()];
        let wider = |[columns, rows]: Window| {
            let wider = |range: Range<i32>, most: i32| (range.start - 2).max(0)..(range.end + 2).min(most);
            [wider(columns, window[0].end), wider(rows, window[1].end)]
        };
        match self {
            Self::Triangle(vertices) => {
                let reach = reach(window, vertices.iter().map(bits));
                cover(&mut truth, &Triangle::from_vertices(*vertices), &reach);
            }
            Self::Line(ends) => {
                cover(&mut truth, &Line::new(ends[0], ends[1]), &wider(reach(window, ends.iter().map(bits))));
            }
            Self::Polygon(contours, rule) => {
                let reach = reach(window, contours.iter().flat_map(|contour| contour.iter()).map(bits));
                cover(
                    &mut truth,
                    &Outline::new(contours.iter().map(|contour| contour.to_vec()).collect(), *rule),
                    &reach,
                );
            }
            Self::Texture { texels, size, corner, pixels } => average(&mut truth, texels, *size, *corner, *pixels),
        }
        truth
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        let place = |vertex: &Vertex| [vertex.x.to_bits(), vertex.y.to_bits()];
        match self {
            Self::Triangle(vertices) => vec![in_pixels(&vertices.each_ref().map(place))],
            Self::Line(ends) => vec![in_pixels(&antialias::rectangle(*ends).each_ref().map(place))],
            Self::Polygon(contours, _) => {
                contours.iter().map(|contour| in_pixels(&contour.iter().map(place).collect::<Vec<_>>())).collect()
            }
            Self::Texture { .. } => vec![],
        }
    }
}

/// The averages of the texels in each pixel, each by its share.
fn average(truth: &mut Truth, texels: &[u8], size: [u16; 2], corner: [i32; 2], pixels: [u16; 2]) {
    truth.coverage = vec![0.0; truth.wanted.len()];
    let share = |texel: u16, pixel: u16, axis: usize| {
        let (texels, pixels) = (f64::from(size[axis]), f64::from(pixels[axis]));
        let from = (f64::from(texel) / texels).max(f64::from(pixel) / pixels);
        let to = (f64::from(texel + 1) / texels).min(f64::from(pixel + 1) / pixels);
        (to - from).max(0.0) * pixels
    };
    for (row, column) in (0..pixels[1]).flat_map(|row| (0..pixels[0]).map(move |column| (row, column))) {
        let mut sum = 0.0;
        for (j, i) in (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (j, i))) {
            let part = share(j, row, 1) * share(i, column, 0);
            sum += part * f64::from(texels[usize::from(j) * usize::from(size[0]) + usize::from(i)]) / 255.0;
        }
        let at = ((corner[1] + i32::from(row)) * WIDTH + corner[0] + i32::from(column)) as usize;
        truth.coverage[at] = sum;
        truth.wanted[at] = Wanted { count: u16::from(sum > 0.5 / 255.0), is_tie: true };
    }
}

/// A mesh of small triangles.
#[derive(Debug, Clone)]
pub(crate) struct Specks(pub(crate) Vec<[Vertex; 3]>);

impl Subject for Specks {
    type Drawn = [[Vertex; 3]];

    fn parts(&self) -> impl Iterator<Item = &Self::Drawn> {
        iter::once(&self.0[..])
    }

    fn truth(&self, aim: Aim, window: &Window) -> Truth {
        self.as_mesh().truth(aim, window)
    }

    fn outline(&self) -> Vec<Vec<(f64, f64)>> {
        self.as_mesh().outline()
    }
}

impl Specks {
    fn as_mesh(&self) -> Mesh {
        let bits = |vertex: &Vertex| [vertex.x.to_bits(), vertex.y.to_bits()];
        Mesh(self.0.iter().map(|triangle| triangle.each_ref().map(bits)).collect())
    }
}
