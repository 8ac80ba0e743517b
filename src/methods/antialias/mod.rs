//! Anti-aliasing as it was published: how much of a pixel an outline, a line or a texture gets.
//!
//! ```text
//!    samples             distance             areas
//!    +---------+         +---------+          +---------+
//!    | . . . # |         |      /  |          |      /##|     what a pixel looks at:
//!    | . . # # |         |  +--/   |          |     /###|     points in it, the distance of its centre
//!    | . . # # |         |    /    |          |    /####|     from the outline, or all of it
//!    | . # # # |         |   /     |          |   /#####|
//!    +---------+         +---------+          +---------+
//! ```
//!
//! What each gets wrong; `tests/methods/antialias.txt` has the errors against exact areas, in 255ths, and what a square of
//! 3/8 of a pixel covers as it moves by sixteenths of one:
//!
//! - **Samples** know n^2 + 1 shades, and an upright edge only n + 1 of those: of random triangles, pixels are 9.3, 3.2, 1.0
//!   and 0.3 off in the mean for n = 2, 4, 8, 16. What is smaller than the distance of samples vanishes and flickers: the
//!   square is a whole pixel or nothing without anti-aliasing, 0 to 64 of its 36 with n = 2.
//! - **Weights** are another filter than the area: they are right by that, and by this one worse than equal samples.
//! - **A ramp of the distance** is right along straight edges that are upright. It forgets one of two edges that are near:
//!   corners are off by half, and triangles below 2 pixels by 30 in the mean, more than without anti-aliasing.
//! - **Signed areas** add up only where the outline does not overlap itself, as the fill rule is applied to a sum of
//!   windings: 0.5 off at worst where it does not, 221 where it does, accumulated or pixel by pixel.
//! - **A line's samples counted by the line** give a share of the n that the line can meet at most in a column, along the
//!   longer axis: a diagonal gets as much in a column as a level line. No n makes that better than 36 in the mean; samples
//!   in the rectangle come to 0.7.
//! - **A texture's texel under each centre** shows patterns that are not there; averages are right.
//!
//! Where a method needs scratch, it is the caller's, and with too little nothing is drawn: [`Error::Scratch`].
//!
//! ```
//! use core::convert::Infallible;
//! use spanfill::{
//!     FillRule, Fragment, FragmentSink, PixelRect, Vertex,
//!     methods::antialias::{Error, Outline, Side, grid, sampled::SampleColumn},
//! };
//!
//! struct Row([u8; 4]);
//!
//! impl FragmentSink for Row {
//!     type Error = Infallible;
//!
//!     fn fragment(&mut self, Fragment { x, coverage, .. }: Fragment) -> Result<(), Infallible> {
//!         self.0[x as usize] = coverage;
//!         Ok(())
//!     }
//! }
//!
//! let wedge: &[Vertex] = &[Vertex::new(0, 0), Vertex::new(4, 0), Vertex::new(0, 1)];
//! let outline = Outline { contours: &[wedge], fill_rule: FillRule::NonZero };
//! let clip = PixelRect { rows: 0..1, columns: 0..4 };
//! let mut row = Row([0; 4]);
//! let too_little = grid::draw(&outline, Side::Four, &mut [SampleColumn::EMPTY; 3], &clip, &mut row);
//! assert_eq!(too_little, Err(Error::Scratch { needed: 4, available: 3 }));
//! grid::draw(&outline, Side::Four, &mut [SampleColumn::EMPTY; 4], &clip, &mut row).unwrap();
//! assert_eq!(row.0, [223, 159, 96, 32]);
//! ```

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "areas in floats, as published, are made 255ths by a cast that saturates"
)]

pub mod accumulated;
pub mod error;
pub mod exact;
pub mod grid;
pub mod line_met;
pub mod line_rectangle;
pub mod minified;
pub mod none;
pub mod outline;
pub mod ramp;
pub mod rotated;
pub mod sampled;
pub mod scene;
pub mod weighted;

pub use error::Error;
pub use grid::Side;
pub use outline::Outline;

use crate::methods::Method;

const GRIDS: &[&str] = &["n = 2", "n = 4", "n = 8", "n = 16"];

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method { name: "none", options: &[""], source: "Rasterization, lecture notes: sample at the pixel's center" },
    Method {
        name: "n x n samples",
        options: GRIDS,
        source: "Rasterization, lecture notes: supersampling (postfiltering)",
    },
    Method {
        name: "rotated grid",
        options: &[""],
        source: "T. Akenine-Moller, E. Haines, Real-time rendering, 2002: rotated grid supersampling",
    },
    Method {
        name: "weighted 4 x 4",
        options: &[""],
        source: "Rasterization, lecture notes: weighted supersampling, 1 2 2 1 / 2 3 3 2 / 2 3 3 2 / 1 2 2 1",
    },
    Method {
        name: "distance ramp",
        options: &["libm's root", "micromath's root"],
        source: "S. Gupta, R. F. Sproull, Filtering edges for gray-scale displays, 1981: intensity by distance",
    },
    Method {
        name: "accumulated signed area",
        options: &["f32", "integers"],
        source: "R. Levien, Inside the fastest font renderer in the world, 2016; D. Turner, FreeType: ftgrays, 2000",
    },
    Method {
        name: "exact area",
        options: &["f32", "f64"],
        source: "E. Catmull, A hidden-surface algorithm with anti-aliasing, 1978",
    },
    Method {
        name: "line's samples, met by the line",
        options: GRIDS,
        source: "Rasterization, lecture notes: the number of subpixels intersected by the line",
    },
    Method {
        name: "line's samples, in the rectangle",
        options: GRIDS,
        source: "Rasterization, lecture notes: the number of subpixels that are inside the rectangle",
    },
    Method {
        name: "scene n times larger, averaged",
        options: GRIDS,
        source: "Rasterization, lecture notes: supersampling: increase resolution",
    },
    Method {
        name: "minified texture",
        options: &["point-sampled", "averaged"],
        source: "Rasterization, lecture notes: antialiasing: textures",
    },
];
