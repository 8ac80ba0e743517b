//! The programs of the notes, as they are printed: no choice left.
//!
//! Sources: `FlatTri` in Java, 12 fraction bits, of "6.837 Lecture 6: Scan Converting Triangles" (MIT); `FlatTri` in C#,
//! doubles, of "CISC 440/640 Lecture 13: Scan Converting Triangles" (Delaware, 2015); the implementation guidelines in C,
//! floats, of "Triangle Rasterization" (Purdue), slides 21-22.
//!
//! | | Java | C# | C |
//! |---|---|---|---|
//! | numbers | floats, coefficients `(int) (a * 4096)` | doubles | floats |
//! | C | averaged | averaged | cross product |
//! | inside | by the sum of the C's | the same | by the third vertex |
//! | box | table, `(int) min` to `(int) (max + 1)` | the same | `(int) (min + .5)` to `(int) (max - .5)` |
//! | samples | integer coordinates | integer coordinates | centres |
//! | test | OR of the signs | `>= 0` three times | `< 0`, of what is written `currEE[i]` for each i |
//! | row | ends after the span | the same | goes on |
//!
//! What is wrong with them: samples at integer coordinates move every triangle by half a pixel to the upper left of
//! where the C program puts it; the table has no entry where all x or all y are equal, see [`bounds`](super::bounds);
//! C is lost in 12 bits from products of about 2^19 square pixels on. What only looks wrong: `flip` leaves the flags
//! alone, as it should, since they are about the vertices; and `xMax = (int) (x + 1)` may be up to two columns beyond
//! the last sample, where the edge equations say no.

use crate::{FragmentSink, PixelRect};

use super::{
    super::number::Fixed,
    Failure,
    bounds::Bounds,
    edge_equations::{Options, Test, edge_equations},
    equation::Constant,
    orientation::Orientation,
};

const FLAT_TRI: Options = Options {
    constant: Constant::Averaged,
    orientation: Orientation::SumOfCs,
    bounds: Bounds::Table,
    at_centre: false,
    stepped: true,
    test: Test::Comparisons,
    early_out: true,
};

/// `FlatTri` in Java; `FRACBITS` is 12.
///
/// # Errors
///
/// The sink's; [`Failure::NoEntry`] where Java throws.
pub fn flat_tri_java<S: FragmentSink>(
    v: &[[f64; 2]; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    edge_equations::<Fixed<i32, 12>, S>(v, Options { test: Test::OrOfSigns, ..FLAT_TRI }, clip, sink)
}

/// `FlatTri` in C#.
///
/// # Errors
///
/// The sink's; [`Failure::NoEntry`] where C# throws.
pub fn flat_tri_csharp<S: FragmentSink>(
    v: &[[f64; 2]; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    edge_equations::<f64, S>(v, FLAT_TRI, clip, sink)
}

/// The implementation guidelines in C.
///
/// # Errors
///
/// The sink's.
pub fn guidelines<S: FragmentSink>(v: &[[f32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), Failure<S::Error>> {
    let options = Options {
        constant: Constant::CrossProduct,
        orientation: Orientation::ThirdVertex,
        bounds: Bounds::Inwards,
        at_centre: true,
        stepped: true,
        test: Test::Comparisons,
        early_out: false,
    };
    edge_equations::<f32, S>(v, options, clip, sink)
}
