//! A row of pixels of a convex shape: what lies between a left side and a right one.
//!
//! Each side leaves an area of its pixels to its right. The left one's is added, the right one's is taken away again. Where
//! they share no columns, each has a run of its own, and between the two is a span.
//!
//! ```text
//!       left               right
//!     |   /#|####|####|####|\   |         run, span, run
//!     |  /##|####|####|####|#\  |
//! ```

use core::ops::Range;

use crate::area::{AreaSink, accumulator::WINDOW_COLUMNS};

/// Fewer columns between the sides are part of their run.
pub(super) const GAP: usize = 4;

/// Which sides have something in some columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sides {
    Left,
    Right,
    Both,
}

/// A row, and which columns the sides have a part of it in.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) row: i32,
    /// How many columns there are.
    pub(super) width: i32,
    pub(super) left: Range<i32>,
    pub(super) right: Range<i32>,
    /// The area of a pixel between the sides.
    pub(super) inside: i32,
}

impl Row {
    /// Sends it, where `cover` tells what is between sides of the columns from one on; `false` where the sink has had enough.
    #[inline]
    pub(super) fn send(
        &self,
        areas: &mut [i32],
        mut cover: impl FnMut(Sides, i32, &mut [i32]),
        sink: &mut dyn AreaSink,
    ) -> bool {
        let Self { row, width, ref left, ref right, inside } = *self;
        let mut window = |sides: Sides, columns: Range<i32>, sink: &mut dyn AreaSink| {
            let (mut start, end) = (columns.start.max(0), columns.end.min(width));
            while start < end {
                let next = end.min(start + WINDOW_COLUMNS);
                let Some(areas) = areas.get_mut(..next.abs_diff(start) as usize) else { break };
                cover(sides, start, areas);
                if !sink.run(row, start, areas) {
                    return false;
                }
                start = next;
            }
            true
        };
        let gap = left.end.max(0)..right.start.min(width);
        if gap.len() <= GAP {
            return window(Sides::Both, left.start.min(right.start)..left.end.max(right.end), sink);
        }
        window(Sides::Left, left.clone(), sink)
            && sink.span(row, gap, inside)
            && window(Sides::Right, right.clone(), sink)
    }
}
