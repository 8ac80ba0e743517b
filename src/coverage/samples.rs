//! Supersampling: coverage as the share of a few points of the pixel that are inside.
//!
//! A pixel's samples are the pixels of the same shape `n` times as large, without anti-aliasing:
//!
//! ```text
//!     +-------------+
//!     | .  .  .  #  |    . . # #|# # # #|# . . .|. . . .    a span on a line of samples, 4 to a pixel
//!     | .  .  #  #  |       2       4       1       0       what it counts for in each pixel
//!     | .  .  #  #  |      +2      +2      -3      -1       the change from the pixel before: two at each end
//!     | .  #  #  #  |
//!     +-------------+
//! ```
//!
//! Only changes are kept, and added up once for all lines of a row of pixels: what lies inside costs nothing.

use core::{mem, num::NonZeroU32, ops::Range};

use crate::{
    coverage::{CoverageSink, Runs},
    span::{Span, SpanSink},
};

/// Which points of a pixel are looked at, and what each counts for.
///
/// They lie in `n` lines of `n`, at the centres of the squares that these cut the pixel into, exactly. A pixel is covered
/// by the share of its samples that are inside, rounded once to 255ths; a sample on an outline belongs to the side to
/// its right, or below, as the centre of a pixel does.
///
/// ```text
///     grid(1)        grid(2)        grid(4)        WEIGHTED
///    +-------+      +-------+      +-------+      +-------+
///    |       |      | .   . |      |. . . .|      |1 2 2 1|
///    |   .   |      |       |      |. . . .|      |2 3 3 2|
///    |       |      | .   . |      |. . . .|      |2 3 3 2|  of 32
///    +-------+      +-------+      |. . . .|      |1 2 2 1|
///                                  +-------+      +-------+
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Samples {
    side: NonZeroU32,
    is_weighted: bool,
}

/// What the samples to the left of each count for, on a line where each counts for 1.
const EQUAL: &[u8] = &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16];
/// The same for the weights 1 2 2 1, of the first line and the last.
const OUTER: &[u8] = &[0, 1, 3, 5, 6];
/// The same for the weights 2 3 3 2, of the two lines between.
const INNER: &[u8] = &[0, 2, 5, 8, 10];

impl Samples {
    /// Samples that count for more the nearer they are to the pixel's centre.
    pub const WEIGHTED: Self = Self { is_weighted: true, ..Self::grid(4) };

    /// `n` x `n` samples, `n` from 1 to 16; what is beyond is taken for the nearest of these.
    pub const fn grid(n: u8) -> Self {
        let n = if n > 16 { 16 } else { n };
        Self { side: NonZeroU32::MIN.saturating_add((n as u32).saturating_sub(1)), is_weighted: false }
    }

    /// Lines to a pixel, and samples to a line: 1 to 16.
    #[inline(always)]
    pub(crate) const fn side(self) -> i32 {
        self.side.get().cast_signed()
    }

    /// What the samples to the left of each of a line count for, and all of them.
    #[inline(always)]
    fn weights(self, line: u32) -> &'static [u8] {
        match (self.is_weighted, line) {
            (false, _) => EQUAL,
            (true, 0 | 3) => OUTER,
            (true, _) => INNER,
        }
    }

    /// What a whole pixel counts for.
    fn whole(self) -> u32 {
        if self.is_weighted { 32 } else { self.side.get() * self.side.get() }
    }
}

/// Scratch for one column of a supersampled shape. 2 bytes.
#[derive(Debug, Clone, Copy, Default)]
pub struct SampleCell(i16);

impl SampleCell {
    /// Unused scratch.
    pub const EMPTY: Self = Self(0);
}

/// Counts samples, given as spans or as the ends of spans, and sends the coverage of each row that is complete.
#[derive(Debug)]
pub(crate) struct Supersampler<'c, 's, S> {
    samples: Samples,
    /// One for each of `columns`, the change from the column before.
    cells: &'c mut [SampleCell],
    columns: Range<i32>,
    first_sample: i32,
    /// Of the usual sides: powers of two, by which nothing has to be divided.
    side_bits: Option<u32>,
    /// A bit for each `1 << bucket_bits` cells that may not all be 0.
    touched: u32,
    bucket_bits: u32,
    /// Of the current row.
    row: i32,
    first_line: i32,
    /// Of the current line.
    weights: &'static [u8],
    line_weight: i32,
    /// 255 for what a whole pixel counts for, with `SCALE_BITS` behind the binary point.
    scale: u32,
    runs: Runs<'s, S>,
}

/// The bits that tell where a row has changed. Wide rows of which little has are swept as fast as narrow ones.
const BUCKETS: u32 = u32::BITS;

/// With these, a count of at most 256 times the scale is below 2^28 + 2^8, and off by less than 2^-12. No count is nearer
/// than 2^-9 to the middle of two 255ths, unless it is there exactly; then it goes up.
const SCALE_BITS: u32 = 20;

impl<'c, 's, S: CoverageSink> Supersampler<'c, 's, S> {
    /// From `row` on; as many cells as columns. No line and no sample is beyond `i32`.
    pub(crate) fn new(
        samples: Samples,
        row: i32,
        columns: Range<i32>,
        cells: &'c mut [SampleCell],
        sink: &'s mut S,
    ) -> Self {
        cells.fill(SampleCell::EMPTY);
        Self {
            samples,
            first_sample: columns.start.wrapping_mul(samples.side()),
            side_bits: samples.side.is_power_of_two().then(|| samples.side.trailing_zeros()),
            columns,
            touched: 0,
            bucket_bits: (usize::BITS - cells.len().saturating_sub(1).leading_zeros()).saturating_sub(BUCKETS.ilog2()),
            cells,
            row,
            first_line: row.wrapping_mul(samples.side()),
            weights: EQUAL,
            line_weight: 0,
            scale: (255 << SCALE_BITS) / samples.whole().max(1) + 1,
            runs: Runs::new(sink),
        }
    }

    /// What follows is on `line`, the first of them the first of the row given at first. Lines go down.
    #[inline]
    pub(crate) fn start(&mut self, line: i32) -> Result<(), S::Error> {
        let mut below = line.wrapping_sub(self.first_line).cast_unsigned();
        if below >= self.samples.side.get() {
            self.finish()?;
            let rows = (below / self.samples.side).cast_signed();
            self.row = self.row.wrapping_add(rows);
            self.first_line = self.first_line.wrapping_add(rows.wrapping_mul(self.samples.side()));
            below %= self.samples.side;
        }
        self.weights = self.samples.weights(below);
        let all = self.weights.get(self.samples.side.get() as usize);
        self.line_weight = all.copied().unwrap_or_default().into();
        Ok(())
    }

    /// Adds all samples of the line from `sample` on, or, with `sign` -1, takes them away.
    #[inline(always)]
    pub(crate) fn add_from(&mut self, sample: i32, sign: i32) {
        let right = sample.saturating_sub(self.first_sample).max(0).cast_unsigned();
        let (column, within) = match self.side_bits {
            Some(bits) => (right >> bits, right & !(u32::MAX << bits)),
            None => (right / self.samples.side, right % self.samples.side),
        };
        let (column, within) = (column as usize, within as usize);
        let before = i32::from(self.weights.get(within).copied().unwrap_or_default());
        match self.cells.get_mut(column..) {
            Some([cell, next, ..]) => {
                cell.change(sign * (self.line_weight - before));
                next.change(sign * before);
                self.touched |= 1 << ((column + 1) >> self.bucket_bits);
            }
            Some([cell]) => cell.change(sign * (self.line_weight - before)),
            _ => return,
        }
        self.touched |= 1 << (column >> self.bucket_bits);
    }

    /// Sends the row, and leaves all cells 0.
    pub(crate) fn finish(&mut self) -> Result<(), S::Error> {
        let mut touched = mem::take(&mut self.touched);
        if touched == 0 {
            return Ok(());
        }
        let Self { cells, runs, columns, bucket_bits, scale, .. } = self;
        runs.start(self.row);
        let (mut start, mut count, mut coverage) = (columns.start, 0_i16, 0);
        while touched != 0 {
            let first = touched.trailing_zeros() << *bucket_bits;
            touched &= touched - 1;
            let end = (first + (1 << *bucket_bits)) as usize;
            let end = end.min(cells.len());
            let mut column = columns.start.wrapping_add_unsigned(first);
            for cell in cells.get_mut(first as usize..end).unwrap_or_default() {
                if cell.0 != 0 {
                    runs.alike(start, column, coverage)?;
                    start = column;
                    count = count.wrapping_add(mem::take(&mut cell.0));
                    coverage = coverage_of(count, *scale);
                }
                column = column.wrapping_add(1);
            }
        }
        runs.alike(start, columns.end, coverage)?;
        self.runs.finish()
    }
}

/// A count in 255ths of the whole, with the scale that belongs to it.
#[inline(always)]
fn coverage_of(count: i16, scale: u32) -> u8 {
    let count = u32::from(count.cast_unsigned());
    (count.wrapping_mul(scale).wrapping_add(1 << (SCALE_BITS - 1)) >> SCALE_BITS).to_le_bytes()[0]
}

impl SampleCell {
    /// By at most 256 either way, as is the sum of all up to here: whatever wraps, wraps back.
    #[inline(always)]
    fn change(&mut self, by: i32) {
        #[allow(clippy::cast_possible_truncation, reason = "at most 16 times the changes of a line")]
        let by = by as i16;
        self.0 = self.0.wrapping_add(by);
    }
}

/// Spans of samples, on lines of them.
impl<S: CoverageSink> SpanSink for Supersampler<'_, '_, S> {
    type Error = S::Error;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        self.start(span.row)?;
        self.add_from(span.columns.start, 1);
        self.add_from(span.columns.end, -1);
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::expect_used, clippy::indexing_slicing, reason = "a test fails by a panic")]
mod tests {
    use std::{convert::Infallible, vec::Vec};

    use super::*;

    struct Nowhere;

    impl CoverageSink for Nowhere {
        type Error = Infallible;

        fn span(&mut self, _: Span, _: u8) -> Result<(), Infallible> {
            Ok(())
        }

        fn run(&mut self, _: i32, _: i32, _: &[u8]) -> Result<(), Infallible> {
            Ok(())
        }
    }

    #[test]
    fn counts_are_rounded_once_and_half_up() {
        for samples in (1..=16).map(Samples::grid).chain([Samples::WEIGHTED]) {
            let whole = samples.whole();
            let mut sink = Nowhere;
            let sampler = Supersampler::new(samples, 0, 0..0, &mut [], &mut sink);
            for count in 0..=whole {
                let expected = (2 * 255 * count + whole) / (2 * whole);
                let count = i16::try_from(count).expect("at most 256");
                assert_eq!(u32::from(coverage_of(count, sampler.scale)), expected, "{count} of {whole}");
            }
        }
    }

    #[test]
    fn weights_add_up() {
        for samples in (1..=16).map(Samples::grid).chain([Samples::WEIGHTED]) {
            let side = samples.side.get();
            let lines: Vec<u32> = (0..side).map(|line| samples.weights(line)[side as usize].into()).collect();
            assert_eq!(lines.iter().sum::<u32>(), samples.whole(), "{samples:?}");
        }
        let weights = (0..4).map(|line| Samples::WEIGHTED.weights(line).windows(2).map(|pair| pair[1] - pair[0]));
        let weights: Vec<Vec<u8>> = weights.map(Iterator::collect).collect();
        assert_eq!(weights, [[1, 2, 2, 1], [2, 3, 3, 2], [2, 3, 3, 2], [1, 2, 2, 1]]);
    }

    #[test]
    fn sides_beyond_the_range_are_the_nearest() {
        assert_eq!(Samples::grid(0), Samples::grid(1));
        assert_eq!(Samples::grid(255), Samples::grid(16));
    }
}
