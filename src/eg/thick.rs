//! Strokes along points, drawn area by area.

use core::{convert::Infallible, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use heapless::Vec;

use crate::{Blend, BlockSink, Mix, PixelRect, Polygon, Vertex, primitive::Quadrilateral};

use super::{
    Blended,
    layers::{Tile, draw_layers, grown, union},
    normal::Vector,
    paint::{Paint, Stroke},
    stroked::{Sides, each_area},
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
    let pixel = |bits: i32| (bits >> 8)..(bits.saturating_add(255) >> 8);
    let pixels = |corner: &Vertex| PixelRect { rows: pixel(corner.y.to_bits()), columns: pixel(corner.x.to_bits()) };
    corners.iter().map(pixels).reduce(|a, b| union(&a, &b)).unwrap_or(PixelRect { rows: 0..0, columns: 0..0 })
}

/// The stroke along points, area by area, where areas overlap more than once.
pub(super) fn draw_thick<D: DrawTarget>(
    points: &[Point],
    by: Point,
    sides: &Sides,
    colour: D::Color,
    target: &mut D,
) -> Result<(), D::Error> {
    let clip = PixelRect::from(target.bounding_box());
    each_area(
        points,
        by,
        sides,
        |_, _| true,
        |corners| {
            let &[a, b, c, ref rest @ ..] = corners else { return Ok(()) };
            let area = Quadrilateral([a, b, c, rest.first().copied().unwrap_or(c)]);
            area.blocks(&clip, &mut Solid { target: &mut *target, colour })
        },
    )
}

/// Blocks in one colour.
struct Solid<'t, D: DrawTarget> {
    target: &'t mut D,
    colour: D::Color,
}

impl<D: DrawTarget> BlockSink for Solid<'_, D> {
    type Error = D::Error;

    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), D::Error> {
        self.target.fill_solid(&Rectangle::from(PixelRect { rows, columns }), self.colour)
    }
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
    let sides = Sides::blended(&paint.sides.open());
    let bounds = touched(points, by, &sides);
    // A mitre may reach twice the width.
    let reach = 2 * paint.sides.width + 1;
    let paint = Paint { fill: None, ..*paint };
    let add_areas = |clip: &PixelRect, tile: &mut Tile| {
        let near = grown(clip, reach);
        let mut together = Together(Vec::new());
        let result: Result<(), Infallible> = each_area(
            points,
            by,
            &sides,
            |start, end| meets(&near, start, end),
            |corners| {
                together.push(corners, clip, tile);
                Ok(())
            },
        );
        together.add(clip, tile);
        match result {
            Ok(()) => {}
            Err(never) => match never {},
        }
    };
    draw_layers(&paint, blended, target, &bounds, add_areas, |_, _| {})
}

/// As many areas as are added up by the non-zero rule; of more near one tile, some may be covered twice where they
/// overlap.
const TOGETHER: usize = 24;

/// Areas of three or four corners near a tile, wound alike.
struct Together(Vec<[Vertex; 4], TOGETHER>);

impl Together {
    fn push(&mut self, corners: &[Vertex], clip: &PixelRect, tile: &mut Tile) {
        let &[a, b, c, ref rest @ ..] = corners else { return };
        let d = rest.first().copied().unwrap_or(c);
        let position = |vertex: Vertex| (i64::from(vertex.x.to_bits()), i64::from(vertex.y.to_bits()));
        let ((ax, ay), (bx, by), (cx, cy), (dx, dy)) = (position(a), position(b), position(c), position(d));
        // Twice the area of a quadrilateral, from its diagonals.
        let is_clockwise = i128::from(cx - ax) * i128::from(dy - by) >= i128::from(cy - ay) * i128::from(dx - bx);
        let area = if is_clockwise { [a, b, c, d] } else { [a, d, c, b] };
        if let Err(area) = self.0.push(area) {
            self.add(clip, tile);
            self.0.clear();
            // There is room now.
            self.0.push(area).unwrap_or_default();
        }
    }

    #[inline(never)]
    fn add(&self, clip: &PixelRect, tile: &mut Tile) {
        // There is as much room here as there. (`collect` has a panic in it.)
        let mut contours: Vec<&[Vertex], TOGETHER> = Vec::new();
        self.0.iter().for_each(|area| contours.push(area.as_slice()).unwrap_or_default());
        if let Ok(polygon) = Polygon::with_contours(&contours).coverage_with::<{ 2 * TOGETHER }>() {
            tile.add(&polygon, clip);
        }
    }
}

/// Whether a segment may meet pixels: the rectangle around it does, and a long one does not pass by on one side.
fn meets(pixels: &PixelRect, a: Vector, b: Vector) -> bool {
    // In 1/16 pixel, so that products fit.
    const FINER: u32 = 4;
    let (a, b) = ((a.0 >> FINER, a.1 >> FINER), (b.0 >> FINER, b.1 >> FINER));
    let sixteenths = |range: &Range<i32>| (i64::from(range.start) << FINER, i64::from(range.end) << FINER);
    let (columns, rows) = (sixteenths(&pixels.columns), sixteenths(&pixels.rows));
    let axis = |range: (i64, i64), a: i64, b: i64| a.max(b) + 1 >= range.0 && a.min(b) <= range.1;
    if !axis(columns, a.0, b.0) || !axis(rows, a.1, b.1) {
        return false;
    }
    // Two pixels more than half, for what is rounded.
    let half = |range: (i64, i64)| (range.1 - range.0) / 2 + (2 << FINER);
    let middle = |range: (i64, i64)| (range.0 + range.1) / 2;
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    if dx.abs() + dy.abs() <= half(columns) + half(rows) {
        return true;
    }
    let distance = dx * (middle(rows) - a.1) - dy * (middle(columns) - a.0);
    distance.abs() <= dx.abs() * half(rows) + dy.abs() * half(columns)
}

/// The rectangle of a stroke, which one pixel thin lines stay within when they are not blended.
pub(super) fn stroked_box(points: &[Point], by: Point, stroke: &Stroke, is_blended: bool) -> Rectangle {
    if stroke.width <= 1 && !is_blended && points.len() > 1 {
        let centres = points.iter().map(|&point| {
            let place = Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y));
            PixelRect { rows: place.y..place.y.saturating_add(1), columns: place.x..place.x.saturating_add(1) }
        });
        return centres.reduce(|a, b| union(&a, &b)).map_or(Rectangle::zero(), Rectangle::from);
    }
    if stroke.width == 0 {
        let first = points.first().copied().unwrap_or_default();
        let corner = Point::new(first.x.saturating_add(by.x), first.y.saturating_add(by.y));
        return Rectangle::new(corner, Size::zero());
    }
    let sides = if is_blended { Sides::blended(&stroke.open()) } else { Sides::new(&stroke.open()) };
    touched(points, by, &sides).into()
}
