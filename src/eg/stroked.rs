//! The areas that a stroke along straight segments covers: one for each segment, and one for the outside of each joint.
//!
//! ```text
//!     +-----------------+ - +  <- mitre, if it is not farther from the vertex than twice the width
//!     |    segment      |  /|
//!     o- - - - - - - - -o+  |
//!     |                 |   |
//!     +-----------------+   |
//! ```

use core::{convert::Infallible, ops::Range};

use embedded_graphics_core::{Drawable, draw_target::DrawTarget, geometry::Point};
use heapless::Vec;

use crate::{
    CoverageSink, PixelRect, Polygon, Vertex, draw::Fill, geometry::touched, outline::Vector, primitive::Quadrilateral,
    shape::Cover, stroke::Unit,
};

use super::{outline::vertex, paint::Sides};

/// The centre of a pixel in 1/256 pixel; pixels beyond the coordinates there are count as the last.
pub(super) fn centre(point: Point) -> Vector {
    let axis = |pixel: i32| i64::from(pixel.clamp(-(1 << 23), (1 << 23) - 1)) * 256 + 128;
    Vector::new(axis(point.x), axis(point.y))
}

/// From an end of a line to where its pixel ends: half a pixel along its major axis.
pub(super) fn cap(from: Vector, to: Vector) -> Vector {
    let Vector { x, y } = to.minus(from);
    let major = x.abs().max(y.abs());
    if major <= 0 { Vector::new(128, 0) } else { Vector::new(128 * x / major, 128 * y / major) }
}

/// From where two sides meet to where they do when each is moved `offset` along its normal; none where they turn back.
pub(super) fn tip([a, b]: [Unit; 2], offset: i64) -> Option<Vector> {
    // Half the square of the length of the sum of the normals, in 2^-30.
    let sum = (1 << 30) + (a.dot(b) >> 30);
    if sum < 1 << 12 {
        return None;
    }
    // An offset is below 2^25, so this is below 2^57.
    let Vector { x, y } = a.0.plus(b.0).times(offset);
    Some(Vector::new(x.checked_div(sum)?, y.checked_div(sum)?))
}

/// The same, none when it is farther away than `limit`.
pub(super) fn mitre(normals: [Unit; 2], offset: i64, limit: i64) -> Option<Vector> {
    tip(normals, offset).filter(|tip| tip.dot(*tip) <= i128::from(limit) * i128::from(limit))
}

/// A rectangle around two.
pub(super) fn union(a: PixelRect, b: PixelRect) -> PixelRect {
    let axis = |a: Range<i32>, b: Range<i32>| a.start.min(b.start)..a.end.max(b.end);
    PixelRect { rows: axis(a.rows, b.rows), columns: axis(a.columns, b.columns) }
}

/// A stroke along points that are moved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Along<'p> {
    pub(super) points: &'p [Point],
    pub(super) by: Point,
    pub(super) sides: Sides,
}

impl Along<'_> {
    /// The rectangle around a segment.
    fn segment(&self, start: Vector, end: Vector, direction: Unit) -> Quadrilateral {
        let normal = direction.turned_back();
        let (up, down) = (normal.times(self.sides.left), normal.times(-self.sides.right));
        Quadrilateral([start.plus(up), end.plus(up), end.plus(down), start.plus(down)].map(vertex))
    }

    /// The area on the outside of a joint, between the rectangles of its segments.
    fn joint(&self, at: Vector, before: Unit, after: Unit) -> Option<Quadrilateral> {
        let turn = before.cross(after) >> 30;
        if turn == 0 {
            return None;
        }
        // Clockwise: the left side is the outside.
        let offset = if turn > 0 { self.sides.left } else { -self.sides.right };
        let normals = [before, after].map(Unit::turned_back);
        let [from, to] = normals.map(|normal| normal.times(offset));
        let tip = mitre(normals, offset, self.sides.limit).unwrap_or(to);
        Some(Quadrilateral([Vector::default(), from, tip, to].map(|corner| vertex(at.plus(corner)))))
    }

    /// The areas of those segments that `is_near` says so for.
    ///
    /// Segments without a length are left out. The first and the last reach to the ends of their pixels; when there is no
    /// other, the points are one, and the stroke is the square that the pen is.
    pub(super) fn each_area<E>(
        &self,
        is_near: impl Fn(Vector, Vector) -> bool,
        mut area: impl FnMut(Quadrilateral) -> Result<(), E>,
    ) -> Result<(), E> {
        let Self { points, by, sides } = *self;
        let place = |point: &Point| centre(Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y)));
        let (Some(first), Some(last)) = (points.first().map(place), points.last().map(place)) else { return Ok(()) };
        // The last segment that has a length ends where the points from there on are all the same.
        let Some(before_last) = points.iter().rposition(|point| place(point) != last) else {
            let (start, end) =
                (Vector::new(first.x - sides.left, first.y), Vector::new(first.x + sides.right, first.y));
            return if points.len() > 1 { area(self.segment(start, end, Unit::RIGHT)) } else { Ok(()) };
        };
        let (mut before, mut start): (Option<Vector>, Vector) = (None, first);
        for (index, point) in points.iter().enumerate().take(before_last + 2).skip(1) {
            let end = place(point);
            if end == start {
                continue;
            }
            if let (true, Some(direction)) = (is_near(start, end), Unit::along(end.minus(start))) {
                let cap = cap(start, end);
                let from = if before.is_none() { start.minus(cap) } else { start };
                let to = if index > before_last { end.plus(cap) } else { end };
                area(self.segment(from, to, direction))?;
                let joint = before.and_then(|before| self.joint(start, Unit::along(start.minus(before))?, direction));
                joint.map_or(Ok(()), &mut area)?;
            }
            (before, start) = (Some(start), end);
        }
        Ok(())
    }

    /// Draws area by area, where areas overlap more than once.
    pub(super) fn draw<D: DrawTarget>(&self, colour: D::Color, target: &mut D) -> Result<(), D::Error> {
        self.each_area(|_, _| true, |area| area.filled(colour).draw(target))
    }
}

/// As many areas as are added up by the non-zero rule; of more near one tile, some may be covered twice where they
/// overlap.
const TOGETHER: usize = 24;

impl Cover for Along<'_> {
    fn touched(&self) -> PixelRect {
        let mut all: Option<PixelRect> = None;
        let result: Result<(), Infallible> = self.each_area(
            |_, _| true,
            |Quadrilateral(corners)| {
                let area = Some(touched(corners.iter())).filter(|area| !area.rows.is_empty());
                all = all.take().into_iter().chain(area).reduce(union);
                Ok(())
            },
        );
        match result {
            Ok(()) => all.unwrap_or(PixelRect { rows: 0..0, columns: 0..0 }),
            Err(never) => match never {},
        }
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut together: Vec<[Vertex; 4], TOGETHER> = Vec::new();
        self.each_area(
            |start, end| self.meets(clip, start, end),
            |area| match together.push(area.clockwise()) {
                Ok(()) => Ok(()),
                Err(area) => {
                    cover(&together, clip, sink)?;
                    together.clear();
                    // There is room now.
                    together.push(area).unwrap_or_default();
                    Ok(())
                }
            },
        )?;
        cover(&together, clip, sink)
    }
}

#[inline(never)]
fn cover<S: CoverageSink>(areas: &[[Vertex; 4]], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let mut contours: [&[Vertex]; TOGETHER] = [&[]; TOGETHER];
    contours.iter_mut().zip(areas).for_each(|(contour, area)| *contour = area);
    let contours = contours.get(..areas.len()).unwrap_or(&contours);
    let polygon = Polygon::with_contours(contours).coverage_with::<{ 2 * TOGETHER }>();
    polygon.map_or(Ok(()), |polygon| polygon.coverage(clip, sink))
}

impl Along<'_> {
    /// Whether a segment may meet pixels: the rectangle around it does, and a long one does not pass by on one side.
    fn meets(&self, pixels: &PixelRect, a: Vector, b: Vector) -> bool {
        // Of pixels the middle and half the size, and as much more as a mitre may reach.
        let axis = |range: &Range<i32>| {
            let (start, end) = (256 * i64::from(range.start), 256 * i64::from(range.end));
            ((start + end) / 2, (end - start) / 2 + self.sides.limit + 512)
        };
        let ((x, half_width), (y, half_height)) = (axis(&pixels.columns), axis(&pixels.rows));
        let is_apart = |a: i64, b: i64, half: i64| a.min(b) > half || a.max(b) < -half;
        let (from, to) = (a.minus(Vector::new(x, y)), b.minus(Vector::new(x, y)));
        if is_apart(from.x, to.x, half_width) || is_apart(from.y, to.y, half_height) {
            return false;
        }
        let along = to.minus(from);
        if along.x.abs() + along.y.abs() <= half_width + half_height {
            return true;
        }
        let reach = Vector::new(along.x.abs(), along.y.abs()).dot(Vector::new(half_height, half_width));
        along.turned().dot(from).abs() <= reach
    }
}
