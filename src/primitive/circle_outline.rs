//! The outline of a circle, one pixel wide: Bresenham's circle, for any centre and radius.

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    PixelRect, Vertex,
    primitive::rows::{centre_of, centres, root_below, send_rows},
    span::RowSink,
};

/// The outline of a circle, one pixel wide, with its centre and radius in 1/256 pixel.
///
/// Where the circle is flatter than a diagonal it has, in each column, the pixel that the circle crosses the middle of
/// the column in; where it is steeper, in each row. A crossing just between two pixels belongs to the inner one. Each
/// pixel comes once; pixels touch at least by a corner. A radius of zero or less draws nothing.
///
/// ```text
///     . . # # # . .
///     . # . . . # .
///     # . . . . . #
///     # . . + . . #       radius 3 around a pixel's centre
///     # . . . . . #
///     . # . . . # .
///     . . # # # . .
/// ```
///
/// # Cost
///
/// Up to five square roots a row.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{CircleOutline, I24F8, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// CircleOutline::new(Vertex::pixel(3, 3), I24F8::lit("3")).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["  ###  ", " #   # ", "#     #", "#     #", "#     #", " #   # ", "  ###  "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct CircleOutline {
    /// The centre.
    pub center: Vertex,
    /// The radius.
    pub radius: I24F8,
}

impl CircleOutline {
    /// An outline of a circle.
    #[inline]
    pub const fn new(center: Vertex, radius: I24F8) -> Self {
        Self { center, radius }
    }

    fn pixel_bounds(&self) -> PixelRect {
        let radius = i64::from(self.radius.to_bits());
        let pixels = |center: I24F8| {
            let center = i64::from(center.to_bits());
            if radius <= 0 { 0..0 } else { centres(center - radius - 128..center + radius + 129) }
        };
        PixelRect { rows: pixels(self.center.y), columns: pixels(self.center.x) }
    }

    /// The flat parts of a row and the steep one, each left and right.
    ///
    /// With `s` the circle's height over the middle of a column, a flat pixel at height `t` has `t - 128 < s <= t +
    /// 128`, and is at least as high as far from the middle; so has a steep one with both exchanged.
    fn columns(&self, row: i32) -> [Range<i32>; 4] {
        let (x, radius) = (i64::from(self.center.x.to_bits()), i64::from(self.radius.to_bits()));
        let height = (centre_of(row) - i64::from(self.center.y.to_bits())).abs();
        let square = i128::from(radius) * i128::from(radius);
        let less = |value: i64| square - i128::from(value.max(0)) * i128::from(value.max(0));
        // dx^2 < r^2 - (t - 128)^2, or up to r^2 itself, and dx^2 >= r^2 - (t + 128)^2; dx <= t.
        let far = if height < 128 { root_below(square + 1) } else { root_below(less(height - 128)) };
        let near = root_below(less(height + 128)).map_or(0, |below| below + 1);
        let (left, right) = match far.map(|far| far.min(height)) {
            Some(far) if near == 0 => (centres(x - far..x + far + 1), 0..0),
            Some(far) if near <= far => (centres(x - far..x - near + 1), centres(x + near..x + far + 1)),
            _ => (0..0, 0..0),
        };
        // The pixels whose middle is nearest to the circle, the outer one where it is half way, in columns as far as
        // high.
        let (mut steep_left, mut steep_right) = (0..0, 0..0);
        if let Some(wide) = root_below(less(height) + 1).filter(|_| height <= radius) {
            // t - 128 < s <= t + 128 for s the root itself, of which `wide` is the whole part: columns from s - 128 up.
            let is_whole = i128::from(wide) * i128::from(wide) == less(height);
            let first = wide - 128 + i64::from(!is_whole);
            let column = centres(x + first..x + first + 256);
            if centre_of(column.start) - x >= height {
                steep_right = column;
            }
            let column = centres(x - first - 255..x - first + 1);
            if x - centre_of(column.start) >= height {
                steep_left = column;
            }
        }
        [steep_left, left, right, steep_right]
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        send_rows(&self.pixel_bounds(), clip, sink, |row| {
            let [a, b, c, d] = self.columns(row);
            // The steep pixels may be among the flat ones, or beside them, on either side.
            let join = |a: &Range<i32>, b: &Range<i32>| match (a.is_empty(), b.is_empty()) {
                (true, _) => [b.clone(), 0..0],
                (_, true) => [a.clone(), 0..0],
                _ if a.start > b.end || b.start > a.end => {
                    if a.start < b.start {
                        [a.clone(), b.clone()]
                    } else {
                        [b.clone(), a.clone()]
                    }
                }
                _ => [a.start.min(b.start)..a.end.max(b.end), 0..0],
            };
            let [[a, b], [c, d]] = [join(&a, &b), join(&c, &d)];
            [a, b, c, d]
        })
    }
}

impl crate::shape::Shape for CircleOutline {
    fn bounds(&self) -> PixelRect {
        self.pixel_bounds()
    }

    fn spans<S: crate::SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.send(clip, &mut crate::span::EachSpan(sink))
    }

    fn blocks<S: crate::BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        crate::span::MergeRows::merged(sink, |merge| self.send(clip, merge))
    }
}
