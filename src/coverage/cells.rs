//! A row of cells: how the area changes from each column to the next.
//!
//! Edges are added in any order and any number, each in the columns that it crosses and one more; a sweep from left to
//! right adds the cells up. The idea is that of Raph Levien's libart and of FreeType's smooth rasterizer (D. Turner,
//! `ftgrays`), with one number a cell in place of two, as in Raph Levien's font-rs.

use core::{mem::replace, ops::Range};

use crate::coverage::{
    CoverageSink,
    ramp::{Ramp, STEPPED},
    runs::Runs,
    sweep::{send_in_eights, send_in_runs},
};

/// Scratch for one column of an anti-aliased polygon. 4 bytes.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Cell(pub(super) i32);

impl Cell {
    /// Unused scratch.
    pub(crate) const EMPTY: Self = Self(0);
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
        let touched = replace(&mut self.touched, self.columns.end..self.columns.start);
        let index = |column: i32| column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        let (start, end) = (index(touched.start), index(touched.end));
        let columns = touched.start..self.columns.end;
        if !S::EIGHTS {
            let cells = self.cells.get_mut(start..end).unwrap_or_default();
            return if cells.is_empty() { Ok(()) } else { send_in_runs(row, columns, cells, runs) };
        }
        // Whole eights, as far as there are columns and cells.
        let end = start + end.saturating_sub(start).next_multiple_of(8);
        let end = end.min(index(self.columns.end)).min(self.cells.len());
        let cells = self.cells.get_mut(start..end).unwrap_or_default();
        if cells.is_empty() { Ok(()) } else { send_in_eights(row, columns, cells, runs.sink) }
    }
}
