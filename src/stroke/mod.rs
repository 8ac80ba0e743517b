//! Strokes: what a pen of some width covers, as closed contours that are wound alike.
//!
//! ```text
//!    .---------------.                 an open subpath is one contour, a closed one two, its sides; where a side crosses
//!    |               |                 itself, at corners whose lines are too short and where a curve is tighter than
//!    a---------.     b                 the stroke, the non-zero rule adds up what is covered, whatever the opacity
//!    |          \    |
//!    '---------- '---'
//! ```
//!
//! As a union of convex pieces, a rectangle for each line and a sector or triangle for each corner, the same pixels take 2 to
//! 15 times as long: every edge between pieces is one more chain that crosses others.
//!
//! What is drawn is what Nehab ("Converting stroked primitives to filled primitives", 2020) defines: the points covered
//! by a line segment of the stroke's width that sweeps along the path, at high curvature up to the evolute, too.

mod corner;
mod dash;
mod fan;
mod normal;
mod piece;
mod run;
mod style;
mod walk;

#[cfg(feature = "embedded-graphics")]
pub(crate) use normal::{Unit, length_q16};
pub use style::{Align, Cap, Join, StrokeStyle};

use crate::outline::{Curves, FinePoint, FineRect, Outline, OutlineSink, Vertices, WindingRule, hull};

/// The stroke of a path or shape: an [`Outline`], to be filled by the non-zero rule.
///
/// Conventions are those of SVG 2: beyond its limit a miter becomes a bevel; dashes start anew in each subpath, and
/// one of a closed contour starts at its first vertex and does not join over it; a subpath of no length is a dot for
/// round caps, an upright square for square ones, and nothing for butt; where a path turns back on itself, there is no
/// miter and no bevel.
///
/// The same whichever way it is drawn, and symmetric about its line. Coverage is within 0.6 of 255 of the true area.
///
/// # Cost
///
/// A line: a square root, two divisions and two edges, and those of its corner, for as often as its vertices are asked
/// for; a chord of a curve the same twice. The latest few are kept on the stack: 2.3 KiB on boards, 33 on hosts, and
/// 1.5 more for dashes.
///
/// # Examples
///
/// ```
/// use spanfill::{Cap, Outline as _, Stroke, StrokeStyle, path};
///
/// let style = StrokeStyle::pixels(4).cap(Cap::Round).dashes(&[6 * 256, 5 * 256]);
/// let stroke = Stroke::new(path!("M10 10h30v20"), style);
/// assert_eq!(stroke.count().contours, 5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Stroke<'d, C> {
    curves: C,
    style: StrokeStyle<'d>,
}

impl<'d, C> Stroke<'d, C> {
    /// The stroke of what a path goes along.
    #[inline]
    pub const fn new(curves: C, style: StrokeStyle<'d>) -> Self {
        Self { curves, style }
    }

    /// What is stroked.
    #[inline]
    pub(crate) const fn curves(&self) -> &C {
        &self.curves
    }

    /// How.
    #[inline]
    pub(crate) const fn style(&self) -> &StrokeStyle<'d> {
        &self.style
    }
}

impl<C: Curves> Stroke<'_, C> {
    /// The chords of its middle line, of each dash by itself.
    pub(crate) fn each_chord(&self, found: &mut dyn FnMut(FinePoint, FinePoint)) {
        walk::Walk::new(&self.curves, &self.style.align(Align::Center), true).each_chord(found);
    }
}

impl<C: Curves> Outline for Stroke<'_, C> {
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R {
        let is_clockwise = self.style.align == Align::Center || goes_clockwise(&self.curves);
        with(&walk::Walk::new(&self.curves, &self.style, is_clockwise))
    }

    fn extent(&self) -> FineRect {
        hull(&self.curves).grown(self.style.reach())
    }

    fn chains_at_most(&self) -> Option<usize> {
        let (reach, more) = self.style.chains();
        Some(self.curves.chains_at_most(Some(reach))?.saturating_mul(more))
    }

    fn winding_rule(&self) -> WindingRule {
        match self.style.align {
            _ if self.style.has_gaps() => WindingRule::NON_ZERO,
            Align::Center => WindingRule::NON_ZERO,
            Align::Inside => WindingRule { mask: 1, flip: 0, least: 0 },
            Align::Outside => WindingRule { mask: 1, flip: 1, least: 0 },
        }
    }
}

/// Whether what a path goes around lies to the right of it.
fn goes_clockwise(curves: &impl Curves) -> bool {
    struct DoubledArea {
        first: Option<(i64, i64)>,
        last: (i64, i64),
        sum: i128,
    }

    impl OutlineSink for DoubledArea {
        fn point(&mut self, x: i64, y: i64) {
            self.first.get_or_insert((x, y));
            let (x0, y0) = core::mem::replace(&mut self.last, (x, y));
            self.sum += i128::from(x0) * i128::from(y) - i128::from(x) * i128::from(y0);
        }

        fn close(&mut self) {
            if let Some((x, y)) = self.first.take() {
                self.point(x, y);
                (self.first, self.last) = (None, (0, 0));
            }
        }
    }

    let mut area = DoubledArea { first: None, last: (0, 0), sum: 0 };
    curves.outline().emit(&mut area);
    area.sum >= 0
}
