//! The shapes of the anti-aliased scenes as outlines, for libraries that fill paths, and for the exact area.

use std::array;

use crate::{
    lineup::some,
    picture::Bounds,
    scenes::{PixelPoint, Scene, SubpixelPoint, circles, concave_polygons, lines, stars, triangles},
};

/// x and y in pixels, (0, 0) being the top-left corner of the top-left pixel.
pub(crate) type Position = (f64, f64);

/// Builds a path, or adds up an area.
pub(crate) trait Pen {
    fn polygon(&mut self, vertices: &[Position]);

    fn circle(&mut self, centre: Position, radius: f64);

    /// A line of 1 px, from end to end and not beyond: a rectangle, unless the library has something better.
    fn line(&mut self, start: Position, end: Position) {
        let (dx, dy) = (end.0 - start.0, end.1 - start.1);
        let twice_length = 2.0 * dx.hypot(dy);
        // A line without length covers nothing.
        if twice_length > 0.0 {
            let (x, y) = (dy / twice_length, -dx / twice_length);
            self.polygon(&[
                (start.0 + x, start.1 + y),
                (end.0 + x, end.1 + y),
                (end.0 - x, end.1 - y),
                (start.0 - x, start.1 - y),
            ]);
        }
    }
}

/// The coordinates that drawing starts from.
pub(crate) trait Outline: 'static {
    fn trace(&self, pen: &mut impl Pen);

    /// What the outline touches.
    fn bounds(&self) -> Bounds;
}

pub(crate) struct TriangleOutline(pub(crate) [PixelPoint; 3]);

impl Outline for TriangleOutline {
    #[inline]
    fn trace(&self, pen: &mut impl Pen) {
        pen.polygon(&self.0.map(centre));
    }

    #[inline]
    fn bounds(&self) -> Bounds {
        bounds_of_pixels(&self.0)
    }
}

pub(crate) struct CircleOutline {
    pub(crate) centre: PixelPoint,
    pub(crate) radius_px: i32,
}

impl Outline for CircleOutline {
    #[inline]
    fn trace(&self, pen: &mut impl Pen) {
        let [x, y] = self.centre.map(f64::from);
        pen.circle((x, y), f64::from(self.radius_px));
    }

    #[inline]
    fn bounds(&self) -> Bounds {
        let ([x, y], radius) = (self.centre, self.radius_px);
        Bounds { left: x - radius, top: y - radius, width: 2 * radius, height: 2 * radius }
    }
}

pub(crate) struct LineOutline(pub(crate) [PixelPoint; 2]);

impl Outline for LineOutline {
    #[inline]
    fn trace(&self, pen: &mut impl Pen) {
        let [start, end] = self.0.map(centre);
        pen.line(start, end);
    }

    /// Half a pixel further than the ends, which are pixel centres.
    #[inline]
    fn bounds(&self) -> Bounds {
        bounds_of_pixels(&self.0)
    }
}

pub(crate) struct PolygonOutline<const N: usize>(pub(crate) [SubpixelPoint; N]);

impl<const N: usize> Outline for PolygonOutline<N> {
    #[inline]
    fn trace(&self, pen: &mut impl Pen) {
        pen.polygon(&self.0.map(position));
    }

    #[inline]
    fn bounds(&self) -> Bounds {
        bounds_of_pixels(&self.0.map(|[x, y]| [x >> 8, y >> 8]))
    }
}

/// A star without its inner lines, which an area that adds up may not cross.
pub(crate) fn star_outline(star: [SubpixelPoint; 5]) -> impl Outline {
    let tips = star.map(position);
    // Each edge goes to the tip after the next; so from a tip, the outline follows its edge up to where the next tip's
    // crosses it.
    let around: [Position; 5] = array::from_fn(|turn| tips[turn * 3 % 5]);
    let outline = array::from_fn(|index| {
        let (tip, next, after_next, before) =
            (around[index / 2], around[(index / 2 + 1) % 5], around[(index / 2 + 2) % 5], around[(index / 2 + 4) % 5]);
        if index % 2 == 0 { tip } else { crossing((tip, after_next), (next, before)) }
    });
    UnionOutline { outline, bounds: PolygonOutline(star).bounds() }
}

struct UnionOutline {
    outline: [Position; 10],
    bounds: Bounds,
}

impl Outline for UnionOutline {
    fn trace(&self, pen: &mut impl Pen) {
        pen.polygon(&self.outline);
    }

    fn bounds(&self) -> Bounds {
        self.bounds
    }
}

fn crossing((a, b): (Position, Position), (c, d): (Position, Position)) -> Position {
    let cross = |(ax, ay): Position, (bx, by): Position| ax * by - ay * bx;
    let from = |(ax, ay): Position, (bx, by): Position| (bx - ax, by - ay);
    let share = cross(from(a, c), from(c, d)) / cross(from(a, b), from(c, d));
    (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1))
}

/// A pixel stands for its centre.
fn centre([x, y]: PixelPoint) -> Position {
    (f64::from(x) + 0.5, f64::from(y) + 0.5)
}

fn position([x, y]: SubpixelPoint) -> Position {
    (f64::from(x) / 256.0, f64::from(y) / 256.0)
}

fn bounds_of_pixels(pixels: &[PixelPoint]) -> Bounds {
    let (mut left, mut top, mut right, mut bottom) = (i32::MAX, i32::MAX, i32::MIN, i32::MIN);
    for &[x, y] in pixels {
        (left, top) = (left.min(x), top.min(y));
        (right, bottom) = (right.max(x), bottom.max(y));
    }
    Bounds { left, top, width: right - left + 1, height: bottom - top + 1 }
}

/// What to do with a scene's outlines, whatever their type.
pub(crate) trait OutlineVisitor {
    type Output;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Self::Output;
}

/// The scene's outlines, as they are drawn.
pub(super) fn with_outlines<V: OutlineVisitor>(scene: Scene, visitor: V) -> V::Output {
    match scene {
        Scene::Triangles(box_px) => visitor.visit(some(scene, triangles(box_px).map(TriangleOutline))),
        Scene::Circles(radius_px) => {
            visitor.visit(some(scene, circles(radius_px).map(|centre| CircleOutline { centre, radius_px })))
        }
        Scene::Lines(box_px) => visitor.visit(some(scene, lines(box_px).map(LineOutline))),
        Scene::Stars(radius_px) => visitor.visit(some(scene, stars(radius_px).map(PolygonOutline))),
        Scene::Concave64(radius_px) => visitor.visit(some(scene, concave_polygons(radius_px).map(PolygonOutline))),
    }
}

/// The same areas, by outlines that do not cross themselves.
pub(crate) fn with_simple_outlines<V: OutlineVisitor>(scene: Scene, visitor: V) -> V::Output {
    match scene {
        Scene::Stars(radius_px) => visitor.visit(some(scene, stars(radius_px).map(star_outline))),
        _ => with_outlines(scene, visitor),
    }
}
