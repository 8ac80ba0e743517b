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
        let columns = clip_range(&span.columns, &self.columns);
        if columns.is_empty() { Ok(()) } else { self.sink.span(Span { row: span.row, columns }) }
    }
}

/// What of `range` lies in `clip`; nothing may also be a range that runs backwards.
#[inline(always)]
pub(crate) fn clip_range(range: &Range<i32>, clip: &Range<i32>) -> Range<i32> {
    range.start.max(clip.start)..range.end.min(clip.end)
}
