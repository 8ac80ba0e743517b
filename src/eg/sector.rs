//! Arcs and sectors: circles cut by the wedge of the sweep; of sectors, with a stroke along the arc and both straight sides.
//!
//! Not blended, the straight sides of the stroke run through the middles of pixels: it begins half a pixel outside of the
//! angle. Below 55 and above 305 degrees its corner is cut off square. Blended, it lies about the sides of the angle as
//! its alignment says, an even width, too; without a stroke, a sector is exactly what lies within its angle, so that
//! sectors which follow each other add up to the circle; one of no angle is nothing.

use embedded_graphics::{
    geometry::Angle,
    primitives::{Arc, Sector},
};
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Size};

use super::{
    boxes::Boxes,
    curve::Curve,
    ellipse::exact,
    layers::Layers,
    outline::{draw_outlines, with_outlines},
    paint::{Paint, Stroke},
    pie::{Pie, Rays, direction, push_ring},
    pixel_box::PixelBox,
    rows::draw_rows,
    styled::Boxed,
    wedge::{DIRECTION, HalfPlane, Sweep, Wedge},
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
    let (cos, sin) = super::wedge::direction(match bevel {
        Bevel::Outer => middle(sector) - quarter,
        Bevel::Inner => middle(sector) + quarter,
    });
    // In half pixels, twice the width outside.
    HalfPlane { normal: (sin, -cos), at_least: 4 * DIRECTION * stroke.outside() }
}

/// The outlines of the stroke and of what it leaves to fill.
fn pies(sector: &Sector, boxes: &Boxes, stroke: &Stroke) -> [Pie; 2] {
    let rays = Rays::new(sector.angle_start, sector.angle_sweep);
    let at = 2 * 256 * stroke.outside();
    let bisector = direction(crate::Angle::from_radians(middle(sector).to_radians()));
    let bevel = bevel(sector).map(|bevel| (bisector, if bevel == Bevel::Outer { -at } else { at }));
    let (outside, inside) = stroke.exact_sides();
    let pie = |pixels: PixelBox, offset: i64, cut: Sweep| Pie {
        pixels,
        rays,
        offset,
        bevel: bevel.filter(|_| rays.sweep == cut),
    };
    [pie(boxes.outer, -outside, Sweep::Narrow), pie(boxes.inner, inside, Sweep::Wide)]
}

fn curves(boxes: &Boxes) -> [Curve; 2] {
    [boxes.outer, boxes.inner].map(|pixels| Curve::new(pixels.width, pixels.height))
}

impl Boxed for Arc {
    const HAS_INSIDE: bool = false;

    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.top_left, Size::new_equal(self.diameter))
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        let (center, [mut outer, mut inner]) = (boxes.outer.center_2x(), curves(boxes));
        let wedge = Wedge::new(self.angle_start, self.angle_sweep);
        draw_rows(&boxes.outer, to, |row, parts| {
            let (outer, inner) = (outer.columns(row, center), inner.columns(row, center));
            let [after_start, before_end] = wedge.sides(row, center, 0);
            parts.add_cut(outer, &[&inner, &after_start, &before_end], |column| {
                let is_held = wedge.holds(after_start.contains(&column), before_end.contains(&column));
                paint.stroke.filter(|_| is_held && !inner.contains(&column))
            });
        })
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, _stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        let rays = Rays::new(self.angle_start, self.angle_sweep);
        match rays.sweep {
            Sweep::Whole => layers.draw(&exact(&boxes.outer), &exact(&boxes.inner)),
            _ => with_outlines(
                false,
                |outline, room, _| push_ring(outline, room, &boxes.outer, &boxes.inner, &rays),
                |_, ring| layers.stroke(&ring),
            ),
        }
    }
}

impl Boxed for Sector {
    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.top_left, Size::new_equal(self.diameter))
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        if paint.stroke.is_none() && self.angle_sweep == Angle::zero() {
            return Ok(());
        }
        let stroke = &paint.sides;
        let (center, [mut outer, mut inner]) = (boxes.outer.center_2x(), curves(boxes));
        let wedge = Wedge::new(self.angle_start, self.angle_sweep);
        let bevel = bevel(self).map(|bevel| (bevel, cut_off(self, bevel, stroke)));
        draw_rows(&boxes.outer, to, |row, parts| {
            let (outer, inner) = (outer.columns(row, center), inner.columns(row, center));
            let [after_start, before_end] = wedge.sides(row, center, DIRECTION * (2 * stroke.outside() + 1));
            let [after_stroke, before_stroke] = wedge.sides(row, center, DIRECTION * (1 - 2 * stroke.inside()));
            let cut = bevel.map_or(0..0, |(_, plane)| plane.columns(row, center));
            let ranges = [&inner, &after_start, &before_end, &after_stroke, &before_stroke, &cut];
            parts.add_cut(outer, &ranges, |column| {
                if !wedge.holds(after_start.contains(&column), before_end.contains(&column)) {
                    return None;
                }
                let is_filled = wedge.holds(after_stroke.contains(&column), before_stroke.contains(&column));
                let is_filled = match bevel {
                    Some((Bevel::Outer, _)) if !is_filled && cut.contains(&column) => return None,
                    Some((Bevel::Inner, _)) => is_filled || cut.contains(&column),
                    _ => is_filled,
                };
                if is_filled && inner.contains(&column) { paint.fill } else { paint.stroke }
            });
        })
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        let [outer, mut inner] = pies(self, boxes, stroke);
        if !layers.has_stroke() {
            if self.angle_sweep == Angle::zero() {
                return Ok(());
            }
            (inner.offset, inner.bevel) = (0, None);
        }
        draw_outlines(layers, |outline, room, is_outer| if is_outer { &outer } else { &inner }.push(outline, room))
    }
}
