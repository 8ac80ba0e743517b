//! From curves to vertices.

use kurbo::{BezPath, PathEl, Point};

/// How far, in pixels, an edge may be from the curve that it stands for.
pub(crate) const TOLERANCE: f64 = 1.0 / 16.0;

/// What is filled in one colour.
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) rgb: [u8; 3],
    pub(crate) even_odd: bool,
    /// In 1/256 pixel.
    pub(crate) contours: Vec<Vec<[i32; 2]>>,
}

impl Shape {
    /// `None` for what has no area at all.
    pub(crate) fn new(rgb: [u8; 3], even_odd: bool, path: &BezPath) -> Option<Self> {
        let contours = contours(path);
        (!contours.is_empty()).then_some(Self { rgb, even_odd, contours })
    }
}

/// Vertices that are the same as those before them are left out, and contours of fewer than three.
fn contours(path: &BezPath) -> Vec<Vec<[i32; 2]>> {
    let mut contours: Vec<Vec<[i32; 2]>> = Vec::new();
    let mut add = |point: Point, starts: bool| {
        if starts || contours.is_empty() {
            contours.push(Vec::new());
        }
        let contour = contours.last_mut().expect("one has been started");
        let vertex = [point.x, point.y].map(|value| (value * 256.0).round() as i32);
        if contour.last() != Some(&vertex) {
            contour.push(vertex);
        }
    };
    kurbo::flatten(path, TOLERANCE, |element| match element {
        PathEl::MoveTo(point) => add(point, true),
        PathEl::LineTo(point) => add(point, false),
        _ => {}
    });
    for contour in &mut contours {
        if contour.len() > 1 && contour.first() == contour.last() {
            contour.pop();
        }
    }
    contours.retain(|contour| contour.len() > 2);
    contours
}
