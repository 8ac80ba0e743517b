//! Outlines whose vertices are worked out, near or far.

use crate::{
    PixelRect,
    area::{
        CoverageEdge, PlacedAreaSink, Rounded,
        far::{self, Far},
        fill::fill,
        source::{FINE_BITS, Outline, Point, Source},
        tiles::{for_each_tile, is_near},
    },
    coverage::CoverageSink,
    outline::{FinePoint, Vertices, WindingRule},
    span::visible,
};

/// From 1/4096 pixel to 2^-16.
const FINER: u32 = 4;

/// Sends how much of each pixel in `clip` an outline covers that lies within the pixels `touched`.
pub(crate) fn send_outline<S: CoverageSink>(
    vertices: &dyn Vertices,
    inside: WindingRule,
    touched: &PixelRect,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    Rounded::send(sink, |areas| send_areas(vertices, inside, touched, clip, slots, areas))
}

fn send_areas(
    vertices: &dyn Vertices,
    inside: WindingRule,
    touched: &PixelRect,
    clip: &PixelRect,
    slots: &mut [CoverageEdge],
    sink: &mut dyn PlacedAreaSink,
) {
    let Some((rows, columns)) = visible(touched, clip) else { return };
    if is_near(touched) {
        let corner = (columns.start, rows.start);
        sink.place(corner);
        let size = (columns.end - columns.start, rows.end - rows.start);
        fill(Source::Outline(&Near { vertices, corner }), inside, size, slots, sink);
        return;
    }
    for_each_tile(&rows, &columns, |tile, corner, size| {
        sink.place(corner);
        let far = Far { vertices: far::Vertices::Outline(vertices), tile, corner };
        fill(Source::Outline(&far), inside, size, slots, sink)
    });
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
