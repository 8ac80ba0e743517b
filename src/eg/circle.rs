//! Circles: embedded-graphics' pixels, and the exact circle where they are blended.

use embedded_graphics::primitives::Circle;
use embedded_graphics_core::{Drawable, draw_target::DrawTarget, geometry::Size, primitives::Rectangle};

use crate::{Blend, Mix, Vertex, draw::Fill};

use super::{
    Blended,
    curve::Curve,
    layers::{draw_area, draw_layers},
    paint::{Paint, Stroke},
    pixel_box::{PixelBox, to_i32},
    rows::draw_rows,
    styled::Primitive,
};

/// The box of the circle that the stroke ends at, and of the one that is filled.
pub(super) fn boxes(circle: &Circle, stroke: &Stroke) -> (PixelBox, PixelBox) {
    let pixels = PixelBox::new(circle.top_left, Size::new_equal(circle.diameter));
    (pixels.offset(stroke.outside()), pixels.offset(-stroke.inside()))
}

/// The circle that touches the sides of a box.
pub(super) fn exact(pixels: &PixelBox) -> crate::Circle {
    let (x, y) = pixels.center_2x();
    let center = Vertex::from_bits(to_i32(128 * (x + 1)), to_i32(128 * (y + 1)));
    crate::Circle::from_bits(center, to_i32(128 * pixels.width))
}

/// Whether the exact circle has embedded-graphics' pixels: it has but for the smallest, and where coordinates end.
fn is_ordinary(pixels: &PixelBox) -> bool {
    const FAR: i64 = 1 << 20;
    (5..FAR).contains(&pixels.width) && pixels.left.abs() < FAR && pixels.top.abs() < FAR
}

impl Primitive for Circle {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let (outer, inner) = boxes(self, &paint.sides);
        if let (Some(fill), None, true) = (paint.fill, paint.stroke, is_ordinary(&inner)) {
            return exact(&inner).filled(fill).draw(target);
        }
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
        match (paint.fill, paint.stroke) {
            (Some(fill), None) => draw_area(exact(&inner), fill, blended, target),
            _ => draw_layers(
                paint,
                blended,
                target,
                &outer.rectangle().into(),
                |clip, tile| tile.add(&exact(&outer), clip),
                |clip, tile| tile.add(&exact(&inner), clip),
            ),
        }
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        boxes(self, stroke).0.rectangle()
    }
}
