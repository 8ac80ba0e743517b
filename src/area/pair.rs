//! Two edges that cross a whole row of pixels without a vertex, and share no column: what is between them goes to the sink as it
//! is worked out.
//!
//! ```text
//!      /#|####|####|####|####|###\ |      a run, a span and a run, or one run where there is little between
//!     /##|####|####|####|####|####\|
//! ```

use crate::area::{AreaSink, accumulator::FULL, chain::CoverageEdge};

/// The most columns of an edge.
const COLUMNS: usize = 8;

/// The same.
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "8")]
pub(super) const COLUMNS_AT_MOST: i32 = COLUMNS as i32;

/// A narrower gap goes with the columns beside it.
const GAP: usize = 4;

/// Room for a row's areas.
pub(super) type PairAreas = [i32; 2 * COLUMNS + GAP];

/// Nothing.
pub(super) const NO_AREAS: PairAreas = [0; 2 * COLUMNS + GAP];

/// Sends what is between two edges; `None` where they have to be added up, `Some(false)` where the sink has had enough.
#[inline]
pub(super) fn send_pair(
    row: i32,
    width: i32,
    (left, left_column): (&mut CoverageEdge, i32),
    (right, right_column): (&mut CoverageEdge, i32),
    areas: &mut PairAreas,
    sink: &mut dyn AreaSink,
) -> Option<bool> {
    if left_column < 0 || !left.is_single || !right.is_single {
        return None;
    }
    let of_left = left.areas_beside(areas.get_mut(..COLUMNS)?)?;
    let gap = right_column.checked_sub(left_column)?;
    let gap = usize::try_from(gap).ok()?.checked_sub(of_left)?;
    let beside = of_left + gap.min(GAP);
    let of_right = right.areas_beside(areas.get_mut(beside..beside + COLUMNS)?)?;
    let right_columns = areas.get_mut(beside..beside + of_right)?;
    if right_column + i32::try_from(of_right).ok()? > width {
        return None;
    }
    for area in &mut *right_columns {
        *area = FULL - *area;
    }
    if gap <= GAP {
        for area in areas.get_mut(of_left..beside)? {
            *area = FULL;
        }
        return Some(sink.run(row, left_column, areas.get(..beside + of_right)?));
    }
    let inside = left_column + i32::try_from(of_left).ok()?..right_column;
    Some(
        sink.run(row, left_column, areas.get(..of_left)?)
            && sink.span(row, inside, FULL)
            && sink.run(row, right_column, areas.get(beside..beside + of_right)?),
    )
}
