//! The shapes: each knows its pixels, and no colour or target.

mod circle;
mod line;
mod outline;
mod polygon;
mod supersampled;
mod triangle;

pub use crate::contours::FillRule;
pub use circle::Circle;
pub use line::Line;
pub use outline::{CoverOutline, OutlineCoverageIn, OutlineCoverageWith};
pub use polygon::{ActiveEdge, Polygon, PolygonCoverageIn, PolygonCoverageWith, PolygonInScratch, PolygonWithCapacity};
pub use supersampled::{PolygonEdges, SampleEdge, SupersampledIn};
pub use triangle::Triangle;

use crate::{
    PixelRect,
    coverage::CoverageSink,
    span::{BlockSink, SpanSink},
};

/// A set of pixels that can be pushed into a sink, cut to a clip.
///
/// Which pixels those are does not depend on the clip: drawing through the tiles of any partition gives the whole.
pub trait Shape {
    /// A rectangle outside which the shape has no pixel.
    fn bounds(&self) -> PixelRect;

    /// Pushes the spans inside `clip`: rows go down, columns go right, each pixel once.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error>;

    /// Pushes the same pixels as rectangles, equal consecutive rows as one.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error>;
}

/// A shape that can tell how much of each pixel it covers.
///
/// Pixels are those that a coordinate can name, columns and rows -8388608..=8388607; what lies beyond may be left out.
///
/// ```text
///      .-'|      |         coverage is the area of the shape in the pixel, in 255ths:
///   .-'###|######|         rounded once, whatever the clip, and nothing of it depends on the clip:
///   ######|######|         drawing through the tiles of any partition gives the whole
///     191    255
/// ```
///
/// For triangles, polygons and lines, the area is exact: coverage is off by at most 0.5, and by what is stated in
/// `docs/NUMERICS.md` about many tall edges in one pixel, less than 0.01 for anything usual. That holds for contours that
/// overlap or cross inside a pixel, too. Circles are within 0.6. Supersampled shapes count samples in place of areas.
pub trait Cover {
    /// A rectangle outside which the shape covers nothing of any pixel.
    fn touched(&self) -> PixelRect;

    /// Pushes the coverage of the pixels inside `clip`.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error>;
}

impl<C: Cover> Cover for &C {
    fn touched(&self) -> PixelRect {
        (**self).touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        (**self).coverage(clip, sink)
    }
}
