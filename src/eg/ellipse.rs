//! Ellipses: embedded-graphics' pixels, and polygons where they are blended.

use embedded_graphics::primitives::Ellipse;
use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    curve::Curve,
    outline::{Layer, draw_outlines, push_ellipse},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    rows::draw_rows,
    styled::Primitive,
};

/// The box of the ellipse that the stroke ends at, and of the one that is filled.
fn boxes(ellipse: &Ellipse, stroke: &Stroke) -> (PixelBox, PixelBox) {
    let pixels = PixelBox::new(ellipse.top_left, ellipse.size);
    (pixels.offset(stroke.outside()), pixels.offset(-stroke.inside()))
}

impl Primitive for Ellipse {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let (outer, inner) = boxes(self, &paint.sides);
        let (x, y) = outer.center_2x();
        let mut outline = Curve::new(outer.width, outer.height);
        let mut filled = Curve::new(inner.width, inner.height);
        draw_rows(&outer, paint, target, |row, parts| {
            parts.add_ring(outline.columns(2 * row - y, x), filled.columns(2 * row - y, x));
        })
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
        let (outer, inner) = boxes(self, &paint.sides);
        if !outer.can_be_blended() {
            return self.draw_aliased(paint, target);
        }
        draw_outlines(paint, blended, target, &outer, |outline, room, layer| {
            push_ellipse(outline, room, if layer == Layer::Outer { &outer } else { &inner });
        })
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        boxes(self, stroke).0.rectangle()
    }
}
