//! Attributes: what varies across a triangle.
//!
//! Vertices are in pixels, y downwards; attributes are whole numbers of any unit, and what is drawn is in the same.
//! Pixels are those whose centres all three edge equations say `>= 0` of.

pub mod affine_pieces;
pub mod average;
pub mod depth;
pub mod gouraud_barycentric;
pub mod gouraud_edge_walk;
pub mod gouraud_fixed;
pub mod gouraud_planes;
pub mod perspective;
pub mod perspective_weights;
pub mod plane;

use crate::methods::{Method, number::Real};

/// A vertex with what it brings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner<R, const N: usize> {
    /// Pixels to the right of the left edge of column 0.
    pub x: R,
    /// Pixels below the top edge of row 0.
    pub y: R,
    /// The homogeneous coordinate, in any unit, above 0: 1 throughout where there is no perspective.
    pub w: R,
    /// The depth, 0 in front.
    pub depth: u16,
    /// Colour channels, texture coordinates.
    pub attributes: [i32; N],
}

/// Each attribute's values at the three vertices.
#[inline(always)]
pub(crate) fn channels<R: Real, const N: usize>([p0, p1, p2]: &[Corner<R, N>; 3]) -> [[R; 3]; N] {
    channels_of(&p0.attributes, &p1.attributes, &p2.attributes).map(|channel| channel.map(R::from_integer))
}

/// The same of attributes alone.
#[inline(always)]
pub(crate) fn channels_of<const N: usize>(s0: &[i32; N], s1: &[i32; N], s2: &[i32; N]) -> [[i32; 3]; N] {
    let mut channels = [[0; 3]; N];
    for (channel, ((s0, s1), s2)) in channels.iter_mut().zip(s0.iter().zip(s1).zip(s2)) {
        *channel = [*s0, *s1, *s2];
    }
    channels
}

const LECTURE_6: &str = "MIT, 6.837 Lecture 6: Scan Converting Triangles";

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method { name: "average", options: &[""], source: LECTURE_6 },
    Method {
        name: "Gouraud, plane equations",
        options: &["f64", "f32", "F = 12", "F = 12, half added", "F = 12, half added, as printed"],
        source: "Gouraud, Continuous shading of curved surfaces, 1971; MIT, 6.837 Lecture 6; Delaware, CISC 440/640 Lecture 13",
    },
    Method {
        name: "Gouraud, barycentric",
        options: &["f64", "f32"],
        source: "Triangles: barycentric coordinates (lecture notes); Rasterization (lecture notes)",
    },
    Method {
        name: "Gouraud, edge walking",
        options: &["fractional offsets", "without offsets"],
        source: "Gouraud 1971; MIT, 6.837 Lecture 6",
    },
    Method {
        name: "perspective",
        options: &["s/w and 1/w, f64", "s/w and 1/w, f32", "f = e/w", "affine", "affine pieces of 16 px"],
        source: "Heckbert and Moreton 1991; Blinn, Hyperbolic interpolation, 1992; Rasterization (lecture notes); Hecker 1995",
    },
    Method { name: "depth", options: &["f64", "F = 12"], source: "Rasterization (lecture notes)" },
    Method {
        name: "spanfill",
        options: &["flat", "gouraud", "perspective", "perspective, divided at each pixel", "depth"],
        source: "spanfill::Triangle, by Shape::spans; spanfill::Affine and spanfill::Perspective, by Attributes",
    },
];
