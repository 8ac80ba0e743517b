//! Lines and polylines of any number of points: one pixel thin as embedded-graphics draws them, or the areas of their
//! segments and joints.

use embedded_graphics::primitives::{Line, Polyline};
use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::PixelRect;

use super::{
    layers::Layers,
    outline::{Area, vertex},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    stroked::{Along, cap, centre, union},
    styled::Primitive,
    thin::draw_chain,
};

fn along<'p>(points: &'p [Point], by: Point, stroke: &Stroke, is_blended: bool) -> Along<'p> {
    Along { points, by, sides: stroke.open().sides(is_blended) }
}

fn moved(point: Point, by: Point) -> Point {
    Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y))
}

pub(super) fn draw_points<D: DrawTarget>(
    points: &[Point],
    by: Point,
    paint: &Paint<D::Color>,
    target: &mut D,
) -> Result<(), D::Error> {
    match paint.stroke {
        Some(stroke) if paint.sides.width > 1 => along(points, by, &paint.sides, false).draw(stroke, target),
        Some(stroke) => draw_chain(points.iter().map(|point| moved(*point, by)), stroke, target),
        None => Ok(()),
    }
}

pub(super) fn layer_points<L: Layers>(
    points: &[Point],
    by: Point,
    stroke: &Stroke,
    layers: &mut L,
) -> Result<(), L::Error> {
    if layers.has_stroke() { layers.draw(&along(points, by, stroke, true), &Area(&[])) } else { Ok(()) }
}

/// The rectangle of a stroke, which one pixel thin lines stay within when they are not blended.
pub(super) fn stroked_box(points: &[Point], by: Point, stroke: &Stroke, is_blended: bool) -> Rectangle {
    let pixels =
        |point: &Point, size: u32| PixelRect::from(PixelBox::new(moved(*point, by), Size::new_equal(size)).rectangle());
    match points {
        [_, _, ..] if stroke.width <= 1 && !is_blended => {
            points.iter().map(|point| pixels(point, 1)).reduce(union).map_or(Rectangle::zero(), Rectangle::from)
        }
        [first, ..] if stroke.width == 0 => Rectangle::new(moved(*first, by), Size::zero()),
        _ => crate::shape::Cover::touched(&along(points, by, stroke, is_blended)).into(),
    }
}

impl Primitive for Line {
    const HAS_INSIDE: bool = false;

    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        draw_points(&[self.start, self.end], Point::zero(), paint, target)
    }

    fn draw_areas<L: Layers>(&self, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        let (start, end) = (centre(self.start), centre(self.end));
        if stroke.width == 1 && start != end {
            let cap = cap(start, end);
            return layers.stroke(&crate::Line::new(vertex(start.minus(cap)), vertex(end.plus(cap))));
        }
        let ends = [self.start, self.end];
        along(&ends, Point::zero(), stroke, true).each_area(|_, _| true, |area| layers.stroke(&area))
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        stroked_box(&[self.start, self.end], Point::zero(), stroke, is_blended)
    }
}

impl Primitive for Polyline<'_> {
    const HAS_INSIDE: bool = false;

    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        draw_points(self.vertices, self.translate, paint, target)
    }

    fn draw_areas<L: Layers>(&self, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        layer_points(self.vertices, self.translate, stroke, layers)
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        stroked_box(self.vertices, self.translate, stroke, is_blended)
    }
}
