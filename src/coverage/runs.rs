//! Coverage on its way to a sink: single pixels gathered into runs.

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
    /// The column after the open run.
    end: i32,
    length: usize,
    coverage: [u8; RUN],
}

impl<'s, S: CoverageSink> Runs<'s, S> {
    #[inline(always)]
    pub(crate) fn new(sink: &'s mut S) -> Self {
        Self { sink, row: 0, end: 0, length: 0, coverage: [0; RUN] }
    }

    /// What follows is on `row`. The run before has been finished.
    #[inline(always)]
    pub(crate) fn start(&mut self, row: i32) {
        self.row = row;
    }

    #[inline(always)]
    pub(crate) fn pixel(&mut self, column: i32, coverage: u8) -> Result<(), S::Error> {
        if coverage == 0 {
            return Ok(());
        }
        if column != self.end || self.length == RUN {
            self.finish()?;
        }
        if let Some(slot) = self.coverage.get_mut(self.length) {
            *slot = coverage;
        }
        self.length += 1;
        self.end = column + 1;
        Ok(())
    }

    /// `columns` that are all covered alike; there may be none.
    #[inline(always)]
    pub(crate) fn alike(&mut self, start: i32, end: i32, coverage: u8) -> Result<(), S::Error> {
        if coverage == 0 || start >= end {
            return Ok(());
        }
        if end - start < SPAN {
            return (start..end).try_for_each(|column| self.pixel(column, coverage));
        }
        self.finish()?;
        self.sink.span(Span { row: self.row, columns: start..end }, coverage)
    }

    /// Sends the open run.
    #[inline(always)]
    pub(crate) fn finish(&mut self) -> Result<(), S::Error> {
        let length = take(&mut self.length);
        match self.coverage.get(..length) {
            Some(run) if length > 0 => self.sink.run(self.row, self.end - i32::try_from(length).unwrap_or(0), run),
            _ => Ok(()),
        }
    }
}
