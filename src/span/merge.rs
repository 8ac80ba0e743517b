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

/// Receives the rows of a shape with several spans a row.
pub(crate) trait RowSink {
    type Error;

    /// The next span of `row`.
    fn span(&mut self, row: i32, columns: Range<i32>) -> Result<(), Self::Error>;

    /// There are no more spans on `row`.
    fn end_row(&mut self, row: i32) -> Result<(), Self::Error>;
}

/// Rows as they come, span by span.
#[derive(Debug)]
pub(crate) struct EachSpan<'s, S>(pub(crate) &'s mut S);

impl<S: SpanSink> RowSink for EachSpan<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn span(&mut self, row: i32, columns: Range<i32>) -> Result<(), S::Error> {
        self.0.span(Span { row, columns })
    }

    #[inline(always)]
    fn end_row(&mut self, _: i32) -> Result<(), S::Error> {
        Ok(())
    }
}

/// Five-pointed stars have two spans a row, letters up to four; 64 bytes of stack.
const MERGED_SPANS: usize = 8;

/// Rows with up to eight spans merged into blocks; further spans are sent as they come.
#[derive(Debug)]
pub(crate) struct MergeRows<'s, S> {
    sink: &'s mut S,
    /// The first of the equal rows that are still growing, and the row after the last.
    rows: Range<i32>,
    /// The spans of each of those rows, or, while they differ, those that the current row has so far.
    open: Vec<Range<i32>, MERGED_SPANS>,
    /// How many of them the current row has repeated.
    repeated: usize,
    /// The current row is not like the ones before.
    differs: bool,
}

impl<'s, S: BlockSink> MergeRows<'s, S> {
    /// The blocks of the rows that `walk` sends.
    #[inline]
    pub(crate) fn merged(
        sink: &'s mut S,
        walk: impl FnOnce(&mut Self) -> Result<(), S::Error>,
    ) -> Result<(), S::Error> {
        let mut merge = Self { sink, rows: 0..0, open: Vec::new(), repeated: 0, differs: false };
        walk(&mut merge)?;
        merge.send()
    }

    /// Sends the equal rows.
    #[inline]
    fn send(&mut self) -> Result<(), S::Error> {
        for columns in &self.open {
            self.sink.block(self.rows.clone(), columns.clone())?;
        }
        Ok(())
    }

    /// `row` differs: sends the rows before, and goes on with what it has repeated of them.
    #[inline]
    fn part(&mut self, row: i32) -> Result<(), S::Error> {
        self.send()?;
        self.open.truncate(self.repeated);
        self.rows = row..row.wrapping_add(1);
        self.differs = true;
        Ok(())
    }

    /// Sends what the current row has so far: it has too many spans to be merged with the next.
    #[cold]
    fn spill(&mut self) -> Result<(), S::Error> {
        self.send()?;
        self.open.clear();
        Ok(())
    }
}

impl<S: BlockSink> RowSink for MergeRows<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn span(&mut self, row: i32, columns: Range<i32>) -> Result<(), S::Error> {
        if !self.differs {
            if self.open.get(self.repeated) == Some(&columns) {
                self.repeated += 1;
                return Ok(());
            }
            self.part(row)?;
        }
        if let Err(columns) = self.open.push(columns) {
            self.spill()?;
            // There is room now: nothing comes back.
            self.open.push(columns).unwrap_or_default();
        }
        Ok(())
    }

    #[inline(always)]
    fn end_row(&mut self, row: i32) -> Result<(), S::Error> {
        if !self.differs && (row != self.rows.end || self.repeated != self.open.len()) {
            self.part(row)?;
        }
        self.rows.end = row.wrapping_add(1);
        self.repeated = 0;
        self.differs = false;
        Ok(())
    }
}
