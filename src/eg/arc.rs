//! Arcs: a ring of embedded-graphics' circles cut by the wedge of the sweep.

use embedded_graphics::primitives::Arc;
use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    circle::{boxes, exact},
    curve::Curve,
    layers::draw_layers,
    outline::{Outline, draw_outline},
    paint::{Paint, Stroke},
    pie::push_ring,
    rows::{Part, draw_rows},
    styled::Primitive,
    wedge::{Sweep, Wedge},
};

impl Primitive for Arc {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        if paint.stroke.is_none() {
            return Ok(());
        }
        let (outer, inner) = boxes(&self.to_circle(), &paint.sides);
        let (x, y) = outer.center_2x();
        let (mut outside, mut inside) = (Curve::new(outer.width, outer.height), Curve::new(inner.width, inner.height));
        let wedge = Wedge::new(self.angle_start, self.angle_sweep);
        draw_rows(&outer, paint, target, |row, parts| {
            let y = 2 * row - y;
            let (outside, inside) = (outside.columns(y, x), inside.columns(y, x));
            let [after_start, before_end] = wedge.sides(y, x, 0);
            parts.add_classified(&outside, &[&inside, &after_start, &before_end], |column| {
                let is_stroke = !inside.contains(&column)
                    && wedge.holds(after_start.contains(&column), before_end.contains(&column));
                is_stroke.then_some(Part::Stroke)
            });
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
        let Some(stroke) = paint.stroke else { return Ok(()) };
        let (outer, inner) = boxes(&self.to_circle(), &paint.sides);
        if !outer.can_be_blended() {
            return self.draw_aliased(paint, target);
        }
        let wedge = Wedge::exact(self.angle_start, self.angle_sweep);
        if wedge.sweep == Sweep::Whole {
            return draw_layers(
                &Paint { fill: None, ..*paint },
                blended,
                target,
                &outer.rectangle().into(),
                |clip, tile| tile.add(&exact(&outer), clip),
                |clip, tile| tile.add(&exact(&inner), clip),
            );
        }
        let mut outline = Outline::new();
        push_ring(&mut outline, &outer, &inner, &wedge, self.angle_sweep);
        draw_outline(&outline, stroke, blended, target)
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        boxes(&self.to_circle(), stroke).0.rectangle()
    }
}
