//! Gradients around a point.

use crate::{
    Vertex,
    attribute::Channels,
    paint::{Paint, Stops, stops::WHOLE},
    subpixel::centre,
};
use fixed::{traits::ToFixed, types::I24F8};

/// A gradient from a point outwards, to a radius: the place of a pixel centre is its distance over the radius.
///
/// A radius of 0 or less has everything beyond its end: the last colour, as in SVG. The centre is at most 2^23 px from
/// what is painted; what is further is beyond the end.
///
/// ```text
///         c b c
///       c b a b c
///         c b c
/// ```
///
/// # Cost
///
/// A square root of 64 bits a pixel; then [`Stops`].
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
    /// `2^56` over the radius in sub-pixels, 0 for none.
    inverse: u64,
    stops: Stops<'a, C, N>,
}

impl<'a, C: Channels<N>, const N: usize> RadialGradient<'a, C, N> {
    /// A gradient around a point.
    pub fn new<R: ToFixed + Copy>(centre: Vertex, radius: R, stops: Stops<'a, C, N>) -> Self
    where
        I24F8: PartialOrd<R>,
    {
        let radius = crate::geometry::saturate(radius).to_bits();
        let inverse = u64::try_from(radius).map_or(0, |radius| if radius == 0 { 0 } else { (1 << 56) / radius.max(1) });
        Self { centre, inverse, stops }
    }
}

impl<C: Channels<N>, const N: usize> Paint<C> for RadialGradient<'_, C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let y = u64::from(centre(row).abs_diff(self.centre.y.to_bits()));
        let (inverse, middle) = (self.inverse, self.centre.x.to_bits());
        let mut next = column;
        let places = core::iter::from_fn(move || {
            let x = u64::from(centre(next).abs_diff(middle));
            next = next.wrapping_add(1);
            Some(if inverse == 0 { WHOLE } else { place(distance(x, y), inverse) })
        });
        let stops = if inverse == 0 { self.stops.padded() } else { self.stops };
        stops.colours(row, column, places)
    }
}

/// `sqrt(x^2 + y^2)` in 1/256 of a sub-pixel, cut off; 2^32 sub-pixels and more are taken for that.
///
/// Near the centre the square has 16 more bits, and the root eight; further out they are fewer, and count for less.
#[inline]
fn distance(x: u64, y: u64) -> u64 {
    let square = (x * x).saturating_add(y * y);
    let bits = square.leading_zeros().min(16) & !1;
    (square << bits).isqrt() << ((16 - bits) / 2)
}

/// In `2^-32` of a gradient: `distance / 256 * inverse / 2^24`.
#[inline]
fn place(distance: u64, inverse: u64) -> i64 {
    let product = u128::from(distance) * u128::from(inverse);
    i64::try_from(product >> 32).unwrap_or(i64::MAX).min(WHOLE << 20)
}
