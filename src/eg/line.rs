//! Lines: one pixel thin as embedded-graphics draws them, or rectangles around the true line.

use core::convert::Infallible;

use embedded_graphics::primitives::{Line, Polyline};
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, primitives::Rectangle};

use crate::{Blend, Fill, Mix, PixelRect, Triangle, Vertex};

use super::{
    Blended,
    layers::{draw_area, draw_layers, grown, union},
    normal::{Vector, add},
    outline::{covered, vertex},
    paint::{Paint, Stroke},
    stroked::{Sides, cap, centre, each_area},
    styled::Primitive,
    thin::draw_thin,
};

/// What a stroke along points may touch.
pub(super) fn touched(points: &[Point], by: Point, sides: &Sides) -> PixelRect {
    let mut all: Option<PixelRect> = None;
    let result: Result<(), Infallible> = each_area(
        points,
        by,
        sides,
        |_, _| true,
        |corners| {
            let area = around(corners);
            all = Some(all.take().map_or(area.clone(), |all| union(&all, &area)));
            Ok(())
        },
    );
    match result {
        Ok(()) => all.unwrap_or(PixelRect { rows: 0..0, columns: 0..0 }),
        Err(never) => match never {},
    }
}

/// The pixels that hold the corners, and those between them.
pub(super) fn around(corners: &[Vertex]) -> PixelRect {
    let mut rect = PixelRect { rows: i32::MAX..i32::MIN, columns: i32::MAX..i32::MIN };
    for corner in corners {
        let pixel = |bits: i32| (bits >> 8)..(bits.saturating_add(255) >> 8);
        rect = union(&rect, &PixelRect { rows: pixel(corner.y.to_bits()), columns: pixel(corner.x.to_bits()) });
    }
    rect
}

/// The stroke along points, area by area, where areas overlap more than once.
pub(super) fn draw_thick<D: DrawTarget>(
    points: &[Point],
    by: Point,
    sides: &Sides,
    colour: D::Color,
    target: &mut D,
) -> Result<(), D::Error> {
    each_area(
        points,
        by,
        sides,
        |_, _| true,
        |corners| {
            let Some((&first, rest)) = corners.split_first() else { return Ok(()) };
            rest.windows(2).try_for_each(|pair| match *pair {
                [second, third] => {
                    use embedded_graphics_core::Drawable;
                    Triangle::from_vertices([first, second, third]).filled(colour).draw(target)
                }
                _ => Ok(()),
            })
        },
    )
}

/// The stroke along points, each pixel once.
pub(super) fn draw_thick_blended<D: DrawTarget, B: Blend<D>>(
    points: &[Point],
    by: Point,
    paint: &Paint<D::Color>,
    blended: &Blended<B>,
    target: &mut D,
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    let sides = Sides::new(&paint.sides.open());
    let bounds = touched(points, by, &sides);
    // A mitre may reach twice the width.
    let reach = 2 * paint.sides.width + 1;
    let paint = Paint { fill: None, ..*paint };
    let add_areas = |clip: &PixelRect, tile: &mut super::layers::Tile| {
        let near = grown(clip, reach);
        let result: Result<(), Infallible> = each_area(
            points,
            by,
            &sides,
            |start, end| meets(&near, start, end),
            |corners| {
                if let Ok(area) = covered(corners) {
                    tile.add(&area, clip);
                }
                Ok(())
            },
        );
        match result {
            Ok(()) => {}
            Err(never) => match never {},
        }
    };
    draw_layers(&paint, blended, target, &bounds, add_areas, |_, _| {})
}

/// Whether the rectangle around two places meets pixels.
fn meets(pixels: &PixelRect, a: Vector, b: Vector) -> bool {
    let axis = |range: &core::ops::Range<i32>, a: i64, b: i64| {
        a.max(b) >= 256 * i64::from(range.start) && a.min(b) <= 256 * i64::from(range.end)
    };
    axis(&pixels.columns, a.0, b.0) && axis(&pixels.rows, a.1, b.1)
}

/// The rectangle of a stroke, which one pixel thin lines stay within when they are not blended.
pub(super) fn stroked_box(points: &[Point], by: Point, stroke: &Stroke, is_blended: bool) -> Rectangle {
    if stroke.width == 1 && !is_blended && points.len() > 1 {
        let centres = points.iter().map(|&point| {
            let place = Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y));
            PixelRect { rows: place.y..place.y.saturating_add(1), columns: place.x..place.x.saturating_add(1) }
        });
        return centres.reduce(|a, b| union(&a, &b)).map_or(Rectangle::zero(), Rectangle::from);
    }
    if stroke.width == 0 {
        let first = points.first().copied().unwrap_or_default();
        let corner = Point::new(first.x.saturating_add(by.x), first.y.saturating_add(by.y));
        return Rectangle::new(corner, embedded_graphics_core::geometry::Size::zero());
    }
    touched(points, by, &Sides::new(&stroke.open())).into()
}

impl Primitive for Line {
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if paint.sides.width == 1 {
            return draw_thin(self.start, self.end, stroke, target);
        }
        draw_thick(&[self.start, self.end], Point::zero(), &Sides::new(&paint.sides.open()), stroke, target)
    }

    fn draw_blended<D: DrawTarget, B: Blend<D> + Copy>(
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
        let sides = Sides::new(&paint.sides.open());
        each_area(
            &[self.start, self.end],
            Point::zero(),
            &sides,
            |_, _| true,
            |corners| match covered(corners) {
                Ok(area) => draw_area(area, stroke, blended, target),
                Err(_) => Ok(()),
            },
        )
    }

    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle {
        stroked_box(&[self.start, self.end], Point::zero(), stroke, is_blended)
    }
}

impl Primitive for Polyline<'_> {
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let Some(stroke) = paint.stroke else { return Ok(()) };
        if paint.sides.width > 1 {
            return draw_thick(self.vertices, self.translate, &Sides::new(&paint.sides.open()), stroke, target);
        }
        let moved = |point: &Point| {
            Point::new(point.x.saturating_add(self.translate.x), point.y.saturating_add(self.translate.y))
        };
        self.vertices.windows(2).try_for_each(|pair| match pair {
            [start, end] => draw_thin(moved(start), moved(end), stroke, target),
            _ => Ok(()),
        })
    }

    fn draw_blended<D: DrawTarget, B: Blend<D> + Copy>(
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
