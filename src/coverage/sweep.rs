//! A row of cells, swept from left to right: the area adds up, and what it makes of each pixel is sent.

use core::{mem::take, ops::Range};

use crate::{
    coverage::{CoverageSink, cells::Cell, ramp::coverage_of, runs::Runs},
    span::Span,
};

/// Sends `columns`, of which the first have cells, in runs and spans. All cells are 0 after that.
#[inline(always)]
pub(super) fn send_in_runs<S: CoverageSink>(
    row: i32,
    columns: Range<i32>,
    cells: &mut [Cell],
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    runs.start(row);
    let mut cells = cells.iter_mut();
    let mut column = columns.start;
    let mut area = 0_u32;
    while let Some(cell) = cells.next() {
        area = area.wrapping_add(take(&mut cell.0).cast_unsigned());
        let coverage = coverage_of(area);
        if coverage != 0 && coverage != 255 {
            runs.pixel(column, coverage)?;
            column += 1;
            continue;
        }
        // As far as it stays so.
        let gap = column;
        column += 1;
        loop {
            let zeros = zeros(cells.as_slice());
            if zeros > 0 {
                cells.nth(zeros - 1);
                column = after(column, zeros);
            }
            let Some(cell) = cells.as_slice().first() else { break };
            let next = area.wrapping_add(cell.0.cast_unsigned());
            if coverage_of(next) != coverage {
                break;
            }
            area = next;
            column += 1;
            if let Some(cell) = cells.next() {
                cell.0 = 0;
            }
        }
        if cells.as_slice().is_empty() {
            column = columns.end;
        }
        if coverage == 0 { runs.finish()? } else { runs.inside(gap, column)? }
    }
    runs.alike(column, columns.end, coverage_of(area))?;
    runs.finish()
}

/// How many cells in front are 0.
#[inline(always)]
fn zeros(cells: &[Cell]) -> usize {
    let (eights, _) = cells.as_chunks();
    let whole = eights.iter().take_while(|eight| are_zero(eight)).count() * 8;
    whole + cells.get(whole..).unwrap_or_default().iter().take_while(|cell| cell.0 == 0).count()
}

#[inline(always)]
fn are_zero(eight: &[Cell; 8]) -> bool {
    eight.iter().fold(0, |any, cell| any | cell.0) == 0
}

#[inline(always)]
fn after(column: i32, columns: usize) -> i32 {
    column.wrapping_add_unsigned(u32::try_from(columns).unwrap_or(0))
}

/// The same in eights, and in spans of eights: most outlines have an edge in every other eight, and an eight that is all inside
/// is blended in less time than a span is started.
#[inline(always)]
pub(super) fn send_in_eights<S: CoverageSink>(
    row: i32,
    columns: Range<i32>,
    cells: &mut [Cell],
    sink: &mut S,
) -> Result<(), S::Error> {
    let (eights, rest) = cells.as_chunks_mut::<8>();
    let mut open = OpenEights { sink, row, column: columns.start, eights: [[0; 8]; OPEN], count: 0 };
    let mut area = 0_u32;
    let mut place = 0;
    loop {
        let alike = eights.get(place..).unwrap_or_default().iter().take_while(|eight| are_zero(eight)).count();
        if alike > 1 {
            open.span(after(open.column, 8 * alike), coverage_of(area))?;
            place += alike;
        }
        let Some(eight) = eights.get_mut(place) else { break };
        open.push(eight, &mut area)?;
        place += 1;
    }
    if !rest.is_empty() {
        open.push_last(rest, &mut area)?;
    }
    open.span(columns.end, coverage_of(area))
}

/// So many eights are sent together, at most.
const OPEN: usize = 8;

/// Eights that follow each other, on their way to the sink.
struct OpenEights<'s, S> {
    sink: &'s mut S,
    row: i32,
    /// The one after the last eight.
    column: i32,
    eights: [[u8; 8]; OPEN],
    count: usize,
}

impl<S: CoverageSink> OpenEights<'_, S> {
    /// Another eight, as the area changes in it.
    #[inline(always)]
    fn push(&mut self, changes: &mut [Cell; 8], area: &mut u32) -> Result<(), S::Error> {
        if let Some(eight) = self.eights.get_mut(self.count) {
            for (coverage, change) in eight.iter_mut().zip(&*changes) {
                *area = area.wrapping_add(change.0.cast_unsigned());
                *coverage = coverage_of(*area);
            }
        }
        *changes = [Cell::EMPTY; 8];
        self.count += 1;
        self.column += 8;
        if self.count < OPEN { Ok(()) } else { self.send() }
    }

    /// Fewer than eight: what is to their right is none of it.
    #[inline(always)]
    fn push_last(&mut self, changes: &mut [Cell], area: &mut u32) -> Result<(), S::Error> {
        let mut coverage = [0; 8];
        for (coverage, change) in coverage.iter_mut().zip(&mut *changes) {
            *area = area.wrapping_add(take(&mut change.0).cast_unsigned());
            *coverage = coverage_of(*area);
        }
        self.send()?;
        self.sink.eights(self.row, self.column, &[coverage])?;
        self.column = after(self.column, changes.len());
        Ok(())
    }

    /// Columns that are all alike, up to `end`; there may be none.
    #[inline(always)]
    fn span(&mut self, end: i32, coverage: u8) -> Result<(), S::Error> {
        self.send()?;
        let columns = self.column..end;
        self.column = end;
        if coverage == 0 || columns.is_empty() {
            Ok(())
        } else {
            self.sink.span(Span { row: self.row, columns }, coverage)
        }
    }

    #[inline(always)]
    fn send(&mut self) -> Result<(), S::Error> {
        let count = take(&mut self.count);
        let Some(first) = u32::try_from(8 * count).ok().filter(|&columns| columns > 0) else { return Ok(()) };
        let first = self.column.wrapping_sub_unsigned(first);
        self.sink.eights(self.row, first, self.eights.get(..count).unwrap_or_default())
    }
}
