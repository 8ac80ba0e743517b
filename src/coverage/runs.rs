//! Coverage on its way to a sink: a row of pixels, put together from left to right.

use core::mem::take;

use crate::{coverage::CoverageSink, span::Span};

/// Runs are at most so long; a display behind a bus pays for an address window once a run.
pub(crate) const RUN: usize = 32;

/// Fewer pixels of one coverage stay in the run that they are part of.
pub(super) const SPAN: i32 = 4;

/// Takes the coverage of a row, columns to the right, and sends runs and spans.
#[derive(Debug)]
pub(crate) struct Runs<'s, S> {
    pub(super) sink: &'s mut S,
    row: i32,
    /// Where the open run starts.
    first: i32,
    length: usize,
    /// Its pixels, if the sink takes eights; it is never longer than that.
    word: u64,
    /// Its pixels, if not.
    pub(super) coverage: [u8; RUN],
}

impl<'s, S: CoverageSink> Runs<'s, S> {
    #[inline(always)]
    pub(crate) fn new(sink: &'s mut S) -> Self {
        Self { sink, row: 0, first: 0, length: 0, word: 0, coverage: [0; RUN] }
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
        if S::EIGHTS {
            self.word |= u64::from(coverage) << (8 * (self.length & 7));
            self.length += 1;
            return if self.length < 8 { Ok(()) } else { self.finish() };
        }
        if let Some(slot) = self.coverage.get_mut(self.length) {
            *slot = coverage;
        }
        self.length += 1;
        if self.length < RUN { Ok(()) } else { self.finish() }
    }

    /// Columns inside, after the open run; there may be none.
    #[inline(always)]
    pub(crate) fn inside(&mut self, start: i32, end: i32) -> Result<(), S::Error> {
        if start < end {
            self.finish()?;
            self.sink.span(Span { row: self.row, columns: start..end }, 255)?;
        }
        Ok(())
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

    /// Sends what has been put into the buffer, for the pixels from `column` on: a run, without the zeros at its ends if it
    /// has any.
    #[inline(always)]
    pub(crate) fn send_all(&mut self, mut column: i32, length: usize, has_zeros: bool) -> Result<(), S::Error> {
        let mut run = self.coverage.get(..length).unwrap_or_default();
        if !has_zeros {
            return if run.is_empty() { Ok(()) } else { self.sink.run(self.row, column, run) };
        }
        while let [0, rest @ ..] = run {
            run = rest;
            column += 1;
        }
        while let [rest @ .., 0] = run {
            run = rest;
        }
        if run.is_empty() {
            Ok(())
        } else if run.contains(&0) {
            Self::send_parts(self.sink, self.row, column, run)
        } else {
            self.sink.run(self.row, column, run)
        }
    }

    /// Sends a run that has zeros in it: a sliver may touch a pixel so little that it rounds to nothing.
    #[cold]
    #[inline(never)]
    fn send_parts(sink: &mut S, row: i32, mut column: i32, run: &[u8]) -> Result<(), S::Error> {
        for coverage in run {
            if *coverage != 0 {
                sink.run(row, column, &[*coverage])?;
            }
            column += 1;
        }
        Ok(())
    }

    /// Sends the open run.
    #[inline(always)]
    pub(crate) fn finish(&mut self) -> Result<(), S::Error> {
        let length = take(&mut self.length);
        if S::EIGHTS {
            let word = take(&mut self.word);
            return if length == 0 { Ok(()) } else { self.sink.eights(self.row, self.first, &[word.to_le_bytes()]) };
        }
        match self.coverage.get(..length) {
            Some(run) if length > 0 => self.sink.run(self.row, self.first, run),
            _ => Ok(()),
        }
    }
}
