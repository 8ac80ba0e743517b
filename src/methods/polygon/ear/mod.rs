//! Any polygon as triangles, by cutting off ears.
//!
//! G. H. Meisters, "Polygons have ears", The American Mathematical Monthly 82, 1975: a simple polygon of more than
//! three vertices has two ears, corners whose triangle holds no other vertex. Cut one off, and what is left is a
//! simple polygon. Holes are first joined to the outline by a cut there and back (D. Eberly, "Triangulation by ear
//! clipping", 2002).
//!
//! The lecture notes (6.837, lecture 6) say of other polygons: "in some overlapping cases you have to introduce a new
//! vertex". Here is where:
//!
//! ```text
//!    a     d          a     d        Where a -> b crosses c -> d, both get a vertex x, and change partners:
//!     \   /            \   /         a -> x -> d and c -> x -> b. Directions stay, hence every winding
//!      \ /              \ /          number does. What was one contour is now two that touch and do not cross,
//!       x      ->       / \          and by the rule of the fill each is outline, hole, or neither.
//!      / \             /   \
//!     c   b           c     b
//! ```
//!
//! Then it is found which contour lies in which (`nest`), holes are joined to outlines (`bridge`), and ears are cut
//! off (`cut`). New vertices are rounded: the edges bend by half a unit, and a centre that lies so close to one of
//! them may change sides. Three edges that cross within a unit of each other may be left crossing; then an ear or two
//! may overlap another.

mod bridge;
mod cut;
mod meet;
mod nest;
mod rings;

pub use rings::Corner;

use crate::{
    fragment::FragmentSink,
    geometry::PixelRect,
    methods::{
        Method,
        polygon::{Contours, Failure, Plane},
    },
    shape::FillRule,
};
use rings::Rings;

/// How the method is charted.
pub const METHOD: Method = Method {
    name: "ear clipping",
    options: &["f32", "fixed"],
    source: "G. H. Meisters, \"Polygons have ears\", 1975; D. Eberly, \"Triangulation by ear clipping\", 2002",
};

/// Fills a polygon, in `f32` pixels or in 1/256 pixel.
///
/// # Errors
///
/// When there are fewer slots than vertices, those that are new included; the sink's.
///
/// # Cost
///
/// A slot a vertex, four for each crossing, and two for each contour. Every pair of edges is looked at, and for every
/// ear all vertices.
pub fn fill<T: Plane, S: FragmentSink>(
    contours: &(impl Contours<T> + ?Sized),
    rule: FillRule,
    clip: &PixelRect,
    slots: &mut [Corner<T>],
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    let available = slots.len();
    let vertices = (0..contours.contours()).map(|contour| contours.vertices(contour)).sum::<usize>();
    if vertices > available {
        return Err(Failure::TooLittleScratch { needed: vertices, available });
    }
    let mut rings = Rings::new(slots);
    rings.load(contours);
    let needed = vertices + meet::slots_for_meetings(&rings) + 2 * contours.contours();
    if needed > available {
        return Err(Failure::TooLittleScratch { needed, available });
    }
    meet::split_where_edges_meet(&mut rings);
    nest::find_roles(&mut rings, rule);
    bridge::join_holes(&mut rings);
    cut::cut_ears(&mut rings, clip, sink).map_err(Failure::Sink)
}
