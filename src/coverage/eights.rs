//! Eight columns at once, for sinks that take them as fast as two or three.
//!
//! How many columns an edge crosses changes from row to row, and no processor foresees it. So nothing here depends on it
//! that is not the same for most rows of an edge: up to three columns are worked out by selecting, not by jumping, and eight
//! are sent whatever they are. With four columns on either side, the row of a shape is one call:
//!
//! ```text
//!       left                 right
//!     |  /#|###|###|###|...|###|###|#\ |    |
//!     '------ four ----'   '------ four ----'      and a span between them
//! ```

use crate::{
    coverage::{
        CoverageSink,
        ramp::{Extent, FULL, Ramp, coverage_of},
        slope::Steepness,
    },
    span::Span,
};

/// How many columns are sent at once.
pub(super) const EIGHT: i32 = 8;

/// So many columns are worked out without a jump; and one more is sent on either side of a span.
const FEW: i32 = 3;

impl Ramp {
    /// The area in each of the eight columns from `column` on.
    #[inline(always)]
    fn eight(&self, column: i32) -> [u32; 8] {
        let (first, last) = (self.first.wrapping_sub(column), self.last.wrapping_sub(column));
        let before = self.second_area.wrapping_sub(first.wrapping_add(1).cast_unsigned().wrapping_mul(self.step));
        let mut areas = [0_u32; 8];
        for (lane, area) in (0..).zip(&mut areas) {
            let between = before.wrapping_add(self.step.wrapping_mul(i32::cast_unsigned(lane)));
            let inside = if lane > first { between } else { 0 };
            let inside = if lane == first { self.first_area } else { inside };
            let inside = if lane == last { self.last_area } else { inside };
            *area = if lane > last { self.height } else { inside };
        }
        areas
    }

    /// The coverage of up to three columns, which are all that it crosses, the first in the lowest byte. In the bytes after
    /// them is the inside of a left edge, and nothing of a right one.
    #[inline(always)]
    fn few<const IS_RIGHT: bool>(&self) -> u64 {
        let covered = |area: u32| u64::from(coverage_of(if IS_RIGHT { FULL.wrapping_sub(area) } else { area }));
        let across = (self.last - self.first).cast_unsigned();
        let word = covered(self.first_area) | (covered(self.second_area) << 8) | (covered(self.last_area) << 16);
        let crossed = (1_u64 << 8 << (8 * across)) - 1;
        if IS_RIGHT { word & crossed } else { word | !crossed }
    }
}

/// See `sides`.
#[inline(always)]
pub(super) fn send_between<S: CoverageSink>(
    row: i32,
    left: (Extent, Steepness),
    right: (Extent, Steepness),
    sink: &mut S,
) -> Result<(), S::Error> {
    let (start, end) = (left.0.first, right.0.last + 1);
    if left.0.last - start < FEW && end - right.0.first <= FEW {
        let left = Ramp::new_few(left.0, FULL, left.1).few::<false>();
        let of_right = Ramp::new_few(right.0, FULL, right.1).few::<true>();
        let width = end - start;
        let before = 8 * (right.0.first - (end - width.min(EIGHT))).cast_unsigned();
        let of_right = (of_right << before) | ((1 << before) - 1);
        if width <= EIGHT {
            return sink.eights(row, start, &[(left & of_right).to_le_bytes()]);
        }
        let sides = (left & u64::from(u32::MAX)) | (of_right & !u64::from(u32::MAX));
        return sink.span_with_sides(Span { row, columns: start..end }, &sides.to_le_bytes());
    }
    let inside = send_left(row, left.0, left.1, right.0.first, sink)?;
    send_right(row, right.0, right.1, inside, sink)
}

/// Sends what an edge leaves of its pixels; after it is the inside, as far as `end`. Where that goes on is returned.
#[inline(never)]
fn send_left<S: CoverageSink>(
    row: i32,
    extent: Extent,
    steepness: Steepness,
    end: i32,
    sink: &mut S,
) -> Result<i32, S::Error> {
    let Extent { first, last, .. } = extent;
    let masked = |column: i32, word: u64| {
        let excess = (column + EIGHT - end).max(0).cast_unsigned();
        (word & (u64::MAX >> (8 * excess))).to_le_bytes()
    };
    if last - first < FEW {
        let word = Ramp::new_few(extent, FULL, steepness).few::<false>();
        sink.eights(row, first, &[masked(first, word)])?;
        return Ok(end.min(first + EIGHT));
    }
    let ramp = Ramp::new(extent, FULL, steepness);
    let mut column = first;
    loop {
        let coverage = ramp.eight(column).map(coverage_of);
        sink.eights(row, column, &[masked(column, u64::from_le_bytes(coverage))])?;
        column += EIGHT;
        if column > last {
            return Ok(end.min(column));
        }
    }
}

/// Sends the inside, from `inside` on, and what an edge takes of its pixels.
#[inline(never)]
fn send_right<S: CoverageSink>(
    row: i32,
    extent: Extent,
    steepness: Steepness,
    inside: i32,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Extent { first, last, .. } = extent;
    let across = last - first;
    let mut column = inside.max(last - (across | (EIGHT - 1)));
    if inside < column {
        sink.span(Span { row, columns: inside..column }, 255)?;
    }
    if across < FEW {
        let word = Ramp::new_few(extent, FULL, steepness).few::<true>();
        let before = 8 * (first - column).cast_unsigned();
        return sink.eights(row, column, &[((word << before) | ((1 << before) - 1)).to_le_bytes()]);
    }
    let ramp = Ramp::new(extent, FULL, steepness);
    while column <= last {
        let coverage = ramp.eight(column).map(|area| coverage_of(FULL.wrapping_sub(area)));
        sink.eights(row, column, &[coverage])?;
        column += EIGHT;
    }
    Ok(())
}
