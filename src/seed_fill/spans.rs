//! Seed fill by spans on a stack of bounded size.
//!
//! After A. R. Smith, "Tint fill", SIGGRAPH 1979, and P. S. Heckbert, "A seed fill algorithm", Graphics Gems, 1990: an
//! entry is a run that has been filled, and a row next to it that has not been looked at. What is open there and
//! touches the run is filled as far as it goes to both sides, and leaves entries of its own.
//!
//! ```text
//!     row - dy    = = = a b b = = = c c c      = filled before this entry was made
//!     row         . o o o o o o o o o o .      the entry's columns lie under "a b b"
//!     row + dy    . ? ? ? ? ? ? ? ? ? ? .      the next row; and back again only where the run sticks out (c)
//! ```
//!
//! An entry that finds no room is not dropped, but done at once: [`walk`] fills whatever open pixels can be reached
//! from it. Those are part of the region, and whatever else is part of it can still be reached from the entries that
//! have room. Dropping entries and looking for them later could not be right: a filled pixel looks like one that had
//! the fill's colour before, and a region that lies next to such a one would be filled, too.

use core::ops::Range;

use embedded_graphics_core::geometry::Point;

use super::{
    region::{Connectivity, FillRegion, Open, SeedFillError},
    walk::walk,
};

/// An entry of a seed fill's stack: a row to be looked at, next to a run that has been filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FillSegment {
    row: i32,
    start: i32,
    end: i32,
    /// From the run to the row: 1 or -1.
    dy: i32,
}

impl FillSegment {
    /// What to make a stack of.
    pub const EMPTY: Self = Self { row: 0, start: 0, end: 0, dy: 1 };
}

pub(super) fn fill<R: FillRegion>(
    region: &mut R,
    seed: Point,
    connectivity: Connectivity,
    stack: &mut [FillSegment],
) -> Result<(), SeedFillError<R::Error>> {
    let mut fill = SpanFill { open: Open::new(region), connectivity, stack, length: 0 };
    if fill.open.has(seed.x, seed.y) {
        let run = fill.run(seed.x, seed.y);
        fill.open.fill(seed.y, run.clone())?;
        fill.push(seed.y, run.clone(), 1)?;
        fill.push(seed.y, run, -1)?;
    }
    while let Some(segment) = fill.pop() {
        fill.look(segment)?;
    }
    Ok(())
}

struct SpanFill<'r, 's, R> {
    open: Open<'r, R>,
    connectivity: Connectivity,
    stack: &'s mut [FillSegment],
    length: usize,
}

impl<R: FillRegion> SpanFill<'_, '_, R> {
    /// The open pixels of a row around one of them. The bounds end before the range of `i32` does.
    fn run(&self, x: i32, y: i32) -> Range<i32> {
        let (mut start, mut end) = (x, x.wrapping_add(1));
        while self.open.has(start.wrapping_sub(1), y) {
            start = start.wrapping_sub(1);
        }
        while self.open.has(end, y) {
            end = end.wrapping_add(1);
        }
        start..end
    }

    /// The columns in which a row next to a run has neighbours of the run.
    fn neighbours(&self, start: i32, end: i32) -> Range<i32> {
        match self.connectivity {
            Connectivity::Four => start..end,
            Connectivity::Eight => start.saturating_sub(1)..end.saturating_add(1),
        }
    }

    /// Has the row next to a run looked at: later if there is room on the stack, at once if there is none.
    fn push(&mut self, row: i32, columns: Range<i32>, dy: i32) -> Result<(), SeedFillError<R::Error>> {
        let row = row.wrapping_add(dy);
        if let Some(entry) = self.stack.get_mut(self.length) {
            *entry = FillSegment { row, start: columns.start, end: columns.end, dy };
            self.length += 1;
            return Ok(());
        }
        for x in self.neighbours(columns.start, columns.end) {
            if self.open.has(x, row) {
                walk(&mut self.open, x, row, self.connectivity)?;
            }
        }
        Ok(())
    }

    fn pop(&mut self) -> Option<FillSegment> {
        self.length = self.length.checked_sub(1)?;
        self.stack.get(self.length).copied()
    }

    /// Fills the runs that touch the entry's.
    fn look(&mut self, FillSegment { row, start, end, dy }: FillSegment) -> Result<(), SeedFillError<R::Error>> {
        let columns = self.neighbours(start, end);
        let mut x = columns.start;
        while x < columns.end {
            if !self.open.has(x, row) {
                x = x.wrapping_add(1);
                continue;
            }
            let run = self.run(x, row);
            self.open.fill(row, run.clone())?;
            self.push(row, run.clone(), dy)?;
            // Back to the row that the entry came from, beyond the run that is filled there.
            if run.start < start {
                self.push(row, run.start..start, dy.wrapping_neg())?;
            }
            if run.end > end {
                self.push(row, end..run.end, dy.wrapping_neg())?;
            }
            x = run.end;
        }
        Ok(())
    }
}
