//! Recursive subdivision of the screen.
//!
//! Source: Warnock, *A hidden surface algorithm for computer generated halftone pictures*, University of Utah TR 4-15,
//! 1969; named in the lecture notes "6.837 Lecture 6" and "CISC 440/640 Lecture 13".
//!
//! ```text
//! +---+---+    A window is done when the triangle does not meet it, when the triangle surrounds it, and when it is a
//! |   | /#|    pixel, whose centre is sampled. Any other is cut in four.
//! +---+-+-+
//! |  /|#|#|    outside:  the corner that is best for some edge fails it
//! | / |#|#|    surrounded: the corner that is worst for each edge passes
//! +---+-+-+
//! ```
//!
//! Windows are `2^k` pixels wide, so that from the value at the first pixel the best and the worst corner are a
//! constant of edge and level away, `(2^k - 1) * 256` times the positive or negative parts of a and b. The cost goes
//! with the outline's length in pixels. Warnock's second way to be done, a window met by one polygon only, hands that
//! to an ordinary scan converter, and would leave nothing to do here.

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, Edge, Edges, PIXEL};

/// A window of `2^level` pixels; it may reach beyond the coordinates that `i32` has.
#[derive(Debug, Clone, Copy)]
struct Window {
    x: i64,
    y: i64,
    level: u32,
}

/// Fills the triangle. A window that is looked at counts as one pixel looked at.
///
/// # Errors
///
/// The sink's.
pub fn warnock<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let Some(edges) = Edges::new(v) else { return Ok(()) };
    let PixelRect { rows, columns } = clip.clone();
    if rows.is_empty() || columns.is_empty() {
        return Ok(());
    }
    let side = columns.end.abs_diff(columns.start).max(rows.end.abs_diff(rows.start));
    // 32 at most: the smallest power of two at or above `side`.
    let level = u32::BITS - (side - 1).leading_zeros();
    let window = Window { x: columns.start.into(), y: rows.start.into(), level };
    let e = edges.at(columns.start, rows.start);
    subdivide(&edges, window, e, clip, sink)
}

fn subdivide<S: FragmentSink>(
    edges: &Edges,
    window: Window,
    e: [i64; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Window { x, y, level } = window;
    let size = 1_i64 << level;
    let (left, right) = (x.max(clip.columns.start.into()), (x + size).min(clip.columns.end.into()));
    let (top, bottom) = (y.max(clip.rows.start.into()), (y + size).min(clip.rows.end.into()));
    if left >= right || top >= bottom {
        return Ok(());
    }
    let [left, right, top, bottom] = [left, right, top, bottom].map(narrow);
    sink.visit(left, top);
    let reach = (size - 1) * PIXEL;
    let at = |edge: &Edge, value: i64, part: fn(i64) -> i64| {
        value.wrapping_add(part(edge.a).wrapping_add(part(edge.b)).wrapping_mul(reach))
    };
    let mut corners = edges.0.iter().zip(e);
    if corners.clone().any(|(edge, value)| at(edge, value, |step| step.max(0)) < 0) {
        return Ok(());
    }
    if corners.all(|(edge, value)| at(edge, value, |step| step.min(0)) >= 0) {
        for y in top..bottom {
            for x in left..right {
                sink.visit(x, y);
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
        return Ok(());
    }
    // A pixel has one corner, which is the best and the worst: only sums that wrapped come here.
    let Some(level) = level.checked_sub(1) else { return Ok(()) };
    let half = 1_i64 << level;
    for (dx, dy) in [(0, 0), (half, 0), (0, half), (half, half)] {
        subdivide(edges, Window { x: x + dx, y: y + dy, level }, edges.moved(e, dx, dy), clip, sink)?;
    }
    Ok(())
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "cut to a clip of i32")]
fn narrow(pixel: i64) -> i32 {
    pixel as i32
}

/// The windows that the traversal starts from hold the bounding box only: Warnock's own start is the screen.
///
/// # Errors
///
/// The sink's.
pub fn warnock_in_box<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    warnock(v, &exact::bounding_box(v, clip), sink)
}
