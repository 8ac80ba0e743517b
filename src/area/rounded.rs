//! Areas on their way to a sink of coverage: rounded once, to 255ths.

use core::ops::Range;

use crate::{
    area::{AreaSink, PlacedAreaSink, WINDOW},
    coverage::CoverageSink,
    span::Span,
};

/// Sends areas to a [`CoverageSink`], from a corner on, and keeps its error.
pub(crate) struct Rounded<'s, S: CoverageSink> {
    sink: &'s mut S,
    /// Column and row that are the first.
    corner: (i32, i32),
    result: Result<(), S::Error>,
    /// Of a run on its way.
    coverage: [u8; WINDOW],
}

impl<'s, S: CoverageSink> Rounded<'s, S> {
    /// Sends what is sent to it.
    pub(crate) fn send(sink: &'s mut S, send: impl FnOnce(&mut dyn PlacedAreaSink)) -> Result<(), S::Error> {
        let mut rounded = Self { sink, corner: (0, 0), result: Ok(()), coverage: [0; WINDOW] };
        send(&mut rounded);
        rounded.result
    }
}

/// `area` is off the range from 0 to 2^24 by less than 2^15: then `255 area + 2^23` is within 0..2^32.
#[inline]
fn rounded(area: i32) -> u8 {
    #[allow(clippy::cast_possible_truncation, reason = "below 256")]
    let coverage = ((area << 8).wrapping_sub(area).wrapping_add(1 << 23).cast_unsigned() >> 24) as u8;
    coverage
}

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
        let mut has_zeros = false;
        for (coverage, area) in self.coverage.iter_mut().zip(areas) {
            *coverage = rounded(*area);
            has_zeros |= *coverage == 0;
        }
        let coverage = self.coverage.get(..areas.len()).unwrap_or_default();
        self.result =
            if has_zeros { send_parts(self.sink, row, column, coverage) } else { self.sink.run(row, column, coverage) };
        self.result.is_ok()
    }
}

impl<S: CoverageSink> PlacedAreaSink for Rounded<'_, S> {
    fn place(&mut self, corner: (i32, i32)) {
        self.corner = corner;
    }
}

/// Sends what is covered at all.
#[inline(never)]
fn send_parts<S: CoverageSink>(sink: &mut S, row: i32, mut column: i32, coverage: &[u8]) -> Result<(), S::Error> {
    for part in coverage.split(|coverage| *coverage == 0) {
        if !part.is_empty() {
            sink.run(row, column, part)?;
        }
        column += i32::try_from(part.len()).unwrap_or(0) + 1;
    }
    Ok(())
}
