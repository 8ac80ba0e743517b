//! What lies between two circles of one centre.

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    PixelRect, Vertex,
    outline::{Curves, Step},
    primitive::rows::{centre_of, centres, circle, root_below, send_rows, shape_by_rows},
    span::RowSink,
};

/// What lies between two circles of one centre, with centre and radii in 1/256 pixel.
///
/// A pixel belongs to it when its centre is nearer than the outer radius and not nearer than the inner: rings whose
/// radii meet share no pixel and leave none out, and one of no inner radius is a [`Circle`](crate::Circle).
///
/// # Cost
///
/// Two square roots a row.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{I24F8, Ring, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Ring::new(Vertex::pixel(3, 3), I24F8::lit("3.5"), I24F8::lit("1.5")).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["  ###  ", " ##### ", "##   ##", "##   ##", "##   ##", " ##### ", "  ###  "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ring {
    /// The centre.
    pub center: Vertex,
    /// Where it ends.
    pub outer: I24F8,
    /// Where it starts; zero or less is the centre.
    pub inner: I24F8,
}

impl Ring {
    /// A ring between two radii.
    #[inline]
    pub const fn new(center: Vertex, outer: I24F8, inner: I24F8) -> Self {
        Self { center, outer, inner }
    }

    pub(super) fn pixel_bounds(&self) -> PixelRect {
        let reach = i64::from(self.outer.to_bits()) - 1;
        let pixels = |center: I24F8| {
            let center = i64::from(center.to_bits());
            if reach < 0 || self.inner >= self.outer { 0..0 } else { centres(center - reach..center + reach + 1) }
        };
        PixelRect { rows: pixels(self.center.y), columns: pixels(self.center.x) }
    }

    /// The columns of a row within a radius.
    fn within(&self, radius: I24F8, row: i32) -> Range<i32> {
        let (x, radius) = (i64::from(self.center.x.to_bits()), i64::from(radius.to_bits()));
        let dy = centre_of(row) - i64::from(self.center.y.to_bits());
        if radius <= 0 {
            return 0..0;
        }
        match root_below(i128::from(radius - dy) * i128::from(radius + dy)) {
            Some(reach) => centres(x - reach..x + reach + 1),
            None => 0..0,
        }
    }

    /// To the left of what is left out, and to the right.
    pub(super) fn columns(&self, row: i32) -> [Range<i32>; 2] {
        let outer = self.within(self.outer, row);
        let inner = self.within(self.inner, row);
        if inner.is_empty() { [outer, 0..0] } else { [outer.start..inner.start, inner.end..outer.end] }
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        send_rows(&self.pixel_bounds(), clip, sink, |row| self.columns(row))
    }
}

shape_by_rows!(Ring);

impl Curves for Ring {
    fn steps(&self) -> u32 {
        match self.inner.to_bits() {
            inner if self.outer.to_bits() <= inner.max(0) => 0,
            1.. => 6,
            _ => 3,
        }
    }

    fn step(&self, index: u32) -> Step {
        let is_outer = index < 3;
        let radius = if is_outer { self.outer } else { self.inner };
        let curve = circle(self.center, radius.to_bits().into(), is_outer);
        match index % 3 {
            0 => Step::Move(curve.from()),
            1 => Step::Curve(curve),
            _ => Step::Close(curve.to(), curve.from()),
        }
    }
}
