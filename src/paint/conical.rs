//! Gradients that turn around a point.

use crate::{
    Vertex,
    attribute::Channels,
    paint::{Paint, Stops},
    subpixel::centre,
};

/// A gradient that turns clockwise around a point: the place of a pixel centre is its angle, from the start on, over a
/// whole turn.
///
/// The start is given in 1/65536 of a turn, clockwise from the right: 0 right, 16384 down, 32768 left, 49152 up. A
/// pixel centre exactly at the gradient's own has the first colour.
///
/// ```text
///        d  e  f
///        c  *  a  <- start
///        c  b  a
/// ```
///
/// # Cost
///
/// A division of 64 bits and a look into a table of 520 bytes a pixel; then [`Stops`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, ConicalGradient, Spread, Stop, Stops, Vertex, prelude::*};
///
/// let stops = [Stop::new(0, Gray8::BLACK), Stop::new(65536, Gray8::WHITE)];
/// let stops = Stops::new(&stops, Spread::Pad)?;
/// let wheel = ConicalGradient::new(Vertex::pixel(10, 10), 0, stops);
/// let mut display = MockDisplay::new();
/// Circle::new(Point::new(10, 10), 9).painted(wheel).draw(&mut display).unwrap();
/// assert_eq!(display.get_pixel(Point::new(10, 15)), Some(Gray8::new(64)));
/// assert_eq!(display.get_pixel(Point::new(5, 10)), Some(Gray8::new(128)));
/// # Ok::<(), spanfill::BadStops>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ConicalGradient<'a, C, const N: usize> {
    centre: Vertex,
    start: u16,
    stops: Stops<'a, C, N>,
}

impl<'a, C: Channels<N>, const N: usize> ConicalGradient<'a, C, N> {
    /// A gradient around a point, from an angle on.
    #[inline]
    pub const fn new(centre: Vertex, start: u16, stops: Stops<'a, C, N>) -> Self {
        Self { centre, start, stops }
    }
}

impl<C: Channels<N>, const N: usize> Paint<C> for ConicalGradient<'_, C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let y = i64::from(centre(row)) - i64::from(self.centre.y.to_bits());
        let (start, middle) = (u32::from(self.start) << 16, self.centre.x.to_bits());
        let mut next = column;
        let places = core::iter::from_fn(move || {
            let x = i64::from(centre(next)) - i64::from(middle);
            next = next.wrapping_add(1);
            Some(if x == 0 && y == 0 { 0 } else { i64::from(turn(x, y).wrapping_sub(start)) })
        });
        self.stops.colours(row, column, places)
    }
}

/// Steps of the table.
const STEPS: usize = 128;

/// `atan(i / STEPS)` in `2^-32` of a turn.
static ARCTANGENTS: [u32; STEPS + 2] = arctangents();

/// The angle clockwise from the right, in `2^-32` of a turn.
///
/// Within its octant it is the arctangent of the smaller over the larger coordinate, from a table, and in a line
/// between: off by at most `(1/128)^2 / 8 * max |atan''| / 2 pi`, with `|atan''| <= 0.65`: 2^-20 of a turn.
fn turn(x: i64, y: i64) -> u32 {
    let (across, down) = (x.unsigned_abs(), y.unsigned_abs());
    let (less, more) = (across.min(down), across.max(down).max(1));
    // In 2^-24; distances have 33 bits.
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^24, as `less` is at most `more`")]
    let ratio = ((less << 24) / more) as usize;
    const FRACTION: u32 = 24 - STEPS.ilog2();
    let (index, fraction) = (ratio >> FRACTION, ratio & ((1 << FRACTION) - 1));
    let entry = |index: usize| u64::from(ARCTANGENTS.get(index).copied().unwrap_or_default());
    let step = entry(index + 1).saturating_sub(entry(index));
    #[allow(clippy::cast_possible_truncation, reason = "an eighth of 2^32, and a step")]
    let octant = (entry(index) + ((step * fraction as u64) >> FRACTION)) as u32;
    const QUARTER: u32 = 1 << 30;
    let quadrant = if down > across { QUARTER - octant } else { octant };
    match (x < 0, y < 0) {
        (false, false) => quadrant,
        (true, false) => (2 * QUARTER).wrapping_sub(quadrant),
        (true, true) => (2 * QUARTER).wrapping_add(quadrant),
        (false, true) => quadrant.wrapping_neg(),
    }
}

/// By Euler's series, `atan x = sum of 2^(2n) (n!)^2 / (2n+1)! x^(2n+1) / (1+x^2)^(n+1)`: each term is at most half of the
/// one before.
#[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
const fn arctangents() -> [u32; STEPS + 2] {
    let mut table = [0; STEPS + 2];
    let mut index = 0;
    while index < table.len() {
        let x = index as f64 / STEPS as f64;
        let mut term = x / (1.0 + x * x);
        let mut sum = 0.0;
        let mut n = 1.0;
        while n < 64.0 {
            sum += term;
            term *= 2.0 * n / (2.0 * n + 1.0) * x * x / (1.0 + x * x);
            n += 1.0;
        }
        let turns = sum / (2.0 * core::f64::consts::PI);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to a little over 1/8")]
        let entry = (turns * 4_294_967_296.0 + 0.5) as u32;
        table[index] = entry;
        index += 1;
    }
    table
}
