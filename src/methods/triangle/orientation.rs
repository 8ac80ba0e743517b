//! Which side of each edge is the inside.
//!
//! Source: by area "6.837 Lecture 6: Scan Converting Triangles" (MIT); by the third vertex the lecture notes "Triangle
//! Rasterization", slides 17-21 (Purdue).
//!
//! The three C's are twice the signed areas of the triangles that the origin forms with the edges; their sum is twice
//! the signed area of the whole. Where it is positive, all three equations are positive inside. The sum cancels where
//! the triangle is small and far away: in floats by what each C was rounded by, in `F` fraction bits where twice the
//! area is below `3 / 2^F`. It may then be 0 or have the wrong sign, and nothing is drawn.

use super::{
    super::number::{Number, Real},
    equation::EdgeEqn,
};

/// How the edges learn which of their sides is inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Orientation {
    /// By the sum of the C's, twice the signed area.
    SumOfCs,
    /// By `(x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)`, twice the signed area.
    Area,
    /// Each by its sign at the vertex that is not its own: `e(x2, y2) < 0` flips it.
    ThirdVertex,
}

/// Flips edges so that the inside is positive. Says whether there is any, as far as the method can tell.
#[inline(always)]
pub fn orient<N: Number>(edges: &mut [EdgeEqn<N>; 3], v: &[[N::Setup; 2]; 3], orientation: Orientation) -> bool {
    let [[x0, y0], [x1, y1], [x2, y2]] = *v;
    let area = match orientation {
        Orientation::SumOfCs => {
            let [e0, e1, e2] = edges;
            e0.c.plus(e1.c).plus(e2.c)
        }
        Orientation::Area => N::from_setup((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)),
        Orientation::ThirdVertex => {
            for (edge, [x, y]) in edges.iter_mut().zip([v[2], v[0], v[1]]) {
                if third_vertex_is_outside(edge, x, y) {
                    edge.flip();
                }
            }
            return true;
        }
    };
    if area.is_negative() {
        edges.iter_mut().for_each(EdgeEqn::flip);
    }
    area.is_negative() || area.is_positive()
}

/// `sidedness = a x + b y + c < 0`, which for integers has to be worked out in the setup's numbers.
#[inline(always)]
fn third_vertex_is_outside<N: Number>(edge: &EdgeEqn<N>, x: N::Setup, y: N::Setup) -> bool {
    edge.sidedness(x, y) < N::Setup::ZERO
}
