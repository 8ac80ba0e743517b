//! Coverage on its way to a sink: a row of pixels, put together from left to right.

use core::mem::take;

use crate::{coverage::CoverageSink, span::Span};

/// Runs are at most so long; a display behind a bus pays for an address window once a run.
const RUN: usize = 32;

/// Fewer pixels of one coverage stay in the run that they are part of.
const SPAN: i32 = 4;

/// Takes the coverage of a row, columns to the right, and sends runs and spans.
#[derive(Debug)]
pub(crate) struct Runs<'s, S> {
    sink: &'s mut S,
    row: i32,
    /// Where the open run starts.
    first: i32,
    length: usize,
    /// Its pixels.
    coverage: [u8; RUN],
}

impl<'s, S: CoverageSink> Runs<'s, S> {
    #[inline(always)]
    pub(crate) fn new(sink: &'s mut S) -> Self {
        Self { sink, row: 0, first: 0, length: 0, coverage: [0; RUN] }
    }

    /// What follows is on `row`. The row before has been finished.
    #[inline(always)]
    pub(crate) fn start(&mut self, row: i32) {
        self.row = row;
    }

    /// The next column of the open run, or the first of the next.
    #[inline(always)]
    pub(crate) fn pixel(&mut self, column: i32, coverage: u8) -> Result<(), S::Error> {
        if coverage == 0 {
            return self.finish();
        }
        if self.length == 0 {
            self.first = column;
        }
        if let Some(slot) = self.coverage.get_mut(self.length) {
            *slot = coverage;
        }
        self.length += 1;
        if self.length < RUN { Ok(()) } else { self.finish() }
    }

    /// The next columns, which are all covered alike; there may be none.
    #[inline(always)]
    pub(crate) fn alike(&mut self, start: i32, end: i32, coverage: u8) -> Result<(), S::Error> {
        if end - start < SPAN {
            return (start..end).try_for_each(|column| self.pixel(column, coverage));
        }
        self.finish()?;
        if coverage == 0 { Ok(()) } else { self.sink.span(Span { row: self.row, columns: start..end }, coverage) }
    }

    /// Sends the open run.
    #[inline(always)]
    pub(crate) fn finish(&mut self) -> Result<(), S::Error> {
        let length = take(&mut self.length);
        match self.coverage.get(..length) {
            Some(run) if length > 0 => self.sink.run(self.row, self.first, run),
            _ => Ok(()),
        }
    }
}
