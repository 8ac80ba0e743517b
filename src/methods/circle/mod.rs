//! Circles around a whole pixel with a radius of whole pixels, as they were published: outlines, and filled.
//!
//! ```text
//!     . . # # # . .       y = sqrt(r^2 - x^2), and what is known of one octant
//!     . #       # .       is known of all:
//!     #           #         (x, y) (y, x) (-x, y) (-y, x) (x, -y) (y, -x) (-x, -y) (-y, -x)
//!     #     +     #
//! ```
//!
//! An outline is right where it has, in each column of the octant 0 <= x <= y, the pixel nearest to the true circle; two
//! pixels are never equally near. A filled circle is right where it ends with those pixels. The crate's circle of radius
//! `r + 1/2` is the nearest that a test of distances has to it, and differs from it in a few pixels.
//!
//! What only looks wrong, and what is; `tests/methods/circle.txt` has the counts for radii of 0 to 100, which have 28,565
//! pixels in their outlines:
//!
//! - **`d = 5 / 4 - r` in integers**, which is `1 - r`, is right: all that is added to `d` is whole, so that the quarter
//!   that is lost never decides its sign. No pixel differs from that of `5/4 - r`, at any radius.
//! - **`y = (int) sqrt(..)`** cuts off: the pixel inside of the circle in place of the nearest one, in 15,476 pixels. Filled,
//!   that is the closed disc of radius r, which is right by its own rule: where x^2 + y^2 <= r^2.
//! - **4-way symmetry has gaps** from a radius of 3 on: where the circle is steeper than a diagonal, columns are more than a
//!   pixel apart. 8-way symmetry has none.
//! - **The `+ 5` that one printed listing lacks** is no matter of taste: without it circles are wrong from a radius of 6 on.
//! - **`r2 - x * x`** in an `f32`: `sqrt(y^2 + y)`, just below `y + 1/2`, comes out there, so that nearest pixels are wrong
//!   from a radius of 2072 on. Cut off, squares less one become squares from 4097 on. In an `int`, `r * r` wraps at 46341.
//! - **micromath's roots** are a few per cent off, which is as many pixels of a radius of 100: outlines miss most of
//!   theirs. Its sines and cosines are good enough for circles of that size.
//!
//! A radius of more than [`octant::LONGEST_WALK`] is not walked: [`far`] draws what is seen of it, nearest pixels.
//!
//! ```
//! use core::convert::Infallible;
//! use spanfill::{
//!     Fragment, FragmentSink, PixelRect,
//!     methods::circle::{midpoint::{self, Decision}, octant::Style},
//! };
//!
//! struct Picture([[char; 5]; 5]);
//!
//! impl FragmentSink for Picture {
//!     type Error = Infallible;
//!
//!     fn fragment(&mut self, Fragment { x, y, .. }: Fragment) -> Result<(), Infallible> {
//!         self.0[y as usize][x as usize] = '#';
//!         Ok(())
//!     }
//! }
//!
//! let mut picture = Picture([[' '; 5]; 5]);
//! let clip = PixelRect { rows: 0..5, columns: 0..5 };
//! midpoint::circle([2, 2, 2], Decision::Integer, Style::Outline, &clip, &mut picture)?;
//! assert_eq!(picture.0.map(String::from_iter), [" ### ", "#   #", "#   #", "#   #", " ### "]);
//! # Ok::<(), Infallible>(())
//! ```

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "published code casts between int and float where it likes; here that saturates, and NaN is 0"
)]

pub mod far;
pub mod functions;
pub mod midpoint;
pub mod ngon;
pub mod octant;
pub mod parametric;
pub mod second_differences;
pub mod symmetry4;
pub mod symmetry8;

use crate::methods::Method;

const ROOTS: &[&str] = &[
    "truncated, outline",
    "truncated, filled",
    "nearest, outline",
    "nearest, filled",
    "micromath, truncated, outline",
    "micromath, truncated, filled",
    "micromath, nearest, outline",
    "micromath, nearest, filled",
];

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method { name: "4-way symmetry", options: ROOTS, source: "Rasterization, lecture notes: 4 way symmetry algorithm" },
    Method { name: "8-way symmetry", options: ROOTS, source: "Rasterization, lecture notes: 8 way symmetry algorithm" },
    Method {
        name: "parametric",
        options: &["libm, outline", "libm, filled", "micromath, outline", "micromath, filled"],
        source: "Rasterization, lecture notes: x = xc + r cos, y = yc + r sin",
    },
    Method {
        name: "midpoint",
        options: &[
            "5/4 - r, outline",
            "5/4 - r, filled",
            "5 / 4 - r in integers, outline",
            "5 / 4 - r in integers, filled",
            "1 - r, outline",
            "1 - r, filled",
            "without + 5, outline",
            "without + 5, filled",
        ],
        source: "Rasterization, lecture notes: midpoint circle algorithm; M. L. V. Pitteway, Algorithm for drawing \
                 ellipses or hyperbolae with a digital plotter, 1967",
    },
    Method {
        name: "second differences",
        options: &["outline", "filled"],
        source: "J. R. Van Aken, An efficient ellipse-drawing algorithm, 1984; J. D. Foley et al., Computer graphics: \
                 principles and practice, 1990",
    },
    Method {
        name: "n-gon",
        options: &[
            "n = 8, outline",
            "n = 16, outline",
            "n = 32, outline",
            "n = 64, outline",
            "n = 128, outline",
            "n = 8, filled",
            "n = 16, filled",
            "n = 32, filled",
            "n = 64, filled",
            "n = 128, filled",
        ],
        source: "Scan converting triangles, 6.837 lecture 6: polygonal approximation to a curve",
    },
];
