//! From differences to areas: what a window has added up is handed over from left to right.

use crate::area::{
    AreaSink,
    accumulator::{Accumulator, WINDOW, WINDOW_COLUMNS},
    cell::FULL,
};

/// What of a window is handed over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Emission {
    pub(super) row: i32,
    /// The window's first column.
    pub(super) start: i32,
    /// The next window's first column.
    pub(super) until: i32,
    /// Whether nothing changes from the last change in the window on, as far as `until`.
    pub(super) is_complete: bool,
    /// What is covered there, if it is not what all changes add up to.
    pub(super) gap: Option<i32>,
}

impl Accumulator {
    /// Hands over a window, and what lies between it and the next; the window is empty then.
    pub(super) fn emit(&mut self, emission: Emission, sink: &mut dyn AreaSink) -> bool {
        let Emission { row, start, until, is_complete, gap } = emission;
        let window_end = (start + WINDOW_COLUMNS).min(until);
        let mut sum = self.base;
        let mut touched = core::mem::take(&mut self.touched);
        let mut column = start;
        while touched != 0 {
            let first = touched.trailing_zeros();
            let next = start + first.cast_signed();
            if next >= window_end {
                break;
            }
            if next > column && rounds_up(sum) && !sink.span(row, column..next, sum) {
                return false;
            }
            let length = (touched >> first).trailing_ones();
            touched = touched.checked_shr(first + length).unwrap_or(0).checked_shl(first + length).unwrap_or(0);
            let count = (length as usize).min((window_end - next).unsigned_abs() as usize);
            // The last is that of what follows, too, unless something changes behind the end.
            let is_cut = count < length as usize || (first + length) as usize == WINDOW;
            let sent = if is_cut { count } else { count - 1 };
            let sums = self.sums(&mut sum, first as usize, count);
            if let Some(run) = sums.get(..sent)
                && !run.is_empty()
                && !sink.run(row, next, run)
            {
                return false;
            }
            column = next + i32::try_from(sent).unwrap_or(0);
            self.forget(first as usize, length as usize + 1);
        }
        self.clear_rest(touched);
        if let (Some(gap), 0) = (gap, touched) {
            sum = gap;
        }
        let end = if is_complete { until } else { window_end };
        end <= column || !rounds_up(sum) || sink.span(row, column..end, sum)
    }
}

/// Whether an area is more than nothing.
#[inline]
fn rounds_up(area: i32) -> bool {
    area > FULL >> 16
}
