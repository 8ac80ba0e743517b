//! How much of each pixel of a row an outline covers, fast: in floats, and with a bound.
//!
//! A row is cut into slabs at all heights where an edge starts or ends or two of them cross. Within a slab the edges keep
//! their order, which is that of their middles. The area to the left of `u` and to the right of an edge that goes from `x0`
//! to `x1` over a slab of height `h` is the integral of `max(0, u - x)`:
//!
//! ```text
//!    0                                     u at or left of both ends
//!    h (u - min)^2 / (2 (max - min))       between them
//!    h (u - middle)                        right of both
//! ```
//!
//! Vertices are exact: 33 bits, relative to the window. A position is off by 2^-53 of how far its edge reaches, at most
//! 2^25 pixels; a crossing that is not where it should be, of edges that are almost parallel, swaps edges that are no
//! farther apart than that, as the error of its height and the distance between them have a factor in common. So areas
//! are off by a few times 2^-28. `tests` holds them against the exact oracle.

use spanfill::{FillRule, Vertex};

/// What areas may be off by, in pixels.
pub(crate) const ERROR: f64 = 1e-6;

/// A point in pixels, relative to the window's upper left corner.
type Point = (f64, f64);

#[derive(Debug, Clone, Copy)]
struct Edge {
    top: Point,
    bottom: Point,
    slope: f64,
    winding: i32,
}

impl Edge {
    fn x_at(&self, y: f64) -> f64 {
        if y >= self.bottom.1 { self.bottom.0 } else { self.top.0 + (y - self.top.1).max(0.0) * self.slope }
    }
}

/// The edges of an outline, and room to work in.
#[derive(Debug)]
pub(crate) struct Areas {
    edges: Vec<Edge>,
    mask: i32,
    /// Those in the current row, between two positions each.
    active: Vec<(Edge, f64, f64)>,
    heights: Vec<f64>,
    /// Of the edges of a slab: twice its middle, where it starts and ends, its winding.
    order: Vec<(f64, f64, f64, i32)>,
}

impl Areas {
    pub(crate) fn new(fill_rule: FillRule) -> Self {
        let mask = if fill_rule == FillRule::EvenOdd { 1 } else { !0 };
        Self { edges: Vec::new(), mask, active: Vec::new(), heights: Vec::new(), order: Vec::new() }
    }

    /// A vertex relative to the pixel in `column` and `row`.
    pub(crate) fn relative(vertex: Vertex, column: i32, row: i32) -> Point {
        let coordinate = |bits: i32, pixel: i32| (i64::from(bits) - 256 * i64::from(pixel)) as f64 / 256.0;
        (coordinate(vertex.x.to_bits(), column), coordinate(vertex.y.to_bits(), row))
    }

    pub(crate) fn add_contour(&mut self, points: impl Iterator<Item = Point> + Clone) {
        let following = points.clone().skip(1).chain(points.clone().take(1));
        for (a, b) in points.zip(following) {
            let (top, bottom, winding) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
            if top.1 < bottom.1 {
                self.edges.push(Edge { top, bottom, slope: (bottom.0 - top.0) / (bottom.1 - top.1), winding });
            }
        }
    }

    /// Of the pixels of a row, from column 0 on. Whether there is an edge in the row.
    pub(crate) fn row(&mut self, row: f64, areas: &mut [f64]) -> bool {
        let Self { edges, mask, active, heights, order } = self;
        let (row_end, width) = (row + 1.0, areas.len() as f64);
        areas.fill(0.0);
        active.clear();
        heights.clear();
        heights.extend([row, row_end]);
        for edge in edges.iter().filter(|edge| edge.top.1 < row_end && edge.bottom.1 > row) {
            let (x0, x1) = (edge.x_at(row), edge.x_at(row_end));
            let (least, most) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
            // What lies to the right of all does not matter.
            if least >= width {
                continue;
            }
            heights.extend([edge.top.1, edge.bottom.1].into_iter().filter(|y| row < *y && *y < row_end));
            for (other, other_least, other_most) in active.iter() {
                if most.max(*other_most) <= 0.0 || least > *other_most || most < *other_least {
                    continue;
                }
                let start = edge.top.1.max(other.top.1).max(row);
                let end = edge.bottom.1.min(other.bottom.1).min(row_end);
                // x + (y - top) slope of both; the slopes' difference as one quotient, so that it is exact where they are alike.
                let (dy, other_dy) = (edge.bottom.1 - edge.top.1, other.bottom.1 - other.top.1);
                let turn = (edge.bottom.0 - edge.top.0) * other_dy - (other.bottom.0 - other.top.0) * dy;
                if start < end && turn != 0.0 {
                    let apart = other.x_at(start) - edge.x_at(start);
                    let height = start + apart * dy / turn * other_dy;
                    if start < height && height < end {
                        heights.push(height);
                    }
                }
            }
            active.push((*edge, least, most));
        }
        if active.is_empty() {
            return false;
        }
        heights.sort_unstable_by(f64::total_cmp);
        for slab in heights.windows(2) {
            let (top, bottom) = (slab[0], slab[1]);
            let (height, middle) = (bottom - top, 0.5 * (top + bottom));
            if height <= 0.0 {
                continue;
            }
            order.clear();
            for (edge, ..) in active.iter().filter(|(edge, ..)| edge.top.1 <= middle && middle < edge.bottom.1) {
                let (x0, x1) = (edge.x_at(top), edge.x_at(bottom));
                order.push((x0 + x1, x0, x1, edge.winding));
            }
            order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
            let mut winding = 0;
            for (_, x0, x1, edge_winding) in order.iter() {
                let was_inside = winding & *mask != 0;
                winding += edge_winding;
                let is_inside = winding & *mask != 0;
                if was_inside != is_inside {
                    let height = if is_inside { height } else { -height };
                    add_right_of(areas, *x0, *x1, height);
                }
            }
        }
        true
    }
}

/// What lies to the right of an edge over a slab.
fn add_right_of(areas: &mut [f64], x0: f64, x1: f64, height: f64) {
    let (least, most) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
    let (half, middle) = (0.5 / (most - least), 0.5 * (x0 + x1));
    let to_the_left_of = |u: f64| match u {
        _ if u <= least => 0.0,
        _ if u >= most => u - middle,
        _ => (u - least) * (u - least) * half,
    };
    let mut before = to_the_left_of(0.0);
    for (area, u) in areas.iter_mut().zip(1..) {
        let after = to_the_left_of(f64::from(u));
        *area += height * (after - before);
        before = after;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        case::{Case, Figure, Size},
        oracle::{HasArea as _, Rng},
    };

    #[test]
    fn areas_are_those_of_the_exact_oracle() {
        let mut worst = 0.0_f64;
        let mut pixels = 0;
        for number in 0..20_000 {
            let mut rng = Rng::new(1, number);
            let bytes: Vec<u8> = (0..24).flat_map(|_| rng.bits().to_le_bytes()).collect();
            let case = Case::decode(&bytes, Size::Small);
            let Figure::Outline(outline) = &case.figure else { continue };
            let mut areas = Areas::new(outline.fill_rule);
            let (column, row) = (case.window.columns.start, case.window.rows.start);
            for contour in &outline.contours {
                areas.add_contour(contour.iter().map(|vertex| Areas::relative(*vertex, column, row)));
            }
            let mut found = vec![0.0; case.window.columns.len()];
            for row in case.window.rows.clone() {
                areas.row(f64::from(row - case.window.rows.start), &mut found);
                for (found, area) in found.iter().zip(outline.areas_in_row(row, &case.window.columns)) {
                    let error = (found - area.value).abs() - area.error;
                    assert!(error < ERROR, "{found}, not {area:?}, in row {row}:\n{}", case.code());
                    (worst, pixels) = (worst.max(error), pixels + usize::from(area.edges > 0));
                }
            }
        }
        assert!(pixels > 50_000 && worst < ERROR / 10.0, "off by {worst} in {pixels} pixels with an edge");
    }
}
