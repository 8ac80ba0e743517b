//! Triangles between the centres of pixels: this crate's own, with strokes between two exact outlines.

use embedded_graphics::primitives::Triangle;
use embedded_graphics_core::{Drawable, draw_target::DrawTarget, geometry::Point, primitives::Rectangle};
use heapless::Vec;

use crate::{Blend, FillRule, Mix, PixelRect, Polygon, Vertex, draw::Fill};

use super::{
    Blended,
    layers::{draw_area, draw_layers, union},
    normal::{Vector, add, along, left, unit},
    outline::{UNIT_BITS, add_outline, vertex},
    paint::{Paint, Stroke},
    stroked::{Sides, centre, mitre, tip},
    styled::Primitive,
    thick::{around, draw_thick, draw_thick_blended, stroked_box},
    thin::draw_chain,
};

/// A triangle with its corners clockwise, and the directions of its sides.
struct Clockwise {
    pixels: [Point; 3],
    corners: [Vector; 3],
    directions: [Vector; 3],
    /// In 1/65536 square pixel.
    doubled_area: i128,
}

impl Clockwise {
    /// None when all corners lie on one line.
    fn new(triangle: &Triangle) -> Option<Self> {
        let [first, second, third] = triangle.vertices;
        let [a, b, c] = triangle.vertices.map(centre);
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        let doubled_area = product(b.0 - a.0, c.1 - a.1) - product(b.1 - a.1, c.0 - a.0);
        if doubled_area == 0 {
            return None;
        }
        let pixels = if doubled_area < 0 { [second, first, third] } else { [first, second, third] };
        let corners = pixels.map(centre);
        let [a, b, c] = corners;
        let direction = |from: Vector, to: Vector| unit((to.0 - from.0, to.1 - from.1));
        Some(Self {
            pixels,
            corners,
            directions: [direction(a, b)?, direction(b, c)?, direction(c, a)?],
            doubled_area: doubled_area.abs(),
        })
    }

    /// Each corner with the left normals of the sides before and after it.
    fn corners(&self) -> [(Vector, [Vector; 2]); 3] {
        let [a, b, c] = self.corners;
        let [ab, bc, ca] = self.directions.map(left);
        [(a, [ca, ab]), (b, [ab, bc]), (c, [bc, ca])]
    }

    /// Moved out by an offset in 1/256 pixel.
    fn outer(&self, sides: &Sides) -> Vec<Vertex, 6> {
        let mut outline = Vec::new();
        for (at, normals) in self.corners() {
            let mut push = |(x, y): Vector| outline.push(vertex(x, y)).unwrap_or_default();
            match mitre(at, normals, sides.left, sides.limit) {
                Some(tip) => push(tip),
                None => normals.map(|normal| add(at, along(normal, sides.left))).into_iter().for_each(push),
            }
        }
        outline
    }

    /// Moved in by an offset in 1/256 pixel; none when nothing is left.
    fn inner(&self, sides: &Sides) -> Option<[Vertex; 3]> {
        let [a, b, c] = self.corners;
        let length = |from: Vector, to: Vector, direction: Vector| {
            let part = |difference: i64, direction: i64| i128::from(difference) * i128::from(direction);
            (part(to.0 - from.0, direction.0) + part(to.1 - from.1, direction.1)) >> UNIT_BITS
        };
        let [ab, bc, ca] = self.directions;
        // The inscribed circle has twice the area over the perimeter as its radius.
        let perimeter = length(a, b, ab) + length(b, c, bc) + length(c, a, ca);
        if i128::from(sides.right) * perimeter >= self.doubled_area {
            return None;
        }
        let [a, b, c] = self.corners().map(|(at, normals)| Some(add(at, tip(normals, -sides.right)?)));
        Some([a?, b?, c?].map(|(x, y)| vertex(x, y)))
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

/// The sides one pixel thin, in embedded-graphics' directions.
fn draw_sides<D: DrawTarget>([a, b, c]: [Point; 3], stroke: D::Color, target: &mut D) -> Result<(), D::Error> {
    draw_chain([a, b, c, a].into_iter(), stroke, target)
}

impl Primitive for Triangle {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let [a, b, c] = self.vertices;
        let is_bare = paint.sides.width == 0 || (paint.sides.width == 1 && paint.stroke.is_some());
        if is_bare && let Some(fill) = paint.fill {
            crate::Triangle::new(a, b, c).filled(fill).draw(target)?;
        }
        let sides = Sides::new(&paint.sides);
        let Some(clockwise) = Clockwise::new(self) else {
            let corners = flat(self);
            return match paint.stroke {
                Some(stroke) if paint.sides.width == 1 => draw_sides(corners, stroke, target),
                Some(stroke) => {
                    draw_thick(&ends(corners), Point::zero(), &Sides::new(&paint.sides.open()), stroke, target)
                }
                None => Ok(()),
            };
        };
        if let (Some(stroke), 1) = (paint.stroke, paint.sides.width) {
            return draw_sides(clockwise.pixels, stroke, target);
        }
        let inner = clockwise.inner(&sides);
        if let Some(stroke) = paint.stroke {
            let outer = clockwise.outer(&sides);
            let contours = [outer.as_slice(), inner.as_ref().map_or(&[][..], |inner| inner)];
            let ring = Polygon::with_contours(&contours).fill_rule(FillRule::EvenOdd);
            if let Ok(ring) = ring.with_capacity::<6>() {
                ring.filled(stroke).draw(target)?;
            }
        }
        match (paint.fill, inner) {
            (Some(fill), Some(inner)) if paint.sides.width > 0 => {
                crate::Triangle::from_vertices(inner).filled(fill).draw(target)
            }
            _ => Ok(()),
        }
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
        let sides = Sides::blended(&paint.sides);
        let Some(clockwise) = Clockwise::new(self) else {
            if paint.stroke.is_none() {
                return Ok(());
            }
            return draw_thick_blended(&ends(flat(self)), Point::zero(), paint, blended, target);
        };
        let inner = clockwise.inner(&sides);
        if let (Some(fill), None) = (paint.fill, paint.stroke) {
            let Some(inner) = inner else { return Ok(()) };
            return draw_area(crate::Triangle::from_vertices(inner), fill, blended, target);
        }
        let outer = clockwise.outer(&sides);
        draw_layers(
            paint,
            blended,
            target,
            &around(&outer),
            |clip, tile| add_outline(&outer, clip, tile),
            |clip, tile| {
                if let Some(inner) = inner {
                    tile.add(&crate::Triangle::from_vertices(inner), clip);
                }
            },
        )
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        let [a, b, c] = self.vertices;
        let plain = stroked_box(&[a, b, c], Point::zero(), &Stroke::thin(), false);
        if stroke.width == 0 || (stroke.width == 1 && !is_blended) {
            return plain;
        }
        let sides = if is_blended { Sides::blended(stroke) } else { Sides::new(stroke) };
        let outer = match Clockwise::new(self) {
            Some(clockwise) => around(&clockwise.outer(&sides)),
            None => stroked_box(&ends(flat(self)), Point::zero(), stroke, is_blended).into(),
        };
        union(&outer, &PixelRect::from(plain)).into()
    }
}
