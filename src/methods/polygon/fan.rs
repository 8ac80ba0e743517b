//! A convex polygon as a fan of triangles.
//!
//! As the lecture notes "Scan Converting Triangles" (6.837, lecture 6) have it: a convex polygon with the vertices
//! v0, v1, ..., vn around it is the triangles (v0, v1, v2), (v0, v2, v3), ..., (v0, vn-1, vn).
//!
//! ```text
//!      v0 ------ v1         Of one that is not convex, triangles leave the polygon and overlap:
//!      | \ `-.    \         what is between v0 and a notch is filled, some of it twice.
//!      |  \   `-.  \
//!      v4--v3----`-v2       Every diagonal is an edge of two triangles: without a rule for ties, a centre on it
//!                           is filled twice.
//! ```

use crate::{
    fragment::{Fragment, FragmentSink},
    geometry::PixelRect,
    methods::{
        Method,
        polygon::{Contours, Plane},
    },
    subpixel::first_centre_at_or_after,
};

/// How the method is charted.
pub const METHOD: Method = Method {
    name: "convex fan",
    options: &["top-left rule", "no tie rule"],
    source: "Lecture notes \"Scan Converting Triangles\", 6.837, lecture 6: decomposition of convex polygons",
};

/// Who has a centre that lies on an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ties {
    /// The triangle to its right, or below.
    TopLeft,
    /// Both triangles: three comparisons with `>= 0`.
    Both,
}

/// Fills each contour by the fan around its first vertex.
///
/// # Errors
///
/// The sink's.
///
/// # Cost
///
/// A triangle for each vertex but two; no scratch.
pub fn fill<S: FragmentSink>(
    contours: &(impl Contours<i32> + ?Sized),
    ties: Ties,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    for contour in 0..contours.contours() {
        let Some(first) = contours.vertex(contour, 0) else { continue };
        let mut second = None;
        for index in 1..contours.vertices(contour) {
            let Some(third) = contours.vertex(contour, index) else { break };
            if let Some(second) = second {
                let triangle = [first, second, third];
                match ties {
                    Ties::TopLeft => Plane::fill(triangle, clip, sink)?,
                    Ties::Both => fill_closed(triangle, clip, sink)?,
                }
            }
            second = Some(third);
        }
    }
    Ok(())
}

/// All centres of the bounding box that lie on no outer side of an edge. Products wrap beyond 2^31 in both directions.
fn fill_closed<S: FragmentSink>(vertices: [[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [a, b, c] = vertices.map(|vertex| vertex.map(i64::from));
    let edge = |from: [i64; 2], to: [i64; 2], p: [i64; 2]| {
        let (run, rise) = (to[0] - from[0], to[1] - from[1]);
        run.wrapping_mul(p[1] - from[1]).wrapping_sub(rise.wrapping_mul(p[0] - from[0]))
    };
    let area = edge(a, b, c);
    if area == 0 {
        return Ok(());
    }
    let sign = area.signum();
    let range = |axis: usize| {
        let coordinates = vertices.map(|vertex| vertex.get(axis).copied().unwrap_or(0));
        let [a, b, c] = coordinates;
        first_centre_at_or_after(a.min(b).min(c))..first_centre_at_or_after(a.max(b).max(c).saturating_add(1))
    };
    let (rows, columns) = (range(1), range(0));
    for y in rows.start.max(clip.rows.start)..rows.end.min(clip.rows.end) {
        for x in columns.start.max(clip.columns.start)..columns.end.min(clip.columns.end) {
            sink.visit(x, y);
            let p = [x, y].map(|pixel| i64::from(pixel) * 256 + 128);
            if [(a, b), (b, c), (c, a)].iter().all(|(from, to)| edge(*from, *to, p).wrapping_mul(sign) >= 0) {
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
    }
    Ok(())
}
