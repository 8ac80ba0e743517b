//! How a picture differs from the exact rule's, pixel by pixel.

use std::{collections::HashMap, ops::Range};

use spanfill::{Circle, FillRule, Line, Triangle, Vertex};

use crate::{
    drawing::{Choice, is_antialiased},
    oracle::{
        area::HasArea,
        ring::Ring,
        rule::{At, Belongs, Outline, centre, cross, product},
    },
    subject::{Geometry, STAR_CONTOURS, Subject},
    variants::{HEIGHT, Picture, WIDTH, attribute::Shaded, circle::shipped},
};

/// What became of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Verdict {
    /// Rightly not there.
    Empty,
    /// Rightly there.
    Right,
    /// Its centre is covered, but it is not there.
    Missing,
    /// It is there, but its centre is not covered.
    Extra,
    /// It came more often than it should.
    Doubled,
    /// Its centre lies on the outline, and the method gives it to the other side than the top-left rule.
    Tie,
    /// Its coverage or its colour is not the nearest to the exact one.
    Off,
}

/// What is right.
#[derive(Debug)]
pub struct Truth {
    /// What it is the truth about.
    geometry: Geometry,
    rule: Rule,
    /// How many shapes own each pixel, and the last of them.
    count: Vec<u16>,
    owner: Vec<u16>,
    is_tie: Vec<bool>,
    /// The part of each pixel that is covered, where it is not all or nothing.
    coverage: Vec<f64>,
}

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// What a method is held to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rule {
    Coverage,
    Centres,
    /// A circle's own: the outline's, the shipped disc's.
    Ring,
    Disc,
}

impl Rule {
    fn of(choice: &Choice) -> Self {
        if is_antialiased(choice) {
            Self::Coverage
        } else if choice.option.contains("outline") {
            Self::Ring
        } else if choice.method == "spanfill" {
            Self::Disc
        } else {
            Self::Centres
        }
    }
}

impl Truth {
    /// Whether it is that of this subject and method, too.
    pub fn is_of(&self, subject: &Subject, choice: &Choice) -> bool {
        self.rule == Rule::of(choice) && self.geometry == subject.geometry
    }

    pub fn new(subject: &Subject, choice: &Choice) -> Self {
        let mut truth = Self {
            geometry: subject.geometry.clone(),
            rule: Rule::of(choice),
            count: vec![0; PIXELS],
            owner: vec![0; PIXELS],
            is_tie: vec![false; PIXELS],
            coverage: vec![],
        };
        let vertex = |[x, y]: [i32; 2]| Vertex::from_bits(x, y);
        let star = || Outline::new(STAR_CONTOURS.iter().map(|contour| contour.to_vec()).collect(), FillRule::EvenOdd);
        match (&subject.geometry, is_antialiased(choice)) {
            (Geometry::Triangles(all), false) => truth.mark_triangles(all),
            (Geometry::Triangles(all), true) => {
                all.iter().for_each(|one| truth.cover(&Triangle::from_vertices(one.vertices.map(vertex))));
            }
            (Geometry::Line([[x1, y1], [x2, y2]]), is_antialiased) => {
                let line = Line::new(Vertex::pixel(*x1, *y1), Vertex::pixel(*x2, *y2));
                if is_antialiased {
                    truth.cover(&line);
                } else {
                    truth.mark(
                        &SCREEN,
                        |column, row| line.has(column, row),
                        |column, row| is_line_tie(&line, column, row),
                    );
                }
            }
            (Geometry::Circle(circle), _) => truth.mark_circle(*circle),
            (Geometry::Star, true) => truth.cover(&star()),
            (Geometry::Star, false) => {
                let star = star();
                let contour: Vec<At> = STAR_CONTOURS[0].iter().map(|vertex| At::from(*vertex)).collect();
                truth.mark(
                    &SCREEN,
                    |column, row| star.has(column, row),
                    |column, row| edges(&contour).any(|edge| lies_on(edge, column, row)),
                );
            }
        }
        truth
    }

    /// Marks the pixels of a shape within a window.
    fn mark(&mut self, window: &Window, has: impl Fn(i32, i32) -> bool, is_tie: impl Fn(i32, i32) -> bool) {
        for row in window.rows.clone() {
            for column in window.columns.clone() {
                let at = (row * WIDTH + column) as usize;
                self.count[at] += u16::from(has(column, row));
                self.is_tie[at] |= is_tie(column, row);
            }
        }
    }

    fn mark_triangles(&mut self, all: &[Shaded]) {
        // On an edge that two triangles share, somebody has to draw the pixel, and only one: a tie is at the rim.
        let mut shared: HashMap<[[i32; 2]; 2], u32> = HashMap::new();
        let key = |a: [i32; 2], b: [i32; 2]| if a < b { [a, b] } else { [b, a] };
        for Shaded { vertices: [a, b, c], .. } in all {
            [key(*a, *b), key(*b, *c), key(*c, *a)].into_iter().for_each(|edge| *shared.entry(edge).or_default() += 1);
        }
        for (index, Shaded { vertices, .. }) in all.iter().enumerate() {
            let [a, b, c] = *vertices;
            let rim: Vec<(At, At)> = [[a, b], [b, c], [c, a]]
                .into_iter()
                .filter(|[a, b]| shared[&key(*a, *b)] == 1)
                .map(|edge| edge.map(|[x, y]| At { x: x.into(), y: y.into() }).into())
                .collect();
            let triangle = Triangle::from_vertices(vertices.map(|[x, y]| Vertex::from_bits(x, y)));
            let window = Window::around(vertices);
            for row in window.rows.clone() {
                for column in window.columns.clone() {
                    let at = (row * WIDTH + column) as usize;
                    if triangle.has(column, row) {
                        self.count[at] += 1;
                        self.owner[at] = index as u16;
                    }
                }
            }
            self.mark(&window, |_, _| false, |column, row| rim.iter().any(|edge| lies_on(*edge, column, row)));
        }
    }

    fn mark_circle(&mut self, circle: [i32; 3]) {
        let [x, y, radius] = circle.map(i64::from);
        let ring = Ring { center: [x, y], radius };
        let disc: Circle = shipped(circle);
        let never = |_: i32, _: i32| false;
        match self.rule {
            Rule::Ring => self.mark(&SCREEN, |column, row| ring.has(column, row), never),
            Rule::Disc => self.mark(&SCREEN, |column, row| disc.has(column, row), never),
            Rule::Coverage | Rule::Centres => self.mark(&SCREEN, |column, row| ring.holds(column, row), never),
        }
    }

    fn cover(&mut self, shape: &impl HasArea) {
        self.coverage =
            (0..HEIGHT).flat_map(|row| shape.areas_in_row(row, &(0..WIDTH))).map(|area| area.value).collect();
    }

    /// The shape that owns a pixel.
    pub fn owner(&self, at: usize) -> Option<usize> {
        (self.count[at] > 0).then_some(self.owner[at].into())
    }

    /// How many pixels the picture has.
    pub fn pixels(&self) -> usize {
        let covered = self.coverage.iter().filter(|part| **part > 0.5 / 255.0).count();
        covered + self.count.iter().filter(|count| **count > 0).count()
    }

    /// What became of a pixel, and by how many levels it is off, beyond what rounding once takes.
    pub fn judge(&self, subject: &Subject, choice: &Choice, picture: &Picture, at: usize) -> (Verdict, f64) {
        let count = picture.count[at];
        if let Some(part) = self.coverage.get(at) {
            let drawn = if count == 0 { 0.0 } else { f64::from(picture.coverage[at]) };
            let off = beyond_rounding(drawn - 255.0 * part);
            let right = if count > 0 { Verdict::Right } else { Verdict::Empty };
            return (if off > 0.0 { Verdict::Off } else { right }, off);
        }
        let wanted = self.count[at];
        let verdict = match (count, wanted) {
            (0, 0) => Verdict::Empty,
            _ if count == wanted => Verdict::Right,
            (0, _) if self.is_tie[at] => Verdict::Tie,
            (1, 0) if self.is_tie[at] => Verdict::Tie,
            (_, 0) => Verdict::Extra,
            _ if count > wanted => Verdict::Doubled,
            _ => Verdict::Missing,
        };
        let Geometry::Triangles(all) = &subject.geometry else { return (verdict, 0.0) };
        if verdict != Verdict::Right || choice.family != "attributes" {
            return (verdict, 0.0);
        }
        let off = self.owner(at).map_or(0.0, |owner| levels_off(&all[owner], choice, picture, at));
        (if off > 0.0 { Verdict::Off } else { verdict }, off)
    }
}

/// How far a pixel's worst channel is from the exact plane through the vertices' values.
fn levels_off(shape: &Shaded, choice: &Choice, picture: &Picture, at: usize) -> f64 {
    let [a, b, c] = shape.vertices.map(|[x, y]| At { x: x.into(), y: y.into() });
    let p = centre(at as i32 % WIDTH, at as i32 / WIDTH);
    let weights = [cross(b, c, p), cross(c, a, p), cross(a, b, p)];
    let area = weights.iter().sum::<i128>() as f64;
    let off = |values: [i32; 3], drawn: i32| {
        let sum: i128 = weights.iter().zip(values).map(|(weight, value)| weight * i128::from(value)).sum();
        beyond_rounding(f64::from(drawn) - sum as f64 / area)
    };
    if choice.method == "depth" {
        return off(shape.depth.map(i32::from), picture.depth[at].into());
    }
    (0..3)
        .map(|channel| off(shape.attributes.map(|at| at[channel]), picture.attributes[at][channel]))
        .fold(0.0, f64::max)
}

fn beyond_rounding(off: f64) -> f64 {
    let beyond = off.abs() - 0.5;
    // The quotients are in `f64`.
    if beyond < 1e-6 { 0.0 } else { beyond }
}

struct Window {
    rows: Range<i32>,
    columns: Range<i32>,
}

const SCREEN: Window = Window { rows: 0..HEIGHT, columns: 0..WIDTH };

impl Window {
    /// The pixels of the screen that vertices lie in, and what is between them.
    fn around(vertices: &[[i32; 2]]) -> Self {
        let range = |axis: usize, size: i32| {
            let pixels = || vertices.iter().map(|vertex| vertex[axis] >> 8);
            pixels().min().unwrap_or(0).clamp(0, size)..pixels().max().unwrap_or(0).saturating_add(1).clamp(0, size)
        };
        Self { rows: range(1, HEIGHT), columns: range(0, WIDTH) }
    }
}

fn edges(contour: &[At]) -> impl Iterator<Item = (At, At)> {
    contour.iter().copied().zip(contour.iter().copied().cycle().skip(1))
}

fn lies_on((a, b): (At, At), column: i32, row: i32) -> bool {
    let p = centre(column, row);
    let within = |a: i64, b: i64, p: i64| a.min(b) <= p && p <= a.max(b);
    within(a.x, b.x, p.x) && within(a.y, b.y, p.y) && cross(a, b, p) == 0
}

/// Whether the line passes exactly between this pixel and the next, in the middle of the step.
fn is_line_tie(line: &Line, column: i32, row: i32) -> bool {
    let (a, b) = (At::from(line.start), At::from(line.end));
    let p = centre(column, row);
    let is_flat = (b.x - a.x).abs() >= (b.y - a.y).abs();
    let turned = |p: At| if is_flat { (p.x, p.y) } else { (p.y, p.x) };
    let ((a_major, a_minor), (b_major, b_minor), (major, minor)) = (turned(a), turned(b), turned(p));
    let length = b_major - a_major;
    let is_within = a_major.min(b_major) <= major && major <= a_major.max(b_major);
    let at_centre = product(a_minor, length) + product(major - a_major, b_minor - a_minor);
    length != 0 && is_within && [minor - 128, minor + 128].into_iter().any(|side| product(side, length) == at_centre)
}
