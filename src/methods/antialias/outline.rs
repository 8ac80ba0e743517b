//! What is drawn: closed contours with a fill rule, looked at edge by edge.

use crate::{FillRule, PixelRect, Vertex};

/// Closed contours with vertices in 1/256 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Outline<'a> {
    /// The last vertex of each is joined to its first.
    pub contours: &'a [&'a [Vertex]],
    /// What is inside where they overlap.
    pub fill_rule: FillRule,
}

/// A point in 1/256 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct At {
    pub(super) x: i64,
    pub(super) y: i64,
}

/// An edge, from its upper end to its lower.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) top: At,
    pub(super) bottom: At,
    /// 1 if the contour goes down here, -1 if up, 0 along a horizontal edge.
    pub(super) winding: i32,
}

impl Edge {
    /// The part of an edge in the rows from `above` to `below`, in 1/256: their heights and columns, if it is any.
    ///
    /// In `f64`, from differences that are exact.
    pub(super) fn within(&self, above: i64, below: i64) -> Option<[[f64; 2]; 2]> {
        let (from, to) = (self.top.y.max(above), self.bottom.y.min(below));
        if from >= to {
            return None;
        }
        let slope = (self.bottom.x - self.top.x) as f64 / (self.bottom.y - self.top.y) as f64;
        let at = |y: i64| {
            let x = if y == self.bottom.y {
                self.bottom.x as f64
            } else {
                self.top.x as f64 + (y - self.top.y) as f64 * slope
            };
            [x, (y - above) as f64]
        };
        Some([at(from), at(to)])
    }

    /// The first of the samples at `first`, `first + step`, .. on the line at `y` that lies on the edge or to its right;
    /// none if the edge does not cross that line. The line lies below every vertex that is on it.
    pub(super) fn crossing(&self, y: i64, first: i64, step: i64) -> Option<i64> {
        let Self { top, bottom, .. } = *self;
        if y < top.y || bottom.y <= y {
            return None;
        }
        let (dx, dy) = (bottom.x - top.x, bottom.y - top.y);
        let (right, down) = (top.x - first, y - top.y);
        // ceil((right + down dx / dy) / step), in 64 bits where that is enough.
        if right.unsigned_abs() | dx.unsigned_abs() | dy.unsigned_abs() < 1 << 31 {
            Some(-(-(right * dy + down * dx)).div_euclid(step * dy))
        } else {
            let [right, down, dx, dy] = [right, down, dx, dy].map(i128::from);
            Some(-(-(right * dy + down * dx)).div_euclid(i128::from(step) * dy) as i64)
        }
    }
}

impl<'a> Outline<'a> {
    pub(super) fn edges(&self) -> impl Iterator<Item = Edge> + 'a {
        self.contours.iter().flat_map(|contour| {
            let following = contour.iter().skip(1).chain(contour.first());
            contour.iter().zip(following).map(|(a, b)| {
                let [a, b] = [a, b].map(|v| At { x: v.x.to_bits().into(), y: v.y.to_bits().into() });
                if a.y <= b.y {
                    Edge { top: a, bottom: b, winding: (b.y > a.y).into() }
                } else {
                    Edge { top: b, bottom: a, winding: -1 }
                }
            })
        })
    }

    pub(super) fn is_inside(&self, winding: i32) -> bool {
        match self.fill_rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding & 1 != 0,
        }
    }

    /// The pixels in the clip that have anything in common with the bounding box.
    pub(super) fn pixels(&self, clip: &PixelRect) -> PixelRect {
        let (mut low, mut high) = ([i32::MAX; 2], [i32::MIN; 2]);
        for vertex in self.contours.iter().copied().flatten() {
            let at = [vertex.x.to_bits(), vertex.y.to_bits()];
            for ((low, high), at) in low.iter_mut().zip(&mut high).zip(at) {
                *low = (*low).min(at);
                *high = (*high).max(at);
            }
        }
        if low[0] >= high[0] || low[1] >= high[1] {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        let [left, top] = low.map(|bits| bits >> 8);
        let [right, bottom] = high.map(|bits| ((bits - 1) >> 8) + 1);
        PixelRect {
            rows: top.max(clip.rows.start)..bottom.min(clip.rows.end),
            columns: left.max(clip.columns.start)..right.min(clip.columns.end),
        }
    }
}

/// How many columns a rectangle has.
pub(super) fn width(pixels: &PixelRect) -> usize {
    if pixels.rows.is_empty() || pixels.columns.is_empty() {
        0
    } else {
        pixels.columns.end.abs_diff(pixels.columns.start) as usize
    }
}

/// A sum of signed areas, 1 a pixel, by the fill rule: right where the outline does not overlap itself.
pub(super) fn ruled(area: f64, fill_rule: FillRule) -> f64 {
    match fill_rule {
        FillRule::NonZero => area.abs().min(1.0),
        FillRule::EvenOdd => {
            let folded = area.abs() - 2.0 * libm::floor(area.abs() / 2.0);
            if folded > 1.0 { 2.0 - folded } else { folded }
        }
    }
}
