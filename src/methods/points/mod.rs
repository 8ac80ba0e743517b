//! Points in place of triangles: when a primitive is smaller than a pixel, its setup costs more than what it draws.
//!
//! ```text
//!     +-------+-------+
//!     | /\    |  ./|  |      a triangle of less than a pixel covers one centre or none: three vertices, three edges and
//!     |/__\ . |  /_|  |      a bounding box for at most one pixel, mostly for none; a point always draws one
//!     +-------+-------+
//! ```
//!
//! `tests/methods_points.rs` draws a surface as a mesh that gets finer and finer, and counts pixels looked at, missing and
//! drawn more than once: triangles stay exact at any size, and points have no holes from where their distance is less than
//! a pixel. In [`crossover`] small triangles become points, and large ones stay what they are.
//!
//! `Math.Round` is one of two ways in which points are wrong. On a screen whose pixel centres lie at half integers, it
//! names the pixel that has the vertex near its top left corner: half a pixel off, right and down. On one with pixel
//! centres at integers, it goes to the even pixel from exactly between two: of vertices on a grid of half pixels, every
//! other pixel gets two and the next none.

#![allow(clippy::cast_possible_truncation, reason = "casts from float saturate, NaN is 0")]

pub mod crossover;
pub mod mesh_points;
pub mod mesh_triangles;
pub mod vertex;

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        name: "vertex as a pixel",
        options: &["Math.Round", "floor"],
        source: "Scan converting triangles, CISC 440/640 lecture 13: Vertex2D.Draw",
    },
    Method {
        name: "triangles as points",
        options: &[""],
        source: "S. Rusinkiewicz, M. Levoy, QSplat, 2000; Scan converting triangles, 6.837 lecture 6: a post-triangle world",
    },
    Method { name: "triangles", options: &[""], source: "Scan converting triangles, CISC 440/640 lecture 13: FlatTri" },
    Method {
        name: "triangles against points",
        options: &["below 1/2 px", "below 1 px", "below 2 px"],
        source: "Scan converting triangles, 6.837 lecture 6: a post-triangle world",
    },
];
