//! Turning spans into blocks: equal consecutive rows become one rectangle a span.
//!
//! To a display behind a bus, a rectangle costs an address window (11 bytes for the usual controllers) whatever its
//! height.

use core::{mem::replace, ops::Range};

use heapless::Vec;

use crate::span::{BlockSink, Span, SpanSink};

/// For shapes with one span a row, which send blocks: the one that is still growing.
///
/// It is told every row from the first to the last, those without a pixel too, so a row is compared by its columns only.
#[derive(Debug)]
pub(crate) struct OpenBlock {
    top: i32,
    columns: Range<i32>,
}

impl OpenBlock {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { top: 0, columns: 0..0 }
    }

    /// The next row has `columns`, which may be empty.
    #[inline(always)]
    pub(crate) fn row<S: BlockSink>(&mut self, row: i32, columns: Range<i32>, sink: &mut S) -> Result<(), S::Error> {
        if columns == self.columns {
            return Ok(());
        }
        let top = replace(&mut self.top, row);
        let columns = replace(&mut self.columns, columns);
        if columns.is_empty() { Ok(()) } else { sink.block(top..row, columns) }
    }

    /// There are no more rows before `end`.
    #[inline(always)]
    pub(crate) fn finish<S: BlockSink>(self, end: i32, sink: &mut S) -> Result<(), S::Error> {
        if self.columns.is_empty() { Ok(()) } else { sink.block(self.top..end, self.columns) }
    }
}

/// Spans from blocks that have their rows to themselves.
#[derive(Debug)]
pub(crate) struct SplitRows<'s, S>(pub(crate) &'s mut S);

impl<S: SpanSink> BlockSink for SplitRows<'_, S> {
    type Error = S::Error;

    #[inline]
    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), S::Error> {
        for row in rows {
            self.0.span(Span { row, columns: columns.clone() })?;
        }
        Ok(())
    }
}

/// For shapes with several spans a row, up to eight; further ones are sent as they come.
#[derive(Debug)]
pub(crate) struct MergeRows<'s, S> {
    sink: &'s mut S,
    /// Rows known to be equal. While there is just one, spans on it are added to `open`.
    rows: Range<i32>,
    /// The spans of each of those rows.
    open: Vec<Range<i32>, MERGED_SPANS>,
    /// How many of them the row after those has repeated so far.
    repeated: usize,
}

/// Five-pointed stars have two spans a row, letters up to four; 64 bytes of stack.
const MERGED_SPANS: usize = 8;

impl<'s, S: BlockSink> MergeRows<'s, S> {
    /// The blocks of the spans that `walk` sends.
    #[inline]
    pub(crate) fn merged(
        sink: &'s mut S,
        walk: impl FnOnce(&mut Self) -> Result<(), S::Error>,
    ) -> Result<(), S::Error> {
        let mut merge = Self { sink, rows: 0..0, open: Vec::new(), repeated: 0 };
        walk(&mut merge)?;
        merge.end_row()?;
        merge.send()
    }

    #[inline]
    fn send(&mut self) -> Result<(), S::Error> {
        for columns in &self.open {
            self.sink.block(self.rows.clone(), columns.clone())?;
        }
        Ok(())
    }

    /// Sends the equal rows, and goes on with `row`, which has repeated the first of their spans.
    #[inline]
    fn begin(&mut self, row: i32) -> Result<(), S::Error> {
        self.send()?;
        self.open.truncate(replace(&mut self.repeated, 0));
        self.rows = row..row.wrapping_add(1);
        Ok(())
    }

    #[inline]
    fn add(&mut self, columns: Range<i32>) -> Result<(), S::Error> {
        if self.open.is_full() {
            self.send()?;
            self.open.clear();
        }
        // There is room now: what `push` would hand back is nothing.
        self.open.push(columns).unwrap_or_default();
        Ok(())
    }

    /// The row after the equal ones is complete: one more of them, or not.
    #[inline]
    fn end_row(&mut self) -> Result<(), S::Error> {
        if self.repeated == 0 {
            return Ok(());
        }
        if self.repeated < self.open.len() {
            return self.begin(self.rows.end);
        }
        self.rows.end = self.rows.end.wrapping_add(1);
        self.repeated = 0;
        Ok(())
    }
}

impl<S: BlockSink> SpanSink for MergeRows<'_, S> {
    type Error = S::Error;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        let Span { row, columns } = span;
        if row == self.rows.start && !self.rows.is_empty() {
            return self.add(columns);
        }
        if row != self.rows.end {
            self.end_row()?;
        }
        if row == self.rows.end && self.open.get(self.repeated) == Some(&columns) {
            self.repeated += 1;
            return Ok(());
        }
        if row != self.rows.end {
            self.repeated = 0;
        }
        self.begin(row)?;
        self.add(columns)
    }
}
