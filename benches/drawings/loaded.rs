//! Drawings in memory, for hosts.

use super::shapes;

/// Shapes, each drawn over those before it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Drawing {
    pub(crate) shapes: Vec<Shape>,
}

/// What is filled in one colour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Shape {
    pub(crate) rgb: [u8; 3],
    pub(crate) even_odd: bool,
    /// Closed, in 1/256 pixel.
    pub(crate) contours: Vec<Vec<[i32; 2]>>,
}

/// The drawing, one of [`DRAWINGS`](super::DRAWINGS), in memory.
pub(crate) fn load(drawing: &[u8]) -> Drawing {
    let shapes = shapes(drawing).map(|shape| Shape {
        rgb: shape.rgb,
        even_odd: shape.even_odd,
        contours: shape.contours.map(Iterator::collect).collect(),
    });
    Drawing { shapes: shapes.collect() }
}

impl Drawing {
    pub(crate) fn vertices(&self) -> usize {
        self.shapes.iter().flat_map(|shape| &shape.contours).map(Vec::len).sum()
    }

    /// The same drawing with so many edges in place of each, the vertices in between rounded to 1/256 pixel. Of an edge
    /// that is shorter than so many of these, there are only as many parts as differ.
    pub(crate) fn cut(&self, parts: i32) -> Self {
        let cut = |contour: &Vec<[i32; 2]>| {
            let edges = contour.iter().zip(contour.iter().cycle().skip(1));
            let vertices =
                edges.flat_map(|(&start, &end)| (0..parts).map(move |part| between(start, end, part, parts)));
            let mut vertices: Vec<[i32; 2]> = vertices.collect();
            vertices.dedup();
            while vertices.len() > 1 && vertices.first() == vertices.last() {
                vertices.pop();
            }
            vertices
        };
        let shapes = self.shapes.iter().map(|shape| Shape {
            rgb: shape.rgb,
            even_odd: shape.even_odd,
            contours: shape.contours.iter().map(cut).collect(),
        });
        Self { shapes: shapes.collect() }
    }
}

fn between(start: [i32; 2], end: [i32; 2], part: i32, parts: i32) -> [i32; 2] {
    let at = |start: i32, end: i32| start + ((end - start) * part + parts / 2).div_euclid(parts);
    [at(start[0], end[0]), at(start[1], end[1])]
}
