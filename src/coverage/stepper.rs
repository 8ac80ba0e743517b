//! An edge in whole rows of pixels, from one to the next.

use crate::coverage::ramp::Extent;

/// Its left end in the current row, how far on that is in the next, and how far to the right end. Positions are in 2^-32 pixel,
/// with `BELOW` bits more behind.
///
/// To the right or to the left, an edge takes up the same width in each row, so its ends need no comparing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stepper<const BELOW: u32> {
    left: i64,
    step: i64,
    width: i64,
}

impl<const BELOW: u32> Stepper<BELOW> {
    /// From a position at the top of a row.
    #[inline(always)]
    pub(crate) fn new(position: i64, step: i64) -> Self {
        Self { left: position + step.min(0), step, width: step.abs() }
    }

    /// Where the edge is at the top of the current row.
    #[inline(always)]
    pub(crate) fn position(&self) -> i64 {
        self.left - self.step.min(0)
    }

    /// Where it is in this row. It is taken to the next.
    #[inline(always)]
    pub(crate) fn step(&mut self) -> Extent {
        let extent = self.extent();
        self.left += self.step;
        extent
    }

    /// Where it is in this row.
    #[inline(always)]
    pub(super) fn extent(&self) -> Extent {
        let (left, right) = (self.left, self.left + self.width);
        Extent {
            first: column(left >> BELOW),
            last: column(right >> BELOW),
            left: part(left >> BELOW),
            right: part(right >> BELOW),
        }
    }
}

#[inline(always)]
fn column(position: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let column = (position >> 32) as i32;
    column
}

#[inline(always)]
fn part(position: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    #[allow(clippy::cast_sign_loss, reason = "bits")]
    let part = position as u32;
    part
}
