//! Lines that get thinner: hands and needles, in one piece if wanted.

use core::ops::Range;

use crate::{
    BlockSink, Line, PixelRect, Vertex,
    outline::{Curves, FinePoint, Step, Vector, clamp_fine},
    primitive::quadrilateral::Quadrilateral,
    primitive::rows::{polygon_step, send_rows, shape_by_rows},
    shape::Shape as _,
    span::RowSink,
};

/// A line from one width to another, with its ends and widths in 1/256 pixel: a hand of a clock, a needle.
///
/// ```text
///       .-----____
///      from       to        cut off square at both ends
///       '-----´´´´
/// ```
///
/// A pixel belongs to it when its centre does, to 1/256 pixel. Where it is thinner than a pixel, that leaves gaps: the
/// centres of a row may all miss it. [`connected`](Self::connected) adds the pixels of its middle line, as [`Line`]
/// has them, and so keeps it in one piece at every angle.
///
/// # Cost
///
/// Four divisions a row, and those of [`Line`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{TaperedLine, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let needle = TaperedLine::new(Vertex::pixel(0, 1), Vertex::pixel(9, 3), [384, 100]).connected();
/// needle.filled(BinaryColor::On).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TaperedLine {
    /// The middle of one end.
    pub from: Vertex,
    /// The middle of the other.
    pub to: Vertex,
    /// Its width there and here, in 1/256 pixel.
    pub widths: [u32; 2],
    /// Whether the pixels of the middle line are added.
    pub is_connected: bool,
}

impl TaperedLine {
    /// A line with a width at either end.
    #[inline]
    pub const fn new(from: Vertex, to: Vertex, widths: [u32; 2]) -> Self {
        Self { from, to, widths, is_connected: false }
    }

    /// The same with the pixels of its middle line.
    #[inline]
    #[must_use]
    pub const fn connected(self) -> Self {
        Self { is_connected: true, ..self }
    }

    /// Its corners in order, in 1/4096 pixel; all the same where it has no length.
    fn fine_corners(&self) -> [FinePoint; 4] {
        let (from, to) = (FinePoint::from_vertex(self.from), FinePoint::from_vertex(self.to));
        let Vector { x, y } = Vector::between(from, to);
        let length = (i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y)).unsigned_abs();
        // With eight bits more.
        let length = (length << 16).isqrt().cast_signed();
        let [at_from, at_to] = self.widths.map(|width| {
            let half = |along: i64| {
                let product = (i128::from(along) * i128::from(width)) << (3 + 8);
                let half = crate::outline::divide_half_even(product, length);
                i64::from(clamp_fine(i64::try_from(half).unwrap_or(0)))
            };
            Vector::new(half(-y), half(x))
        });
        let back = |vector: Vector, point: FinePoint| Vector::default().minus(vector).from(point);
        [at_from.from(from), at_to.from(to), back(at_to, to), back(at_from, from)]
    }

    fn line(&self) -> Line {
        Line { start: self.from, end: self.to }
    }

    /// Of the vertices of the polygon alone.
    fn polygon_bounds(&self) -> PixelRect {
        let corners = self.fine_corners().map(FinePoint::to_vertex);
        Quadrilateral(corners).bounds()
    }

    fn pixel_bounds(&self) -> PixelRect {
        let bounds = self.polygon_bounds();
        if !self.is_connected {
            return bounds;
        }
        let line = self.line().bounds();
        let around = |a: &Range<i32>, b: &Range<i32>| {
            if a.is_empty() { b.clone() } else { a.start.min(b.start)..a.end.max(b.end) }
        };
        PixelRect { rows: around(&bounds.rows, &line.rows), columns: around(&bounds.columns, &line.columns) }
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        let corners = self.fine_corners().map(FinePoint::to_vertex);
        let sides = Quadrilateral(corners);
        send_rows(&self.pixel_bounds(), clip, sink, |row| {
            let clip = PixelRect { rows: row..row + 1, columns: clip.columns.clone() };
            // Both have one span a row, and these touch: the middle line's pixel is the one nearest to where the sides
            // go by.
            let mut around = Around(0..0);
            let Ok(()) = sides.blocks(&clip, &mut around);
            if self.is_connected {
                let Ok(()) = self.line().blocks(&clip, &mut around);
            }
            [around.0]
        })
    }
}

/// From the first column to the last of what it is sent.
struct Around(Range<i32>);

impl BlockSink for Around {
    type Error = core::convert::Infallible;

    fn block(&mut self, _: Range<i32>, columns: Range<i32>) -> Result<(), Self::Error> {
        self.0 = if self.0.is_empty() { columns } else { self.0.start.min(columns.start)..self.0.end.max(columns.end) };
        Ok(())
    }
}

shape_by_rows!(TaperedLine);

impl Curves for TaperedLine {
    fn steps(&self) -> u32 {
        5
    }

    fn step(&self, index: u32) -> Step {
        polygon_step(&self.fine_corners(), index)
    }
}
