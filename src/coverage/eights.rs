//! Eight columns at once, for sinks that take them as fast as two or three.
//!
//! How many columns an edge crosses changes from row to row, and no processor foresees it. So nothing here depends on it
//! that is not the same for most rows of an edge: up to four columns are worked out by selecting, not by jumping, and eight
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
        ramp::{Extent, FULL, Ramp, coverage_beside},
        steepness::Steepness,
    },
    span::Span,
};

/// How many columns are sent at once.
pub(super) const EIGHT: i32 = 8;

/// So many columns are worked out without a jump, and sent on either side of a span.
const FEW: i32 = 4;

impl Ramp {
    /// The coverage of the eight columns from `column` on, the first in the lowest byte, as if all of them were between the
    /// first that it crosses and the last.
    #[inline(always)]
    fn eight_between<const IS_RIGHT: bool>(&self, column: i32) -> u64 {
        let before = column.wrapping_sub(self.first).wrapping_sub(1).cast_unsigned();
        let mut area = self.second_area.wrapping_add(before.wrapping_mul(self.step));
        let mut coverage = [0; EIGHT as usize];
        for coverage in &mut coverage {
            *coverage = coverage_beside::<IS_RIGHT>(area);
            area = area.wrapping_add(self.step);
        }
        u64::from_le_bytes(coverage)
    }

    /// The coverage of up to four columns, which are all that it crosses, the first in the lowest byte. In the bytes after
    /// them is the inside of a left edge, and nothing of a right one.
    #[inline(always)]
    fn few<const IS_RIGHT: bool>(&self) -> u64 {
        let covered = |area: u32| u64::from(coverage_beside::<IS_RIGHT>(area));
        let third_area = self.second_area.wrapping_add(self.step);
        let word = covered(self.first_area) | (covered(self.second_area) << 8) | (covered(third_area) << 16);
        let at_last = 8 * (self.last - self.first).cast_unsigned();
        let before_last = word & ((1 << at_last) - 1);
        let after = if IS_RIGHT { 0 } else { !0xFF };
        before_last | ((covered(self.last_area) | after) << at_last)
    }
}

/// See `sides`.
#[inline(always)]
pub(super) fn send_between<const STEEP: bool, S: CoverageSink>(
    row: i32,
    left: (Extent, Steepness),
    right: (Extent, Steepness),
    sink: &mut S,
) -> Result<(), S::Error> {
    let (start, end) = (left.0.first, right.0.last + 1);
    let (left_word, right_word) = if STEEP || (left.1.is_steep() && right.1.is_steep()) {
        (two::<false>(left.0, left.1), two::<true>(right.0, right.1))
    } else if left.0.last - start < FEW && end - right.0.first <= FEW {
        (few::<false>(left.0, left.1), few::<true>(right.0, right.1))
    } else {
        return send_wide(row, left, right, sink);
    };
    let right_from = |column: i32| after_inside(right_word, right.0.first - column);
    if end - start <= EIGHT {
        return sink.eights(row, start, &[(left_word & right_from(start)).to_le_bytes()]);
    }
    let sides = (left_word & u64::from(u32::MAX)) | (right_from(end - EIGHT) & !u64::from(u32::MAX));
    sink.span_with_sides(Span { row, columns: start..end }, &sides.to_le_bytes())
}

/// The same with an eight or more on either side.
#[inline(always)]
fn send_wide<S: CoverageSink>(
    row: i32,
    left: (Extent, Steepness),
    right: (Extent, Steepness),
    sink: &mut S,
) -> Result<(), S::Error> {
    let (start, end) = (left.0.first, right.0.last + 1);
    let are_eights = left.0.last - start < EIGHT && end - right.0.first <= EIGHT && end - start >= 2 * EIGHT;
    if !are_eights {
        let inside = send_left(row, left.0, left.1, right.0.first, sink)?;
        return send_right(row, right.0, right.1, inside, sink);
    }
    let inside = start + EIGHT..end - EIGHT;
    let (left_word, right_word) = (eight::<false>(left.0, left.1), eight::<true>(right.0, right.1));
    sink.eights(row, start, &[left_word.to_le_bytes()])?;
    sink.eights(row, inside.end, &[after_inside(right_word, right.0.first - inside.end).to_le_bytes()])?;
    if inside.start < inside.end { sink.span(Span { row, columns: inside }, 255) } else { Ok(()) }
}

/// A word of what a right edge takes of its pixels, after so many of the inside: `(word << bits) | ((1 << bits) - 1)`.
#[inline(always)]
fn after_inside(word: u64, columns: i32) -> u64 {
    (word.wrapping_add(1) << (8 * columns.cast_unsigned())).wrapping_sub(1)
}

/// As [`Ramp::few`], of an edge that crosses at most a pixel in a row, and so at most two columns.
#[inline(always)]
fn two<const IS_RIGHT: bool>(extent: Extent, steepness: Steepness) -> u64 {
    let (first, last) = Ramp::ends_of_steep(extent, steepness);
    let covered = |area: u32| u64::from(coverage_beside::<IS_RIGHT>(area));
    let word = covered(first) | (covered(last) << 8);
    if IS_RIGHT { word } else { word | (u64::MAX << 16) }
}

/// The same of an edge that crosses at most four columns.
#[inline(always)]
fn few<const IS_RIGHT: bool>(extent: Extent, steepness: Steepness) -> u64 {
    if steepness.is_steep() {
        two::<IS_RIGHT>(extent, steepness)
    } else {
        Ramp::new_few(extent, steepness).few::<IS_RIGHT>()
    }
}

/// The same of an edge that crosses at most eight columns.
#[inline(never)]
fn eight<const IS_RIGHT: bool>(extent: Extent, steepness: Steepness) -> u64 {
    let across = extent.last - extent.first;
    if across < FEW {
        return few::<IS_RIGHT>(extent, steepness);
    }
    let ramp = Ramp::new(extent, FULL, steepness);
    let covered = |area: u32| u64::from(coverage_beside::<IS_RIGHT>(area));
    let word = (ramp.eight_between::<IS_RIGHT>(ramp.first) & !0xFF) | covered(ramp.first_area);
    let at_last = 8 * across.cast_unsigned();
    let after = if IS_RIGHT { 0 } else { !0xFF };
    (word & ((1 << at_last) - 1)) | ((covered(ramp.last_area) | after) << at_last)
}

/// Sends what an edge leaves of its pixels; after it is the inside, as far as `end`. Where that goes on is returned.
#[inline(never)]
pub(super) fn send_left<S: CoverageSink>(
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
    if last - first < EIGHT {
        sink.eights(row, first, &[masked(first, eight::<false>(extent, steepness))])?;
        return Ok(end.min(first + EIGHT));
    }
    let ramp = Ramp::new(extent, FULL, steepness);
    let mut column = first;
    let mut word = (ramp.eight_between::<false>(column) & !0xFF) | u64::from(coverage_beside::<false>(ramp.first_area));
    while column + EIGHT <= last {
        sink.eights(row, column, &[word.to_le_bytes()])?;
        column += EIGHT;
        word = ramp.eight_between::<false>(column);
    }
    let at_last = 8 * (last - column).cast_unsigned();
    let word = (word & ((1 << at_last) - 1))
        | (u64::from(coverage_beside::<false>(ramp.last_area)) << at_last)
        | (!0xFF << at_last);
    sink.eights(row, column, &[masked(column, word)])?;
    Ok(end.min(column + EIGHT))
}

/// Sends the inside, from `inside` on, and what an edge takes of its pixels.
#[inline(never)]
pub(super) fn send_right<S: CoverageSink>(
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
    if across < EIGHT {
        let word = after_inside(eight::<true>(extent, steepness), first - column);
        return sink.eights(row, column, &[word.to_le_bytes()]);
    }
    let ramp = Ramp::new(extent, FULL, steepness);
    let covered = |area: u32| u64::from(coverage_beside::<true>(area));
    let at_first = 8 * (first - column).cast_unsigned();
    let mut word = ramp.eight_between::<true>(column) & (!0xFF << at_first);
    word |= (covered(ramp.first_area) << at_first) | ((1 << at_first) - 1);
    while column + EIGHT <= last {
        sink.eights(row, column, &[word.to_le_bytes()])?;
        column += EIGHT;
        word = ramp.eight_between::<true>(column);
    }
    let at_last = 8 * (last - column).cast_unsigned();
    let word = (word & ((1 << at_last) - 1)) | (covered(ramp.last_area) << at_last);
    sink.eights(row, column, &[word.to_le_bytes()])
}
