//! A part of a chain without a vertex within it.

use core::ops::Range;

use crate::area::{
    accumulator::Accumulator,
    division::{floor_ratio, part_of},
    source::{FINE_BITS, FINE_ONE},
    steepness::Steepness,
};

/// Columns in 2^-32 pixel, heights in 2^-16 from the top of the row; y0 < y1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Line {
    pub(super) x0: i64,
    pub(super) y0: i32,
    pub(super) x1: i64,
    pub(super) y1: i32,
}

impl Line {
    /// Where it is at a height.
    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn x_at(&self, y: i32) -> i64 {
        if y == self.y0 {
            return self.x0;
        }
        if y == self.y1 {
            return self.x1;
        }
        // At most 2^46 and 2^16.
        self.x0 + floor_ratio((self.x1 - self.x0) * i64::from(y - self.y0), (self.y1 - self.y0).unsigned_abs())
    }

    /// At which height it is at a column.
    #[cfg_attr(target_pointer_width = "64", inline)]
    fn y_at(&self, x: i64) -> i32 {
        // At most 2^46 and 2^16.
        let dy = part_of(x.abs_diff(self.x0), (self.y1 - self.y0).unsigned_abs(), self.x1.abs_diff(self.x0));
        self.y0 + dy.cast_signed()
    }

    /// What of it lies between two columns, the left one belonging to it.
    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn within(&self, columns: &Range<i64>) -> Option<Self> {
        let (low, high) = (self.x0.min(self.x1), self.x0.max(self.x1));
        if low >= columns.end || high < columns.start || (high == columns.start && low < high) {
            return None;
        }
        let mut line = *self;
        if low < columns.start {
            let y = self.y_at(columns.start);
            if self.x0 < self.x1 {
                (line.x0, line.y0) = (columns.start, y)
            } else {
                (line.x1, line.y1) = (columns.start, y)
            }
        }
        if high > columns.end {
            let y = self.y_at(columns.end);
            if self.x0 < self.x1 {
                (line.x1, line.y1) = (columns.end, y)
            } else {
                (line.x0, line.y0) = (columns.end, y)
            }
        }
        (line.y0 < line.y1).then_some(line)
    }

    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn between(&self, y0: i32, y1: i32) -> Self {
        Self { x0: self.x_at(y0), y0, x1: self.x_at(y1), y1 }
    }

    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) fn add(&self, weight: i32, accumulator: &mut Accumulator) {
        let dy = self.y1 - self.y0;
        accumulator
            .add(self.x0, self.x1, dy, weight, || Steepness::of_segment(self.x0.abs_diff(self.x1), dy.unsigned_abs()));
    }
}

/// From 2^-16 pixel to 2^-32.
#[inline]
pub(super) fn finest(x: i32) -> i64 {
    i64::from(x) << FINE_BITS
}

/// From 2^-32 pixel to 2^-16.
#[inline]
pub(super) fn floor(x: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    let x = (x >> FINE_BITS) as i32;
    x
}

#[inline]
pub(super) fn ceil(x: i64) -> i32 {
    floor(x + i64::from(FINE_ONE - 1))
}

/// The same, to the nearest.
#[inline]
pub(super) fn nearest(x: i64) -> i32 {
    floor(x + i64::from(FINE_ONE / 2))
}
