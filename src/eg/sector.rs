//! Sectors: circles cut by the wedge of the sweep, with a stroke along the arc and both straight sides.
//!
//! Not blended, the straight sides of the stroke run through the middles of pixels: it begins half a pixel outside of the
//! angle. Below 55 and above 305 degrees its corner is cut off square. Blended, it lies about the sides of the angle as
//! its alignment says, an even width, too; without a stroke, a sector is exactly what lies within its angle, so that
//! sectors which follow each other add up to the circle; one of no angle is nothing.

use embedded_graphics::{geometry::Angle, primitives::Sector};
use embedded_graphics_core::{draw_target::DrawTarget, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    circle::boxes,
    curve::Curve,
    normal::unit,
    outline::{Layer, draw_outlines},
    paint::{Paint, Stroke},
    pie::Pie,
    rows::{Part, draw_rows},
    styled::Primitive,
    wedge::{DIRECTION, HalfPlane, Sweep, Wedge, direction},
};

/// Which corner of the stroke is cut off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Bevel {
    /// The one that sticks out of a narrow sector.
    Outer,
    /// The one that sticks into a sector that is nearly whole.
    Inner,
}

fn bevel(sector: &Sector) -> Option<Bevel> {
    let turned = sector.angle_sweep.abs();
    if turned < Angle::from_degrees(55.0) {
        Some(Bevel::Outer)
    } else if turned > Angle::from_degrees(305.0) && turned < Angle::from_degrees(360.0) {
        Some(Bevel::Inner)
    } else {
        None
    }
}

/// The middle of the sweep.
fn middle(sector: &Sector) -> Angle {
    sector.angle_start + Angle::from_radians(sector.angle_sweep.to_radians() / 2.0)
}

/// What of the plane a bevel takes from the stroke.
fn cut_off(sector: &Sector, bevel: Bevel, stroke: &Stroke) -> HalfPlane {
    let quarter = Angle::from_radians(core::f32::consts::FRAC_PI_2);
    let (cos, sin) = direction(match bevel {
        Bevel::Outer => middle(sector) - quarter,
        Bevel::Inner => middle(sector) + quarter,
    });
    // In half pixels, twice the width outside.
    HalfPlane { normal: (sin, -cos), at_least: 4 * DIRECTION * stroke.outside() }
}

/// The outlines of the stroke and of what it leaves to fill.
fn pies(sector: &Sector, stroke: &Stroke) -> (Pie, Pie) {
    let (outer, inner) = boxes(&sector.to_circle(), stroke);
    let wedge = Wedge::exact(sector.angle_start, sector.angle_sweep);
    let at = 2 * 256 * stroke.outside();
    let bevel = bevel(sector).and_then(|bevel| {
        let at = if bevel == Bevel::Outer { -at } else { at };
        Some((unit(direction(middle(sector)))?, at))
    });
    let (outside, inside) = stroke.exact_halves();
    let outer = Pie {
        pixels: outer,
        wedge,
        sweep: sector.angle_sweep,
        offset: -128 * outside,
        bevel: bevel.filter(|_| wedge.sweep == Sweep::Narrow),
    };
    let inner =
        Pie { pixels: inner, offset: 128 * inside, bevel: bevel.filter(|_| wedge.sweep == Sweep::Wide), ..outer };
    (outer, inner)
}

impl Primitive for Sector {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        if paint.stroke.is_none() && self.angle_sweep == Angle::zero() {
            return Ok(());
        }
        let stroke = &paint.sides;
        let (outer, inner) = boxes(&self.to_circle(), stroke);
        let (x, y) = outer.center_2x();
        let (mut outside, mut inside) = (Curve::new(outer.width, outer.height), Curve::new(inner.width, inner.height));
        let wedge = Wedge::new(self.angle_start, self.angle_sweep);
        let bevel = bevel(self).map(|bevel| (bevel, cut_off(self, bevel, stroke)));
        draw_rows(&outer, paint, target, |row, parts| {
            let y = 2 * row - y;
            let (outside, inside) = (outside.columns(y, x), inside.columns(y, x));
            let [after_start, before_end] = wedge.sides(y, x, DIRECTION * (2 * stroke.outside() + 1));
            let [after_stroke, before_stroke] = wedge.sides(y, x, DIRECTION * (1 - 2 * stroke.inside()));
            let cut = bevel.map_or(0..0, |(_, plane)| plane.columns(y, x));
            let ranges = [&inside, &after_start, &before_end, &after_stroke, &before_stroke, &cut];
            parts.add_classified(&outside, &ranges, |column| {
                if !wedge.holds(after_start.contains(&column), before_end.contains(&column)) {
                    return None;
                }
                let mut is_filled = wedge.holds(after_stroke.contains(&column), before_stroke.contains(&column));
                if let (false, true, Some((bevel, _))) = (is_filled, cut.contains(&column), bevel) {
                    if bevel == Bevel::Outer {
                        return None;
                    }
                    is_filled = true;
                }
                Some(if is_filled && inside.contains(&column) { Part::Fill } else { Part::Stroke })
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
        let (outer, mut inner) = pies(self, &paint.sides);
        if paint.stroke.is_none() {
            if self.angle_sweep == Angle::zero() {
                return Ok(());
            }
            (inner.offset, inner.bevel) = (0, None);
        }
        if !outer.pixels.can_be_blended() {
            return self.draw_aliased(paint, target);
        }
        draw_outlines(paint, blended, target, &outer.pixels, |outline, room, layer| {
            let pie = if layer == Layer::Outer { &outer } else { &inner };
            pie.push(outline, room);
        })
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        boxes(&self.to_circle(), stroke).0.rectangle()
    }
}
