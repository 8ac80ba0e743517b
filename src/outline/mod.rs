//! Outlines that are made as they are asked for: sources of edges, without storage for vertices.
//!
//! ```text
//! Curves: lines and curves, open or closed --flatten--> Outline: closed contours of points -> edges
//!                                         \--stroke---> Outline: convex pieces
//! ```
//!
//! # Why they push
//!
//! An [`Outline`] pushes its points into a sink, from the start, as often as it is asked: the walk is a plain loop
//! whose state is in registers and on the stack, and ends with it. A cursor that is pulled would have to carry the
//! state of a path, a dash, a join and a curve in each of its copies (some 300 bytes for a dashed stroke), so an edge
//! table that keeps a cursor for each active chain would need more memory than one that keeps the edges. What a table
//! may want to keep instead of points are *curves*: [`OutlineSink::curve`] hands over a [`Curve`], less than 100 bytes
//! that can be walked again, from either end, to the same points. A sink that does not care gets its points.
//!
//! What it costs: who needs an outline in bands of rows walks it once for each, and skips what lies outside by the
//! [extent](Outline::extent) of the whole and the [hull](Curve::rows) of each curve.

mod curve;
mod fine;
mod flatten;

pub use curve::{Curve, CurvePoints};
pub use fine::{FinePoint, FineRect};
pub(crate) use fine::{Vector, clamp_fine, divide_half_even, shift_half_even};
pub use flatten::Flattened;

/// Closed contours of points with 12 fraction bits (1/4096 pixel), made on the fly, as often as asked.
///
/// Coordinates are within ±2^31 (524288 pixels): what lies beyond is drawn in to there.
pub trait Outline {
    /// Calls `point` for each vertex of each contour in order, and `close` after each contour; starts afresh at each
    /// call, and always makes the same points.
    fn emit<S: OutlineSink>(&self, sink: &mut S);

    /// A rectangle that no point is outside of, without walking the outline where it is cheaper to know. Empty
    /// outlines may have any.
    fn extent(&self) -> FineRect {
        let mut extent = FineRect::EMPTY;
        self.emit(&mut extent);
        extent
    }

    /// How many points and contours it has: what a sink that stores them needs. Walks the outline.
    fn count(&self) -> OutlineCount {
        let mut count = OutlineCount::default();
        self.emit(&mut count);
        count
    }
}

/// Receives the points of an [`Outline`].
pub trait OutlineSink {
    /// The next vertex of the contour, in 1/4096 pixel.
    fn point(&mut self, x: i64, y: i64);

    /// The contour's last vertex is joined to its first. It may have any number of points.
    fn close(&mut self);

    /// The next vertices of the contour, as a curve that starts at its last point.
    #[inline]
    fn curve(&mut self, curve: &Curve) {
        for FinePoint { x, y } in curve.points() {
            self.point(x.into(), y.into());
        }
    }
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
    fn emit<S: OutlineSink>(&self, sink: &mut S) {
        (**self).emit(sink);
    }

    fn extent(&self) -> FineRect {
        (**self).extent()
    }
}

/// Lines and curves, open or closed: what can be filled and stroked.
pub trait Curves {
    /// Tells the sink each subpath in order: its start, its lines and curves, and whether it is closed. Starts afresh
    /// at each call.
    fn trace<S: CurveSink>(&self, sink: &mut S);

    /// The inside, by whichever rule it is drawn: open subpaths are closed by a line.
    #[inline]
    fn outline(&self) -> Flattened<'_, Self> {
        Flattened(self)
    }
}

impl<C: Curves> Curves for &C {
    fn trace<S: CurveSink>(&self, sink: &mut S) {
        (**self).trace(sink);
    }
}

/// Receives the lines and curves of a path.
pub trait CurveSink {
    /// A subpath starts here.
    fn start(&mut self, at: FinePoint);

    /// A line from where the last one ended.
    fn line(&mut self, to: FinePoint);

    /// A curve from where the last one ended.
    fn curve(&mut self, curve: &Curve);

    /// The subpath ends: joined to its start by a line and a corner, or as it is.
    fn end(&mut self, is_closed: bool);
}
