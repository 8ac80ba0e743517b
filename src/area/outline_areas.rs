//! Outlines whose vertices are worked out, near or far.

use crate::{
    PixelRect, WindingRule,
    area::{
        CoverageEdge, Inside, PlacedAreaSink as _, Rounded,
        far::{self, Far},
        fill::fill,
        source::{FINE_BITS, Outline, Point, Source},
        tiles::{REACH, for_each_tile},
    },
    coverage::CoverageSink,
    outline::{FinePoint, Vertices},
    span::clip_range,
};

/// From 1/4096 pixel to 2^-16.
const FINER: u32 = 4;

/// Sends how much of each pixel in `clip` an outline covers that lies within the pixels `touched`.
pub(crate) fn send_outline<S: CoverageSink>(
    vertices: &dyn Vertices,
    rule: WindingRule,
    touched: &PixelRect,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    let (rows, columns) = (clip_range(&touched.rows, &clip.rows), clip_range(&touched.columns, &clip.columns));
    if rows.is_empty() || columns.is_empty() {
        return Ok(());
    }
    let inside = Inside { mask: rule.mask, flip: rule.flip, least: rule.least };
    let mut rounded = Rounded::new(sink);
    let length = |range: &core::ops::Range<i32>| i64::from(range.end).abs_diff(i64::from(range.start)) << FINE_BITS;
    if length(&touched.rows) <= REACH && length(&touched.columns) <= REACH {
        let corner = (columns.start, rows.start);
        rounded.place(corner);
        let size = (columns.end - columns.start, rows.end - rows.start);
        fill(Source::Outline(&Near { vertices, corner }), inside, size, slots, &mut rounded);
        return rounded.result;
    }
    for_each_tile(&rows, &columns, |tile, corner, size| {
        rounded.place(corner);
        let far = Far { vertices: far::Vertices::Outline(vertices), tile, corner };
        fill(Source::Outline(&far), inside, size, slots, &mut rounded)
    });
    rounded.result
}

struct Near<'a> {
    vertices: &'a dyn Vertices,
    /// Of what is drawn, in pixels.
    corner: (i32, i32),
}

impl Outline for Near<'_> {
    fn contours(&self) -> u32 {
        self.vertices.contours()
    }

    fn first(&self, contour: u32) -> Option<u32> {
        self.vertices.first(contour)
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        self.vertices.next(contour, index, is_forward)
    }

    fn vertex(&self, contour: u32, index: u32) -> Point {
        let FinePoint { x, y } = self.vertices.vertex(contour, index);
        // At most 2^29 apart, whatever is lost of each.
        let relative = |at: i32, corner: i32| (at << FINER).wrapping_sub(corner << FINE_BITS);
        Point { x: relative(x, self.corner.0), y: relative(y, self.corner.1) }
    }
}
