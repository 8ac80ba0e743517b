//! Filled triangle: two trapezoids that share the long edge.

use core::mem::swap;

use crate::{
    PixelRect, Vertex,
    edge::Edge,
    limits::NARROW_EXTENT,
    shape::Shape,
    span::{ClipColumns, Span, SpanSink},
    subpixel::first_centre_at_or_after,
};

/// A filled triangle with vertices in 1/256 pixel, in any order.
///
/// Every coordinate is legal. A pixel belongs to the triangle when its centre does; a centre on the outline belongs
/// when the triangle lies to its right, or, on a horizontal edge, below. Triangles that share an edge cover each pixel
/// once.
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
        let [mut top, mut middle, mut bottom] = self.vertices;
        if top.y > middle.y {
            swap(&mut top, &mut middle);
        }
        if middle.y > bottom.y {
            swap(&mut middle, &mut bottom);
        }
        if top.y > middle.y {
            swap(&mut top, &mut middle);
        }
        let rows = [top, middle, bottom].map(|vertex| {
            first_centre_at_or_after(vertex.y.to_bits()).clamp(clip.rows.start, clip.rows.end.max(clip.rows.start))
        });
        let (left, right) = self.extent();
        let inside =
            first_centre_at_or_after(left) >= clip.columns.start && first_centre_at_or_after(right) <= clip.columns.end;
        let height = bottom.y.to_bits().wrapping_sub(top.y.to_bits()).cast_unsigned();
        let narrow = height.max(right.wrapping_sub(left).cast_unsigned()) < NARROW_EXTENT;
        if inside && narrow {
            walk_narrow([top, middle, bottom], rows, sink)
        } else {
            walk_any([top, middle, bottom], rows, &mut ClipColumns { columns: clip.columns.clone(), sink })
        }
    }
}

/// Rows `rows[0]..rows[1]` between the long edge and the upper, `rows[1]..rows[2]` between the long and the lower.
#[inline(always)]
fn walk_narrow<S: SpanSink>(
    [top, middle, bottom]: [Vertex; 3],
    [first, turn, end]: [i32; 3],
    sink: &mut S,
) -> Result<(), S::Error> {
    if first >= end {
        return Ok(());
    }
    let mut long = Edge::on_row(top, bottom, first);
    let middle_is_right = is_right_of(top, bottom, middle);
    let mut row = first;
    let (mut from, mut to) = ((top, middle), turn);
    loop {
        if row < to {
            let short = Edge::on_row(from.0, from.1, row);
            let (mut left, mut right) = if middle_is_right { (long, short) } else { (short, long) };
            while row < to {
                if left.column < right.column {
                    sink.span(Span { row, columns: left.column..right.column })?;
                }
                left.step();
                right.step();
                row += 1;
            }
            long = if middle_is_right { left } else { right };
        }
        if to == end {
            return Ok(());
        }
        (from, to) = ((middle, bottom), end);
    }
}

/// Whether `point` lies to the right of the line from `top` to `bottom`; differences below 2^22.
#[inline]
fn is_right_of(top: Vertex, bottom: Vertex, point: Vertex) -> bool {
    let dx = |to: Vertex| i64::from(to.x.to_bits().wrapping_sub(top.x.to_bits()));
    let dy = |to: Vertex| i64::from(to.y.to_bits().wrapping_sub(top.y.to_bits()));
    dx(point) * dy(bottom) > dx(bottom) * dy(point)
}

/// The same for every coordinate there is: which edge is the left one is seen from the columns.
#[inline(never)]
fn walk_any<S: SpanSink>(
    [top, middle, bottom]: [Vertex; 3],
    [first, turn, end]: [i32; 3],
    sink: &mut S,
) -> Result<(), S::Error> {
    if first >= end {
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
            if !columns.is_empty() {
                sink.span(Span { row, columns })?;
            }
            long.step_or(|| Edge::on_row(top, bottom, row.wrapping_add(1)));
            short.step_or(|| Edge::on_row(from, to, row.wrapping_add(1)));
        }
    }
    Ok(())
}
