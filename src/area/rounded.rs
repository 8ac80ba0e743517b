//! Areas on their way to a sink of coverage: rounded once, to 255ths.

use core::ops::Range;

use crate::{
    area::{AreaSink, PlacedAreaSink, WINDOW},
    coverage::CoverageSink,
    span::Span,
};

/// Sends areas to a [`CoverageSink`], from a corner on, and keeps its error.
pub(crate) struct Rounded<'s, S: CoverageSink> {
    pub(crate) sink: &'s mut S,
    /// Column and row that are the first.
    pub(crate) corner: (i32, i32),
    pub(crate) result: Result<(), S::Error>,
}

/// `area` is off the range from 0 to 2^24 by less than 2^15: then `255 area + 2^23` is within 0..2^32.
#[inline]
fn rounded(area: i32) -> u8 {
    #[allow(clippy::cast_possible_truncation, reason = "below 256")]
    let coverage = ((area << 8).wrapping_sub(area).wrapping_add(1 << 23).cast_unsigned() >> 24) as u8;
    coverage
}

/// The longest run, in whole eights.
const LONGEST: usize = WINDOW.next_multiple_of(8);

impl<S: CoverageSink> AreaSink for Rounded<'_, S> {
    fn span(&mut self, row: i32, columns: Range<i32>, area: i32) -> bool {
        let coverage = rounded(area);
        if coverage != 0 {
            let (x, y) = self.corner;
            let span = Span { row: y + row, columns: x + columns.start..x + columns.end };
            self.result = self.sink.span(span, coverage);
        }
        self.result.is_ok()
    }

    fn run(&mut self, row: i32, column: i32, areas: &[i32]) -> bool {
        let (x, y) = self.corner;
        let (row, column) = (y + row, x + column);
        let mut coverage = [0; LONGEST];
        for (coverage, area) in coverage.iter_mut().zip(areas) {
            *coverage = rounded(*area);
        }
        if S::EIGHTS {
            let eights = coverage.as_chunks::<8>().0.get(..areas.len().div_ceil(8)).unwrap_or_default();
            self.result = self.sink.eights(row, column, eights);
        } else {
            self.result = self.send_parts(row, column, coverage.get(..areas.len()).unwrap_or_default());
        }
        self.result.is_ok()
    }
}

impl<S: CoverageSink> PlacedAreaSink for Rounded<'_, S> {
    fn place(&mut self, corner: (i32, i32)) {
        self.corner = corner;
    }
}

impl<S: CoverageSink> Rounded<'_, S> {
    /// Without what is not covered at all.
    fn send_parts(&mut self, row: i32, mut column: i32, mut coverage: &[u8]) -> Result<(), S::Error> {
        while let Some((first, rest)) = coverage.split_first() {
            if *first == 0 {
                coverage = rest;
                column += 1;
                continue;
            }
            let length = coverage.iter().position(|coverage| *coverage == 0).unwrap_or(coverage.len());
            let (run, after) = coverage.split_at_checked(length).unwrap_or_default();
            self.sink.run(row, column, run)?;
            column += i32::try_from(length).unwrap_or(0);
            coverage = after;
        }
        Ok(())
    }
}
