//! The boundary to grow up to, and a pixel to grow from.

use core::ops::Range;

use super::{Canvas, Touch};
use crate::{geometry::PixelRect, methods::polygon::Contours, shape::FillRule};

/// Closes the pixels of the edges of contours in 1/256 pixel: lines from the pixel of one vertex to that of the next,
/// as Bresenham's, with their steps taken by quotient and remainder.
///
/// Where they change rows (or columns, if steep), a fill by corners would get through: against [`Touch::Corners`],
/// the pixel beside the step is closed, too.
pub fn draw(contours: &(impl Contours<i32> + ?Sized), against: Touch, canvas: &mut Canvas<'_>) {
    for edge in contours.edges() {
        let [a, b] = edge.map(|vertex| vertex.map(|coordinate| coordinate >> 8));
        let (dx, dy) = (b[0].abs_diff(a[0]), b[1].abs_diff(a[1]));
        let (rows, columns) = (canvas.clip.rows.clone(), canvas.clip.columns.clone());
        if dx >= dy {
            let (a, b) = if a[0] <= b[0] { (a, b) } else { (b, a) };
            steps([a[0], a[1]], [b[0], b[1]], &columns, against, |x, y| canvas.close(x, y));
        } else {
            let (a, b) = if a[1] <= b[1] { (a, b) } else { (b, a) };
            steps([a[1], a[0]], [b[1], b[0]], &rows, against, |y, x| canvas.close(x, y));
        }
    }
}

/// One pixel a step along the longer axis, which comes first.
fn steps(
    [from, across]: [i32; 2],
    [to, last_across]: [i32; 2],
    clip: &Range<i32>,
    against: Touch,
    mut pixel: impl FnMut(i32, i32) -> bool,
) {
    // Vertices have 24 bits before the point: lengths have 25, twice their products 51.
    let (length, rise) = (i64::from(to) - i64::from(from), i64::from(last_across) - i64::from(across));
    let start = from.max(clip.start);
    let end = to.saturating_add(1).min(clip.end);
    // Across by rise / length a step, and half a pixel to round: (2 rise k + length) / (2 length), rounded down.
    let divisor = (2 * length).max(1);
    let numerator = 2 * rise * (i64::from(start) - i64::from(from)) + length;
    let (mut quotient, mut remainder) = (numerator.div_euclid(divisor), numerator.rem_euclid(divisor));
    let (whole, part) = ((2 * rise).div_euclid(divisor), (2 * rise).rem_euclid(divisor));
    let mut previous = None;
    for along in start..end {
        #[allow(clippy::cast_possible_truncation, reason = "between the two ends")]
        let here = across.wrapping_add(quotient as i32);
        if against == Touch::Corners && previous.is_some_and(|previous| previous != here) {
            pixel(along, previous.unwrap_or(here));
        }
        pixel(along, here);
        previous = Some(here);
        quotient += whole;
        remainder += part;
        if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        }
    }
}

/// A pixel inside: the middle of the widest span of the middle row. None where the polygon has none there.
pub fn seed(contours: &(impl Contours<i32> + ?Sized), rule: FillRule, clip: &PixelRect) -> Option<[i32; 2]> {
    let heights = || contours.edges().map(|[[_, y], _]| y >> 8);
    let top = heights().min()?.max(clip.rows.start);
    let bottom = heights().max()?.min(clip.rows.end.saturating_sub(1));
    if top > bottom {
        return None;
    }
    let row = top + (bottom - top) / 2;
    let centre = i64::from(row) * 256 + 128;
    let crossings = || contours.edges().filter_map(move |edge| crossing(edge, centre));
    let mut widest: Option<(i64, i64)> = None;
    for (start, _) in crossings() {
        let winding: i32 = crossings().filter(|(x, _)| *x <= start).map(|(_, direction)| direction).sum();
        let is_inside = match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding & 1 != 0,
        };
        let Some(end) = crossings().map(|(x, _)| x).filter(|x| *x > start).min() else { continue };
        let subpixels = |column: i32| i64::from(column) * 256;
        let (start, end) = (start.max(subpixels(clip.columns.start)), end.min(subpixels(clip.columns.end)));
        if is_inside && start < end && widest.is_none_or(|(from, to)| end - start > to - from) {
            widest = Some((start, end));
        }
    }
    let (start, end) = widest?;
    let column = i32::try_from((start + (end - start) / 2) >> 8).ok()?;
    Some([column, row])
}

/// Where an edge crosses a height, and whether downwards (1) or upwards (-1).
fn crossing([a, b]: [[i32; 2]; 2], y: i64) -> Option<(i64, i32)> {
    let ([ax, ay], [bx, by]) = (a.map(i64::from), b.map(i64::from));
    if (ay <= y) == (by <= y) {
        return None;
    }
    let offset = i128::from(y - ay) * i128::from(bx - ax) / i128::from(by - ay);
    Some((ax + i64::try_from(offset).ok()?, if ay < by { 1 } else { -1 }))
}
