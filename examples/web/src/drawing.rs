//! A subject in the form that a method wants, and the method.

use spanfill::{FillRule, Vertex};

use crate::{
    subject::{Geometry, STAR_CONTOURS, STAR_OUTLINE, Subject},
    variants::{
        Frame, Outcome, Picture, SCREEN, Variant,
        antialias::{ANTIALIAS, Scene},
        attribute::ATTRIBUTES,
        circle::CIRCLES,
        line::LINES,
        points::POINTS,
        polygon::POLYGONS,
        triangle::{INSIDE, SHARED, TRAVERSAL},
    },
};

/// A method of the literature with one of its options, by their names in `spanfill::methods::FAMILIES`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    pub family: &'static str,
    pub method: &'static str,
    pub option: &'static str,
}

/// What can be drawn part by part.
pub trait Drawing {
    fn parts(&self) -> usize;

    /// Draws a part for the judge.
    fn check(&self, part: usize, picture: &mut Picture) -> Outcome;

    /// Draws everything for the clock; what a method cannot draw, it leaves out.
    fn time(&self, frame: &mut Frame);
}

struct Parts<S: ?Sized + 'static> {
    variant: &'static Variant<S>,
    shapes: Vec<Box<S>>,
}

impl<S: ?Sized> Drawing for Parts<S> {
    fn parts(&self) -> usize {
        self.shapes.len()
    }

    fn check(&self, part: usize, picture: &mut Picture) -> Outcome {
        (self.variant.check)(&self.shapes[part], &SCREEN, picture)
    }

    fn time(&self, frame: &mut Frame) {
        for shape in &self.shapes {
            let _ = (self.variant.time)(shape, &SCREEN, frame);
        }
    }
}

fn parts<S: ?Sized>(
    list: &'static [Variant<S>],
    choice: &Choice,
    shapes: impl Iterator<Item = Box<S>>,
) -> Option<Box<dyn Drawing>> {
    let wanted = |variant: &&Variant<S>| {
        (variant.family, variant.method, variant.option) == (choice.family, choice.method, choice.option)
    };
    let variant = list.iter().find(wanted)?;
    Some(Box::new(Parts { variant, shapes: shapes.collect() }))
}

fn one<S>(list: &'static [Variant<S>], choice: &Choice, shape: S) -> Option<Box<dyn Drawing>> {
    parts(list, choice, [Box::new(shape)].into_iter())
}

/// The subject by the method, where it is one for such a subject.
pub fn drawing(subject: &Subject, choice: &Choice) -> Option<Box<dyn Drawing>> {
    let vertex = |[x, y]: [i32; 2]| Vertex::from_bits(x, y);
    match (&subject.geometry, choice.family) {
        (Geometry::Triangles(all), family) => {
            let corners = all.iter().map(|triangle| triangle.vertices);
            match (family, all.as_slice()) {
                ("triangle: inside test", _) => parts(INSIDE, choice, corners.map(Box::new)),
                ("triangle: traversal", _) => parts(TRAVERSAL, choice, corners.map(Box::new)),
                ("shared edges", _) => parts(SHARED, choice, [corners.collect()].into_iter()),
                ("attributes", _) => parts(ATTRIBUTES, choice, all.iter().copied().map(Box::new)),
                ("points", _) => {
                    parts(POINTS, choice, [corners.map(|corners| corners.map(vertex)).collect()].into_iter())
                }
                ("anti-aliasing", [triangle]) => one(ANTIALIAS, choice, Scene::Triangle(triangle.vertices.map(vertex))),
                _ => None,
            }
        }
        (Geometry::Line(line), "line") => one(LINES, choice, *line),
        (Geometry::Line(line), "anti-aliasing") => {
            one(ANTIALIAS, choice, Scene::Line(line.map(|[x, y]| Vertex::pixel(x, y))))
        }
        (Geometry::Circle(circle), "circle") => one(CIRCLES, choice, *circle),
        (Geometry::Star, "polygon") => one(POLYGONS, choice, STAR_OUTLINE),
        (Geometry::Star, "anti-aliasing") => one(ANTIALIAS, choice, Scene::Polygon(STAR_CONTOURS, FillRule::EvenOdd)),
        _ => None,
    }
}

/// Whether a method tells how much of a pixel is covered.
pub fn is_antialiased(choice: &Choice) -> bool {
    choice.family == "anti-aliasing"
        || matches!((choice.family, choice.method), ("line", "Wu" | "Gupta-Sproull"))
        || matches!((choice.family, choice.option), ("line", "exact coverage"))
}
