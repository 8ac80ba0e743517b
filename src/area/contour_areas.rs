//! Contours of vertices, near or far.

use crate::{
    PixelRect,
    area::{
        CoverageEdge, PlacedAreaSink, Rounded,
        far::{Far, Vertices},
        fill::fill,
        source::Source,
        tiles::{for_each_tile, is_near},
    },
    contours::Contours,
    coverage::CoverageSink,
    geometry::touched,
    limits::ONE,
    outline::WindingRule,
    span::visible,
};

/// Sends how much of each pixel in `clip` the contours cover.
pub(crate) fn send_contours<S: CoverageSink>(
    contours: Contours<'_>,
    inside: WindingRule,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    Rounded::send(sink, |areas| send_areas(contours, inside, clip, slots, areas))
}

/// Sends the areas of the pixels in `clip`, before anything is rounded to 255ths.
pub(crate) fn send_areas(
    contours: Contours<'_>,
    inside: WindingRule,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut dyn PlacedAreaSink,
) {
    let touched = touched((0..contours.len()).flat_map(|index| contours.contour(index)));
    let Some((rows, columns)) = visible(&touched, clip) else { return };
    if is_near(&touched) {
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
