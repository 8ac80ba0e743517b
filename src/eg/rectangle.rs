//! Rectangles: whole pixels, one `fill_solid` for the inside and one for each side of the stroke.

use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use super::{
    boxes::Boxes,
    layers::Layers,
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    styled::Boxed,
};

impl Boxed for Rectangle {
    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.top_left, self.size)
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        boxes.draw(&boxes.outer, paint, to)
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, _stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        layers.draw(&boxes.outer, &boxes.inner)
    }

    fn is_whole(&self) -> bool {
        true
    }
}
