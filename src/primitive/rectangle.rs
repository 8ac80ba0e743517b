//! Upright rectangle with its sides in 1/256 pixel.

use crate::{
    PixelRect, Vertex,
    outline::{Curves, FinePoint, Step},
    primitive::rows::{centres, polygon_step, send_rows, shape_by_rows},
    span::RowSink,
};

/// An upright rectangle with its sides in 1/256 pixel.
///
/// Every coordinate is legal. A pixel belongs to it when its centre does, and centres on its left and upper side do:
/// rectangles that share a side share no pixel, and leave none out.
///
/// # Cost
///
/// Additions.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Rectangle, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Rectangle::new(Vertex::new(0.5, 0.75), Vertex::new(3.25, 2.6)).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["    ", "### ", "### "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rectangle {
    /// The upper left corner.
    pub low: Vertex,
    /// The lower right corner.
    pub high: Vertex,
}

impl Rectangle {
    /// A rectangle between opposite corners, whichever they are.
    pub fn new(corner: Vertex, opposite: Vertex) -> Self {
        Self {
            low: Vertex { x: corner.x.min(opposite.x), y: corner.y.min(opposite.y) },
            high: Vertex { x: corner.x.max(opposite.x), y: corner.y.max(opposite.y) },
        }
    }

    fn pixel_bounds(&self) -> PixelRect {
        let pixels = |low: i32, high: i32| centres(i64::from(low)..i64::from(high));
        PixelRect {
            rows: pixels(self.low.y.to_bits(), self.high.y.to_bits()),
            columns: pixels(self.low.x.to_bits(), self.high.x.to_bits()),
        }
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        let bounds = self.pixel_bounds();
        send_rows(&bounds, clip, sink, |_| [bounds.columns.clone()])
    }
}

shape_by_rows!(Rectangle);

impl Curves for Rectangle {
    fn steps(&self) -> u32 {
        5
    }

    fn step(&self, index: u32) -> Step {
        let (low, high) = (FinePoint::from_vertex(self.low), FinePoint::from_vertex(self.high));
        let corner = FinePoint::from_bits;
        polygon_step(&[low, corner(high.x, low.y), high, corner(low.x, high.y)], index)
    }
}
