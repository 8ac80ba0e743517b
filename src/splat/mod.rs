//! Points in place of triangles: a hierarchy of spheres, refined until a sphere is as small as a pixel.
//!
//! S. Rusinkiewicz and M. Levoy, "QSplat: a multiresolution point rendering system for large meshes", 2000. A model is a
//! tree of bounding spheres. Drawing starts at its root and goes down: what is out of sight or turned away is left
//! out with everything below it, what is smaller than a threshold is drawn as a *splat*, a square of its size, in its
//! colour. So a model of millions of points costs what the screen shows of it.
//!
//! ```text
//!    bytes -> nodes, from the root down -> spheres in the view -> splats, by depth -> target
//! ```
//!
//! # Format
//!
//! All numbers are little-endian. A header of 34 bytes: `SPL1`, the number of nodes (4), the root's centre (3 times 4) and
//! radius (4), the root's node (6), the offset of its children's group (4). Then groups, breadth first. A group is the
//! nodes of up to four siblings, and, where any of them has children, the offset (4) of the first of their groups; the
//! others follow it. Every offset leads forwards, so that nothing can go in a circle.
//!
//! A node has 48 bits:
//!
//! | bits | what |
//! |--:|---|
//! | 13 | centre and radius, in 13ths of the parent's: see [`Sphere::child`] |
//! | 2 | children: 0, 2, 3 or 4 |
//! | 1 | whether any of them has children |
//! | 14 | normal, one of 52 x 52 on each side of a cube: see [`normal`] |
//! | 2 | normal cone: its half-angle's sine is 1/16, 4/16, 9/16 or 1 |
//! | 16 | colour, 5-6-5 |
//!
//! What builds a model is in the crate's `examples/splats`.

mod draw;
mod model;
mod normals;
mod sphere;
mod view;

pub use draw::{Refinement, Splat, SplatSink, Squares};
pub use model::{BrokenModel, Model, Node};
pub use normals::{CONE_SINES, NORMAL_CODES, normal};
pub use sphere::{SPHERE_CODES, Sphere};
pub use view::{NoView, View};
