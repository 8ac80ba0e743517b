//! A triangle given by its three edges in place of its three vertices.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT) and "CISC 440/640 Lecture 13"
//! (Delaware): "Triangles are determined by 3 points or 3 edges."
//!
//! ```text
//! A1 x + B1 y + C1 = 0      two edges meet where      x = (B1 C2 - B2 C1) / (A1 B2 - A2 B1)
//! A2 x + B2 y + C2 = 0                                y = (C1 A2 - C2 A1) / (A1 B2 - A2 B1)
//! ```
//!
//! Nine numbers in place of six, because an equation may be multiplied by anything: the edges are homogeneous. So
//! nothing is known of their orientation, which each gets from its sign at the vertex opposite; and the vertices have
//! to be found for that and for the box. Edges that are nearly parallel meet in rounded places.

use core::cmp::Ordering;

use crate::{FragmentSink, PixelRect};

use super::{
    super::number::{Number, Real},
    bounds::{centres, clipped},
    edge_equations::{Options, scan},
    equation::EdgeEqn,
};

/// `[A, B, C]` of `A x + B y + C = 0`.
pub type Edge<R> = [R; 3];

/// The edges of a triangle given by vertices, for those who have no others.
#[inline(always)]
pub fn edges_of<R: Real>(v: &[[R; 2]; 3]) -> [Edge<R>; 3] {
    [(v[0], v[1]), (v[1], v[2]), (v[2], v[0])]
        .map(|([x0, y0], [x1, y1])| [y0 - y1, x1 - x0, -R::HALF * ((y0 - y1) * (x0 + x1) + (x1 - x0) * (y0 + y1))])
}

/// Where two edges meet; not finite where they are parallel.
#[inline(always)]
fn meet<R: Real>([a1, b1, c1]: Edge<R>, [a2, b2, c2]: Edge<R>) -> [R; 2] {
    let determinant = a1 * b2 - a2 * b1;
    [(b1 * c2 - b2 * c1) / determinant, (c1 * a2 - c2 * a1) / determinant]
}

/// Fills what the three edges enclose. Each edge may have any factor, of any sign.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn three_edges<R: Real + Number, S: FragmentSink>(
    edges: &[Edge<R>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [e0, e1, e2] = *edges;
    let vertices = [meet(e1, e2), meet(e2, e0), meet(e0, e1)];
    let mut oriented = *edges;
    for ([a, b, c], [x, y]) in oriented.iter_mut().zip(vertices) {
        let sidedness = *a * x + *b * y + *c;
        match sidedness.partial_cmp(&R::ZERO) {
            Some(Ordering::Greater) => {}
            Some(Ordering::Less) => (*a, *b, *c) = (-*a, -*b, -*c),
            // NaN, too: parallel edges enclose nothing.
            _ => return Ok(()),
        }
    }
    let [[x0, y0], [x1, y1], [x2, y2]] = vertices;
    let extent = |a: R, b: R, c: R| centres(a.at_most(b).at_most(c), a.at_least(b).at_least(c));
    let area = PixelRect {
        rows: clipped(extent(y0, y1, y2), &clip.rows),
        columns: clipped(extent(x0, x1, x2), &clip.columns),
    };
    scan(&oriented.map(EdgeEqn::from_coefficients), Options::USUAL, &area, sink)
}
