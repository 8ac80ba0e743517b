//! What shapes that know each row's columns have in common.

use core::ops::Range;

use crate::{
    PixelRect, Vertex,
    outline::{Curve, FinePoint, Step, Vector},
    span::{RowSink, clip_range},
    subpixel::first_centre_at_or_after_wide,
};

/// The columns, or rows, whose centres are at or after the first position and before the second; in 1/256 pixel.
pub(super) fn centres(positions: Range<i64>) -> Range<i32> {
    #[allow(clippy::cast_possible_truncation, reason = "positions below 2^33 are in pixels below 2^25")]
    let pixel = |position: i64| first_centre_at_or_after_wide(position.clamp(-(1 << 34), 1 << 34)) as i32;
    pixel(positions.start)..pixel(positions.end)
}

/// The centre of a row or column, in 1/256 pixel.
pub(super) fn centre_of(pixel: i32) -> i64 {
    i64::from(pixel) * 256 + 128
}

/// The largest whole number whose square is less than `square`; none where there is none that is at least 0.
pub(super) fn root_below(square: i128) -> Option<i64> {
    let below = u128::try_from(square - 1).ok()?;
    // Below 2^126.
    let root = match u64::try_from(below) {
        Ok(below) => below.isqrt(),
        Err(_) => u64::try_from(below.isqrt()).unwrap_or(u64::MAX >> 1),
    };
    Some(root.cast_signed())
}

/// Sends each visible row's columns: `columns` tells up to `N` ranges, from left to right, which may touch or be empty.
pub(super) fn send_rows<const N: usize, R: RowSink>(
    bounds: &PixelRect,
    clip: &PixelRect,
    sink: &mut R,
    mut columns: impl FnMut(i32) -> [Range<i32>; N],
) -> Result<(), R::Error> {
    for row in clip_range(&bounds.rows, &clip.rows) {
        let mut open = 0..0;
        for range in columns(row) {
            let range = clip_range(&range, &clip.columns);
            if range.is_empty() {
                continue;
            }
            if open.is_empty() {
                open = range;
            } else if range.start <= open.end {
                open.end = open.end.max(range.end);
            } else {
                sink.span(row, core::mem::replace(&mut open, range))?;
            }
        }
        if !open.is_empty() {
            sink.span(row, open)?;
        }
        sink.end_row(row)?;
    }
    Ok(())
}

/// Implements `Shape` by a function that sends rows.
macro_rules! shape_by_rows {
    ($shape:ty) => {
        impl $crate::shape::Shape for $shape {
            fn bounds(&self) -> $crate::PixelRect {
                self.pixel_bounds()
            }

            fn spans<S: $crate::SpanSink>(&self, clip: &$crate::PixelRect, sink: &mut S) -> Result<(), S::Error> {
                self.send(clip, &mut $crate::span::EachSpan(sink))
            }

            fn blocks<S: $crate::BlockSink>(&self, clip: &$crate::PixelRect, sink: &mut S) -> Result<(), S::Error> {
                $crate::span::MergeRows::merged(sink, |merge| self.send(clip, merge))
            }
        }

        impl $crate::outline::Outline for $shape {
            fn with_vertices<R>(&self, with: impl FnOnce(&dyn $crate::outline::Vertices) -> R) -> R {
                $crate::outline::Curves::outline(self).with_vertices(with)
            }

            fn extent(&self) -> $crate::outline::FineRect {
                $crate::outline::Curves::outline(self).extent()
            }
        }
    };
}

pub(super) use shape_by_rows;

/// A whole turn, in 2^-32.
pub(super) const TURN: i64 = 1 << 32;

/// The half axes of a circle, for `Curve::arc`: `radius` in 1/256 pixel, 12 bits more for axes.
pub(super) const fn circle_axes(radius: i64) -> [Vector; 2] {
    [Vector::new(radius << 12, 0), Vector::new(0, radius << 12)]
}

/// A whole circle, clockwise or not, from its rightmost point.
pub(super) fn circle(center: Vertex, radius: i64, is_clockwise: bool) -> Curve {
    let center = FinePoint::from_vertex(center);
    let right = Vector::new(radius << 4, 0).from(center);
    let sweep = if is_clockwise { TURN } else { -TURN };
    Curve::arc(right, right, center, circle_axes(radius), crate::Angle::ZERO, sweep)
}

/// A closed subpath: one of the points, in order, or the close.
pub(super) fn polygon_step(points: &[FinePoint], index: u32) -> Step {
    let at = |index: usize| points.get(index).copied().unwrap_or_default();
    let index = index as usize;
    match index.checked_sub(1) {
        None => Step::Move(at(0)),
        Some(before) if index < points.len() => Step::Line(at(before), at(index)),
        Some(before) => Step::Close(at(before), at(0)),
    }
}
