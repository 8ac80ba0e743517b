//! Filled triangle: two trapezoids that share the long edge.

mod areas;

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    PixelRect, Vertex,
    edge::Edge,
    geometry::by_height,
    shape::Shape,
    span::{BlockSink, OpenBlock, Span, SpanSink, clip_range},
    subpixel::first_centre_at_or_after,
};

/// A filled triangle with vertices in 1/256 pixel, in any order.
///
/// Every coordinate is legal. A pixel belongs to the triangle when its centre does; a centre on the outline belongs
/// when the triangle lies to its right, or, on a horizontal edge, below. Triangles that share an edge cover each pixel
/// once.
///
/// [Anti-aliased](crate::AntiAlias::antialiased), a pixel is covered by the exact area of the triangle within it,
/// rounded once to 255ths.
///
/// ```text
///           a                   a
///   long -> |\ <- upper         .
///           | \                 # .
///           |  b       gives    # # b
///           | /                 # #
///           |/ <- lower         # .
///           c                   c
/// ```
///
/// # Cost
///
/// Three divisions, then an addition and a subtraction for each end of a visible row. No scratch. Rows and columns
/// outside the clip cost nothing.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Triangle, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Triangle::new(Point::new(0, 0), Point::new(5, 3), Point::new(1, 5))
///     .filled(BinaryColor::On)
///     .draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// With anti-aliasing:
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// # use spanfill::{Over, Triangle, prelude::*};
/// # let triangle = Triangle::new(Point::new(0, 0), Point::new(5, 3), Point::new(1, 5));
/// # let mut display = MockDisplay::new();
/// triangle.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Triangle {
    /// The corners.
    pub vertices: [Vertex; 3],
}

impl Triangle {
    /// A triangle from three corners.
    #[inline]
    pub fn new(a: impl Into<Vertex>, b: impl Into<Vertex>, c: impl Into<Vertex>) -> Self {
        Self::from_vertices([a.into(), b.into(), c.into()])
    }

    /// A triangle from its corners, in a constant too.
    #[inline]
    pub const fn from_vertices(vertices: [Vertex; 3]) -> Self {
        Self { vertices }
    }

    /// The leftmost and the rightmost x.
    #[inline]
    fn extent(&self) -> (i32, i32) {
        let [a, b, c] = self.vertices.map(|vertex| vertex.x.to_bits());
        (a.min(b).min(c), a.max(b).max(c))
    }
}

impl Shape for Triangle {
    #[inline]
    fn bounds(&self) -> PixelRect {
        let [a, b, c] = self.vertices.map(|vertex| vertex.y.to_bits());
        let (left, right) = self.extent();
        PixelRect {
            rows: first_centre_at_or_after(a.min(b).min(c))..first_centre_at_or_after(a.max(b).max(c)),
            columns: first_centre_at_or_after(left)..first_centre_at_or_after(right),
        }
    }

    #[inline]
    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let each_row = |row, columns: Range<i32>| {
            if columns.is_empty() { Ok(()) } else { sink.span(Span { row, columns }) }
        };
        let sorted = self.sorted();
        if self.is_narrow(&sorted, clip) { sorted.rows_narrow(each_row) } else { sorted.rows_any(clip, each_row) }
    }

    #[inline]
    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let sorted = self.sorted();
        if self.is_narrow(&sorted, clip) { sorted.walk_narrow(sink) } else { sorted.walk_any(clip, sink) }
    }
}

/// The corners from top to bottom.
#[derive(Debug, Clone, Copy)]
struct Sorted {
    top: Vertex,
    middle: Vertex,
    bottom: Vertex,
}

impl Triangle {
    #[inline(always)]
    fn sorted(&self) -> Sorted {
        let [a, b, c] = self.vertices;
        let (a, b) = by_height(a, b);
        let (b, bottom) = by_height(b, c);
        let (top, middle) = by_height(a, b);
        Sorted { top, middle, bottom }
    }

    /// All of it is inside the clip and in the narrow zone.
    #[inline(always)]
    fn is_narrow(&self, sorted: &Sorted, clip: &PixelRect) -> bool {
        let (rows, columns) = clip.narrow();
        let (left, right) = self.extent();
        left >= columns.start
            && right <= columns.end
            && sorted.top.y >= I24F8::from_bits(rows.start)
            && sorted.bottom.y <= I24F8::from_bits(rows.end)
    }
}

impl Sorted {
    /// The first rows of the upper and the lower half, and the row after the last.
    #[inline(always)]
    fn rows(&self) -> [i32; 3] {
        [self.top, self.middle, self.bottom].map(|vertex| first_centre_at_or_after(vertex.y.to_bits()))
    }

    #[inline(always)]
    fn walk_narrow<S: BlockSink>(&self, sink: &mut S) -> Result<(), S::Error> {
        if self.middle_is_right() { self.walk_halves::<S, true>(sink) } else { self.walk_halves::<S, false>(sink) }
    }

    /// Whether the middle vertex lies to the right of the long edge.
    #[inline(always)]
    fn middle_is_right(&self) -> bool {
        let dx = |to: Vertex| i64::from(to.x.to_bits().wrapping_sub(self.top.x.to_bits()));
        let dy = |to: Vertex| i64::from(to.y.to_bits().wrapping_sub(self.top.y.to_bits()));
        dx(self.middle) * dy(self.bottom) > dx(self.bottom) * dy(self.middle)
    }

    /// In one loop: what becomes of a row is there once, not for each half and side.
    #[inline(always)]
    fn rows_narrow<E>(&self, mut each_row: impl FnMut(i32, Range<i32>) -> Result<(), E>) -> Result<(), E> {
        let [first, turn, end] = self.rows();
        if first == end {
            return Ok(());
        }
        let middle_is_right = self.middle_is_right();
        let long = Edge::on_first_row(self.top, self.bottom, first);
        let (from, to) = if first < turn { (self.top, self.middle) } else { (self.middle, self.bottom) };
        let short = Edge::on_first_row(from, to, first);
        let (mut left, mut right) = if middle_is_right { (long, short) } else { (short, long) };
        let mut row = first;
        loop {
            each_row(row, left.column..right.column)?;
            row = row.wrapping_add(1);
            if row == end {
                return Ok(());
            }
            left.step();
            right.step();
            if row == turn {
                let lower = Edge::on_first_row(self.middle, self.bottom, turn);
                *(if middle_is_right { &mut right } else { &mut left }) = lower;
            }
        }
    }

    #[inline(always)]
    fn walk_halves<S: BlockSink, const MIDDLE_IS_RIGHT: bool>(&self, sink: &mut S) -> Result<(), S::Error> {
        let [first, turn, end] = self.rows();
        if first == end {
            return Ok(());
        }
        let mut long = Edge::on_first_row(self.top, self.bottom, first);
        let mut block = OpenBlock::new();
        let mut walk_half = |mut short: Edge, rows: Range<i32>| {
            for row in rows {
                let columns = if MIDDLE_IS_RIGHT { long.column..short.column } else { short.column..long.column };
                block.row(row, columns, sink)?;
                long.step();
                short.step();
            }
            Ok(())
        };
        if first < turn {
            walk_half(Edge::on_first_row(self.top, self.middle, first), first..turn)?;
        }
        if turn < end {
            walk_half(Edge::on_first_row(self.middle, self.bottom, turn), turn..end)?;
        }
        block.finish(end, sink)
    }

    #[inline(never)]
    fn walk_any<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut block = OpenBlock::new();
        self.rows_any(clip, |row, columns| block.row(row, columns, sink))?;
        let [.., end] = self.rows().map(|row| row.min(clip.rows.end).max(clip.rows.start));
        block.finish(end, sink)
    }

    /// For every coordinate and clip there is. Which edge is the left one is seen from the columns.
    #[inline]
    fn rows_any<E>(
        &self,
        clip: &PixelRect,
        mut each_row: impl FnMut(i32, Range<i32>) -> Result<(), E>,
    ) -> Result<(), E> {
        let Self { top, middle, bottom } = *self;
        let [first, turn, end] = self.rows().map(|row| row.min(clip.rows.end).max(clip.rows.start));
        if first == end {
            return Ok(());
        }
        let mut long = Edge::on_row(top, bottom, first);
        for (from, to, rows) in [(top, middle, first..turn), (middle, bottom, turn..end)] {
            if rows.is_empty() {
                continue;
            }
            let mut short = Edge::on_row(from, to, rows.start);
            for row in rows {
                let columns = long.column.min(short.column)..long.column.max(short.column);
                each_row(row, clip_range(&columns, &clip.columns))?;
                long.step_or(|| Edge::on_row(top, bottom, row.wrapping_add(1)));
                short.step_or(|| Edge::on_row(from, to, row.wrapping_add(1)));
            }
        }
        Ok(())
    }
}
