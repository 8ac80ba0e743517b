//! Paths: borrowed lines, curves and arcs, from constants or from SVG path data.

mod arc;
mod element;
mod number;
mod parse;
mod transform;

pub use element::{ArcTo, Element};
pub use parse::{PathError, SvgElements};
pub use transform::Transform;

use crate::outline::{Curve, CurveSink, Curves, FinePoint, Outline, OutlineSink};

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

impl Curves for Path<'_> {
    fn trace<S: CurveSink>(&self, sink: &mut S) {
        let mut pen = Pen { sink, start: None, at: FinePoint::default(), is_open: false };
        for element in self.elements {
            let Self { transform, .. } = self;
            let place = |point: FinePoint| transform.apply(point);
            match *element {
                Element::Move(to) => pen.lift(place(to)),
                Element::Line(to) => pen.draw(|sink, _| {
                    let to = place(to);
                    sink.line(to);
                    to
                }),
                Element::Quadratic(control, to) => {
                    pen.draw_curve(|from| Curve::quadratic(from, place(control), place(to)));
                }
                Element::Cubic(control1, control2, to) => {
                    pen.draw_curve(|from| Curve::cubic(from, place(control1), place(control2), place(to)));
                }
                Element::Arc(arc) => pen.draw_curve(|from| arc.curve(from, transform)),
                Element::Close => pen.close(),
            }
        }
        pen.finish();
    }
}

impl Outline for Path<'_> {
    fn emit<S: OutlineSink>(&self, sink: &mut S) {
        self.outline().emit(sink);
    }
}

/// Where the path is drawn from.
struct Pen<'s, S> {
    sink: &'s mut S,
    /// Of the subpath; none before the first move.
    start: Option<FinePoint>,
    at: FinePoint,
    /// The sink has been told of the subpath.
    is_open: bool,
}

impl<S: CurveSink> Pen<'_, S> {
    fn lift(&mut self, to: FinePoint) {
        self.finish();
        self.start = Some(to);
        self.at = to;
    }

    fn draw(&mut self, element: impl FnOnce(&mut S, FinePoint) -> FinePoint) {
        if self.start.is_none() {
            return;
        }
        if !self.is_open {
            self.sink.start(self.at);
            self.is_open = true;
        }
        self.at = element(self.sink, self.at);
    }

    fn draw_curve(&mut self, curve: impl FnOnce(FinePoint) -> Curve) {
        self.draw(|sink, from| {
            let curve = curve(from);
            sink.curve(&curve);
            curve.to()
        });
    }

    fn close(&mut self) {
        let Some(start) = self.start else { return };
        if !self.is_open {
            self.sink.start(self.at);
        }
        self.sink.end(true);
        self.is_open = false;
        self.at = start;
    }

    fn finish(&mut self) {
        if self.is_open {
            self.sink.end(false);
            self.is_open = false;
        }
    }
}
