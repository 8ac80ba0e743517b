//! Fill by barycentric coordinates, as quotients of edge equations.
//!
//! Source: the lecture notes "Triangles" (barycentric coordinates, Gouraud shading), whose algorithm this is, step by
//! step; `beta + gamma <= 1` from the notes "Rasterization". Both follow Shirley, *Fundamentals of Computer Graphics*.
//!
//! ```text
//! p = alpha a + beta b + gamma c          f_ab(x, y) = (ya - yb) x + (xb - xa) y + xa yb - xb ya
//! alpha = f_bc(x, y) / f_bc(xa, ya)       and so on round; inside where all three lie in [0, 1]
//! ```
//!
//! Quotients need no orientation: numerator and denominator change sign together. They cost three divisions a pixel,
//! and two roundings more than the comparison of the numerator with 0. As the three add up to 1, none is above 1 where
//! none is below 0, so the upper bounds can go, and with `alpha = 1 - beta - gamma` one of the quotients.
//!
//! A degenerate triangle divides by 0: its coordinates are infinite or NaN, of which the upper bounds keep the first
//! out, too.

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    super::number::Real,
    bounds::{centres, clipped},
};

/// The steps in which the notes make the algorithm faster.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Step {
    /// All pixels, rows first.
    EveryPixel,
    /// All pixels, columns first: "for all x do for all y do".
    EveryPixelByColumns,
    /// "Use a bounding rectangle", columns first as printed.
    BoundingBox,
    /// "Make computation of barycentric coordinates incremental."
    Incremental,
    /// "Don't need to check upper bound."
    WithoutUpperBounds,
    /// `beta >= 0`, `gamma >= 0`, `beta + gamma <= 1`: two quotients.
    BetaPlusGamma,
}

/// The implicit line through two points: `f_ab`.
#[derive(Debug, Clone, Copy)]
struct Line<R> {
    dx: R,
    dy: R,
    constant: R,
}

impl<R: Real> Line<R> {
    #[inline(always)]
    fn through([xa, ya]: [R; 2], [xb, yb]: [R; 2]) -> Self {
        Self { dx: ya - yb, dy: xb - xa, constant: xa * yb - xb * ya }
    }

    #[inline(always)]
    fn at(&self, [x, y]: [R; 2]) -> R {
        self.dx * x + self.dy * y + self.constant
    }
}

/// Fills the triangle of three vertices in pixels.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn barycentric<R: Real, S: FragmentSink>(
    v: &[[R; 2]; 3],
    step: Step,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [a, b, c] = *v;
    let (f_ab, f_bc, f_ca) = (Line::through(a, b), Line::through(b, c), Line::through(c, a));
    let (at_a, at_b, at_c) = (f_bc.at(a), f_ca.at(b), f_ab.at(c));
    let coordinates = |x: i32, y: i32| {
        let p = [R::from_integer(x) + R::HALF, R::from_integer(y) + R::HALF];
        [f_bc.at(p) / at_a, f_ca.at(p) / at_b, f_ab.at(p) / at_c]
    };
    let mut draw = |x: i32, y: i32, is_inside: bool| {
        sink.visit(x, y);
        if is_inside { sink.fragment(Fragment::pixel(x, y)) } else { Ok(()) }
    };
    let within = |[alpha, beta, gamma]: [R; 3]| {
        let is_part = |part: R| part >= R::ZERO && part <= R::ONE;
        is_part(alpha) && is_part(beta) && is_part(gamma)
    };
    let [x, y] = [0, 1].map(|axis| {
        let [a, b, c] = v.map(|vertex| if axis == 0 { vertex[0] } else { vertex[1] });
        centres(a.at_most(b).at_most(c), a.at_least(b).at_least(c))
    });
    let (columns, rows) = (clipped(x, &clip.columns), clipped(y, &clip.rows));
    match step {
        Step::EveryPixel => {
            for y in clip.rows.clone() {
                for x in clip.columns.clone() {
                    draw(x, y, within(coordinates(x, y)))?;
                }
            }
        }
        Step::EveryPixelByColumns => {
            for x in clip.columns.clone() {
                for y in clip.rows.clone() {
                    draw(x, y, within(coordinates(x, y)))?;
                }
            }
        }
        Step::BoundingBox => {
            for x in columns {
                for y in rows.clone() {
                    draw(x, y, within(coordinates(x, y)))?;
                }
            }
        }
        Step::Incremental => {
            let [alpha_x, beta_x, gamma_x] = [f_bc.dx / at_a, f_ca.dx / at_b, f_ab.dx / at_c];
            for y in rows {
                let [mut alpha, mut beta, mut gamma] = coordinates(columns.start, y);
                for x in columns.clone() {
                    draw(x, y, within([alpha, beta, gamma]))?;
                    alpha = alpha + alpha_x;
                    beta = beta + beta_x;
                    gamma = gamma + gamma_x;
                }
            }
        }
        Step::WithoutUpperBounds => {
            for y in rows {
                for x in columns.clone() {
                    let [alpha, beta, gamma] = coordinates(x, y);
                    draw(x, y, alpha >= R::ZERO && beta >= R::ZERO && gamma >= R::ZERO)?;
                }
            }
        }
        Step::BetaPlusGamma => {
            for y in rows {
                for x in columns.clone() {
                    let [_, beta, gamma] = coordinates(x, y);
                    draw(x, y, beta >= R::ZERO && gamma >= R::ZERO && beta + gamma <= R::ONE)?;
                }
            }
        }
    }
    Ok(())
}
