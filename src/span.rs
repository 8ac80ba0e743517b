//! What shapes produce, and where it goes.
//!
//! A shape pushes; nothing pulls. Pushing keeps the walk a plain loop with its state in registers, lets `?` carry the
//! sink's error out, and needs no sentinel state.

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

/// Cuts spans to a range of columns on their way to the sink; what lies outside is dropped.
#[derive(Debug)]
pub(crate) struct ClipColumns<'s, S> {
    pub(crate) columns: Range<i32>,
    pub(crate) sink: &'s mut S,
}

impl<S: SpanSink> SpanSink for ClipColumns<'_, S> {
    type Error = S::Error;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        let columns = span.columns.start.max(self.columns.start)..span.columns.end.min(self.columns.end);
        if columns.is_empty() { Ok(()) } else { self.sink.span(Span { row: span.row, columns }) }
    }
}

/// Turns spans into blocks: equal spans on consecutive rows, with nothing between them, become one.
#[derive(Debug)]
pub(crate) struct MergeRows<'s, S> {
    sink: &'s mut S,
    rows: Range<i32>,
    columns: Range<i32>,
}

impl<'s, S: BlockSink> MergeRows<'s, S> {
    #[inline]
    pub(crate) fn new(sink: &'s mut S) -> Self {
        Self { sink, rows: 0..0, columns: 0..0 }
    }

    /// Sends what is still open.
    #[inline]
    pub(crate) fn finish(self) -> Result<(), S::Error> {
        if self.rows.is_empty() { Ok(()) } else { self.sink.block(self.rows, self.columns) }
    }
}

impl<S: BlockSink> SpanSink for MergeRows<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        if span.columns == self.columns && span.row == self.rows.end {
            self.rows.end = span.row.wrapping_add(1);
            return Ok(());
        }
        let rows = core::mem::replace(&mut self.rows, span.row..span.row.wrapping_add(1));
        let columns = core::mem::replace(&mut self.columns, span.columns);
        if rows.is_empty() { Ok(()) } else { self.sink.block(rows, columns) }
    }
}
