//! Drawing cut to a grid in memory.

use core::{convert::Infallible, fmt, ops::Range};

use embedded_graphics_core::{
    Pixel,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    framebuffer::{
        grid::Grid,
        layout::{Layout, Values},
    },
    span::{BlockSink, clip_range},
};

/// Memory that can be drawn on, its grid, and the coordinates of its first pixel.
pub(crate) struct Surface<'u, C: PixelColor, L: Layout<C>> {
    pub(crate) units: &'u mut [L::Unit],
    pub(crate) grid: Grid,
    pub(crate) top_left: Point,
}

impl<'u, C: PixelColor, L: Layout<C>> Surface<'u, C, L> {
    /// The pixels that it has.
    #[inline(always)]
    pub(crate) fn bounds(&self) -> Rectangle {
        Rectangle::new(self.top_left, self.grid.size())
    }

    /// Where a pixel is from the first one, if it is on the surface.
    #[inline(always)]
    fn local(&self, point: Point) -> Option<(u32, u32)> {
        // What lies before the first is a huge unsigned number.
        let column = point.x.wrapping_sub(self.top_left.x).cast_unsigned();
        let row = point.y.wrapping_sub(self.top_left.y).cast_unsigned();
        (column < self.grid.width && row < self.grid.height).then_some((column, row))
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, point: Point, colour: C) {
        if let Some((column, row)) = self.local(point) {
            let (line, column, row) = self.grid.place::<C, L>(column, row);
            L::set(self.units, line, column, row, colour);
        }
    }

    #[inline(always)]
    pub(crate) fn draw_iter(&mut self, pixels: impl IntoIterator<Item = Pixel<C>>) {
        for Pixel(point, colour) in pixels {
            self.set(point, colour);
        }
    }

    /// What of an area is on the surface, from its first pixel on.
    #[inline(always)]
    pub(super) fn clip(&self, area: &Rectangle) -> (Range<u32>, Range<u32>) {
        let (area, bounds) = (PixelRect::from(*area), PixelRect::from(self.bounds()));
        let local = |range: &Range<i32>, bounds: &Range<i32>| {
            let Range { start, end } = clip_range(range, bounds);
            if start < end { start.abs_diff(bounds.start)..end.abs_diff(bounds.start) } else { 0..0 }
        };
        (local(&area.rows, &bounds.rows), local(&area.columns, &bounds.columns))
    }

    /// What lies on the surface, as nearly everything does, costs four comparisons.
    #[inline(always)]
    pub(crate) fn fill_solid(&mut self, area: &Rectangle, colour: C) {
        let Size { width, height } = area.size;
        match self.local(area.top_left) {
            Some((column, row)) if width <= self.grid.width - column && height <= self.grid.height - row => {
                if width > 0 {
                    self.fill_block(row..row + height, column..column + width, L::ink(colour));
                }
            }
            _ => self.fill_solid_clipped(area, colour),
        }
    }

    #[cold]
    #[inline(never)]
    fn fill_solid_clipped(&mut self, area: &Rectangle, colour: C) {
        let (rows, columns) = self.clip(area);
        if !rows.is_empty() && !columns.is_empty() {
            self.fill_block(rows, columns, L::ink(colour));
        }
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self, colour: C) {
        self.fill_block(0..self.grid.height, 0..self.grid.width, L::ink(colour));
    }

    /// The same where nobody else has pixels in the rest of a line's last byte: it gets the colour, too.
    #[inline(always)]
    pub(crate) fn clear_whole(&mut self, colour: C) {
        let beside = if L::STEP < 8 { 8 / L::STEP } else { 1 };
        let width = self.grid.width.next_multiple_of(beside);
        let grid = Grid { width, ..self.grid };
        Surface::<C, L> { units: &mut *self.units, grid, top_left: self.top_left }.clear(colour);
    }

    /// Fills what lies on the surface.
    #[inline(always)]
    fn fill_block(&mut self, rows: Range<u32>, columns: Range<u32>, ink: L::Ink) {
        if L::LINE_ROWS > 1 {
            return self.fill_pages(rows, columns, ink);
        }
        let Grid { stride, width, skip, .. } = self.grid;
        let mut start = rows.start as usize * stride;
        // Rows that follow each other in memory without a gap are as good as one.
        if columns == (0..width) && u64::from(width) * u64::from(L::STEP) == stride as u64 * 8 {
            let length = (rows.end - rows.start) as usize * width as usize;
            return L::fill(self.units, start, 0..length, 0..1, ink);
        }
        let columns = (columns.start + skip) as usize..(columns.end + skip) as usize;
        for _ in rows {
            L::fill(self.units, start, columns.clone(), 0..1, ink);
            start += stride;
        }
    }

    /// As good as one are full pages, too, that follow each other without a gap.
    #[inline(always)]
    fn fill_pages(&mut self, rows: Range<u32>, columns: Range<u32>, ink: L::Ink) {
        let Grid { stride, width, skip, .. } = self.grid;
        let (mut start, end) = (rows.start + skip, rows.end + skip);
        let full = (end / L::LINE_ROWS).saturating_sub(start / L::LINE_ROWS);
        if start.is_multiple_of(L::LINE_ROWS) && full > 0 && columns == (0..width) && width as usize == stride {
            let line = (start / L::LINE_ROWS) as usize * stride;
            L::fill(self.units, line, 0..full as usize * stride, 0..L::LINE_ROWS, ink);
            start += full * L::LINE_ROWS;
        }
        fill_pages::<C, L>(self.units, stride, start..end, &(columns.start as usize..columns.end as usize), ink);
    }

    /// `colours` are those of the whole area, on the surface or not, row by row; it may end early.
    #[inline(always)]
    pub(crate) fn fill_contiguous(&mut self, area: &Rectangle, colours: impl IntoIterator<Item = C>) {
        let mut colours = colours.into_iter();
        let (rows, columns) = self.clip(area);
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let first = Point::new(
            self.top_left.x.wrapping_add_unsigned(columns.start),
            self.top_left.y.wrapping_add_unsigned(rows.start),
        );
        let above = first.y.abs_diff(area.top_left.y);
        let to_the_left = first.x.abs_diff(area.top_left.x);
        let to_the_right = area.size.width - to_the_left - (columns.end - columns.start);
        for _ in 0..above {
            skip(&mut colours, area.size.width);
        }
        for row in rows {
            skip(&mut colours, to_the_left);
            let (line, start, row) = self.grid.place::<C, L>(columns.start, row);
            for column in start..start + (columns.end - columns.start) as usize {
                let Some(colour) = colours.next() else { return };
                L::set(self.units, line, column, row, colour);
            }
            skip(&mut colours, to_the_right);
        }
    }

    /// Replaces each of so many pixels, from `start` to the right, by what `change` makes of it; those on the surface, if the
    /// first is.
    #[inline(always)]
    pub(crate) fn change(self, start: Point, width: usize, change: impl FnMut(C) -> C) {
        if let Some((column, row)) = self.local(start) {
            let width = width.min((self.grid.width - column) as usize);
            let (line, column, row) = self.grid.place::<C, L>(column, row);
            L::change(self.units, line, column..column + width, row, change);
        }
    }

    /// Fills so many pixels from `start` to the right; those on the surface, if the first is.
    #[inline(always)]
    pub(crate) fn fill_right(&mut self, start: Point, width: u32, colour: C) {
        if let Some((column, row)) = self.local(start) {
            let width = width.min(self.grid.width - column);
            let (line, column, row) = self.grid.place::<C, L>(column, row);
            L::fill(self.units, line, column..column + width as usize, row..row + 1, L::ink(colour));
        }
    }

    /// What fills the blocks of a shape.
    #[inline(always)]
    pub(crate) fn solid(self, colour: C) -> SolidBlocks<'u, C, L> {
        let Self { units, grid: Grid { stride, skip, .. }, top_left: Point { x, y } } = self;
        let (above, before) = if L::LINE_ROWS > 1 { (skip, 0) } else { (0, skip) };
        SolidBlocks {
            units,
            stride,
            rows_before: above.wrapping_sub(y.cast_unsigned()),
            columns_before: before.wrapping_sub(x.cast_unsigned()),
            ink: L::ink(colour),
        }
    }
}

impl<'u, C: PixelColor> Surface<'u, C, Values>
where
    Values: Layout<C, Unit = C>,
{
    /// The pixels from one on to the right end of its row.
    #[inline(always)]
    pub(crate) fn row_from(self, start: Point) -> Option<&'u mut [C]> {
        let (column, row) = self.local(start)?;
        let line = row as usize * self.grid.stride;
        self.units.get_mut(line + column as usize..line + self.grid.width as usize)
    }
}

fn skip(colours: &mut impl Iterator, count: u32) {
    if let Some(last) = count.checked_sub(1) {
        colours.nth(last as usize);
    }
}

/// Blocks to memory, in one colour.
///
/// Little enough for registers. Shapes send what lies in the clip, so nothing is compared but with the memory's end; numbers
/// wrap where somebody else sends what does not.
pub(crate) struct SolidBlocks<'u, C: PixelColor, L: Layout<C>> {
    units: &'u mut [L::Unit],
    stride: usize,
    /// To be added to a row, and to a column.
    rows_before: u32,
    columns_before: u32,
    ink: L::Ink,
}

impl<C: PixelColor, L: Layout<C>> BlockSink for SolidBlocks<'_, C, L> {
    type Error = Infallible;

    #[inline(always)]
    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), Infallible> {
        let Self { ref mut units, stride, rows_before, columns_before, ink } = *self;
        let row = |row: i32| row.cast_unsigned().wrapping_add(rows_before);
        let column = |column: i32| column.cast_unsigned().wrapping_add(columns_before) as usize;
        let columns = column(columns.start)..column(columns.end);
        if L::LINE_ROWS > 1 {
            fill_pages::<C, L>(units, stride, row(rows.start)..row(rows.end), &columns, ink);
            return Ok(());
        }
        let mut line = (row(rows.start) as usize).wrapping_mul(stride);
        for _ in rows {
            L::fill(units, line, columns.clone(), 0..1, ink);
            line = line.wrapping_add(stride);
        }
        Ok(())
    }
}

/// Fills line by line where several rows share one: the first and the last may be filled in part.
#[inline(always)]
fn fill_pages<C: PixelColor, L: Layout<C>>(
    units: &mut [L::Unit],
    stride: usize,
    rows: Range<u32>,
    columns: &Range<usize>,
    ink: L::Ink,
) {
    let mut row = rows.start;
    while row < rows.end {
        let (page, first) = (row / L::LINE_ROWS, row % L::LINE_ROWS);
        let count = (rows.end - row).min(L::LINE_ROWS - first);
        L::fill(units, (page as usize).wrapping_mul(stride), columns.clone(), first..first + count, ink);
        row += count;
    }
}

impl<C: PixelColor, L: Layout<C>> fmt::Debug for Surface<'_, C, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Surface").field("grid", &self.grid).field("top_left", &self.top_left).finish_non_exhaustive()
    }
}
