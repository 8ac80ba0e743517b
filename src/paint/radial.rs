//! Gradients around a point.
//!
//! With `u` and `v` the planes over the screen that are 1 at the ends of the ellipse's two half axes, the place of a
//! pixel is `hypot(u, v)`. With a focus it is the `t` of the circle `|p - f - t e| = r + t (1 - r)` that goes through
//! the pixel, where `e` leads from the focus `f` to the middle. Circles of that family shrink to a point, `a = f - e r
//! / (1 - r)`, and with `d` the way from there to the pixel, along and across `e`, and `R = 1 - r`, `A = R^2 - e^2`,
//!
//! ```text
//!   t = hypot(R along / A, across / sqrt A) - (d . e) / A - r / R
//! ```
//!
//! which is two planes under a root, and one beside it: a focus costs an addition a pixel.

use fixed::{traits::ToFixed, types::I24F8};

use crate::{
    Vertex,
    attribute::Channels,
    paint::{
        Paint, Stops,
        plane::{Places, Plane, SLOPE_BITS, Slope, difference, slope},
        stops::WHOLE,
    },
};

/// A gradient from a point outwards: to a circle, or to any ellipse.
///
/// The place of a pixel centre is its distance over the radius. A radius of 0 or less, or an ellipse without area, has
/// everything beyond its end: the last colour, as in SVG.
///
/// ```text
///         c b c
///       c b a b c
///         c b c
/// ```
///
/// # Cost
///
/// Divisions of 128 bits when it is made. A square root of 64 bits a pixel; then [`Stops`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, RadialGradient, Spread, Stop, Stops, Vertex, prelude::*};
///
/// let stops = [Stop::new(0, Gray8::WHITE), Stop::new(65536, Gray8::BLACK)];
/// let stops = Stops::new(&stops, Spread::Pad)?;
/// let glow = RadialGradient::new(Vertex::pixel(10, 10), 10, stops);
/// let mut display = MockDisplay::new();
/// Circle::new(Point::new(10, 10), 9).painted(glow).draw(&mut display).unwrap();
/// // 5 px away: 3 right, 4 down.
/// assert_eq!(display.get_pixel(Point::new(13, 14)), Some(Gray8::new(128)));
/// # Ok::<(), spanfill::BadStops>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct RadialGradient<'a, C, const N: usize> {
    centre: Vertex,
    /// `u` and `v` from the centre; none without an area.
    axes: Option<[Slope; 2]>,
    /// What the root is of, and what is taken from it.
    planes: [Plane; 3],
    stops: Stops<'a, C, N>,
}

/// Fraction bits of what is worked out once.
const BITS: u32 = 40;
const ONE: i128 = 1 << BITS;
/// 1024 gradients a pixel.
const STEEPEST: i64 = 1 << 50;
/// What a focus may be away from the middle, of the way to the rim; beyond, places near the rim would have no bits.
const FURTHEST: i128 = ONE / 256 * 255;

impl<'a, C: Channels<N>, const N: usize> RadialGradient<'a, C, N> {
    /// A gradient around a point, to a circle.
    pub fn new<R: ToFixed + Copy>(centre: Vertex, radius: R, stops: Stops<'a, C, N>) -> Self
    where
        I24F8: PartialOrd<R>,
    {
        let radius = i128::from(crate::geometry::saturate(radius).to_bits());
        let unit = slope(1 << SLOPE_BITS, radius);
        Self::with_axes(centre, (radius > 0).then_some([[unit, 0], [0, unit]]), stops)
    }

    /// A gradient around a point, to the ellipse that has these ends of two half axes: in general, what an affine
    /// transform makes of a circle's centre, its rightmost and its lowest point.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
    /// use spanfill::{RadialGradient, Spread, Stop, Stops, Triangle, Vertex, prelude::*};
    ///
    /// let stops = [Stop::new(0, Gray8::WHITE), Stop::new(65536, Gray8::BLACK)];
    /// let ends = [Vertex::pixel(10, 0), Vertex::pixel(0, 5)];
    /// let quarter = RadialGradient::elliptical(Vertex::pixel(0, 0), ends, Stops::new(&stops, Spread::Pad)?);
    /// let mut display = MockDisplay::new();
    /// Triangle::new(Point::new(0, 0), Point::new(9, 0), Point::new(0, 9)).painted(quarter).draw(&mut display).unwrap();
    /// assert_eq!(display.get_pixel(Point::new(4, 0)), display.get_pixel(Point::new(0, 2)));
    /// # Ok::<(), spanfill::BadStops>(())
    /// ```
    pub fn elliptical(centre: Vertex, ends: [Vertex; 2], stops: Stops<'a, C, N>) -> Self {
        let [[ax, ay], [bx, by]] = ends.map(|end| difference(centre, end));
        let area = ax * by - ay * bx;
        let over = |numerator: i128| slope(numerator << SLOPE_BITS, area);
        Self::with_axes(centre, (area != 0).then(|| [[over(by), over(-bx)], [over(-ay), over(ax)]]), stops)
    }

    fn with_axes(centre: Vertex, axes: Option<[Slope; 2]>, stops: Stops<'a, C, N>) -> Self {
        // A focus may make them steeper.
        let axes = axes.map(|axes| axes.map(|axis| axis.map(|part| part.clamp(-STEEPEST, STEEPEST))));
        let plane = |slope| Plane { origin: centre, offset: 0, slope };
        let [u, v] = axes.unwrap_or_default();
        Self { centre, axes, planes: [plane(u), plane(v), plane([0, 0])], stops }
    }

    /// The same with its start at another point, the focus, or on a circle around that, whose radius is given in
    /// 1/65536 of the gradient's own. On the way from there to the end, circles move towards the centre.
    ///
    /// The focus' circle has to lie within the gradient's: a focus that is too far out is moved inwards to 255/256 of
    /// the way, and a radius is at most 65280.
    ///
    /// ```text
    ///      .-------.
    ///     /  .---.  \
    ///    |  ( * ) |  |       * the focus
    ///     \  '---'  /
    ///      '-------'
    /// ```
    pub fn with_focus(mut self, focus: Vertex, radius: u32) -> Self {
        let Some([u, v]) = self.axes else { return self };
        let radius = i128::from(radius.min(0xff00)) << (BITS - 16);
        let rest = ONE - radius;
        let way = difference(focus, self.centre);
        let along = |[x, y]: Slope| {
            let [dx, dy] = way;
            ((i128::from(x) * dx + i128::from(y) * dy) >> (SLOPE_BITS - BITS)).clamp(-(1 << 50), 1 << 50)
        };
        let mut e = [along(u), along(v)];
        let furthest = (rest * FURTHEST) >> BITS;
        let length = |[x, y]: [i128; 2]| i128::try_from((x * x + y * y).unsigned_abs().isqrt()).unwrap_or(0);
        let far = length(e);
        if far > furthest {
            e = e.map(|e| e * furthest / far.max(1));
        }
        let [eu, ev] = e;
        let far = length(e);
        let square = eu * eu + ev * ev;
        // With twice the bits, its root, and with as many as products of slopes leave room for.
        let a = (rest * rest - square).max(1);
        let root = i128::try_from(a.unsigned_abs().isqrt()).unwrap_or(1);
        let a = a >> 20;
        let over = |numerator: i128, denominator: i128| numerator / denominator.max(1);
        // In 2^-88: slopes times `e`.
        let sum = |p: Slope, by: i128, q: Slope, and: i128| -> [i128; 2] {
            let ([px, py], [qx, qy]) = (p.map(i128::from), q.map(i128::from));
            [px * by + qx * and, py * by + qy * and]
        };
        let (towards, across) = (sum(u, eu, v, ev), sum(v, eu, u, -ev));
        let centre = self.centre;
        let plane = |offset: i128, slope| Plane { origin: centre, offset: i64::try_from(offset).unwrap_or(0), slope };
        let start = over(radius << 32, rest);
        self.planes = if far == 0 {
            let scaled = |axis: Slope| axis.map(|part| slope(i128::from(part) << BITS, rest));
            [plane(0, scaled(u)), plane(0, scaled(v)), plane(start, [0, 0])]
        } else {
            [
                plane(over(far << 52, a), towards.map(|part| slope((over(part, far) * rest) << 20, a))),
                plane(0, across.map(|part| slope(over(part, far) << BITS, root))),
                plane(
                    start + over(over((square >> 20) << 32, a) << BITS, rest),
                    towards.map(|part| slope(part << 20, a)),
                ),
            ]
        };
        self
    }
}

impl<C: Channels<N>, const N: usize> Paint<C> for RadialGradient<'_, C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let [u, v, beside] = self.planes.map(|plane| plane.row(row, column));
        // Without an area, all is beyond the end.
        let (beside, stops) = match self.axes {
            Some(_) => (beside, self.stops),
            None => (Places::alike(-WHOLE), self.stops.padded()),
        };
        let places = u.zip(v).zip(beside).map(|((u, v), beside)| hypot(u, v).saturating_sub(beside));
        stops.colours(row, column, places)
    }
}

/// `sqrt(u^2 + v^2)`, cut off: 31 bits of it are right.
#[inline]
fn hypot(u: i64, v: i64) -> i64 {
    let (u, v) = (u.unsigned_abs(), v.unsigned_abs());
    let shift = (u64::BITS - 31).saturating_sub((u | v).leading_zeros());
    let (u, v) = (u >> shift, v >> shift);
    i64::try_from((u * u + v * v).isqrt() << shift).unwrap_or(i64::MAX)
}
