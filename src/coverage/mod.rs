//! How much of each pixel a shape covers, and where that goes.

mod beyond;
mod cells;
mod chain;
mod circle_chords;
mod circle_rows;
mod convex;
mod eights;
mod few;
mod ramp;
mod runs;
mod samples;
mod sides;
mod slope;
mod steepness;
mod stepper;
mod straight;
mod sweep;

pub(crate) use beyond::send_within_range;
pub(crate) use cells::Cell;
pub(crate) use cells::Cells;
pub(crate) use chain::WideChain;
pub(crate) use circle_rows::NearCircle;
pub(crate) use convex::{Side, send};
pub(crate) use ramp::{Extent, Ramp, height_in, height_of};
pub(crate) use runs::Runs;
pub(crate) use samples::Supersampler;
pub use samples::{SampleCell, Samples};
pub(crate) use steepness::Steepness;
pub(crate) use straight::{Side as StraightSide, Straight, send_straight};

use crate::span::Span;

/// Receives an anti-aliased shape: how much of each pixel it covers, in 255ths.
///
/// Everything lies inside the clip that the shape was given, each pixel comes at most once, and none comes that is not
/// covered. They come in no particular order.
///
/// ```text
///              run                span               run
///          10  84 201 | 255 255 255 255 255 255 | 130  12
/// ```
pub trait CoverageSink {
    /// What can fail in the sink; it ends the walk and is handed to the caller.
    type Error;

    /// Whether the edges of shapes come by [`eights`](Self::eights) and [`span_with_sides`](Self::span_with_sides), too, which
    /// suits sinks that handle eight pixels as fast as two or three. The coverage is the same.
    const EIGHTS: bool = false;

    /// Takes pixels that are all covered alike, of which there is at least one: mostly wholly, by 255.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Self::Error>;

    /// Takes the pixels of `row` from `column` on, one for each of `coverage`, of which there is at least one and
    /// none is 0.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Self::Error>;

    /// Takes a span of at least eight pixels, of which the first four and the last four are covered as `sides` tells, and
    /// the others wholly. Those of coverage 0 are not part of the shape.
    ///
    /// ```text
    ///   sides     84 201 255 255                 255 255 255  31
    ///   columns   [ 84 201 255 255 | 255 255 255 | 255 255 255  31 ]
    /// ```
    ///
    /// By itself it is two eights and a span.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    #[inline]
    fn span_with_sides(&mut self, span: Span, sides: &[u8; 8]) -> Result<(), Self::Error> {
        let [a, b, c, d, e, f, g, h] = *sides;
        let Span { row, columns } = span;
        let inside = columns.start.wrapping_add(4)..columns.end.wrapping_sub(4);
        self.eights(row, columns.start, &[[a, b, c, d, 0, 0, 0, 0]])?;
        if inside.start < inside.end {
            self.span(Span { row, columns: inside.clone() }, 255)?;
        }
        self.eights(row, inside.end, &[[e, f, g, h, 0, 0, 0, 0]])
    }

    /// Takes eight pixels of `row` for each of `coverage`, of which there is at least one, from `column` on. Those of coverage 0
    /// are not part of the shape, and may lie to the right of the clip.
    ///
    /// ```text
    ///   coverage   [ 84 201 255 255 255 255 255 255 ] [ 255 130   0   0   0  31  97   0 ]
    /// ```
    ///
    /// By itself it takes them apart into runs.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    #[inline]
    fn eights(&mut self, row: i32, column: i32, coverage: &[[u8; 8]]) -> Result<(), Self::Error> {
        let coverage = coverage.as_flattened();
        let mut rest = coverage;
        while let Some(start) = rest.iter().position(|&coverage| coverage != 0) {
            rest = rest.get(start..).unwrap_or_default();
            let length = rest.iter().position(|&coverage| coverage == 0).unwrap_or(rest.len());
            let (run, after) = rest.split_at_checked(length).unwrap_or_default();
            let before = i32::try_from(coverage.len() - rest.len()).unwrap_or(0);
            self.run(row, column.wrapping_add(before), run)?;
            rest = after;
        }
        Ok(())
    }
}
