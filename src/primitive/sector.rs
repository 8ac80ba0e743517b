//! Sectors of discs and of rings: pies, gauges.
//!
//! A sector is cut out by two rays. A centre belongs to the side after a ray that it lies on, so sectors that share a
//! ray share no pixel and leave none out. The rays' directions are sine and cosine in 2^-30; from there on everything
//! is exact.

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    Angle, PixelRect, Vertex,
    outline::{Curve, Curves, FinePoint, Step, Vector},
    primitive::{
        ring::Ring,
        rows::{centre_of, centres, circle_axes, send_rows, shape_by_rows},
    },
    span::RowSink,
};

/// Further than any column.
const FAR: i32 = 1 << 26;

/// The points after the ray at an angle, by less than half a turn: those with `cos dy - sin dx >= 0`.
#[derive(Debug, Clone, Copy)]
struct HalfPlane {
    sin: i64,
    cos: i64,
}

impl HalfPlane {
    fn after(angle: Angle) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin: sin.into(), cos: cos.into() }
    }

    /// The columns of a row that is `dy` from the centre, which is at `x`.
    fn columns(&self, x: i64, dy: i64) -> Range<i32> {
        // sin dx <= cos dy, at most 2^62.
        let rest = self.cos * dy;
        let in_columns = |dx: i64| x + dx.clamp(-(1 << 33), 1 << 33);
        if self.sin > 0 {
            -FAR..centres(0..in_columns(rest.div_euclid(self.sin)) + 1).end
        } else if self.sin < 0 {
            // dx >= cos dy / sin: the least whole number that is.
            let least = -(rest.div_euclid(-self.sin));
            centres(in_columns(least)..0).start..FAR
        } else if rest >= 0 {
            -FAR..FAR
        } else {
            0..0
        }
    }
}

/// A wedge from one angle clockwise to another.
#[derive(Debug, Clone, Copy)]
struct Wedge {
    start: Angle,
    sweep: Angle,
    after_start: HalfPlane,
    after_end: HalfPlane,
    /// It is less than half a turn wide.
    is_narrow: bool,
}

impl Wedge {
    fn new(start: Angle, sweep: Angle) -> Self {
        Self {
            start,
            sweep,
            after_start: HalfPlane::after(start),
            after_end: HalfPlane::after(start + sweep),
            is_narrow: sweep < Angle::HALF,
        }
    }

    fn holds(&self, angle: Angle) -> bool {
        angle - self.start < self.sweep
    }

    /// Up to two ranges of a row's columns.
    fn columns(&self, x: i64, dy: i64) -> [Range<i32>; 2] {
        if dy == 0 {
            // Rays of both directions lie in this row. The centre belongs to the right.
            let middle = centres(x..x).start;
            let part = |angle: Angle, range: Range<i32>| if self.holds(angle) { range } else { 0..0 };
            return [part(Angle::HALF, -FAR..middle), part(Angle::ZERO, middle..FAR)];
        }
        let start = self.after_start.columns(x, dy);
        let end = self.after_end.columns(x, dy);
        // What is not after the end lies before it.
        let before_end = complement(&end);
        if self.sweep == Angle::HALF {
            // Both rays lie on one line, and the first alone belongs to the sector: this row meets that, or the last.
            if dy.signum() == self.after_start.sin.signum() { [start, 0..0] } else { before_end }
        } else if self.is_narrow {
            before_end.map(|before| start.start.max(before.start)..start.end.min(before.end))
        } else {
            // Not both before the start and after the end.
            let [one, other] = complement(&start);
            let out = if one.is_empty() { other } else { one };
            complement(&(out.start.max(end.start)..out.end.min(end.end)))
        }
    }
}

fn complement(range: &Range<i32>) -> [Range<i32>; 2] {
    if range.is_empty() { [-FAR..FAR, 0..0] } else { [-FAR..range.start, range.end..FAR] }
}

/// A sector of a disc: a piece of pie.
///
/// It goes from an angle clockwise, by less than a whole turn; a sweep of 0 is nothing, and a whole turn is a
/// [`Circle`](crate::Circle). A pixel belongs to it when its centre is nearer to the middle than the radius, and not
/// before the first ray and before the last: sectors that follow each other share no pixel and leave none out. The tip
/// itself belongs to the sector that looks to the right.
///
/// # Cost
///
/// A square root and two divisions a row.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Angle, I24F8, Sector, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let quarter = Sector::new(Vertex::new(0, 0), I24F8::lit("4"), Angle::ZERO, Angle::QUARTER);
/// quarter.filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["####", "####", "### ", "##  "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Sector {
    /// Its tip.
    pub center: Vertex,
    /// Its radius.
    pub radius: I24F8,
    /// Its first ray.
    pub start: Angle,
    /// How far it goes, clockwise.
    pub sweep: Angle,
}

impl Sector {
    /// A sector from an angle, clockwise.
    #[inline]
    pub const fn new(center: Vertex, radius: I24F8, start: Angle, sweep: Angle) -> Self {
        Self { center, radius, start, sweep }
    }

    const fn arc(&self) -> Arc {
        let Self { center, radius, start, sweep } = *self;
        Arc { center, outer: radius, inner: I24F8::ZERO, start, sweep }
    }

    fn pixel_bounds(&self) -> PixelRect {
        self.arc().pixel_bounds()
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        self.arc().send(clip, sink)
    }
}

shape_by_rows!(Sector);

impl Curves for Sector {
    fn steps(&self) -> u32 {
        self.arc().steps()
    }

    fn step(&self, index: u32) -> Step {
        self.arc().step(index)
    }
}

/// A piece of a ring, cut off along its rays: a gauge.
///
/// As [`Sector`], between two radii. For one with round ends, stroke its [`center_line`](Self::center_line).
///
/// # Cost
///
/// Two square roots and two divisions a row.
///
/// # Examples
///
/// ```
/// use spanfill::{Angle, Arc, Cap, I24F8, Outline as _, Stroke, StrokeStyle, Vertex};
///
/// let gauge = Arc::new(Vertex::pixel(60, 60), I24F8::lit("50"), I24F8::lit("40"), Angle::degrees(150), Angle::degrees(240));
/// let round = Stroke::new(gauge.center_line(), StrokeStyle::pixels(10).cap(Cap::Round));
/// assert!(round.extent().high.y > gauge.extent().high.y);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Arc {
    /// The circles' centre.
    pub center: Vertex,
    /// Where it ends.
    pub outer: I24F8,
    /// Where it begins; zero or less is the centre.
    pub inner: I24F8,
    /// Its first ray.
    pub start: Angle,
    /// How far it goes, clockwise.
    pub sweep: Angle,
}

impl Arc {
    /// An arc between two radii, from an angle, clockwise.
    #[inline]
    pub const fn new(center: Vertex, outer: I24F8, inner: I24F8, start: Angle, sweep: Angle) -> Self {
        Self { center, outer, inner, start, sweep }
    }

    /// The open arc half way between its radii, to be stroked.
    #[inline]
    pub const fn center_line(&self) -> ArcLine {
        let inner = if self.inner.to_bits() > 0 { self.inner.to_bits() as i64 } else { 0 };
        let radius = (self.outer.to_bits() as i64 + inner) << 3;
        ArcLine { center: self.center, radius, start: self.start, sweep: self.sweep }
    }

    const fn ring(&self) -> Ring {
        Ring::new(self.center, self.outer, self.inner)
    }

    fn pixel_bounds(&self) -> PixelRect {
        if self.sweep == Angle::ZERO {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        self.ring().pixel_bounds()
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        let (ring, wedge) = (self.ring(), Wedge::new(self.start, self.sweep));
        let (x, y) = (i64::from(self.center.x.to_bits()), i64::from(self.center.y.to_bits()));
        send_rows(&self.pixel_bounds(), clip, sink, |row| {
            let [left, right] = ring.columns(row);
            let wedge = wedge.columns(x, centre_of(row) - y);
            let cut = |part: &Range<i32>, side: &Range<i32>| part.start.max(side.start)..part.end.min(side.end);
            let [one, other] = &wedge;
            [cut(&left, one), cut(&left, other), cut(&right, one), cut(&right, other)]
        })
    }
}

shape_by_rows!(Arc);

impl Curves for Arc {
    fn steps(&self) -> u32 {
        let (outer, inner) = (self.outer.to_bits(), self.inner.to_bits().max(0));
        if self.sweep == Angle::ZERO || outer <= inner { 0 } else { 5 }
    }

    fn step(&self, index: u32) -> Step {
        let (outer, inner) = (i64::from(self.outer.to_bits()), i64::from(self.inner.to_bits()).max(0));
        let line =
            |radius: i64| ArcLine { center: self.center, radius: radius << 4, start: self.start, sweep: self.sweep };
        let (outer, inner) = (line(outer).curve(), line(inner).curve().reversed());
        match index {
            0 => Step::Move(outer.from()),
            1 => Step::Curve(outer),
            2 => Step::Line(outer.to(), inner.from()),
            // A sector has no inner arc.
            3 if inner.from() == inner.to() => Step::Line(inner.from(), inner.to()),
            3 => Step::Curve(inner),
            _ => Step::Close(inner.to(), outer.from()),
        }
    }
}

/// Part of a circle, as a line: see [`Arc::center_line`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ArcLine {
    center: Vertex,
    /// In 1/4096 pixel.
    radius: i64,
    start: Angle,
    sweep: Angle,
}

impl ArcLine {
    fn curve(&self) -> Curve {
        let center = FinePoint::from_vertex(self.center);
        let end = |angle: Angle| {
            let (sin, cos) = angle.sin_cos();
            let part = |sine: i32| {
                // A radius of at most 2^35 times 2^30.
                let part = crate::outline::divide_half_even(i128::from(self.radius) * i128::from(sine), 1 << 30);
                i64::try_from(part).unwrap_or(0)
            };
            Vector::new(part(cos), part(sin)).from(center)
        };
        let (from, to) = (end(self.start), end(self.start + self.sweep));
        let axes = circle_axes(self.radius >> 4);
        Curve::arc(from, to, center, axes, self.start, self.sweep.to_bits().into())
    }
}

impl Curves for ArcLine {
    fn steps(&self) -> u32 {
        2
    }

    fn step(&self, index: u32) -> Step {
        let curve = self.curve();
        if index == 0 { Step::Move(curve.from()) } else { Step::Curve(curve) }
    }
}
