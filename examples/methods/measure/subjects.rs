//! The shapes that the oracle knows, in the methods' own form.

use std::{iter, ops::Range};

use spanfill::{Circle, FillRule, I24F8, Line, Triangle, Vertex};

use super::{
    suite::{Aim, Subject},
    truth::{Truth, Wanted},
};
use crate::{
    oracle::{
        Belongs, HasArea, Outline,
        rule::{At, centre, cross},
    },
    variants::{self, WIDTH},
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
