//! What shapes produce, and where it goes.
//!
//! A shape pushes; nothing pulls. Pushing keeps the walk a plain loop with its state in registers, lets `?` carry the
//! sink's error out, and needs no sentinel state.

mod clip;
mod merge;

pub(crate) use clip::{clip_range, visible};
pub(crate) use merge::{EachSpan, MergeRows, OpenBlock, RowSink, SplitRows};

use core::ops::Range;

/// A horizontal run of pixels: `columns` of `row`, half-open, never empty when a shape sends it.
///
/// ```text
///            columns.start   columns.end
///                 |               |
///   row  . . . . [# # # # # # # #[. . . .
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Span {
    /// The row, in whole pixels.
    pub row: i32,
    /// The columns, in whole pixels, half-open.
    pub columns: Range<i32>,
}

/// Receives the spans of a shape.
///
/// Rows go down, columns go right, each pixel comes once, and everything lies inside the clip the shape was given.
pub trait SpanSink {
    /// What can fail in the sink; it ends the walk and is handed to the caller.
    type Error;

    /// Takes one span.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    fn span(&mut self, span: Span) -> Result<(), Self::Error>;
}

impl<S: SpanSink + ?Sized> SpanSink for &mut S {
    type Error = S::Error;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        (**self).span(span)
    }
}

/// Receives the pixels of a shape as rectangles, each pixel once: what a display with an address window wants.
///
/// Equal consecutive rows come as one rectangle. The first rows of the rectangles go down; columns go right among
/// rectangles with the same first row.
pub trait BlockSink {
    /// What can fail in the sink; it ends the walk and is handed to the caller.
    type Error;

    /// Takes one rectangle, never empty.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the shape stops at once.
    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), Self::Error>;
}
