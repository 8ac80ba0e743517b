//! Outlines that are made as they are asked for: sources of edges, without storage for vertices.
//!
//! ```text
//! Curves: lines and curves, by number --flatten--> Outline: closed contours, vertex by vertex -> chains of edges
//!                                     \--stroke---> Outline: both sides of each subpath, or of each dash
//! ```
//!
//! # Why vertices have numbers
//!
//! An active chain of edges asks for its next vertex when an edge ends, dozens of chains side by side. So a vertex is
//! worked out from its number alone: the number says which line or curve it belongs to, which chord of it, and which
//! vertex of the corner there. A chain remembers eight bytes, where a cursor over a dashed stroke would have some 300. What
//! it costs: a vertex is worked out again for each time that it is asked for, some three times a drawing, but for the
//! latest few, which are kept.

mod chains;
mod curve;
mod fine;
mod flatten;
mod kept;

pub(crate) use chains::{RowCounts, most_chains};
pub use curve::{Curve, CurvePoints};
pub use fine::{FinePoint, FineRect};
pub(crate) use fine::{Vector, clamp_fine, divide_half_even, shift_half_even, shift_half_even_wide};
pub use flatten::Flattened;
pub(crate) use flatten::most_chords;
pub(crate) use kept::{KEPT_VERTICES, Kept};

/// Closed contours of points with 12 fraction bits (1/4096 pixel), made on the fly, as often as asked.
///
/// Coordinates are within ±2^31 (524288 pixels): what lies beyond is drawn in to there. Filled by the non-zero rule.
pub trait Outline {
    /// Hands over its vertices by number; a few of those that were asked for last are kept on the stack while it does.
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R;

    /// A rectangle that no point is outside of, without walking the outline. Empty outlines may have any.
    fn extent(&self) -> FineRect;

    /// A number that it has no more chains in a row than, where that is known without walking it.
    #[doc(hidden)]
    #[inline]
    fn chains_at_most(&self) -> Option<usize> {
        None
    }

    /// What is inside, where it is not what the contours go around at all.
    #[doc(hidden)]
    #[inline]
    fn winding_rule(&self) -> WindingRule {
        WindingRule::NON_ZERO
    }

    /// Calls `point` for each vertex of each contour in order, and `close` after each contour.
    fn emit<S: OutlineSink>(&self, sink: &mut S) {
        self.with_vertices(|vertices| {
            for contour in 0..vertices.contours() {
                let Some(first) = vertices.first(contour) else { continue };
                let mut index = first;
                loop {
                    let FinePoint { x, y } = vertices.vertex(contour, index);
                    sink.point(x.into(), y.into());
                    index = vertices.next(contour, index, true);
                    if index == first {
                        break;
                    }
                }
                sink.close();
            }
        });
    }

    /// How many points and contours it has: what a sink that stores them needs. Walks the outline.
    fn count(&self) -> OutlineCount {
        let mut count = OutlineCount::default();
        self.emit(&mut count);
        count
    }
}

/// Closed contours whose vertices are worked out when they are asked for.
pub trait Vertices {
    /// How many contours there may be.
    fn contours(&self) -> u32;

    /// The index of some vertex of a contour; none where it is empty.
    fn first(&self, contour: u32) -> Option<u32>;

    /// The index, below 2^30, that follows along the contour, or comes before; the last is followed by the first.
    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32;

    /// The vertex of an index that was handed out.
    fn vertex(&self, contour: u32, index: u32) -> FinePoint;
}

/// Bits of an index.
pub(crate) const INDEX_BITS: u32 = 30;

/// Which windings are inside: those with a bit of `mask`, once `flip` is flipped, and above `least`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct WindingRule {
    pub(crate) mask: i32,
    pub(crate) flip: i32,
    pub(crate) least: i32,
}

impl WindingRule {
    pub(crate) const NON_ZERO: Self = Self::with_mask(!0);

    pub(crate) const fn with_mask(mask: i32) -> Self {
        Self { mask, flip: 0, least: i32::MIN }
    }

    /// 1 inside, 0 outside.
    #[inline]
    pub(crate) fn of(self, winding: i32) -> i32 {
        i32::from((winding ^ self.flip) & self.mask != 0 && winding > self.least)
    }

    /// The weight of what changes a winding.
    #[inline]
    pub(crate) fn weight(self, winding: i32, direction: i8) -> i32 {
        self.of(winding + i32::from(direction)) - self.of(winding)
    }
}

/// Receives the points of an [`Outline`].
pub trait OutlineSink {
    /// The next vertex of the contour, in 1/4096 pixel.
    fn point(&mut self, x: i64, y: i64);

    /// The contour's last vertex is joined to its first. It may have any number of points.
    fn close(&mut self);
}

/// How large an outline is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct OutlineCount {
    /// Its vertices.
    pub points: usize,
    /// Its contours.
    pub contours: usize,
}

impl OutlineSink for OutlineCount {
    fn point(&mut self, _: i64, _: i64) {
        self.points += 1;
    }

    fn close(&mut self) {
        self.contours += 1;
    }
}

impl OutlineSink for FineRect {
    fn point(&mut self, x: i64, y: i64) {
        self.add(FinePoint::clamped(x, y));
    }

    fn close(&mut self) {}
}

impl<O: Outline> Outline for &O {
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R {
        (**self).with_vertices(with)
    }

    fn extent(&self) -> FineRect {
        (**self).extent()
    }

    fn winding_rule(&self) -> WindingRule {
        (**self).winding_rule()
    }

    fn chains_at_most(&self) -> Option<usize> {
        (**self).chains_at_most()
    }
}

/// Lines and curves, open or closed: what can be filled and stroked.
pub trait Curves {
    /// How many steps there are.
    fn steps(&self) -> u32;

    /// A step by its number, below [`steps`](Self::steps); always the same. Beyond them, a move to anywhere.
    fn step(&self, index: u32) -> Step;

    /// The same of its inside, or of a stroke.
    #[doc(hidden)]
    #[inline]
    fn chains_at_most(&self, _stroke: Option<StrokeReach>) -> Option<usize> {
        None
    }

    /// The inside, by the non-zero rule or another: open subpaths are closed by a line.
    #[inline]
    fn outline(&self) -> Flattened<'_, Self>
    where
        Self: Sized,
    {
        Flattened { curves: self, fill_rule: crate::contours::FillRule::NonZero }
    }
}

impl<C: Curves> Curves for &C {
    fn steps(&self) -> u32 {
        (**self).steps()
    }

    fn step(&self, index: u32) -> Step {
        (**self).step(index)
    }

    fn chains_at_most(&self, stroke: Option<StrokeReach>) -> Option<usize> {
        (**self).chains_at_most(stroke)
    }
}

/// One step of [`Curves`]. Lines and curves begin where the step before them ends; what stands before the first move is
/// not drawn. What follows a [`Close`](Self::Close) without a move begins where the closed subpath did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// A subpath begins here.
    Move(FinePoint),
    /// From one point to another.
    Line(FinePoint, FinePoint),
    /// A curve.
    Curve(Curve),
    /// From one point to the start of the subpath, which is closed by it.
    Close(FinePoint, FinePoint),
}

impl Step {
    /// A rectangle that nothing of it is outside of.
    pub(crate) const fn hull(&self) -> FineRect {
        let mut hull = FineRect::EMPTY;
        match self {
            Self::Move(at) => hull.add(*at),
            Self::Line(from, to) | Self::Close(from, to) => {
                hull.add(*from);
                hull.add(*to);
            }
            Self::Curve(curve) => return curve.hull(),
        }
        hull
    }

    /// Where it ends.
    #[inline]
    pub(crate) const fn end(&self) -> FinePoint {
        match self {
            Self::Move(to) | Self::Line(_, to) | Self::Close(_, to) => *to,
            Self::Curve(curve) => curve.to(),
        }
    }
}

/// How far a stroke reaches from its line, in 1/4096 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StrokeReach {
    /// Half of its width.
    pub(crate) radius: i64,
    /// Nothing is farther away.
    pub(crate) most: i32,
    /// So many dashes are so long together, with their gaps; none is without gaps.
    pub(crate) dashes: Option<(u32, u64)>,
}

impl StrokeReach {
    /// How many dashes of a step meet a row of pixels at most.
    pub(crate) const fn dashes_in(&self, step: &Step) -> u32 {
        let Some((count, cycle)) = self.dashes else { return 0 };
        let (length, height) = match step {
            Step::Move(_) => return count,
            Step::Line(from, to) | Step::Close(from, to) => {
                let vector = Vector::between(*from, *to);
                (vector.dot(vector).unsigned_abs().isqrt() + 1, vector.y.unsigned_abs() as u128)
            }
            Step::Curve(curve) => (curve.length_at_most() as u128, 0),
        };
        // What of a line is within reach of the row.
        let near = 4096 + 2 * self.most.unsigned_abs() as u128;
        let near = match (length * near).checked_div(height) {
            Some(part) if height > near => part + 1,
            _ => length,
        };
        let cycles = match near.checked_div(cycle as u128) {
            Some(cycles) => cycles + 2,
            None => 2,
        };
        let dashes = cycles * count as u128;
        #[allow(clippy::cast_possible_truncation, reason = "compared")]
        let dashes = if dashes < u32::MAX as u128 / 4 { dashes as u32 } else { u32::MAX / 4 };
        dashes
    }
}

/// Every line and curve, in a rectangle.
pub(crate) fn hull(curves: &dyn Curves) -> FineRect {
    let mut hull = FineRect::EMPTY;
    for index in 0..curves.steps() {
        match curves.step(index) {
            Step::Curve(curve) => {
                let FineRect { low, high } = curve.hull();
                hull.add(low);
                hull.add(high);
            }
            step => hull.add(step.end()),
        }
    }
    hull
}
