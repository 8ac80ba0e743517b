//! Lines one pixel thin, as they were published: between whole pixels, one pixel in each step of the longer axis.
//!
//! ```text
//!    #-#_. . . .         y' = 2, y = 7 columns: where the line passes between two rows,
//!    . . #-#-#_.         which of the two it takes is all that these methods can differ in,
//!    . . . . . #-#       if they are right
//! ```
//!
//! What only looks wrong, and what is; `tests/methods/line.txt` has the counts, of 2000 lines in the first octant with
//! 40,768 pixels and 2000 in any direction with 39,675:
//!
//! - **`d <= 0` in the code, `d < 0` in its derivation** (*Rasterization*, lecture notes): both are nearest pixels. They
//!   differ where the line passes exactly between two, and nowhere else: in 1,299 pixels.
//! - **`xi < dx` loses a pixel**: the last one of every line.
//! - **`floor` for nearest**: [`slope_intercept`] takes the row above wherever the line is past the middle of it, in 16,691
//!   pixels, which is 41 %.
//! - **`DisplayPixel(x, y)` with a `float y`** converts by cutting off the fraction: the same as `floor`, but for rows
//!   above the screen's top, where it draws one row lower: two rows of the line end up on row 0.
//! - **`y += m`** drifts: see [`dda`].
//! - **Printed code for one octant** draws something in all others: [`bresenham`] a horizontal line or a diagonal,
//!   [`slope_intercept`] one pixel a column of a steep line, none of a line to the left.
//!
//! Integers wrap, as in the published code: lines of more than 2^30 pixels are wrong in all methods with a decision
//! variable of 32 bits. Time is bounded by [`display::PATIENCE`] steps outside of the clip.
//!
//! ```
//! use core::convert::Infallible;
//! use spanfill::{
//!     Fragment, FragmentSink, PixelRect,
//!     methods::line::directly::{self, Ties},
//! };
//!
//! struct Rows([i32; 7]);
//!
//! impl FragmentSink for Rows {
//!     type Error = Infallible;
//!
//!     fn fragment(&mut self, Fragment { x, y, .. }: Fragment) -> Result<(), Infallible> {
//!         self.0[x as usize] = y;
//!         Ok(())
//!     }
//! }
//!
//! let mut rows = Rows([0; 7]);
//! directly::line([[0, 0], [6, 2]], Ties::Diagonal, &PixelRect { rows: 0..9, columns: 0..7 }, &mut rows)?;
//! assert_eq!(rows.0, [0, 0, 1, 1, 1, 2, 2]);
//! # Ok::<(), Infallible>(())
//! ```

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "published code casts between int and float where it likes; here that saturates, and NaN is 0"
)]

pub mod bresenham;
pub mod by_transformation;
pub mod dda;
pub mod directly;
pub mod display;
pub mod gupta_sproull;
pub mod slope_intercept;
pub mod wu;

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        name: "y = mx + b",
        options: &[
            "floor, xi < dx",
            "floor, xi <= dx",
            "nearest, xi < dx",
            "nearest, xi <= dx",
            "floor, all octants",
            "nearest, all octants",
        ],
        source: "Rasterization, lecture notes: basic incremental algorithm",
    },
    Method {
        name: "DDA",
        options: &["as printed", "truncated", "nearest", "16 fraction bits"],
        source: "Rasterization, lecture notes: DDA (digital differential analyzer) algorithm",
    },
    Method {
        name: "Bresenham",
        options: &["d <= 0", "d < 0"],
        source: "Rasterization, lecture notes: Bresenham's line algorithm; J. E. Bresenham, Algorithm for computer \
                 control of a digital plotter, 1965",
    },
    Method {
        name: "Bresenham, by transformation",
        options: &["d <= 0", "d < 0"],
        source: "Rasterization, lecture notes: general Bresenham's line algorithm",
    },
    Method {
        name: "Bresenham, directly",
        options: &["d < 0", "ties down and right"],
        source: "J. E. Bresenham, Algorithm for computer control of a digital plotter, 1965",
    },
    Method {
        name: "Wu",
        options: &["16 bits, from both ends", "16 bits, from one end", "f32, ends between pixels"],
        source: "X. Wu, An efficient antialiasing technique, 1991",
    },
    Method {
        name: "Gupta-Sproull",
        options: &["libm's root", "micromath's root"],
        source: "S. Gupta, R. F. Sproull, Filtering edges for gray-scale displays, 1981",
    },
];
