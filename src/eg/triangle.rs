//! Triangles between the centres of pixels: this crate's own, with strokes between two exact outlines.

use embedded_graphics::primitives::Triangle;
use embedded_graphics_core::{Drawable, draw_target::DrawTarget, geometry::Point, primitives::Rectangle};
use heapless::Vec;

use crate::{FillRule, Polygon, Vertex, draw::Fill, geometry::touched, outline::Vector, stroke::Unit};

use super::{
    layers::Layers,
    line::{draw_points, layer_points, stroked_box},
    outline::{Area, vertex},
    paint::{Paint, Sides, Stroke},
    stroked::{centre, mitre, tip, union},
    styled::Primitive,
    thin::draw_chain,
};

/// A triangle with its corners clockwise.
struct Clockwise {
    pixels: [Point; 3],
    /// With the left normals of the sides before and after each.
    corners: [(Vector, [Unit; 2]); 3],
    /// Of the inscribed circle, in 1/256 pixel, rounded up.
    radius: i128,
}

impl Clockwise {
    /// None when all corners lie on one line.
    fn new(triangle: &Triangle) -> Option<Self> {
        let [first, second, third] = triangle.vertices;
        let [a, b, c] = triangle.vertices.map(centre);
        let area = b.minus(a).turned().dot(c.minus(a));
        let pixels = if area < 0 { [second, first, third] } else { [first, second, third] };
        let [a, b, c] = pixels.map(centre);
        let sides = [b.minus(a), c.minus(b), a.minus(c)];
        let normal = |side: Vector| Some(Unit::along(side)?.turned_back());
        let [ab, bc, ca] = [normal(sides[0])?, normal(sides[1])?, normal(sides[2])?];
        let perimeter = sides.iter().map(|side| i128::from(crate::stroke::length_q16(*side))).sum::<i128>();
        // Twice the area over the perimeter.
        let radius = (16 * area.abs()).checked_div(perimeter)?;
        Some(Self { pixels, corners: [(a, [ca, ab]), (b, [ab, bc]), (c, [bc, ca])], radius }).filter(|_| area != 0)
    }

    /// Moved out.
    fn outer(&self, sides: &Sides) -> Vec<Vertex, 6> {
        let mut outline = Vec::new();
        for (at, normals) in self.corners {
            let mut push = |to: Vector| outline.push(vertex(at.plus(to))).unwrap_or_default();
            match mitre(normals, sides.left, sides.limit) {
                Some(tip) => push(tip),
                None => normals.map(|normal| normal.times(sides.left)).into_iter().for_each(push),
            }
        }
        outline
    }

    /// Moved in; none when nothing is left.
    fn inner(&self, sides: &Sides) -> Option<crate::Triangle> {
        if i128::from(sides.right) >= self.radius {
            return None;
        }
        let [a, b, c] = self.corners.map(|(at, normals)| Some(vertex(at.plus(tip(normals, -sides.right)?))));
        Some(crate::Triangle::from_vertices([a?, b?, c?]))
    }
}

/// The corners of a triangle that is a line, in order.
fn flat(triangle: &Triangle) -> [Point; 3] {
    let mut corners = triangle.vertices;
    corners.sort_unstable_by_key(|corner| (corner.y, corner.x));
    corners
}

fn ends([first, _, last]: [Point; 3]) -> [Point; 2] {
    [first, last]
}

impl Primitive for Triangle {
    const HAS_INSIDE: bool = true;

    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let clockwise = Clockwise::new(self);
        let is_thin = paint.stroke.is_some() && paint.sides.width == 1;
        if let (true, Some(fill)) = (is_thin || paint.sides.width == 0, paint.fill) {
            crate::Triangle::from_vertices(self.vertices.map(Vertex::from)).filled(fill).draw(target)?;
        }
        if let (true, Some(stroke)) = (is_thin, paint.stroke) {
            // In embedded-graphics' directions.
            let [a, b, c] = clockwise.map_or_else(|| flat(self), |clockwise| clockwise.pixels);
            return draw_chain([a, b, c, a].into_iter(), stroke, target);
        }
        let Some(clockwise) = clockwise else {
            return draw_points(&ends(flat(self)), Point::zero(), paint, target);
        };
        let sides = paint.sides.sides(false);
        let inner = clockwise.inner(&sides);
        if let Some(stroke) = paint.stroke {
            let outer = clockwise.outer(&sides);
            let contours = [outer.as_slice(), inner.as_ref().map_or(&[][..], |inner| &inner.vertices)];
            let ring = Polygon::with_contours(&contours).fill_rule(FillRule::EvenOdd);
            if let Ok(ring) = ring.with_capacity::<6>() {
                ring.filled(stroke).draw(target)?;
            }
        }
        match (paint.fill, inner) {
            (Some(fill), Some(inner)) if paint.sides.width > 0 => inner.filled(fill).draw(target),
            _ => Ok(()),
        }
    }

    fn draw_areas<L: Layers>(&self, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        let sides = stroke.sides(true);
        let Some(clockwise) = Clockwise::new(self) else {
            return layer_points(&ends(flat(self)), Point::zero(), stroke, layers);
        };
        let outer = clockwise.outer(&sides);
        match clockwise.inner(&sides) {
            Some(inner) => layers.draw(&Area(&outer), &inner),
            None => layers.draw(&Area(&outer), &Area(&[])),
        }
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        let thin = stroked_box(&self.vertices, Point::zero(), &stroke.thin(), false);
        if stroke.width == 0 || (stroke.width == 1 && !is_blended) {
            return thin;
        }
        let outer = match Clockwise::new(self) {
            Some(clockwise) => touched(clockwise.outer(&stroke.sides(is_blended)).iter()),
            None => stroked_box(&ends(flat(self)), Point::zero(), stroke, is_blended).into(),
        };
        union(outer, thin.into()).into()
    }
}
