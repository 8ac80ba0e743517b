//! Points in place of triangles: when a primitive is smaller than a pixel, its setup costs more than what it draws.
//!
//! ```text
//!     +-------+-------+
//!     | /\    |  ./|  |      a triangle of less than a pixel covers one centre or none: three vertices, three edges and
//!     |/__\ . |  /_|  |      a bounding box for at most one pixel, mostly for none; a point always draws one
//!     +-------+-------+
//! ```
//!
//! `tests/methods/points.txt` has a surface of 1024 pixels as a mesh that gets finer and finer. Triangles stay exact at any
//! size: with cells of a pixel each looks at one pixel in the mean, with cells of an eighth 131,072 of them at 2,492, and all
//! the rest is setup. As points, the mesh has holes where cells are larger than a pixel (half of all pixels at 2) and none
//! from there on; each pixel then comes as often as there are centroids in it, and some beyond the outline. In [`crossover`]
//! small triangles become points and large ones stay what they are, which is right as long as no neighbour is the other.
//!
//! `Math.Round` is one of two ways in which points are wrong. On a screen whose pixel centres lie at half integers, it
//! names the pixel that has the vertex near its top left corner: half a pixel off, right and down. On one with pixel
//! centres at integers, it goes to the even pixel from exactly between two: of vertices on a grid of half pixels, every
//! other pixel gets three and the next one.

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
