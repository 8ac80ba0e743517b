//! Gradients along a line.

use crate::{
    Vertex,
    attribute::Channels,
    paint::{
        Paint, Stops,
        stops::{Places, WHOLE},
    },
    subpixel::centre,
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
    start: Vertex,
    /// How the place changes with x and y, in `2^-48` of the gradient a sub-pixel: below `2^48 + 1`, as `|d|` is at
    /// least 1. None where `d` is 0.
    slope: Option<[i64; 2]>,
    stops: Stops<'a, C, N>,
}

impl<'a, C: Channels<N>, const N: usize> LinearGradient<'a, C, N> {
    /// A gradient between two points.
    pub fn new(start: Vertex, end: Vertex, stops: Stops<'a, C, N>) -> Self {
        let d = [
            i128::from(end.x.to_bits()) - i128::from(start.x.to_bits()),
            i128::from(end.y.to_bits()) - i128::from(start.y.to_bits()),
        ];
        let [dx, dy] = d;
        let square = dx * dx + dy * dy;
        let slope = (square > 0).then(|| {
            d.map(|d| {
                let doubled = ((d << 49) + square).div_euclid((2 * square).max(1));
                i64::try_from(doubled).unwrap_or(0)
            })
        });
        Self { start, slope, stops }
    }
}

impl<C: Channels<N>, const N: usize> Paint<C> for LinearGradient<'_, C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let Some([gx, gy]) = self.slope else {
            return self.stops.padded().colours(row, column, Places { at: WHOLE, step: 0 });
        };
        let x = i128::from(centre(column)) - i128::from(self.start.x.to_bits());
        let y = i128::from(centre(row)) - i128::from(self.start.y.to_bits());
        // Below 2^83: 2^48 times twice a distance of 2^33.
        let place = (i128::from(gx) * x + i128::from(gy) * y) >> 16;
        // Far beyond, no gradient has anything but its ends; repeated ones lose their phase.
        let reach = i128::from(WHOLE) << 20;
        let places = Places { at: i64::try_from(place.clamp(-reach, reach)).unwrap_or(0), step: (gx << 8) >> 16 };
        self.stops.colours(row, column, places)
    }
}
