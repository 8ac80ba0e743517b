//! Circles, row by row: the chords of an outline (see `circle_chords`), worked out once for both sides.
//!
//! A row that one chord crosses is sent as it is. Where there are more, or the clip cuts the row, cells add them up.

use core::ops::Range;

use crate::{
    coverage::{
        Cell, Cells, CoverageSink, Ramp, Runs,
        circle_chords::{BITS, Center, Chord, FINER, LARGEST_RADIUS, Outline, Point, ROW},
        few::{Changes, NEAR, send_few},
        ramp::height_in,
        sides::send_between,
    },
    limits::SUBPIXEL_BITS,
    span::clip_range,
};

/// Cells for either side of a row, or for both.
const SIDE: usize = 64;

/// Centres so far from the origin leave every place in its range.
const REACH: u32 = 1 << 30;

/// A circle that is small enough, and near enough to the origin; in 1/256 pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NearCircle {
    x: i32,
    y: i32,
    radius: i32,
}

impl NearCircle {
    /// None for one that is not.
    #[inline(always)]
    pub(crate) fn new(x: i32, y: i32, radius: i32) -> Option<Self> {
        let is_near = radius <= LARGEST_RADIUS && x.unsigned_abs() <= REACH && y.unsigned_abs() <= REACH;
        is_near.then_some(Self { x, y, radius })
    }

    /// Sends what is in some of the columns that it touches.
    pub(crate) fn send<S: CoverageSink>(
        &self,
        touched: Range<i32>,
        rows: Range<i32>,
        columns: Range<i32>,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let outline = Outline::new(self.radius.unsigned_abs());
        let center = Center::new(self.x);
        Walk {
            outline,
            center,
            touched,
            columns,
            runs: Runs::new(sink),
            changes: Changes::default(),
            cells: [Cell::EMPTY; 2 * SIDE],
        }
        .send(self.y, rows)
    }
}

struct Walk<'s, S> {
    outline: Outline,
    center: Center,
    touched: Range<i32>,
    columns: Range<i32>,
    runs: Runs<'s, S>,
    changes: Changes,
    /// All 0 between two rows.
    cells: [Cell; 2 * SIDE],
}

impl<S: CoverageSink> Walk<'_, S> {
    /// Sends the rows; the centre is at `y`.
    #[inline(always)]
    fn send(mut self, y: i32, rows: Range<i32>) -> Result<(), S::Error> {
        let radius = self.outline.radius.cast_signed();
        let mut top = ((rows.start << SUBPIXEL_BITS) - y) << FINER;
        let mut upper = self.outline.at(top.max(-radius));
        for row in rows {
            top += ROW.cast_signed();
            let lower = self.outline.at(top.min(radius));
            if !self.send_whole(row, upper, lower)? {
                self.send_cells(row, upper, lower)?;
            }
            upper = lower;
        }
        Ok(())
    }

    /// Sends a row that one chord crosses on either side, unless it is cut or the two are in the same column.
    #[inline(always)]
    fn send_whole(&mut self, row: i32, upper: Point, lower: Point) -> Result<bool, S::Error> {
        if lower.y.abs_diff(upper.y) != ROW {
            return Ok(false);
        }
        let Some(chord) = self.outline.chord(upper, lower) else { return Ok(false) };
        let (left, right) = chord.extents(self.center);
        let is_inside = left.first >= self.columns.start && right.last < self.columns.end;
        if left.last >= right.first || !is_inside {
            return Ok(false);
        }
        send_between(row, (left, chord.steepness), (right, chord.steepness), &mut self.runs)?;
        Ok(true)
    }

    /// Sends any row.
    #[inline(never)]
    fn send_cells(&mut self, row: i32, upper: Point, lower: Point) -> Result<(), S::Error> {
        let Self { outline, center, touched, columns, runs, changes, cells } = self;
        let center = *center;
        let inner = upper.width.min(lower.width);
        let outer = if upper.y < 0 && lower.y > 0 { outline.radius } else { upper.width.max(lower.width) };
        // A chord is moved outwards by less than a pixel, and changes the column after its last. In the one after the
        // circle's last, nothing is left.
        let outer = outer + ROW;
        let left = center.column_at(center.left(outer))..center.column_at(center.left(inner)) + 2;
        let right = center.column_at(center.right(inner))..center.column_at(center.right(outer)) + 2;
        let near = |side: &Range<i32>| side.end - side.start <= NEAR;
        if (near(&left) && near(&right)) || right.end - left.start <= NEAR {
            let (mut of_left, mut of_right) = changes.sides();
            outline.chords(upper, lower, &mut |chord: &Chord| {
                of_left.add(&chord.left(center, touched));
                of_right.add(&chord.right(center, touched));
            });
            if send_few::<true, S>(row, of_left, of_right, columns, runs)? {
                return Ok(());
            }
        }
        let columns = columns.start..columns.end + i32::from(columns.end == touched.end);
        if (right.end - left.start).unsigned_abs() as usize <= 2 * SIDE {
            let zone = clip_range(&(left.start..right.end), &columns);
            if zone.is_empty() {
                return Ok(());
            }
            let mut both = Cells::new(cells, zone);
            outline.chords(upper, lower, &mut |chord: &Chord| {
                both.add_ramp(&chord.left(center, touched), 1);
                both.add_ramp(&chord.right(center, touched), -1);
            });
            return both.sweep(row, runs);
        }
        // The columns between the sides belong to the left one, which ends with what is covered of them.
        let (of_left, of_right) = cells.split_at_mut(SIDE);
        let left = clip_range(&(left.start..right.start), &columns);
        let right = clip_range(&right, &columns);
        let mut left_cells = Cells::new(of_left, left.clone());
        let mut right_cells = Cells::new(of_right, right.clone());
        let height = height_in::<BITS>(lower.y - upper.y);
        right_cells.add_ramp(&Ramp::in_column(right.start - 1, height, 0), 1);
        outline.chords(upper, lower, &mut |chord: &Chord| {
            if !left.is_empty() {
                left_cells.add_ramp(&chord.left(center, touched), 1);
            }
            if !right.is_empty() {
                right_cells.add_ramp(&chord.right(center, touched), -1);
            }
        });
        if !left.is_empty() {
            left_cells.sweep(row, runs)?;
        }
        if right.is_empty() { Ok(()) } else { right_cells.sweep(row, runs) }
    }
}
