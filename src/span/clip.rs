//! Cutting spans to the visible columns.

use core::ops::Range;

use crate::span::{Span, SpanSink};

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
