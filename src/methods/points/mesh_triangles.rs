//! Each triangle as a triangle: three edge equations over its bounding box, by integers, with the top-left rule.
//!
//! A pixel's centre is `A x + B y + C` from an edge, `A = y0 - y1`, `B = x1 - x0`; one that lies on the edge belongs to the
//! triangle to its right, or below. A step of one pixel adds `256 A` or `256 B`. No span is left early: in triangles as
//! small as these there is nothing to leave.

use crate::{Fragment, FragmentSink, PixelRect, Vertex};

/// An edge equation and its value at the first centre of a row.
#[derive(Debug, Clone, Copy)]
struct Edge {
    a: i128,
    b: i128,
    row: i128,
}

impl Edge {
    /// Of the edge from `v0` to `v1`, positive within, at the centre `at`.
    fn new(v0: [i64; 2], v1: [i64; 2], at: [i64; 2], sign: i128) -> Self {
        let (a, b) = (i128::from(v0[1] - v1[1]) * sign, i128::from(v1[0] - v0[0]) * sign);
        // What lies on a left or an upper edge is inside: 0 counts as positive.
        let is_inclusive = a > 0 || (a == 0 && b > 0);
        let row = a * i128::from(at[0] - v0[0]) + b * i128::from(at[1] - v0[1]);
        Self { a, b, row: row - i128::from(!is_inclusive) }
    }
}

/// Draws a triangle.
///
/// # Errors
///
/// The sink's.
pub fn draw<S: FragmentSink>(triangle: &[Vertex; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [v0, v1, v2] = triangle.map(|v| [i64::from(v.x.to_bits()), i64::from(v.y.to_bits())]);
    let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
    let area = product(v1[0] - v0[0], v2[1] - v0[1]) - product(v1[1] - v0[1], v2[0] - v0[0]);
    if area == 0 {
        return Ok(());
    }
    let sign = area.signum();
    // The centres between the smallest and the largest coordinate.
    let range = |at: usize, clip: &core::ops::Range<i32>| {
        let coordinates = [v0, v1, v2].map(|v| v.get(at).copied().unwrap_or(0));
        let low = coordinates.iter().copied().fold(i64::MAX, i64::min);
        let high = coordinates.iter().copied().fold(i64::MIN, i64::max);
        (((low + 127) >> 8) as i32).max(clip.start)..(((high - 128) >> 8) as i32 + 1).min(clip.end)
    };
    let (columns, rows) = (range(0, &clip.columns), range(1, &clip.rows));
    let at = [columns.start, rows.start].map(|pixel| 256 * i64::from(pixel) + 128);
    let mut edges = [(v0, v1), (v1, v2), (v2, v0)].map(|(from, to)| Edge::new(from, to, at, sign));
    for row in rows {
        let mut values = edges.map(|edge| edge.row);
        for column in columns.clone() {
            sink.visit(column, row);
            if values.iter().all(|value| *value >= 0) {
                sink.fragment(Fragment::pixel(column, row))?;
            }
            for (value, edge) in values.iter_mut().zip(&edges) {
                *value += 256 * edge.a;
            }
        }
        for edge in &mut edges {
            edge.row += 256 * edge.b;
        }
    }
    Ok(())
}
