//! Triangles: which pixels are inside, in which order they are looked at, and who draws those of a shared edge.
//!
//! Vertices are in pixels where a method works with floats, y downwards, pixel centres at half integers; in integers
//! of 1/256 px, or with the method's own fraction bits, elsewhere. No vertex, of whatever value, makes a method panic,
//! run on, or leave its clip; what it draws then may be wrong, and `tests/methods_triangle.rs` says how often.

pub mod backtrack;
pub mod barycentric;
pub mod blocks;
pub mod bounding_box;
pub mod bounds;
pub mod dda_exact;
pub mod dda_fixed;
pub mod dda_float;
pub mod edge_equations;
pub mod edge_walk;
pub mod equation;
pub mod every_pixel;
pub mod exact;
pub mod micropolygons;
pub mod midpoint_outline;
pub mod orientation;
pub mod printed;
pub mod reference_point;
pub mod snapped;
pub mod three_edges;
pub mod tie_break;
pub mod untied;
pub mod warnock;

use crate::methods::Method;

/// Why a method did not draw all of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Failure<E> {
    /// The table that finds the bounding box by signs has no such entry; nothing was drawn. See [`bounds`].
    NoEntry {
        /// What was looked up: 6 where all coordinates are as good as equal.
        index: i32,
    },
    /// Longer than a method can take that has work to do for its length squared; nothing was drawn. See
    /// [`micropolygons`].
    TooLong,
    /// The sink's.
    Sink(E),
}

impl<E> From<E> for Failure<E> {
    #[inline(always)]
    fn from(error: E) -> Self {
        Self::Sink(error)
    }
}

const LECTURE_6: &str = "MIT, 6.837 Lecture 6: Scan Converting Triangles";
const BARYCENTRIC: &str =
    "Triangles: barycentric coordinates (lecture notes), after Shirley, Fundamentals of Computer Graphics";
const RASTERIZATION: &str = "Rasterization (lecture notes), after Akenine-Möller and Hasselgren";
const SHIPPED: Method =
    Method { name: "spanfill", options: &["shipped"], source: "spanfill::Triangle, by Shape::spans" };

/// Which pixels are inside.
pub const INSIDE: &[Method] = &[
    Method {
        name: "midpoint outline, filled",
        options: &[""],
        source: "Bresenham, Algorithm for computer control of a digital plotter, 1965; Pitteway 1967; Triangles (lecture notes)",
    },
    Method {
        name: "barycentric",
        options: &[
            "every pixel, rows first",
            "every pixel, columns first",
            "bounding box",
            "bounding box, f64",
            "incremental",
            "without upper bounds",
            "beta + gamma <= 1",
        ],
        source: BARYCENTRIC,
    },
    Method { name: "given by", options: &["three vertices", "three edges"], source: LECTURE_6 },
    Method {
        name: "edge equations",
        options: &[
            "f32",
            "f64",
            "F = 4, 32 bits",
            "F = 8, 32 bits",
            "F = 12, 32 bits",
            "F = 16, 32 bits",
            "F = 4, 64 bits",
            "F = 8, 64 bits",
            "F = 12, 64 bits",
            "F = 16, 64 bits",
        ],
        source: "Pineda, A parallel algorithm for polygon rasterization, 1988; MIT, 6.837 Lecture 6",
    },
    Method {
        name: "edge functions, snapped",
        options: &[
            "F = 4, 32 bits",
            "F = 8, 32 bits",
            "F = 12, 32 bits",
            "F = 16, 32 bits",
            "F = 4, 64 bits",
            "F = 8, 64 bits",
            "F = 12, 64 bits",
            "F = 16, 64 bits",
        ],
        source: "Pineda 1988; Giesen, Triangle rasterization in practice, 2013",
    },
    Method {
        name: "constant C",
        options: &[
            "cross product",
            "one vertex",
            "averaged",
            "differences",
            "differences, stepped",
            "cross product, at each pixel",
            "averaged, at each pixel",
        ],
        source: LECTURE_6,
    },
    Method { name: "area", options: &["sum of the C's", "cross product"], source: LECTURE_6 },
    Method {
        name: "orientation",
        options: &["signed area", "third vertex", "signed area, F = 12", "third vertex, F = 12"],
        source: "MIT, 6.837 Lecture 6; Purdue, Triangle Rasterization",
    },
    Method {
        name: "bounding box",
        options: &[
            "centres",
            "(int) min to (int) (max + 1)",
            "(int) (min + .5) to (int) (max - .5)",
            "six-entry table",
            "six-entry table, F = 12",
        ],
        source: "MIT, 6.837 Lecture 6; Purdue, Triangle Rasterization",
    },
    Method {
        name: "samples",
        options: &["integer coordinates", "centres"],
        source: "MIT, 6.837 Lecture 6; Rasterization (lecture notes)",
    },
    Method { name: "sign test", options: &["three comparisons", "OR of the signs"], source: LECTURE_6 },
    Method { name: "row", options: &["whole", "early-out"], source: LECTURE_6 },
    Method {
        name: "as printed",
        options: &["FlatTri, Java", "FlatTri, C#", "guidelines, C"],
        source: "MIT, 6.837 Lecture 6; Delaware, CISC 440/640 Lecture 13, 2015; Purdue, Triangle Rasterization",
    },
    SHIPPED,
];

/// In which order pixels are looked at.
pub const TRAVERSAL: &[Method] = &[
    Method { name: "every pixel", options: &[""], source: RASTERIZATION },
    Method { name: "bounding box", options: &[""], source: RASTERIZATION },
    Method {
        name: "backtrack",
        options: &[""],
        source: "Akenine-Möller and Ström, Graphics for the masses, 2003; Rasterization (lecture notes)",
    },
    Method {
        name: "edge walking",
        options: &[
            "f32 DDA, ceiling and floor",
            "f32 DDA, half open",
            "f64 DDA, half open",
            "fixed DDA, F = 8, half open",
            "fixed DDA, F = 12, half open",
            "fixed DDA, F = 16, ceiling and floor",
            "fixed DDA, F = 16, half open",
            "exact remainder, ceiling and floor",
            "exact remainder, half open",
        ],
        source: "MIT, 6.837 Lecture 6; Hecker, Perspective texture mapping, 1995",
    },
    Method {
        name: "Warnock",
        options: &["whole screen", "bounding box"],
        source: "Warnock, A hidden surface algorithm for computer generated halftone pictures, 1969",
    },
    Method {
        name: "micropolygons",
        options: &["middles to 1/256 px", "middles exact"],
        source: "Cook, Carpenter and Catmull, The Reyes image rendering architecture, 1987",
    },
    Method {
        name: "8 x 8 blocks",
        options: &[""],
        source: "McCormack and McNamara, Tiled polygon traversal using half-plane edge functions, 2000",
    },
    SHIPPED,
];

/// Who draws the pixels of a shared edge.
pub const SHARED: &[Method] = &[
    Method { name: "none", options: &[">= 0", "> 0"], source: RASTERIZATION },
    Method { name: "tie-break", options: &["left and bottom, y up", "left and top, y down"], source: RASTERIZATION },
    Method {
        name: "reference point",
        options: &[
            "(-1, -1), y up",
            "(-1, -1), y down",
            "on an edge's line, y up",
            "on an edge's line, y down",
            "on an edge's line, then a second, y up",
            "on an edge's line, then a second, y down",
        ],
        source: BARYCENTRIC,
    },
    SHIPPED,
];
