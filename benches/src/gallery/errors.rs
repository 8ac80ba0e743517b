//! How far each library's coverage is from the area, shape by shape, whatever crosses and overlaps.
//!
//! Vertices are multiples of 1/256 pixel: between two such heights, a strip, there are edges and no vertex. In each
//! strip, the edges are sorted by where they cross its middle; those where the outline's inside starts or ends add their
//! exact area, in `f64`, as in [`exact`](crate::exact). That is the area of the shape, but for edges that cross each other
//! within a strip: they spoil what lies between them in a 256th of a pixel's height.

use crate::{
    drawing::PIXELS,
    drawings::{Drawing, Shape},
    exact::ExactArea,
    gallery::painters::Painter,
    picture::{Coverage, no_coverage},
    row::Difference,
    scenes::{FRAME_HEIGHT, FRAME_WIDTH},
};

/// Strips of a row.
const STRIPS: i32 = 256;

/// The error of each painter, in 255ths: the largest, and the mean over the pixels that are covered in part. `None` for
/// who has no coverage.
pub(super) fn errors(drawing: &Drawing, painters: &mut [&mut dyn Painter]) -> Vec<Option<Difference>> {
    let mut areas: Box<[f64; PIXELS]> = vec![0.0; PIXELS].try_into().expect("as many as asked for");
    let mut exact = ExactArea::new();
    let mut coverage = no_coverage();
    let mut errors = vec![Some(Difference::default()); painters.len()];
    let mut in_part = 0_u32;
    for (index, shape) in drawing.shapes.iter().enumerate() {
        add_shape(shape, &mut exact);
        exact.take(&mut areas);
        in_part += areas.iter().filter(|area| (1e-9..1.0 - 1e-9).contains(*area)).count() as u32;
        for (painter, error) in painters.iter_mut().zip(&mut errors) {
            *error = error
                .and_then(|error| painter.coverage(index, &mut coverage).then(|| worse(error, &coverage, &*areas)));
        }
    }
    let mean = |error: Difference| Difference { mean: error.mean / f64::from(in_part.max(1)), ..error };
    errors.into_iter().map(|error| error.map(mean)).collect()
}

/// The mean is still a sum.
fn worse(mut error: Difference, coverage: &Coverage, areas: &[f64]) -> Difference {
    for (coverage, area) in coverage.iter().zip(areas) {
        let off = (f64::from(*coverage) - 255.0 * area).abs();
        error.max = error.max.max(off);
        error.mean += off;
    }
    error
}

/// An edge from top to bottom.
struct Edge {
    /// On the frame.
    first_strip: i32,
    end_strip: i32,
    /// Where it enters the strip, in pixels.
    x: f64,
    /// How much further right it leaves it.
    step: f64,
    winding: i32,
}

impl Edge {
    fn new([x0, y0]: [i32; 2], [x1, y1]: [i32; 2]) -> Option<Self> {
        let ((top_x, top), (bottom_x, bottom), winding) =
            if y0 < y1 { ((x0, y0), (x1, y1), 1) } else { ((x1, y1), (x0, y0), -1) };
        let (first_strip, end_strip) = (top.max(0), bottom.min(FRAME_HEIGHT * STRIPS));
        let step = f64::from(bottom_x - top_x) / f64::from(bottom - top) / 256.0;
        let x = f64::from(top_x) / 256.0 + f64::from(first_strip - top) * step;
        (first_strip < end_strip).then_some(Self { first_strip, end_strip, x, step, winding })
    }

    fn middle(&self) -> f64 {
        self.x + self.step / 2.0
    }
}

fn add_shape(shape: &Shape, exact: &mut ExactArea) {
    let mut edges: Vec<Edge> = Vec::new();
    for contour in &shape.contours {
        let ends = contour.iter().cycle().skip(1);
        edges.extend(contour.iter().zip(ends).filter_map(|(&start, &end)| Edge::new(start, end)));
    }
    edges.sort_unstable_by_key(|edge| edge.first_strip);
    let Some(first) = edges.first().map(|edge| edge.first_strip) else { return };
    let last = edges.iter().map(|edge| edge.end_strip).max().unwrap_or(first);
    let mut waiting = edges.into_iter().peekable();
    let mut active: Vec<Edge> = Vec::new();
    for strip in first..last {
        active.retain(|edge| edge.end_strip > strip);
        while let Some(edge) = waiting.next_if(|edge| edge.first_strip == strip) {
            active.push(edge);
        }
        // In order but for a few: the sort is quick.
        active.sort_by(|one, other| one.middle().total_cmp(&other.middle()));
        let (mut winding, mut was_inside) = (0, false);
        for edge in &mut active {
            winding += edge.winding;
            let is_inside = if shape.even_odd { !was_inside } else { winding != 0 };
            if is_inside != was_inside {
                let sign = if is_inside { 1.0 } else { -1.0 };
                let on_frame = |x: f64| x.clamp(0.0, f64::from(FRAME_WIDTH));
                let sides = (on_frame(edge.x), on_frame(edge.x + edge.step));
                exact.part_of_a_row((strip / STRIPS) as usize, sign / f64::from(STRIPS), sides);
            }
            was_inside = is_inside;
            edge.x += edge.step;
        }
    }
}
