//! Shared edges: the pixels on an edge belong to the triangle on the side of a point off the screen.
//!
//! Source: the lecture notes "Triangles" (barycentric coordinates), "dealing with shared triangle edges", after
//! Shirley, *Fundamentals of Computer Graphics*, who takes r = (-1, -1):
//!
//! ```text
//! if alpha >= 0 and beta >= 0 and gamma >= 0
//!   if (alpha > 0 or f_bc(a) f_bc(r) > 0) and
//!      (beta  > 0 or f_ca(b) f_ca(r) > 0) and
//!      (gamma > 0 or f_ab(c) f_ab(r) > 0) draw
//! ```
//!
//! Of the two triangles at an edge, one has its third vertex on r's side. Not so where r lies on the edge's own line:
//! `f(r) = 0`, neither draws, and the edge is a crack. From (-1, -1) that happens to a diagonal of slope 1 through
//! pixel corners, to any line that aims there. r may not be seen, but lines through it are. A second point, tried
//! where the first says 0, mends all lines but the one through both.

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    exact,
    tie_break::{Axis, along, centre_along},
};

/// Fills the triangle of three vertices in 1/256 px from the top left. `points` are in pixels from the origin of the
/// `axis`; each is tried where those before lie on the edge's line.
///
/// # Errors
///
/// The sink's.
pub fn reference_point<S: FragmentSink>(
    v: &[[i32; 2]; 3],
    axis: Axis,
    points: &[[f64; 2]],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let pixels = |[x, y]: [i64; 2]| [x, y].map(pixels);
    let [a, b, c] = along(axis, v, clip).map(pixels);
    let (f_bc, f_ca, f_ab) = (line(b, c), line(c, a), line(a, b));
    // Whether the pixels on an edge are the triangle's, which all of them are or none.
    let owns = |f: &dyn Fn([f64; 2]) -> f64, third: [f64; 2]| {
        let side = points.iter().map(|r| f(third) * f(*r)).find(|product| *product != 0.0);
        side.is_some_and(|product| product > 0.0)
    };
    let (at_a, at_b, at_c) = (f_bc(a), f_ca(b), f_ab(c));
    let (owns_bc, owns_ca, owns_ab) = (owns(&f_bc, a), owns(&f_ca, b), owns(&f_ab, c));
    let PixelRect { rows, columns } = exact::bounding_box(v, clip);
    for x in columns {
        for y in rows.clone() {
            sink.visit(x, y);
            let p = pixels(centre_along(axis, x, y, clip));
            let (alpha, beta, gamma) = (f_bc(p) / at_a, f_ca(p) / at_b, f_ab(p) / at_c);
            if alpha >= 0.0
                && beta >= 0.0
                && gamma >= 0.0
                && (alpha > 0.0 || owns_bc)
                && (beta > 0.0 || owns_ca)
                && (gamma > 0.0 || owns_ab)
            {
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
    }
    Ok(())
}

/// `f_ab(x, y) = (ya - yb) x + (xb - xa) y + xa yb - xb ya`: exact in doubles for coordinates of up to 2^18 px.
#[inline(always)]
fn line([xa, ya]: [f64; 2], [xb, yb]: [f64; 2]) -> impl Fn([f64; 2]) -> f64 {
    move |[x, y]| (ya - yb) * x + (xb - xa) * y + xa * yb - xb * ya
}

#[inline(always)]
#[allow(clippy::cast_precision_loss, reason = "coordinates of some 41 bits")]
fn pixels(subpixels: i64) -> f64 {
    subpixels as f64 / 256.0
}
