//! Polygons: by scan lines, by triangles, and by seeds.
//!
//! | module | |
//! |---|---|
//! | [`scan_line`] | the edge table and the active edge table, in three arithmetics |
//! | [`fan`] | a convex polygon is triangles around its first vertex |
//! | [`ear`] | any polygon is triangles, once it has a vertex wherever it crosses itself |
//! | [`seed`] | draw the outline, then grow from a pixel inside |

mod contours;
pub mod ear;
pub mod fan;
mod half_plane;
pub mod scan_line;
pub mod seed;

pub use contours::{Contours, Failure};
pub use half_plane::Plane;

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] =
    &[scan_line::METHOD, fan::METHOD, ear::METHOD, seed::PIXELS, seed::SPANS, seed::RESCAN, seed::WALK];
