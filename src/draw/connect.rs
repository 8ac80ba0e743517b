//! The middle of a stroke, one pixel wide: what keeps thin strokes in one piece.

use core::ops::Range;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    BlockSink, Line, PixelRect, Vertex,
    outline::{Curves, FinePoint},
    shape::Shape,
    stroke::Stroke,
};

impl<C: Curves> Stroke<'_, C> {
    /// Draws the pixels of its middle line, of each dash by itself: whatever angle it is at, they touch at least by
    /// corners.
    ///
    /// A stroke of less than a pixel and a half has gaps without anti-aliasing, and dots with [`Dither`](crate::Dither).
    /// Drawn in the same colour before or after it, this closes them, and adds no more than the pixels of [`Line`] and those
    /// that the path's vertices lie in. Some are drawn more than once.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
    /// use spanfill::{Stroke, StrokeStyle, path};
    ///
    /// let hair = Stroke::new(path!("M.5.5l6 2"), StrokeStyle::new(128));
    /// let mut display = MockDisplay::new();
    /// display.set_allow_overdraw(true);
    /// hair.connect(BinaryColor::On, &mut display)?;
    /// display.assert_pattern(&["##     ", "  ###  ", "     ##"]);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    pub fn connect<D: DrawTarget>(&self, colour: D::Color, target: &mut D) -> Result<(), D::Error> {
        let clip = PixelRect::from(target.bounding_box());
        let mut sink = Pixels { target, colour };
        let mut result = Ok(());
        self.each_chord(&mut |from, to| {
            if result.is_ok() {
                result = chord(from, to, &clip, &mut sink);
            }
        });
        result
    }
}

/// The pixels of a line, and that of the vertex at its start.
///
/// A line that is flatter than a diagonal has pixels up to the column before that of its end, or to that: less than a
/// column and a row from it. So the pixel that the end lies in touches it, and, the same way, the line that goes on.
fn chord<S: BlockSink>(from: FinePoint, to: FinePoint, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [from, to] = [from, to].map(FinePoint::to_vertex);
    for Vertex { x, y } in [from, to] {
        let (column, row) = (x.to_bits() >> 8, y.to_bits() >> 8);
        if clip.columns.contains(&column) && clip.rows.contains(&row) {
            sink.block(row..row + 1, column..column + 1)?;
        }
    }
    Line { start: from, end: to }.blocks(clip, sink)
}

struct Pixels<'t, D: DrawTarget> {
    target: &'t mut D,
    colour: D::Color,
}

impl<D: DrawTarget> BlockSink for Pixels<'_, D> {
    type Error = D::Error;

    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), D::Error> {
        let size = Size::new(columns.end.abs_diff(columns.start), rows.end.abs_diff(rows.start));
        self.target.fill_solid(&Rectangle::new(Point::new(columns.start, rows.start), size), self.colour)
    }
}
