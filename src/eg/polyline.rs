//! Polylines: thin lines, or the areas of their segments and joints, of any number of points.

use embedded_graphics::primitives::Polyline;
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    paint::{Paint, Stroke},
    stroked::Sides,
    styled::Primitive,
    thick::{draw_thick, draw_thick_blended, stroked_box},
    thin::draw_chain,
};

impl Primitive for Polyline<'_> {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if paint.sides.width > 1 {
            return draw_thick(self.vertices, self.translate, &Sides::new(&paint.sides.open()), stroke, target);
        }
        let moved = |point: &Point| {
            Point::new(point.x.saturating_add(self.translate.x), point.y.saturating_add(self.translate.y))
        };
        draw_chain(self.vertices.iter().map(moved), stroke, target)
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
        if paint.stroke.is_none() {
            return Ok(());
        }
        draw_thick_blended(self.vertices, self.translate, paint, blended, target)
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        stroked_box(self.vertices, self.translate, stroke, is_blended)
    }
}
