//! Rectangles: whole pixels, one `fill_solid` for the inside and one for each side of the stroke.

use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    layers::{draw_area, draw_layers},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    rows::draw_rows,
    styled::Primitive,
};

/// The box that the stroke ends at, and the one that is filled.
fn boxes(rectangle: &Rectangle, stroke: &Stroke) -> (PixelBox, PixelBox) {
    let pixels = PixelBox::new(rectangle.top_left, rectangle.size);
    (pixels.offset(stroke.outside()), pixels.offset(-stroke.inside()))
}

impl Primitive for Rectangle {
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let (outer, inner) = boxes(self, &paint.sides);
        draw_rows(&outer, paint, target, |row, parts| {
            let columns = if inner.has_row(row) { inner.columns() } else { 0..0 };
            parts.add_ring(outer.columns(), columns);
        })
    }

    fn draw_blended<D: DrawTarget, B: Blend<D> + Copy>(
        &self,
        paint: &Paint<D::Color>,
        blended: &Blended<B>,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D::Color: Mix,
    {
        if blended.opacity == 255 {
            // There are no partial pixels.
            return self.draw_aliased(paint, target);
        }
        let (outer, inner) = boxes(self, &paint.sides);
        match (paint.fill, paint.stroke) {
            (Some(fill), None) => draw_area(inner, fill, blended, target),
            _ => draw_layers(
                paint,
                blended,
                target,
                &outer.rectangle().into(),
                |clip, tile| tile.add(&outer, clip),
                |clip, tile| tile.add(&inner, clip),
            ),
        }
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        boxes(self, stroke).0.rectangle()
    }
}
