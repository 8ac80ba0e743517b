//! Lines: one pixel thin as embedded-graphics draws them, or rectangles around the true line.

use embedded_graphics::primitives::Line;
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    layers::draw_area,
    normal::add,
    outline::{draw_outline, vertex},
    paint::{Paint, Stroke},
    stroked::{Sides, cap, centre, each_area},
    styled::Primitive,
    thick::{draw_thick, stroked_box},
    thin::draw_thin,
};

impl Primitive for Line {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if paint.sides.width == 1 {
            return draw_thin(self.start, self.end, stroke, target);
        }
        draw_thick(&[self.start, self.end], Point::zero(), &Sides::new(&paint.sides.open()), stroke, target)
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
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if paint.sides.width == 1 {
            let (start, end) = (centre(self.start), centre(self.end));
            let (x, y) = cap(start, end);
            let (start, end) = (add(start, (-x, -y)), add(end, (x, y)));
            let line = crate::Line::new(vertex(start.0, start.1), vertex(end.0, end.1));
            return draw_area(line, stroke, blended, target);
        }
        let sides = Sides::blended(&paint.sides.open());
        each_area(
            &[self.start, self.end],
            Point::zero(),
            &sides,
            |_, _| true,
            |corners| draw_outline(corners, stroke, blended, target),
        )
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        stroked_box(&[self.start, self.end], Point::zero(), stroke, is_blended)
    }
}
