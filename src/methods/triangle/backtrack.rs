//! Backtrack traversal: rows downwards, each started where the one above ended.
//!
//! Source: the lecture notes "Rasterization", "Backtrack traversal", after Akenine-Möller and Ström, *Graphics for the
//! masses*, SIGGRAPH 2003.
//!
//! ```text
//!        v                      each row: to the left until outside on the left, then to the right, drawing,
//!       #.                      until outside on the right; then down
//!    <.##.
//!   <.####.                     outside to the left:  outside of an edge with a > 0
//!  <.######.                    outside to the right: outside of an edge with a < 0
//! ```
//!
//! Never leaves the bounding box. A row whose pixels are outside on both sides at once is empty: to be inside, a pixel
//! would have to lie right of the first edge and left of the second, which already are in the other order there.

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, Edges, is_inside};

/// Whether a pixel is outside of an edge of the given side.
#[inline(always)]
fn is_outside(edges: &Edges, e: [i64; 3], side: impl Fn(i64) -> bool) -> bool {
    edges.0.iter().zip(e).any(|(edge, value)| value < 0 && side(edge.a))
}

/// Fills the triangle; attributes are worked out on the way to the right only.
///
/// # Errors
///
/// The sink's.
pub fn backtrack<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let Some(edges) = Edges::new(v) else { return Ok(()) };
    let PixelRect { rows, columns } = exact::bounding_box(v, clip);
    if columns.is_empty() {
        return Ok(());
    }
    let last = columns.end.saturating_sub(1);
    // The pixel of the topmost vertex.
    let [top_x, _] = v.iter().copied().min_by_key(|[_, y]| *y).unwrap_or_default();
    let mut x = (top_x >> 8).clamp(columns.start, last);
    let mut e = edges.at(x, rows.start);
    for y in rows {
        sink.visit(x, y);
        while x > columns.start && !is_outside(&edges, e, |a| a > 0) {
            x = x.saturating_sub(1);
            e = edges.moved(e, -1, 0);
            sink.visit(x, y);
        }
        loop {
            if is_inside(e) {
                sink.fragment(Fragment::pixel(x, y))?;
            }
            if x >= last || is_outside(&edges, e, |a| a < 0) {
                break;
            }
            x = x.saturating_add(1);
            e = edges.moved(e, 1, 0);
            sink.visit(x, y);
        }
        e = edges.moved(e, 0, 1);
    }
    Ok(())
}
