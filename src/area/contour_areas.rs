//! Contours of vertices, near or far.

use crate::{
    PixelRect,
    area::{
        CoverageEdge, Inside, PlacedAreaSink, Rounded,
        far::{Far, Vertices},
        fill::fill,
        source::{FINE_BITS, Source},
        tiles::{REACH, for_each_tile},
    },
    contours::Contours,
    coverage::CoverageSink,
    geometry::touched,
    limits::ONE,
    span::clip_range,
};

/// Sends how much of each pixel in `clip` the contours cover.
pub(crate) fn send_contours<S: CoverageSink>(
    contours: Contours<'_>,
    inside: Inside,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut rounded = Rounded::new(sink);
    send_areas(contours, inside, clip, slots, &mut rounded);
    rounded.result
}

/// Sends the areas of the pixels in `clip`, before anything is rounded to 255ths.
pub(crate) fn send_areas(
    contours: Contours<'_>,
    inside: Inside,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut dyn PlacedAreaSink,
) {
    let touched = touched((0..contours.len()).flat_map(|index| contours.contour(index)));
    let (rows, columns) = (clip_range(&touched.rows, &clip.rows), clip_range(&touched.columns, &clip.columns));
    if rows.is_empty() || columns.is_empty() {
        return;
    }
    let length = |range: &core::ops::Range<i32>| i64::from(range.end).abs_diff(i64::from(range.start)) << FINE_BITS;
    if length(&touched.rows) <= REACH && length(&touched.columns) <= REACH {
        let origin = (columns.start.wrapping_mul(ONE), rows.start.wrapping_mul(ONE));
        let size = (columns.end - columns.start, rows.end - rows.start);
        sink.place((columns.start, rows.start));
        fill(Source::Contours { contours, origin }, inside, size, slots, sink);
        return;
    }
    for_each_tile(&rows, &columns, |tile, corner, size| {
        sink.place(corner);
        let far = Far { vertices: Vertices::Contours(contours), tile, corner };
        fill(Source::Outline(&far), inside, size, slots, sink)
    });
}
