//! Contours of vertices, near or far.

use crate::{
    PixelRect,
    area::{
        AreaSink, CoverageEdge, Inside, Rounded,
        far::{Far, LONGEST, TILE},
        fill::fill,
        source::Source,
    },
    contours::Contours,
    coverage::CoverageSink,
    geometry::touched,
    limits::ONE,
    span::clip_range,
};

/// Takes areas from a corner of the screen on.
pub(crate) trait PlacedAreaSink: AreaSink {
    /// Column and row that are the first in what follows.
    fn place(&mut self, corner: (i32, i32));
}

/// Sends how much of each pixel in `clip` the contours cover.
pub(crate) fn send_contours<S: CoverageSink>(
    contours: Contours<'_>,
    inside: Inside,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut rounded = Rounded { sink, corner: (0, 0), result: Ok(()) };
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
    const REACH: i64 = (LONGEST as i64) / ONE as i64;
    let length = |range: &core::ops::Range<i32>| i64::from(range.end) - i64::from(range.start);
    if length(&touched.rows) <= REACH && length(&touched.columns) <= REACH {
        let origin = (columns.start.wrapping_mul(ONE), rows.start.wrapping_mul(ONE));
        let size = (columns.end - columns.start, rows.end - rows.start);
        sink.place((columns.start, rows.start));
        fill(Source::Contours { contours, origin }, inside, size, slots, sink);
        return;
    }
    let mut y = rows.start;
    while y < rows.end {
        let tile_y = y & -TILE;
        let bottom = rows.end.min(tile_y.saturating_add(TILE));
        let mut x = columns.start;
        while x < columns.end {
            let tile_x = x & -TILE;
            let right = columns.end.min(tile_x.saturating_add(TILE));
            sink.place((x, y));
            let far = Far { contours, tile: (tile_x, tile_y), corner: (x, y) };
            if !fill(Source::Outline(&far), inside, (right - x, bottom - y), slots, sink) {
                return;
            }
            x = right;
        }
        y = bottom;
    }
}
