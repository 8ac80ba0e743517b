//! Where areas go.

use core::ops::Range;

/// Receives the areas of a row of pixels, in 2^-24 pixel, from left to right.
///
/// What is covered is less than 2^-9 pixel off the range from nothing to all.
pub(crate) trait AreaSink {
    /// Columns that are covered alike; `false` ends the walk.
    fn span(&mut self, row: i32, columns: Range<i32>, area: i32) -> bool;

    /// Columns one by one; `false` ends the walk.
    fn run(&mut self, row: i32, column: i32, areas: &[i32]) -> bool;
}

/// Takes areas from a corner of the screen on.
pub(crate) trait PlacedAreaSink: AreaSink {
    /// Column and row that are the first in what follows.
    fn place(&mut self, corner: (i32, i32));
}
