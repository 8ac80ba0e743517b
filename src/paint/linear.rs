//! Gradients along a line.

use crate::{
    Vertex,
    attribute::Channels,
    paint::{
        Paint, Stops,
        plane::{Places, Plane, SLOPE_BITS, difference, slope},
        stops::WHOLE,
    },
};

/// A gradient from one point to another: the place of a pixel centre is that of its foot on the line through both.
///
/// `t = ((P - P0) . d) / |d|^2`, `d` from the start to the end. Where they are the same point, everything is beyond the
/// end: the last colour, as in SVG.
///
/// ```text
///      start * a a b b c c * end
///              a a b b c c           alike across the line
/// ```
///
/// # Cost
///
/// Two divisions of 128 bits when it is made; then [`Stops`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{LinearGradient, Spread, Stop, Stops, Triangle, Vertex, prelude::*};
///
/// let stops = [Stop::new(0, Gray4::BLACK), Stop::new(65536, Gray4::WHITE)];
/// let stops = Stops::new(&stops, Spread::Pad)?;
/// let across = LinearGradient::new(Vertex::pixel(0, 0), Vertex::pixel(5, 0), stops);
/// let mut display = MockDisplay::new();
/// Triangle::new(Point::new(0, 0), Point::new(6, 0), Point::new(0, 6)).painted(across).draw(&mut display).unwrap();
/// display.assert_pattern(&["0369CF", "0369C ", "0369  ", "036   ", "03    ", "0     "]);
/// # Ok::<(), spanfill::BadStops>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LinearGradient<'a, C, const N: usize> {
    /// None where start and end are one point.
    plane: Option<Plane>,
    stops: Stops<'a, C, N>,
}

impl<'a, C: Channels<N>, const N: usize> LinearGradient<'a, C, N> {
    /// A gradient between two points.
    pub fn new(start: Vertex, end: Vertex, stops: Stops<'a, C, N>) -> Self {
        let d = difference(start, end);
        let [dx, dy] = d;
        let square = dx * dx + dy * dy;
        let plane =
            (square > 0).then(|| Plane { origin: start, offset: 0, slope: d.map(|d| slope(d << SLOPE_BITS, square)) });
        Self { plane, stops }
    }
}

impl<C: Channels<N>, const N: usize> Paint<C> for LinearGradient<'_, C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        match &self.plane {
            Some(plane) => self.stops.colours(row, column, plane.row(row, column)),
            None => self.stops.padded().colours(row, column, Places::alike(WHOLE)),
        }
    }
}
