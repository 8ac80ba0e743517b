//! Numbers out of bytes.

use std::ops::RangeInclusive;

use arbitrary::Unstructured;

/// Bytes that are taken for choices. Where they end, every choice is the first one.
pub(crate) struct Source<'a>(Unstructured<'a>);

impl<'a> Source<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    pub(crate) fn int(&mut self, range: RangeInclusive<i64>) -> i64 {
        let first = *range.start();
        self.0.int_in_range(range).unwrap_or(first)
    }

    pub(crate) fn count(&mut self, range: RangeInclusive<usize>) -> usize {
        let first = *range.start();
        self.0.int_in_range(range).unwrap_or(first)
    }

    /// Whether a choice among `n` is the last of them.
    pub(crate) fn one_in(&mut self, n: u8) -> bool {
        self.0.int_in_range(1..=n).unwrap_or(1) == n
    }

    pub(crate) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.count(0..=from.len() - 1)]
    }

    /// Of any magnitude up to 2^`bits`, small ones as likely as large ones.
    pub(crate) fn magnitude(&mut self, bits: i64) -> i64 {
        let limit = 1 << self.int(0..=bits);
        self.int(-limit..=limit)
    }
}
