//! Traversal of the bounding box.
//!
//! Source: the lecture notes "Rasterization", "Bounding Box Traversal"; stepping from pixel to pixel after Pineda, *A
//! parallel algorithm for polygon rasterization*, SIGGRAPH 1988.

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, Edges, is_inside};

/// Executes the inside test for every pixel whose centre lies in the bounding box; values step.
///
/// # Errors
///
/// The sink's.
pub fn bounding_box<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let Some(edges) = Edges::new(v) else { return Ok(()) };
    let PixelRect { rows, columns } = exact::bounding_box(v, clip);
    let mut line = edges.at(columns.start, rows.start);
    for y in rows {
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
    Ok(())
}
