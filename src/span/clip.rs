//! Cutting spans to the visible columns.

use core::ops::Range;

/// What of `range` lies in `clip`; nothing may also be a range that runs backwards.
#[inline(always)]
pub(crate) fn clip_range(range: &Range<i32>, clip: &Range<i32>) -> Range<i32> {
    range.start.max(clip.start)..range.end.min(clip.end)
}
