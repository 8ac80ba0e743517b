//! Traversal of every pixel of the screen: "simple (and naive)".
//!
//! Source: the lecture notes "Rasterization", "Triangle Traversal".

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{Edges, is_inside};

/// Executes the inside test for every pixel of the clip, each by itself.
///
/// # Errors
///
/// The sink's.
pub fn every_pixel<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let Some(edges) = Edges::new(v) else { return Ok(()) };
    for y in clip.rows.clone() {
        for x in clip.columns.clone() {
            sink.visit(x, y);
            if is_inside(edges.at(x, y)) {
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
    }
    Ok(())
}
