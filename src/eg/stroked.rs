//! The areas that a stroke along straight segments covers: one for each segment, and one for the outside of each joint.
//!
//! ```text
//!     +-----------------+ - +  <- mitre, if it is not farther from the vertex than twice the width
//!     |    segment      |  /|
//!     o- - - - - - - - -o+  |
//!     |                 |   |
//!     +-----------------+   |
//! ```

use embedded_graphics_core::geometry::Point;

use crate::Vertex;

use super::{
    normal::{ONE, Vector, add, along, cross, dot, left, unit},
    outline::vertex,
    paint::Stroke,
};

/// The centre of a pixel in 1/256 pixel; pixels beyond the coordinates there are count as the last.
pub(super) fn centre(point: Point) -> Vector {
    let axis = |pixel: i32| i64::from(pixel.clamp(-(1 << 23), (1 << 23) - 1)) * 256 + 128;
    (axis(point.x), axis(point.y))
}

fn minus(a: Vector, b: Vector) -> Vector {
    (a.0 - b.0, a.1 - b.1)
}

fn corner((x, y): Vector) -> Vertex {
    vertex(x, y)
}

/// From an end of a line to where its pixel ends: half a pixel along its major axis.
pub(super) fn cap(from: Vector, to: Vector) -> Vector {
    let (x, y) = minus(to, from);
    let major = x.abs().max(y.abs());
    if major <= 0 { (128, 0) } else { (128 * x / major, 128 * y / major) }
}

/// The tip of two sides that meet at `at`, each `offset` along its normal; none when it is farther away than `limit`.
pub(super) fn mitre(at: Vector, normals: [Vector; 2], offset: i64, limit: i64) -> Option<Vector> {
    let tip = tip(normals, offset)?;
    let square = |value: i64| value.unsigned_abs().saturating_pow(2);
    let is_near = square(tip.0).saturating_add(square(tip.1)) <= square(limit);
    is_near.then(|| add(at, tip))
}

/// From where two sides meet to where they do when each is moved `offset` along its normal; none where they turn back.
pub(super) fn tip([a, b]: [Vector; 2], offset: i64) -> Option<Vector> {
    // Half the square of the length of the sum of the normals.
    let sum = ONE + dot(a, b);
    if sum < ONE >> 18 {
        return None;
    }
    // An offset is below 2^25, so this is below 2^45.
    Some(((offset * (a.0 + b.0)).checked_div(sum)?, (offset * (a.1 + b.1)).checked_div(sum)?))
}

/// The sides of a stroke in 1/256 pixel: to its left and to its right, and how far a mitre may reach.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sides {
    pub(super) left: i64,
    pub(super) right: i64,
    pub(super) limit: i64,
}

impl Sides {
    pub(super) fn new(stroke: &Stroke) -> Self {
        let (left, right) = stroke.halves();
        Self { left: 128 * left, right: 128 * right, limit: 512 * stroke.width }
    }
}

impl Sides {
    /// Of a blended stroke, which has no need of whole pixels: in the middle, its sides are as far from the line as
    /// each other, whichever way that goes.
    pub(super) fn blended(stroke: &Stroke) -> Self {
        let sides = Self::new(stroke);
        if stroke.is_centered() {
            let half = (sides.left + sides.right) / 2;
            Self { left: half, right: half, ..sides }
        } else {
            sides
        }
    }
}

/// The rectangle around a segment.
fn segment(start: Vector, end: Vector, direction: Vector, sides: &Sides) -> [Vertex; 4] {
    let normal = left(direction);
    let (up, down) = (along(normal, sides.left), along(normal, -sides.right));
    [corner(add(start, up)), corner(add(end, up)), corner(add(end, down)), corner(add(start, down))]
}

/// The area on the outside of a joint, between the rectangles of its segments: three vertices, or four with a mitre.
fn joint(at: Vector, before: Vector, after: Vector, sides: &Sides) -> Option<([Vertex; 4], usize)> {
    let turn = cross(before, after);
    if turn == 0 {
        return None;
    }
    // Clockwise: the left side is the outside.
    let offset = if turn > 0 { sides.left } else { -sides.right };
    let normals = [left(before), left(after)];
    let [from, to] = normals.map(|normal| corner(add(at, along(normal, offset))));
    Some(match mitre(at, normals, offset, sides.limit) {
        Some(tip) => ([corner(at), from, corner(tip), to], 4),
        None => ([corner(at), from, to, to], 3),
    })
}

/// The areas of a stroke along `points`, moved by `by`, of those segments that `is_near` says so for.
///
/// Segments without a length are left out. The first and the last reach to the ends of their pixels; when there is no
/// other, the points are one, and the stroke is the square that the pen is.
pub(super) fn each_area<E>(
    points: &[Point],
    by: Point,
    sides: &Sides,
    is_near: impl Fn(Vector, Vector) -> bool,
    mut area: impl FnMut(&[Vertex]) -> Result<(), E>,
) -> Result<(), E> {
    let place = |point: &Point| centre(Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y)));
    let (Some(first), Some(last)) = (points.first().map(place), points.last().map(place)) else { return Ok(()) };
    if points.len() < 2 {
        return Ok(());
    }
    let (mut before, mut start): (Option<Vector>, Vector) = (None, first);
    // The last segment that has a length ends where the points from there on are all the same.
    let end_of_all = points.iter().rposition(|point| place(point) != last).map_or(0, |index| index + 1);
    if end_of_all == 0 {
        return if is_near(first, first) {
            area(&segment(minus(first, (sides.left, 0)), add(first, (sides.right, 0)), (ONE, 0), sides))
        } else {
            Ok(())
        };
    }
    for (index, point) in points.iter().enumerate().skip(1) {
        let end = place(point);
        if end == start {
            continue;
        }
        let direction = if is_near(start, end) { unit(minus(end, start)) } else { None };
        if let Some(direction) = direction {
            let cap = cap(start, end);
            let from = if before.is_none() { minus(start, cap) } else { start };
            let to = if index >= end_of_all { add(end, cap) } else { end };
            area(&segment(from, to, direction, sides))?;
            let joint = before.and_then(|before| joint(start, unit(minus(start, before))?, direction, sides));
            if let Some((corners, count)) = joint {
                area(corners.get(..count).unwrap_or(&corners))?;
            }
        }
        (before, start) = (Some(start), end);
    }
    Ok(())
}
