//! Rectangles: whole pixels, one `fill_solid` for the inside and one for each side of the stroke.

use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use crate::{Blend, Mix, PixelRect};

use super::{
    Blended,
    layers::{draw_area, draw_layers},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    styled::Primitive,
};

/// The box that the stroke ends at, and the one that is filled.
fn boxes(rectangle: &Rectangle, stroke: &Stroke) -> (PixelBox, PixelBox) {
    let pixels = PixelBox::new(rectangle.top_left, rectangle.size);
    (pixels.offset(stroke.outside()), pixels.offset(-stroke.inside()))
}

/// What of a box the target shows.
pub(super) fn fill_box<D: DrawTarget>(pixels: &PixelBox, colour: D::Color, target: &mut D) -> Result<(), D::Error> {
    let PixelRect { rows, columns } = pixels.visible(&target.bounding_box().into());
    if rows.is_empty() || columns.is_empty() {
        return Ok(());
    }
    target.fill_solid(&PixelRect { rows, columns }.into(), colour)
}

impl Primitive for Rectangle {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let (outer, inner) = boxes(self, &paint.sides);
        if let Some(fill) = paint.fill {
            fill_box(&inner, fill, target)?;
        }
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if inner.is_empty() {
            return fill_box(&outer, stroke, target);
        }
        let (above, left) = (inner.top - outer.top, inner.left - outer.left);
        let beside = PixelBox { width: left, ..PixelBox { left: outer.left, ..inner } };
        fill_box(&PixelBox { height: above, ..outer }, stroke, target)?;
        fill_box(&beside, stroke, target)?;
        let right = inner.left + inner.width;
        fill_box(&PixelBox { left: right, width: outer.left + outer.width - right, ..beside }, stroke, target)?;
        let below = inner.top + inner.height;
        fill_box(&PixelBox { top: below, height: outer.top + outer.height - below, ..outer }, stroke, target)
    }

    fn draw_blended<D: DrawTarget, B: Blend<D>>(
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
