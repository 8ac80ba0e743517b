//! A row of cells: how the area changes from each column to the next.
//!
//! Edges are added in any order and any number, each in the columns that it crosses and one more; a sweep from left to
//! right adds the cells up. The idea is that of FreeType's smooth rasterizer (R. Levien's and D. Turner's `ftgrays`, after
//! Raph Levien's libart), with one number a cell in place of two.

use core::ops::Range;

use crate::coverage::{
    CoverageSink,
    ramp::{Ramp, coverage_of},
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

    #[inline(always)]
    fn add(&mut self, column: i32, area: u32) {
        let index = column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        if let Some(cell) = self.cells.get_mut(index) {
            cell.0 = cell.0.wrapping_add(area.cast_signed());
        }
    }

    /// Adds what is to the right of an edge, or, with `sign` -1, takes it away.
    #[inline]
    pub(crate) fn add_ramp(&mut self, ramp: &Ramp, sign: i32) {
        let sign = sign.cast_unsigned();
        let first = ramp.first.max(self.columns.start);
        if first >= self.columns.end {
            return;
        }
        let end = ramp.last.min(self.columns.end - 1).max(first - 1) + 1;
        let mut before = 0;
        for column in first..end {
            let area = ramp.at(column);
            self.add(column, area.wrapping_sub(before).wrapping_mul(sign));
            before = area;
        }
        if end < self.columns.end {
            self.add(end, ramp.height.wrapping_sub(before).wrapping_mul(sign));
        }
        self.touched.start = self.touched.start.min(first);
        self.touched.end = self.touched.end.max((end + 1).min(self.columns.end));
    }

    /// Sends the row, and leaves all cells 0.
    pub(crate) fn sweep<S: CoverageSink>(&mut self, row: i32, runs: &mut Runs<'_, S>) -> Result<(), S::Error> {
        let Range { start, end } = core::mem::replace(&mut self.touched, self.columns.end..self.columns.start);
        let range = |column: i32| column.wrapping_sub(self.columns.start).cast_unsigned() as usize;
        let Some(mut cells) = self.cells.get_mut(range(start)..range(end)) else { return Ok(()) };
        runs.start(row);
        let mut column = start;
        let mut area = 0_u32;
        while let Some((cell, rest)) = cells.split_first_mut() {
            area = area.wrapping_add(core::mem::take(&mut cell.0).cast_unsigned());
            let alike = rest.iter().take_while(|cell| cell.0 == 0).count();
            cells = rest.get_mut(alike..).unwrap_or_default();
            let mut next = column.wrapping_add_unsigned(u32::try_from(alike).unwrap_or(0)) + 1;
            if cells.is_empty() {
                next = self.columns.end;
            }
            runs.alike(column, next, coverage_of(area))?;
            column = next;
        }
        runs.finish()
    }
}
