//! Shared edges: left edges and horizontal ones with the inside on the side of larger y own their pixels.
//!
//! Source: the lecture notes "Rasterization", "Tiebreaker rule", as printed:
//!
//! ```text
//! bool inside(e, x, y)
//!     if e(x, y) > 0 return true              y up:   a > 0 is a left edge,  a = 0, b > 0 a bottom one
//!     if e(x, y) < 0 return false             y down: a > 0 is a left edge,  a = 0, b > 0 a top one
//!     if a > 0 return true
//!     if a < 0 return false
//!     if a = 0 && b > 0 return true
//!     return false
//! ```
//!
//! On the two sides of an edge, a and b have opposite signs, so one of two neighbours has each pixel on it. With the
//! origin at the bottom left that is the notes' "left and bottom horizontal"; the same code with the origin at the top
//! left is the top-left rule of Direct3D and of this crate. Both are watertight; they differ by a row of pixels where
//! horizontal edges lie on centres, and by nothing else.

use crate::{Fragment, FragmentSink, PixelRect};

use super::exact::{self, PIXEL};

/// Where the origin is, and so which way y grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Bottom left of the clip, y up.
    Up,
    /// Top left, y down.
    Down,
}

/// `E(x, y) = a x + b y + c`, positive inside.
#[derive(Debug, Clone, Copy)]
struct Edge {
    a: i64,
    b: i64,
    c: i64,
}

impl Edge {
    #[inline(always)]
    fn inside(&self, x: i64, y: i64) -> bool {
        let Self { a, b, c } = *self;
        let e = a.wrapping_mul(x).wrapping_add(b.wrapping_mul(y)).wrapping_add(c);
        if e != 0 {
            return e > 0;
        }
        if a != 0 {
            return a > 0;
        }
        b > 0
    }
}

/// The vertices with y growing along `axis`: up from the row below the clip's last.
#[inline(always)]
pub fn along(axis: Axis, v: &[[i32; 2]; 3], clip: &PixelRect) -> [[i64; 2]; 3] {
    v.map(|[x, y]| [i64::from(x), flipped(axis, y.into(), clip)])
}

/// The centre of a pixel, likewise.
#[inline(always)]
pub fn centre_along(axis: Axis, x: i32, y: i32, clip: &PixelRect) -> [i64; 2] {
    [exact::centre(x), flipped(axis, exact::centre(y), clip)]
}

#[inline(always)]
fn flipped(axis: Axis, y: i64, clip: &PixelRect) -> i64 {
    match axis {
        Axis::Up => PIXEL * i64::from(clip.rows.end) - y,
        Axis::Down => y,
    }
}

/// Fills the triangle of three vertices in 1/256 px from the top left; with y up, they are turned over first.
///
/// # Errors
///
/// The sink's.
pub fn tie_break<S: FragmentSink>(
    v: &[[i32; 2]; 3],
    axis: Axis,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let p = along(axis, v, clip);
    let edge = |[p0x, p0y]: [i64; 2], [p1x, p1y]: [i64; 2]| Edge {
        a: -(p1y - p0y),
        b: p1x - p0x,
        c: p0x.wrapping_mul(p1y).wrapping_sub(p0y.wrapping_mul(p1x)),
    };
    let mut edges = [edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])];
    let area = edges.iter().fold(0_i64, |sum, edge| sum.wrapping_add(edge.c));
    if area == 0 {
        return Ok(());
    }
    if area < 0 {
        edges = edges.map(|Edge { a, b, c }| Edge { a: -a, b: -b, c: c.wrapping_neg() });
    }
    let PixelRect { rows, columns } = exact::bounding_box(v, clip);
    for y in rows {
        for x in columns.clone() {
            sink.visit(x, y);
            let [px, py] = centre_along(axis, x, y, clip);
            if edges.iter().all(|edge| edge.inside(px, py)) {
                sink.fragment(Fragment::pixel(x, y))?;
            }
        }
    }
    Ok(())
}
