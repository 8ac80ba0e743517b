//! `DisplayPixel`, and how a walk of unlimited length comes to the clip in limited time.

use core::ops::Range;

use crate::{Fragment, FragmentSink, PixelRect};

/// How many steps a method walks outside of the clip before it gets there: its error builds up as it was published. What
/// lies before those is passed in one step, without error.
pub const PATIENCE: u32 = 1 << 20;

/// The lecture's `DisplayPixel(x, y)`: one pixel, if it is in the clip.
#[inline(always)]
pub(in crate::methods) fn display_pixel<S: FragmentSink>(
    x: i32,
    y: i32,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    display(Fragment::pixel(x, y), clip, sink)
}

/// One pixel of some coverage, if it is in the clip and not empty.
#[inline(always)]
pub(in crate::methods) fn display<S: FragmentSink>(
    fragment: Fragment,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    if fragment.coverage > 0 && clip.columns.contains(&fragment.x) && clip.rows.contains(&fragment.y) {
        sink.fragment(fragment)?;
    }
    Ok(())
}

/// The steps, of those from 0 to `last` away from `start`, that lie in `range`: upwards, or downwards.
pub(in crate::methods) fn steps_within(start: i32, down: bool, last: i32, range: &Range<i32>) -> Range<u32> {
    let start = i64::from(start);
    let (low, high) = (i64::from(range.start), i64::from(range.end));
    let (first, end) = if down { (start - high + 1, start - low + 1) } else { (low - start, high - start) };
    let last = i64::from(last);
    // Both are below 2^31.
    let clamped = |step: i64| u32::try_from(step.clamp(0, last.max(-1) + 1)).unwrap_or(0);
    clamped(first)..clamped(end)
}

/// How many steps before `first` are passed in one.
pub(in crate::methods) fn passed(first: u32) -> u32 {
    first.saturating_sub(PATIENCE)
}
