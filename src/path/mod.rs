//! Paths: borrowed lines, curves and arcs, from constants or from SVG path data.

mod arc;
mod element;
mod number;
mod parse;
mod transform;
mod transformed;

pub use element::{ArcTo, Element};
pub use parse::{PathError, SvgElements};
pub use transform::Transform;
pub use transformed::Transformed;

use crate::outline::{Curve, Curves, FinePoint, FineRect, Outline, RowCounts, Step, StrokeReach, Vertices};

/// Lines, Bézier curves and elliptical arcs, borrowed: from a constant, as a rule.
///
/// Subpaths start with [`Element::Move`]; what stands before the first is not drawn. What follows a
/// [`Close`](Element::Close) without a move starts where the closed subpath did. A move that nothing follows draws
/// nothing. All coordinates are legal.
///
/// [`path!`](crate::path!) makes one from SVG path data when the program is compiled: a wrong string does not compile.
///
/// Drawn, it is flattened as it is walked, see [`Curve`]: coverage is within 0.6 of 255 of the true area for curves of
/// up to some 4096 pixels, and no vertex is stored.
///
/// # Cost
///
/// 40 bytes an element, in flash.
///
/// # Examples
///
/// ```
/// use spanfill::{Element, FinePoint, Outline as _, Path, path};
///
/// const LEAF: Path = Path::new(&[
///     Element::Move(FinePoint::whole(1, 1)),
///     Element::Quadratic(FinePoint::whole(9, 1), FinePoint::whole(9, 9)),
///     Element::Quadratic(FinePoint::whole(1, 9), FinePoint::whole(1, 1)),
///     Element::Close,
/// ]);
/// const SAME: Path = path!("M1 1Q9 1 9 9T1 1z");
///
/// assert_eq!(LEAF.elements()[..2], SAME.elements()[..2]);
/// assert_eq!(LEAF.count().contours, 1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Path<'a> {
    elements: &'a [Element],
    transform: Transform,
}

impl<'a> Path<'a> {
    /// A path where its points are.
    #[inline]
    pub const fn new(elements: &'a [Element]) -> Self {
        Self { elements, transform: Transform::IDENTITY }
    }

    /// What it is made of.
    #[inline]
    pub const fn elements(&self) -> &'a [Element] {
        self.elements
    }

    /// The same turned, scaled, skewed, moved: after what it has been already.
    #[inline]
    #[must_use]
    pub const fn transformed(self, transform: Transform) -> Self {
        Self { transform: self.transform.then(transform), ..self }
    }

    /// The same, moved.
    #[inline]
    #[must_use]
    pub const fn moved(self, by: FinePoint) -> Self {
        self.transformed(Transform::moved(by))
    }
}

impl Path<'_> {
    const fn element(&self, index: u32) -> Option<&Element> {
        if (index as usize) < self.elements.len() {
            #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
            let element = &self.elements[index as usize];
            Some(element)
        } else {
            None
        }
    }

    /// Where the subpath begins that an element is of: what precedes the first move has none.
    const fn start(&self, mut index: u32) -> Option<FinePoint> {
        loop {
            if let Some(Element::Move(to)) = self.element(index) {
                return Some(self.transform.apply(*to));
            }
            if index == 0 {
                return None;
            }
            index -= 1;
        }
    }

    const fn end(&self, index: u32) -> FinePoint {
        let to = match self.element(index) {
            Some(Element::Move(to) | Element::Line(to) | Element::Quadratic(_, to) | Element::Cubic(_, _, to)) => *to,
            Some(Element::Arc(arc)) => arc.to,
            Some(Element::Close) | None => match self.start(index) {
                Some(start) => return start,
                None => FinePoint::from_bits(0, 0),
            },
        };
        self.transform.apply(to)
    }

    const fn count(&self) -> u32 {
        #[allow(clippy::cast_possible_truncation, reason = "compared")]
        let count = if self.elements.len() < u32::MAX as usize { self.elements.len() as u32 } else { u32::MAX };
        count
    }

    const fn step_at(&self, index: u32) -> Step {
        let transform = &self.transform;
        let from = if index > 0 { self.end(index - 1) } else { FinePoint::from_bits(0, 0) };
        match self.element(index) {
            None => Step::Move(FinePoint::from_bits(0, 0)),
            Some(Element::Move(to)) => Step::Move(transform.apply(*to)),
            Some(Element::Line(to)) => Step::Line(from, transform.apply(*to)),
            Some(Element::Quadratic(control, to)) => {
                Step::Curve(Curve::quadratic(from, transform.apply(*control), transform.apply(*to)))
            }
            Some(Element::Cubic(control1, control2, to)) => Step::Curve(Curve::cubic(
                from,
                transform.apply(*control1),
                transform.apply(*control2),
                transform.apply(*to),
            )),
            Some(Element::Arc(arc)) => Step::Curve(arc.curve(from, transform)),
            Some(Element::Close) => match self.start(index) {
                Some(start) => Step::Close(from, start),
                // Before the first move.
                None => Step::Line(from, from),
            },
        }
    }

    const fn hull(&self) -> FineRect {
        let mut hull = FineRect::EMPTY;
        let mut index = 0;
        while index < self.count() {
            match self.step_at(index) {
                Step::Curve(curve) => {
                    let FineRect { low, high } = curve.hull();
                    hull.add(low);
                    hull.add(high);
                }
                step => hull.add(step.end()),
            }
            index += 1;
        }
        hull
    }

    /// How much scratch the anti-aliased inside needs: as many chains of edges as are in a row of pixels at most, or a few
    /// more. Meant for constants; takes a pass over the elements.
    pub const fn coverage_edges(&self) -> usize {
        self.chains_at_most(None)
    }

    /// The same of a stroke.
    ///
    /// A stroke has two sides, each with the chains of the path. On the inner side of a corner both may overlap: two
    /// chains more. The inner side of a curve has them between any two chords, where it is tighter than the stroke.
    pub(crate) const fn chains_at_most(&self, stroke: Option<StrokeReach>) -> usize {
        let (sides, corner, radius, reach) = match stroke {
            Some(StrokeReach { radius, most, .. }) => (2, 2, radius, most),
            None => (1, 0, 0, 0),
        };
        // Dashed curves have more chords.
        let finer = match stroke {
            Some(StrokeReach { dashes: Some(_), .. }) => 4,
            _ => 1,
        };
        let mut counts = RowCounts::new(self.hull().grown(reach));
        // The chain so far.
        let (mut top, mut bottom, mut direction) = (0, 0, 0);
        let mut index = 0;
        while index < self.count() {
            let step = self.step_at(index);
            let (from, to) = match step {
                Step::Move(to) => (to, to),
                Step::Line(from, to) | Step::Close(from, to) => (from, to),
                Step::Curve(curve) => (curve.from(), curve.to()),
            };
            if let Some(stroke) = &stroke {
                // A dash has two sides.
                let FineRect { low, high } = step.hull();
                let dashes = 2 * stroke.dashes_in(&step);
                counts.add(low.y.saturating_sub(reach), high.y.saturating_add(reach), dashes);
            }
            if let Step::Curve(curve) = step {
                let FineRect { low, high } = curve.hull();
                let spikes = if radius > 0 && curve.tightest() <= 2 * radius { 2 * finer * curve.chords() } else { 0 };
                let chains = sides * curve.parts() + spikes + 2 * corner;
                counts.add(low.y.saturating_sub(reach), high.y.saturating_add(reach), chains);
            } else {
                let goes = if from.y < to.y {
                    1
                } else if from.y > to.y {
                    -1
                } else {
                    0
                };
                let (low, high) = if from.y < to.y { (from.y, to.y) } else { (to.y, from.y) };
                let goes_on = goes == direction && goes != 0 && !matches!(step, Step::Move(_));
                if goes_on {
                    top = if low < top { low } else { top };
                    bottom = if high > bottom { high } else { bottom };
                } else if goes != 0 || stroke.is_some() {
                    if direction != 0 {
                        counts.add(top.saturating_sub(reach), bottom.saturating_add(reach), sides);
                    }
                    (top, bottom, direction) = (low, high, goes);
                    if goes == 0 {
                        counts.add(low.saturating_sub(reach), high.saturating_add(reach), sides);
                    }
                }
                counts.add(to.y.saturating_sub(reach), to.y.saturating_add(reach), corner);
            }
            let is_open = match self.element(index + 1) {
                Some(Element::Move(_)) | None => true,
                Some(_) => false,
            };
            // Filled, an open subpath is closed; a curve ends what was before it.
            if (is_open || matches!(step, Step::Curve(_) | Step::Close(..))) && direction != 0 {
                counts.add(top.saturating_sub(reach), bottom.saturating_add(reach), sides);
                direction = 0;
            }
            if is_open
                && stroke.is_none()
                && let Some(start) = self.start(index)
            {
                let (low, high) = if start.y < to.y { (start.y, to.y) } else { (to.y, start.y) };
                counts.add(low, high, 1);
            }
            index += 1;
        }
        counts.most()
    }
}

impl Curves for Path<'_> {
    fn steps(&self) -> u32 {
        // What is drawn begins with the first move.
        let is_move = |element: &Element| matches!(element, Element::Move(_));
        if self.elements.iter().any(is_move) { self.count() } else { 0 }
    }

    fn step(&self, index: u32) -> Step {
        self.step_at(index)
    }

    fn chains_at_most(&self, stroke: Option<StrokeReach>) -> Option<usize> {
        Some(Path::chains_at_most(self, stroke))
    }
}

impl Outline for Path<'_> {
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R {
        self.outline().with_vertices(with)
    }

    fn extent(&self) -> FineRect {
        self.hull()
    }

    fn chains_at_most(&self) -> Option<usize> {
        Some(self.coverage_edges())
    }
}
