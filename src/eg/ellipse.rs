//! Circles and ellipses: embedded-graphics' pixels; where they are blended, exact circles, and polygons for ellipses.

use embedded_graphics::primitives::{Circle, Ellipse};
use embedded_graphics_core::{Drawable, draw_target::DrawTarget, geometry::Size};

use crate::draw::Fill;

use super::{
    boxes::Boxes,
    curve::Curve,
    layers::Layers,
    outline::{draw_outlines, push_ellipse, vertex},
    paint::{Paint, Stroke},
    pixel_box::{PixelBox, to_i32},
    rows::draw_rows,
    styled::Boxed,
};

/// The circle that touches the sides of a box.
pub(super) fn exact(pixels: &PixelBox) -> crate::Circle {
    crate::Circle::from_bits(vertex(pixels.center()), to_i32(128 * pixels.width))
}

fn draw_pixels<D: DrawTarget>(boxes: &Boxes, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
    let [mut outer, mut inner] = [boxes.outer, boxes.inner].map(|pixels| Curve::new(pixels.width, pixels.height));
    let center = boxes.outer.center_2x();
    draw_rows(&boxes.outer, target, |row, parts| {
        parts.add_ring(paint, outer.columns(row, center), inner.columns(row, center));
    })
}

impl Boxed for Circle {
    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.top_left, Size::new_equal(self.diameter))
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        match (paint.fill, paint.stroke) {
            // The exact circle has embedded-graphics' pixels, but for that of three.
            (Some(fill), None) if boxes.inner.width > 3 && boxes.inner.can_be_blended() => {
                exact(&boxes.inner).filled(fill).draw(to)
            }
            _ => draw_pixels(boxes, paint, to),
        }
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, _stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        layers.draw(&exact(&boxes.outer), &exact(&boxes.inner))
    }
}

impl Boxed for Ellipse {
    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.top_left, self.size)
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        draw_pixels(boxes, paint, to)
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, _stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        draw_outlines(layers, |outline, room, is_outer| {
            push_ellipse(outline, room, if is_outer { &boxes.outer } else { &boxes.inner });
        })
    }
}
