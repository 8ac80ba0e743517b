//! How much of each pixel a shape covers, and where that goes.

mod runs;
mod samples;

pub(crate) use runs::Runs;
pub(crate) use samples::Supersampler;
pub use samples::{SampleCell, Samples};

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
}

impl<S: CoverageSink + ?Sized> CoverageSink for &mut S {
    type Error = S::Error;

    #[inline]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), S::Error> {
        (**self).span(span, coverage)
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), S::Error> {
        (**self).run(row, column, coverage)
    }
}
