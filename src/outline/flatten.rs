//! The inside of lines and curves as closed contours.

use crate::outline::{Curve, CurveSink, Curves, FinePoint, Outline, OutlineSink};

/// The inside of a path: every subpath a contour, closed or not.
#[derive(Debug)]
pub struct Flattened<'c, C: ?Sized>(pub(crate) &'c C);

impl<C: ?Sized> Clone for Flattened<'_, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: ?Sized> Copy for Flattened<'_, C> {}

impl<C: Curves + ?Sized> Outline for Flattened<'_, C> {
    fn emit<S: OutlineSink>(&self, sink: &mut S) {
        self.0.trace(&mut Contours(sink));
    }
}

struct Contours<'s, S>(&'s mut S);

impl<S: OutlineSink> CurveSink for Contours<'_, S> {
    fn start(&mut self, at: FinePoint) {
        self.0.point(at.x.into(), at.y.into());
    }

    fn line(&mut self, to: FinePoint) {
        self.0.point(to.x.into(), to.y.into());
    }

    fn curve(&mut self, curve: &Curve) {
        self.0.curve(curve);
    }

    fn end(&mut self, _: bool) {
        self.0.close();
    }
}
