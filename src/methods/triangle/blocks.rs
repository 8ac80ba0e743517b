//! Blocks of 8 x 8 pixels: those outside are skipped, those inside are filled, the rest tested.
//!
//! Source: McCormack and McNamara, *Tiled polygon traversal using half-plane edge functions*, HWWS 2000; Pineda,
//! SIGGRAPH 1988, for the corners; what GPUs do.
//!
//! ```text
//! outside:  the corner that is best for some edge fails it      best = e + 7 * 256 * (max(a, 0) + max(b, 0))
//! inside:   the corner that is worst for each edge passes       worst = e + 7 * 256 * (min(a, 0) + min(b, 0))
//! ```

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, Edges, PIXEL, is_inside};

const SIDE: i32 = 8;

/// Fills the triangle in blocks that start at multiples of 8. A block that is looked at counts as one pixel looked at.
///
/// # Errors
///
/// The sink's.
pub fn blocks<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let Some(edges) = Edges::new(v) else { return Ok(()) };
    let area = exact::bounding_box(v, clip);
    if area.rows.is_empty() || area.columns.is_empty() {
        return Ok(());
    }
    let reach = i64::from(SIDE - 1) * PIXEL;
    let best = edges.0.map(|edge| (edge.a.max(0) + edge.b.max(0)).wrapping_mul(reach));
    let worst = edges.0.map(|edge| (edge.a.min(0) + edge.b.min(0)).wrapping_mul(reach));
    let is_beyond = |e: [i64; 3], corner: [i64; 3]| {
        let [e0, e1, e2] = e;
        let [c0, c1, c2] = corner;
        is_inside([e0.wrapping_add(c0), e1.wrapping_add(c1), e2.wrapping_add(c2)])
    };
    let mut top = area.rows.start & -SIDE;
    while top < area.rows.end {
        let rows = top.max(area.rows.start)..top.saturating_add(SIDE).min(area.rows.end);
        let mut left = area.columns.start & -SIDE;
        while left < area.columns.end {
            let columns = left.max(area.columns.start)..left.saturating_add(SIDE).min(area.columns.end);
            sink.visit(columns.start, rows.start);
            let first = edges.at(left, top);
            if is_beyond(first, worst) {
                for y in rows.clone() {
                    for x in columns.clone() {
                        sink.visit(x, y);
                        sink.fragment(Fragment::pixel(x, y))?;
                    }
                }
            } else if is_beyond(first, best) {
                let mut line = edges.at(columns.start, rows.start);
                for y in rows.clone() {
                    let mut e = line;
                    for x in columns.clone() {
                        sink.visit(x, y);
                        if is_inside(e) {
                            sink.fragment(Fragment::pixel(x, y))?;
                        }
                        e = edges.moved(e, 1, 0);
                    }
                    line = edges.moved(line, 0, 1);
                }
            }
            left = left.saturating_add(SIDE);
        }
        top = top.saturating_add(SIDE);
    }
    Ok(())
}
