//! Two edges that cross a row of pixels from top to bottom: what is between them goes to the sink as it is worked out.
//!
//! ```text
//!      /#|####|####|####|####|###\ |      a run, a span and a run, or one run where there is little between
//!     /##|####|####|####|####|####\|
//! ```

use core::hint::black_box;

use crate::area::{
    AreaSink,
    cell::{FULL, WHOLE, column_of, trapezoid, within},
    row::GAP,
    steepness::{Steepness, height_of},
};

/// Where an edge crosses a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// How far to the left it reaches and how far to the right, in 2^-32 pixel.
    pub(super) left: i64,
    pub(super) right: i64,
    /// Worked out, if it has more than one column.
    pub(super) steepness: Steepness,
}

impl Side {
    /// The first of its columns and the last.
    #[inline]
    pub(super) fn columns(&self) -> (i32, i32) {
        (column_of(self.left), column_of(self.right))
    }

    /// What it leaves of its columns to its right, or the rest of them; how many there are, if there is room.
    #[inline]
    fn areas<const COVERED: bool>(&self, areas: &mut [i32]) -> Option<usize> {
        let of = |area: u32| if COVERED { FULL - area.cast_signed() } else { area.cast_signed() };
        let count = column_of(self.right).wrapping_sub(column_of(self.left)).cast_unsigned() as usize;
        let (x, to) = (within(self.left), within(self.right));
        if count == 0 {
            *areas.first_mut()? = of(WHOLE - (x + to) / 2);
            return Some(1);
        }
        let (last, others) = areas.get_mut(..=count)?.split_last_mut()?;
        let (mut product, per_column) = (self.steepness.product(WHOLE - x), self.steepness.product(WHOLE));
        let (mut x, mut gone) = (x, 0);
        for area in others {
            // Too few to be unrolled.
            black_box(());
            let at = height_of(product).min(WHOLE);
            *area = of(at - trapezoid(x + WHOLE, at - gone));
            product = product.wrapping_add(per_column);
            (gone, x) = (at, 0);
        }
        *last = of(WHOLE - trapezoid(to, WHOLE - gone));
        Some(count + 1)
    }
}

/// Sends what is between two sides; `None` where the clip cuts it, where they cross, or where a half of `areas` has no room for
/// what is sent at once.
#[inline(always)]
pub(super) fn send_pair(
    row: i32,
    width: i32,
    [left, right]: [&Side; 2],
    areas: &mut [i32],
    sink: &mut dyn AreaSink,
) -> Option<bool> {
    let ((start, inside), (outside, end)) = (left.columns(), right.columns());
    if start < 0 || end >= width || outside < start || end < inside {
        return None;
    }
    let (areas, of_right) = areas.split_at_mut(areas.len() / 2);
    let of_left = left.areas::<false>(areas)?;
    let count = right.areas::<true>(of_right)?;
    let of_right = of_right.get(..count)?;
    let before = (outside - start).unsigned_abs() as usize;
    if before > of_left + GAP {
        return Some(
            sink.run(row, start, areas.get(..of_left)?)
                && sink.span(row, inside + 1..outside, FULL)
                && sink.run(row, outside, of_right),
        );
    }
    let areas = areas.get_mut(..before + of_right.len())?;
    for area in areas.get_mut(of_left..)? {
        black_box(());
        *area = FULL;
    }
    for (area, of_right) in areas.get_mut(before..)?.iter_mut().zip(of_right) {
        black_box(());
        *area -= FULL - of_right;
    }
    Some(sink.run(row, start, areas))
}
