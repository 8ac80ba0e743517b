//! Cutting spans to the visible columns.

use core::ops::Range;

use crate::PixelRect;

/// What of `range` lies in `clip`; nothing may also be a range that runs backwards.
#[inline(always)]
pub(crate) fn clip_range(range: &Range<i32>, clip: &Range<i32>) -> Range<i32> {
    range.start.max(clip.start)..range.end.min(clip.end)
}

/// The rows and columns of `touched` that lie in `clip`, if there are any.
#[inline]
pub(crate) fn visible(touched: &PixelRect, clip: &PixelRect) -> Option<(Range<i32>, Range<i32>)> {
    let rows = clip_range(&touched.rows, &clip.rows);
    let columns = clip_range(&touched.columns, &clip.columns);
    (!rows.is_empty() && !columns.is_empty()).then_some((rows, columns))
}
