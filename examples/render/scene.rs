//! What is to be drawn, in the crate's own numbers: pixels and 1/256 of them.

use embedded_graphics::{
    geometry::Size,
    pixelcolor::{Gray8, Rgb888},
    primitives::Rectangle,
};
use spanfill::{FillRule, I24F8, Spread, Stop, Vertex};

/// Shapes in the order in which they are painted, for a display of a size.
#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) size: Size,
    pub(crate) items: Vec<Item>,
}

/// One shape in its paint.
#[derive(Debug)]
pub(crate) struct Item {
    pub(crate) outline: Outline,
    pub(crate) colours: Colours,
    /// Of 255; not 0.
    pub(crate) opacity: u8,
    /// No pixel outside of this rectangle is touched.
    pub(crate) clip: Rectangle,
}

/// One colour, or a gradient.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Colours {
    One(Rgb888),
    Gradient(Gradient),
}

/// One of the crate's gradients, owning its stops.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gradient {
    pub(crate) places: Places,
    pub(crate) spread: Spread,
    pub(crate) stops: Vec<Stop<Rgb888>>,
    /// How much of each stop is let through; none where all of it is.
    pub(crate) opacities: Option<Vec<Stop<Gray8>>>,
}

/// Where a gradient goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Places {
    Linear {
        start: Vertex,
        end: Vertex,
    },
    Radial {
        center: Vertex,
        ends: [Vertex; 2],
        focus: Vertex,
        /// In 1/65536 of the gradient.
        focal_radius: u32,
    },
}

/// One of the crate's shapes, owning its vertices.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Outline {
    Triangle([Vertex; 3]),
    Line([Vertex; 2]),
    Circle { center: Vertex, radius: I24F8 },
    Polygon { contours: Vec<Vec<Vertex>>, rule: FillRule },
}

impl Outline {
    /// The shape that fills these contours; none when there is no area to fill.
    pub(crate) fn filling(contours: Vec<Vec<Vertex>>, rule: FillRule) -> Option<Self> {
        match contours.as_slice() {
            [only] => match *only.as_slice() {
                // Three vertices, and the same when a fourth says that the outline returns to the first.
                [a, b, c] => return Some(Self::Triangle([a, b, c])),
                [a, b, c, d] if a == d => return Some(Self::Triangle([a, b, c])),
                _ if only.len() < 3 => return None,
                _ => {}
            },
            _ if contours.iter().all(|contour| contour.len() < 3) => return None,
            _ => {}
        }
        Some(Self::Polygon { contours, rule })
    }
}

/// How many shapes of each kind a scene has.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) triangles: usize,
    pub(crate) polygons: usize,
    pub(crate) circles: usize,
    pub(crate) lines: usize,
    /// Of the polygons alone.
    pub(crate) contours: usize,
    /// Of the polygons alone.
    pub(crate) vertices: usize,
}

impl Scene {
    pub(crate) fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        for item in &self.items {
            match &item.outline {
                Outline::Triangle(_) => counts.triangles += 1,
                Outline::Line(_) => counts.lines += 1,
                Outline::Circle { .. } => counts.circles += 1,
                Outline::Polygon { contours, .. } => {
                    counts.polygons += 1;
                    counts.contours += contours.len();
                    counts.vertices += contours.iter().map(Vec::len).sum::<usize>();
                }
            }
        }
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contour(points: &[(i32, i32)]) -> Vec<Vertex> {
        points.iter().map(|&(x, y)| Vertex::new(x, y)).collect()
    }

    #[test]
    fn three_vertices_are_a_triangle_closed_or_not() {
        let corners = [(0, 0), (8, 0), (0, 8)];
        let triangle = Some(Outline::Triangle(corners.map(|(x, y)| Vertex::new(x, y))));
        assert_eq!(Outline::filling(vec![contour(&corners)], FillRule::NonZero), triangle);
        let closed = contour(&[(0, 0), (8, 0), (0, 8), (0, 0)]);
        assert_eq!(Outline::filling(vec![closed], FillRule::EvenOdd), triangle);
    }

    #[test]
    fn other_contours_keep_every_vertex() {
        let contours = vec![contour(&[(0, 0), (8, 0), (8, 0), (0, 8)]), contour(&[(1, 1), (2, 2)])];
        let polygon = Outline::Polygon { contours: contours.clone(), rule: FillRule::EvenOdd };
        assert_eq!(Outline::filling(contours, FillRule::EvenOdd), Some(polygon));
    }

    #[test]
    fn contours_without_area_are_no_shape() {
        assert_eq!(Outline::filling(vec![], FillRule::NonZero), None);
        assert_eq!(Outline::filling(vec![contour(&[(0, 0), (8, 0)])], FillRule::NonZero), None);
        assert_eq!(Outline::filling(vec![contour(&[(0, 0), (8, 0)]), contour(&[(3, 3)])], FillRule::NonZero), None);
    }
}
