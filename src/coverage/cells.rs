//! A row of cells: how the area changes from each column to the next.
//!
//! Edges are added in any order and any number, each in the columns that it crosses and one more; a sweep from left to
//! right adds the cells up. The idea is that of Raph Levien's libart and of FreeType's smooth rasterizer (D. Turner,
//! `ftgrays`), with one number a cell in place of two, as in Raph Levien's font-rs.

use core::{mem::take, ops::Range};

use crate::coverage::{
    CoverageSink,
    ramp::{Ramp, STEPPED, coverage_of},
    runs::Runs,
};

/// Scratch for one column of an anti-aliased polygon. 4 bytes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cell(i32);

impl Cell {
    /// Unused scratch.
    pub const EMPTY: Self = Self(0);
}

/// Cells for `columns`, at least as many as those.
#[derive(Debug)]
pub(crate) struct Cells<'c> {
    cells: &'c mut [Cell],
    columns: Range<i32>,
    /// Columns outside are as they were: 0.
    touched: Range<i32>,
}

impl<'c> Cells<'c> {
    /// All cells are 0.
    #[inline]
    pub(crate) fn new(cells: &'c mut [Cell], columns: Range<i32>) -> Self {
        Self { cells, touched: columns.end..columns.start, columns }
    }

    /// Adds what is to the right of an edge, or, with `sign` -1, takes it away.
    #[inline(always)]
    pub(crate) fn add_ramp(&mut self, ramp: &Ramp, sign: i32) {
        // The column after the last is where the area stops changing.
        let first = ramp.first.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        let length = ramp.last.wrapping_sub(ramp.first).cast_unsigned() as usize + 2;
        if ramp.first < self.columns.start
            || ramp.last >= self.columns.end - 1
            || length > STEPPED.unsigned_abs() as usize
        {
            return self.add_cut(ramp, sign);
        }
        self.touched.start = self.touched.start.min(ramp.first);
        self.touched.end = self.touched.end.max(ramp.last + 2);
        let sign = sign.cast_unsigned();
        let change = |cell: &mut Cell, by: u32| cell.0 = cell.0.wrapping_add(by.wrapping_mul(sign).cast_signed());
        match self.cells.get_mut(first..).and_then(|cells| cells.get_mut(..length)) {
            Some([a, b]) => {
                change(a, ramp.first_area);
                change(b, ramp.height.wrapping_sub(ramp.first_area));
            }
            Some([a, b, c]) => {
                change(a, ramp.first_area);
                change(b, ramp.last_area.wrapping_sub(ramp.first_area));
                change(c, ramp.height.wrapping_sub(ramp.last_area));
            }
            Some([a, b, between @ .., c, d]) => {
                change(a, ramp.first_area);
                change(b, ramp.second_area.wrapping_sub(ramp.first_area));
                let mut area = ramp.second_area;
                for cell in between {
                    change(cell, ramp.step);
                    area = area.wrapping_add(ramp.step);
                }
                change(c, ramp.last_area.wrapping_sub(area));
                change(d, ramp.height.wrapping_sub(ramp.last_area));
            }
            _ => {}
        }
    }

    /// The same for an edge that the columns cut.
    #[inline(never)]
    fn add_cut(&mut self, ramp: &Ramp, sign: i32) {
        let first = ramp.first.max(self.columns.start);
        if first >= self.columns.end {
            return;
        }
        let end = ramp.last.saturating_add(2).min(self.columns.end).max(first + 1);
        let index = |column: i32| column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        let mut before = 0;
        for (column, cell) in (first..end).zip(self.cells.get_mut(index(first)..).unwrap_or_default()) {
            let area = ramp.at(column);
            let change = area.wrapping_sub(before).wrapping_mul(sign.cast_unsigned());
            cell.0 = cell.0.wrapping_add(change.cast_signed());
            before = area;
        }
        self.touched.start = self.touched.start.min(first);
        self.touched.end = self.touched.end.max(end);
    }

    /// Sends the row, and leaves all cells 0.
    #[inline(never)]
    pub(crate) fn sweep<S: CoverageSink>(&mut self, row: i32, runs: &mut Runs<'_, S>) -> Result<(), S::Error> {
        let Range { start, end } = core::mem::replace(&mut self.touched, self.columns.end..self.columns.start);
        let index = |column: i32| column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        if S::EIGHTS {
            runs.finish()?;
            return self.sweep_eights(row, start, end, runs.sink);
        }
        let Some(cells) = self.cells.get_mut(index(start)..index(end)) else { return Ok(()) };
        runs.start(row);
        let mut cells = cells.iter_mut();
        let mut column = start;
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
                    column = column.wrapping_add_unsigned(u32::try_from(zeros).unwrap_or(0));
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
                column = self.columns.end;
            }
            if coverage == 0 { runs.finish()? } else { runs.inside(gap, column)? }
        }
        runs.alike(column, self.columns.end, coverage_of(area))?;
        runs.finish()
    }
}

impl Cells<'_> {
    #[inline(always)]
    fn sweep_eights<S: CoverageSink>(&mut self, row: i32, start: i32, end: i32, sink: &mut S) -> Result<(), S::Error> {
        let index = |column: i32| column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        // Whole eights, as far as there are cells.
        let width = end.wrapping_sub(start).max(0).cast_unsigned() as usize;
        let end = (index(start) + width.next_multiple_of(8)).min(index(self.columns.end));
        let Some(cells) = self.cells.get_mut(index(start)..end) else { return Ok(()) };
        let (eights, rest) = cells.as_chunks_mut::<8>();
        let mut row_of = [[0_u8; 8]; 8];
        let mut count = 0;
        let mut column = start;
        let mut area = 0_u32;
        let mut index = 0;
        while let Some(eight) = eights.get_mut(index) {
            if is_zero(eight) {
                let zeros = eights.get(index..).unwrap_or_default().iter().take_while(|eight| is_zero(eight)).count();
                if zeros > 1 {
                    if count > 0 {
                        sink.eights(row, column - 8 * count as i32, row_of.get(..count).unwrap_or_default())?;
                        count = 0;
                    }
                    let coverage = coverage_of(area);
                    let end = column + 8 * zeros as i32;
                    if coverage > 0 {
                        sink.span(crate::span::Span { row, columns: column..end }, coverage)?;
                    }
                    column = end;
                    index += zeros;
                    continue;
                }
            }
            if let Some(Some(eight)) = eights.get_mut(index).map(Some)
                && let Some(slot) = row_of.get_mut(count)
            {
                for (coverage, change) in slot.iter_mut().zip(&mut *eight) {
                    area = area.wrapping_add(change.0.cast_unsigned());
                    *coverage = coverage_of(area);
                }
                *eight = [Cell::EMPTY; 8];
            }
            count += 1;
            index += 1;
            column += 8;
            if count == 8 {
                sink.eights(row, column - 64, &row_of)?;
                count = 0;
            }
        }
        if count > 0 {
            sink.eights(row, column - 8 * count as i32, row_of.get(..count).unwrap_or_default())?;
        }
        if !rest.is_empty() {
            let mut coverages = [0; 8];
            for (coverage, change) in coverages.iter_mut().zip(rest) {
                area = area.wrapping_add(take(&mut change.0).cast_unsigned());
                *coverage = coverage_of(area);
            }
            return sink.eights(row, column, &[coverages]);
        }
        let coverage = coverage_of(area);
        if coverage > 0 && column < self.columns.end {
            sink.span(crate::span::Span { row, columns: column..self.columns.end }, coverage)?;
        }
        Ok(())
    }
}

#[inline(always)]
fn is_zero(eight: &[Cell; 8]) -> bool {
    eight.iter().fold(0, |any, cell| any | cell.0) == 0
}

/// How many cells in front are 0.
#[inline(always)]
fn zeros(cells: &[Cell]) -> usize {
    let is_zero = |eight: &&[Cell]| eight.iter().fold(0, |any, cell| any | cell.0) == 0;
    let whole = cells.chunks_exact(8).take_while(is_zero).count() * 8;
    whole + cells.get(whole..).unwrap_or_default().iter().take_while(|cell| cell.0 == 0).count()
}
