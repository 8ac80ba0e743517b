//! Fill by edge equations, stepped over the bounding box, with every choice that the literature leaves.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT), "CISC 440/640 Lecture 13: Scan
//! Converting Triangles" (Delaware, 2015), "Triangle Rasterization" (Purdue) and "Rasterization" (the one with Bresenham,
//! tie-breaks and backtracking), after Pineda, *A parallel algorithm for polygon rasterization*, SIGGRAPH 1988.
//!
//! ```text
//! e(x + 1, y) = e(x, y) + A        a pixel is inside where all three are at or above 0
//! e(x, y + 1) = e(x, y) + B
//! ```
//!
//! For vertices in 1/256 px, coefficients need 8 fraction bits and values at centres 16. With fewer, every C is off by
//! up to `2^-F`, which moves an edge of length l by up to `2^-F / l` px; with fewer than 8, A and B are off as well, and
//! that is multiplied by x and y. With more, a word of 32 bits is soon full: `|C|` reaches the box's area, and `(int)`
//! *saturates* it from `2^(31-F)` square pixels on, 724 px square for 12 bits, which is what breaks: the diagonal of a
//! triangle of 1024 px is drawn where x + y is 512. Sums that wrap on their way do no harm as long as the value itself
//! fits.

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    super::number::Number,
    Failure,
    bounds::Bounds,
    equation::{Constant, EdgeEqn},
    orientation::{Orientation, orient},
};

/// How three values become one answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Test {
    /// `e0 >= 0 && e1 >= 0 && e2 >= 0`.
    Comparisons,
    /// `(e0 | e1 | e2) >= 0`: one comparison, of the signs alone. A float's -0 counts as outside.
    OrOfSigns,
}

/// What the literature leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Options {
    /// How C comes about.
    pub constant: Constant,
    /// How the inside is found.
    pub orientation: Orientation,
    /// Which pixels are looked at.
    pub bounds: Bounds,
    /// Whether samples lie at pixel centres, or at integer coordinates as in "6.837 Lecture 6".
    pub at_centre: bool,
    /// Whether values step from pixel to pixel, or are worked out at each.
    pub stepped: bool,
    /// How three values become one answer.
    pub test: Test,
    /// Whether a row ends with the first pixel outside after one inside: a triangle is convex.
    pub early_out: bool,
}

impl Options {
    /// Averaged C, oriented by area, sampled at the centres of the bounding box, compared three times.
    pub const USUAL: Self = Self {
        constant: Constant::Averaged,
        orientation: Orientation::SumOfCs,
        bounds: Bounds::Centres,
        at_centre: true,
        stepped: true,
        test: Test::Comparisons,
        early_out: false,
    };
}

/// Fills the triangle of three vertices in pixels.
///
/// # Errors
///
/// The sink's; [`Failure::NoEntry`] with [`Bounds::Table`], before anything is drawn.
#[inline(always)]
pub fn edge_equations<N: Number, S: FragmentSink>(
    v: &[[N::Setup; 2]; 3],
    options: Options,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    let mut edges =
        [(v[0], v[1]), (v[1], v[2]), (v[2], v[0])].map(|(from, to)| EdgeEqn::<N>::new(from, to, options.constant));
    if !orient(&mut edges, v, options.orientation) {
        return Ok(());
    }
    let area = options.bounds.of(v, &edges, clip)?;
    Ok(scan(&edges, options, &area, sink)?)
}

/// The loop over a box.
#[inline(always)]
pub fn scan<N: Number, S: FragmentSink>(
    edges: &[EdgeEqn<N>; 3],
    options: Options,
    area: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (left, top) = (area.columns.start, area.rows.start);
    let mut t = edges.map(|edge| edge.evaluate(left, top, options.at_centre));
    for y in area.rows.clone() {
        let mut e = t;
        let mut been_inside = false;
        for x in area.columns.clone() {
            sink.visit(x, y);
            if !options.stepped {
                e = edges.map(|edge| edge.evaluate(x, y, options.at_centre));
            }
            if options.test.is_inside(e) {
                sink.fragment(Fragment::pixel(x, y))?;
                been_inside = true;
            } else if options.early_out && been_inside {
                break;
            }
            e = [e[0].plus(edges[0].a), e[1].plus(edges[1].a), e[2].plus(edges[2].a)];
        }
        t = [t[0].plus(edges[0].b), t[1].plus(edges[1].b), t[2].plus(edges[2].b)];
    }
    Ok(())
}

impl Test {
    #[inline(always)]
    fn is_inside<N: Number>(self, [e0, e1, e2]: [N; 3]) -> bool {
        match self {
            Self::Comparisons => e0.is_at_least_zero() && e1.is_at_least_zero() && e2.is_at_least_zero(),
            // Without a jump, as `e0 | e1 | e2` has none.
            Self::OrOfSigns => !(e0.sign_bit() | e1.sign_bit() | e2.sign_bit()),
        }
    }
}
