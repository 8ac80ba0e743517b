//! Shapes between two sides of at most two straight edges each, in the narrow zone: triangles and thin lines.
//!
//! Most rows are crossed by one edge on either side, from top to bottom. What the left one leaves of its pixels and what
//! the right one takes of its own are sent as they are, and all between is inside:
//!
//! ```text
//!        left          right
//!     |   /#|###|###|###\   |
//!     |  /##|###|###|####\  |        runs of one or two pixels, and a span
//!     | /###|###|###|#####\ |
//! ```
//!
//! Positions are in 2^-32 pixel: the upper half of one is its column. On a row boundary, an edge is where it is on the first
//! one, plus as many times its step as there are rows in between: it does not matter which of them are walked. A step is
//! rounded to 2^-32 pixel, and there are at most 2^14 rows: 2^-18 pixel.

use core::{
    mem::take,
    ops::{Range, RangeInclusive},
};

use heapless::Vec;

use crate::coverage::{
    CoverageSink,
    ramp::{FULL, Ramp, coverage_of, height_in},
    runs::{RUN, Runs},
    slope::{Slope, Steepness, high_word},
};

/// An edge that goes down; heights in 2^-`BITS` pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Straight<const BITS: u32> {
    /// Where it is at `y`.
    position: i64,
    /// To the next row.
    step: i64,
    y: i32,
    /// Its lower end.
    until: i32,
    end: i64,
    rise: Rise,
}

/// How steep an edge is: see [`Steepness::shifts`].
#[derive(Debug, Clone, Copy)]
struct Rise {
    mantissa: u32,
    up: u32,
    down: u32,
}

impl Rise {
    /// How far down for a width.
    #[inline(always)]
    fn of(&self, across: u32) -> u32 {
        high_word(across << self.up, self.mantissa) >> self.down
    }

    /// The same for a pixel, of an edge that crosses one within a row.
    #[inline(always)]
    fn of_a_pixel(&self) -> u32 {
        self.mantissa >> self.down
    }

    /// The areas of an edge that crosses `columns`, from so far into the first to so far into the last.
    #[inline(always)]
    fn ramp(&self, columns: RangeInclusive<i32>, left: u32, right: u32, height: u32) -> Ramp {
        let (first, last) = (*columns.start(), *columns.end());
        if first == last {
            return Ramp::in_column(first, height, height - high_word(height, (left >> 1) + (right >> 1)));
        }
        let down = self.of(!left).min(height);
        let (rest, step) =
            if first + 1 == last { (height - down, 0) } else { (self.of(right).min(height), self.of_a_pixel()) };
        Ramp {
            first,
            last,
            height,
            first_area: high_word(!left, down) >> 1,
            last_area: height - (high_word(right, rest) >> 1),
            second_area: down + (step >> 1),
            step,
            steepness: Steepness::NONE,
        }
    }
}

impl<const BITS: u32> Straight<BITS> {
    /// From one position and height to another, in the direction (dx, dy), both at most 2^22.
    #[inline(always)]
    pub(crate) fn new(from: (i64, i32), to: (i64, i32), dx: i32, dy: u32) -> Self {
        let slope = Slope::directed(0, dx, dy);
        let (mantissa, up, down) = slope.steepness.shifts();
        let rise = Rise { mantissa, up, down };
        Self { position: from.0, step: slope.step(), y: from.1, until: to.1, end: to.0, rise }
    }

    /// From here to a position below.
    #[inline(always)]
    fn ramp(&self, to: i64, height: u32) -> Ramp {
        let (from, to) = if self.step < 0 { (to, self.position) } else { (self.position, to) };
        self.rise.ramp(upper(from)..=upper(to), lower(from), lower(to), height)
    }

    #[inline(always)]
    fn at(&self, y: i32) -> i64 {
        if y == self.until { self.end } else { self.position + ((self.step * i64::from(y - self.y)) >> BITS) }
    }

    /// Takes it to a height on its way that is the top of a row.
    #[inline(always)]
    fn skip_to(&mut self, y: i32) {
        let boundary = (self.y + (1 << BITS) - 1) >> BITS << BITS;
        let rows = (y - boundary) >> BITS;
        self.position = self.at(boundary) + self.step * i64::from(rows);
        self.y = y;
    }
}

/// One side: an edge, and perhaps another below.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side<const BITS: u32> {
    pub(crate) edge: Straight<BITS>,
    pub(crate) next: Option<Straight<BITS>>,
}

impl<const BITS: u32> Side<BITS> {
    /// Takes it to the top of a row, unless it starts farther down.
    #[inline(always)]
    fn skip_to(&mut self, row: i32) {
        let y = row << BITS;
        if y >= self.edge.until {
            self.turn();
        }
        if y > self.edge.y && y < self.edge.until {
            self.edge.skip_to(y);
        }
    }

    #[inline(always)]
    fn turn(&mut self) {
        if let Some(next) = self.next.take() {
            self.edge = next;
        }
    }

    /// How many rows from `row` on its edge crosses from top to bottom.
    #[inline(always)]
    fn whole_rows(&self, row: i32) -> i32 {
        if self.edge.y == row << BITS { (self.edge.until >> BITS) - row } else { 0 }
    }

    /// What it has of `row`, one or two pieces, of which the second may be nothing. The side is taken to the next row.
    #[inline(always)]
    fn pieces(&mut self, row: i32, mut piece: impl FnMut(Ramp)) {
        let bottom = (row + 1) << BITS;
        loop {
            let edge = &mut self.edge;
            let y = bottom.min(edge.until);
            if y > edge.y {
                let to = edge.at(y);
                let height = height_in::<BITS>(y - edge.y);
                piece(edge.ramp(to, height));
                (edge.position, edge.y) = (to, y);
            }
            if y < edge.until || self.next.is_none() {
                return;
            }
            self.turn();
        }
    }
}

/// Sends what lies between two sides.
#[inline(always)]
pub(crate) fn send_straight<const BITS: u32, S: CoverageSink>(
    mut left: Side<BITS>,
    mut right: Side<BITS>,
    mut rows: Range<i32>,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    left.skip_to(rows.start);
    right.skip_to(rows.start);
    let mut runs = Runs::new(sink);
    let mut changes = [0; NEAR as usize + 1];
    while rows.start < rows.end {
        let whole = left.whole_rows(rows.start).min(right.whole_rows(rows.start)).min(rows.end - rows.start);
        if whole > 0 {
            send_rows(
                &mut left.edge,
                &mut right.edge,
                rows.start..rows.start + whole,
                columns,
                &mut changes,
                &mut runs,
            )?;
            rows.start += whole;
        } else {
            send_pieces(&mut left, &mut right, rows.start, columns, &mut changes, &mut runs)?;
            rows.start += 1;
        }
    }
    Ok(())
}

/// A row in which a side begins, ends or turns.
#[inline(never)]
fn send_pieces<const BITS: u32, S: CoverageSink>(
    left: &mut Side<BITS>,
    right: &mut Side<BITS>,
    row: i32,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    // Two a side; there are never more.
    let mut ramps = Vec::<_, 4>::new();
    left.pieces(row, |ramp| ramps.push((ramp, 1)).unwrap_or_default());
    right.pieces(row, |ramp| ramps.push((ramp, u32::MAX)).unwrap_or_default());
    send_ramps(row, &ramps, columns, changes, runs)
}

/// An edge in whole rows: its left end in the current one, how far on that is in the next, and how far to the right end.
///
/// To the right or to the left, an edge takes up the same width in each row, so its ends need no comparing.
#[derive(Debug, Clone, Copy)]
struct Stepper {
    left: i64,
    step: i64,
    width: i64,
    rise: Rise,
}

impl Stepper {
    #[inline(always)]
    fn new<const BITS: u32>(edge: &Straight<BITS>) -> Self {
        Self { left: edge.position + edge.step.min(0), step: edge.step, width: edge.step.abs(), rise: edge.rise }
    }

    /// Takes the edge to the row that the stepper is on.
    #[inline(always)]
    fn put_back<const BITS: u32>(&self, edge: &mut Straight<BITS>, row: i32) {
        edge.position = self.left - self.step.min(0);
        edge.y = row << BITS;
    }

    /// Where it is in this row. It is taken to the next.
    #[inline(always)]
    fn step(&mut self) -> Extent {
        let (left, right) = (self.left, self.left + self.width);
        self.left += self.step;
        Extent { first: upper(left), last: upper(right), left: lower(left), right: lower(right) }
    }
}

#[inline(always)]
fn upper(position: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let upper = (position >> 32) as i32;
    upper
}

#[inline(always)]
fn lower(position: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    #[allow(clippy::cast_sign_loss, reason = "bits")]
    let lower = position as u32;
    lower
}

/// The columns that an edge crosses in a row, and how far into the first and the last, in 2^-32.
#[derive(Debug, Clone, Copy)]
struct Extent {
    first: i32,
    last: i32,
    left: u32,
    right: u32,
}

/// Rows that both edges cross from top to bottom.
#[inline(always)]
fn send_rows<const BITS: u32, S: CoverageSink>(
    left_edge: &mut Straight<BITS>,
    right_edge: &mut Straight<BITS>,
    rows: Range<i32>,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut left, mut right) = (Stepper::new(left_edge), Stepper::new(right_edge));
    let (start, end) = (columns.start, columns.end);
    let end_row = rows.end;
    for row in rows {
        let (of_left, of_right) = (left.step(), right.step());
        if of_left.last < of_right.first && of_left.first >= start && of_right.last < end {
            send_side::<false, S>(row, of_left, &left.rise, runs)?;
            let inside = of_left.last + 1..of_right.first;
            if inside.start < inside.end {
                runs.sink.span(crate::span::Span { row, columns: inside }, 255)?;
            }
            send_side::<true, S>(row, of_right, &right.rise, runs)?;
        } else {
            send_cut(row, (&of_left, &left.rise), (&of_right, &right.rise), columns, changes, runs)?;
        }
    }
    left.put_back(left_edge, end_row);
    right.put_back(right_edge, end_row);
    Ok(())
}

/// What the left edge leaves of its pixels, or what the right one takes of its own.
#[inline(always)]
fn send_side<const IS_RIGHT: bool, S: CoverageSink>(
    row: i32,
    extent: Extent,
    rise: &Rise,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let Runs { sink, coverage: run, .. } = runs;
    let coverage = |area: u32| coverage_of(if IS_RIGHT { FULL.wrapping_sub(area) } else { area });
    let Extent { first, last, left, right } = extent;
    if first == last {
        return send_run::<IS_RIGHT, S>(
            row,
            first,
            &[coverage(FULL - high_word(FULL, (left >> 1) + (right >> 1)))],
            sink,
        );
    }
    let down = rise.of(!left).min(FULL);
    let first_coverage = coverage(high_word(!left, down) >> 1);
    let last_coverage = |rest: u32| coverage(FULL - (high_word(right, rest) >> 1));
    if first + 1 == last {
        return send_run::<IS_RIGHT, S>(row, first, &[first_coverage, last_coverage(FULL - down)], sink);
    }
    let step = rise.of_a_pixel();
    let mut area = down + (step >> 1);
    let mut column = first;
    // How many there are left between the first and the last.
    let mut between = last.wrapping_sub(first).wrapping_sub(1).cast_unsigned() as usize;
    let mut start = 1;
    run[0] = first_coverage;
    loop {
        let length = between.min(RUN - 1 - start);
        for slot in run.get_mut(start..start + length).unwrap_or_default() {
            *slot = coverage(area);
            area += step;
        }
        between -= length;
        let mut end = start + length;
        if between == 0 {
            if let Some(slot) = run.get_mut(end) {
                *slot = last_coverage(rise.of(right).min(FULL));
            }
            end += 1;
        }
        send_run::<IS_RIGHT, S>(row, column, run.get(..end).unwrap_or_default(), sink)?;
        if between == 0 {
            return Ok(());
        }
        column = column.wrapping_add_unsigned(u32::try_from(end).unwrap_or(0));
        start = 0;
    }
}

/// A run that may begin with zeros, on the left, or end with them, on the right.
#[inline(always)]
fn send_run<const IS_RIGHT: bool, S: CoverageSink>(
    row: i32,
    mut column: i32,
    mut run: &[u8],
    sink: &mut S,
) -> Result<(), S::Error> {
    if IS_RIGHT {
        while let [rest @ .., 0] = run {
            run = rest;
        }
    } else {
        while let [0, rest @ ..] = run {
            run = rest;
            column += 1;
        }
    }
    if run.is_empty() { Ok(()) } else { sink.run(row, column, run) }
}

/// A row of which the edges share columns, or that the clip cuts.
#[inline(never)]
fn send_cut<S: CoverageSink>(
    row: i32,
    left: (&Extent, &Rise),
    right: (&Extent, &Rise),
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let ramps = [(left.0.ramp(left.1), 1), (right.0.ramp(right.1), u32::MAX)];
    send_ramps(row, &ramps, columns, changes, runs)
}

impl Extent {
    #[inline(always)]
    fn ramp(&self, rise: &Rise) -> Ramp {
        rise.ramp(self.first..=self.last, self.left, self.right, FULL)
    }
}

/// So many columns, and one more, are added up at once.
const NEAR: i32 = 15;

/// How the area changes from each column to the next; 0 between rows.
type Changes = [u32; NEAR as usize + 1];

/// Adds up what is right of a few edges, each with its sign: 1 on the left, -1 on the right.
#[inline(always)]
fn send_ramps<S: CoverageSink>(
    row: i32,
    ramps: &[(Ramp, u32)],
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    runs.start(row);
    let (mut start, mut end) = (i32::MAX, i32::MIN);
    for (ramp, _) in ramps {
        (start, end) = (start.min(ramp.first), end.max(ramp.last + 1));
    }
    if end.wrapping_sub(start) > NEAR || start < columns.start || end > columns.end {
        return send_far(ramps, start.max(columns.start)..end.min(columns.end), runs);
    }
    for (ramp, sign) in ramps {
        let mut before = 0;
        let mut index = ramp.first.wrapping_sub(start).cast_unsigned() as usize;
        let mut change = |area: u32| {
            if let Some(change) = changes.get_mut(index) {
                *change = change.wrapping_add(area.wrapping_sub(before).wrapping_mul(*sign));
            }
            before = area;
            index += 1;
        };
        change(ramp.first_area);
        if ramp.last != ramp.first {
            let mut area = ramp.second_area;
            for _ in ramp.first + 1..ramp.last {
                change(area);
                area = area.wrapping_add(ramp.step);
            }
            change(ramp.last_area);
        }
        change(ramp.height);
    }
    let mut area = 0_u32;
    let length = (end - start).cast_unsigned() as usize;
    for (coverage, change) in runs.coverage.iter_mut().zip(changes.iter_mut()).take(length) {
        area = area.wrapping_add(take(change));
        *coverage = coverage_of(area);
    }
    if let Some(last) = changes.get_mut(length) {
        *last = 0;
    }
    runs.send_all(start, length)
}

/// Column by column, but for what is between the sides.
#[inline(never)]
fn send_far<S: CoverageSink>(
    ramps: &[(Ramp, u32)],
    columns: Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let (mut left_end, mut right_start) = (i32::MIN, i32::MAX);
    for (ramp, sign) in ramps {
        if *sign == 1 {
            left_end = left_end.max(ramp.last + 1);
        } else {
            right_start = right_start.min(ramp.first);
        }
    }
    let mut column = columns.start;
    while column < columns.end {
        let add = |area: u32, (ramp, sign): &(Ramp, u32)| area.wrapping_add(ramp.at(column).wrapping_mul(*sign));
        let coverage = coverage_of(ramps.iter().fold(0, add));
        if column >= left_end && column < right_start {
            let until = right_start.min(columns.end);
            runs.alike(column, until, coverage)?;
            column = until;
        } else {
            runs.pixel(column, coverage)?;
            column += 1;
        }
    }
    runs.finish()
}
