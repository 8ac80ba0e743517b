//! Shared edges without a rule: `>= 0` draws the pixels on an edge twice, `> 0` never.
//!
//! Source: the lecture notes "Rasterization", "Shared edges", which set a pixel where all three edge equations are `> 0`
//! on one slide and where they are `>= 0` on another. "6.837 Lecture 6" says "positive" in its text and has `>= 0` in
//! its code.

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, Edge};

/// What a value of 0 is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// Inside: neighbours overlap.
    Included,
    /// Outside: neighbours leave a crack.
    Excluded,
}

/// Fills the triangle.
///
/// # Errors
///
/// The sink's.
pub fn untied<S: FragmentSink>(
    v: &[[i32; 2]; 3],
    boundary: Boundary,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(edges) = exact::Edges::new(v) else { return Ok(()) };
    let PixelRect { rows, columns } = exact::bounding_box(v, clip);
    let has = |edge: &Edge, x: i32, y: i32| match boundary {
        Boundary::Included => edge.undecided_at(x, y) >= 0,
        Boundary::Excluded => edge.undecided_at(x, y) > 0,
    };
    for y in rows {
        for x in columns.clone() {
            sink.visit(x, y);
            if edges.0.iter().all(|edge| has(edge, x, y)) {
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
    }
    Ok(())
}
