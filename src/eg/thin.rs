//! Lines one pixel thin, in embedded-graphics' pixels.
//!
//! They are the pixels of [`Line`] but where the true line passes exactly between two of them. `Line` takes the greater
//! one; embedded-graphics stays where it is for as long as it can, which is the lesser one where the line runs to
//! greater rows (or columns). Such a line is mirrored to have it run to lesser ones, and its pixels are mirrored back.

use core::ops::Range;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{BlockSink, Line, PixelRect, Vertex, shape::Shape};

/// Draws the lines from pixel to pixel, each without the one that it starts in but for the first.
pub(super) fn draw_chain<D: DrawTarget>(
    points: impl Iterator<Item = Point>,
    colour: D::Color,
    target: &mut D,
) -> Result<(), D::Error> {
    let mut points = points;
    let Some(mut start) = points.next() else { return Ok(()) };
    let mut drawn = None;
    points.try_for_each(|end| {
        draw_without(drawn, start, end, colour, target)?;
        start = end;
        drawn = Some(end);
        Ok(())
    })
}

fn draw_without<D: DrawTarget>(
    drawn: Option<Point>,
    start: Point,
    end: Point,
    colour: D::Color,
    target: &mut D,
) -> Result<(), D::Error> {
    let is_steep = end.y.abs_diff(start.y) >= end.x.abs_diff(start.x);
    let mirrors = if is_steep {
        Mirrors { rows: false, columns: end.x > start.x }
    } else {
        Mirrors { rows: end.y > start.y, columns: false }
    };
    let clip = mirrors.rect(PixelRect::from(target.bounding_box()));
    let line = Line::new(mirrors.vertex(start), mirrors.vertex(end));
    line.blocks(&clip, &mut Mirrored { target, colour, mirrors, drawn })
}

/// Which axes are mirrored.
#[derive(Debug, Clone, Copy)]
struct Mirrors {
    rows: bool,
    columns: bool,
}

impl Mirrors {
    fn range(is_mirrored: bool, range: Range<i32>) -> Range<i32> {
        if is_mirrored { range.end.saturating_neg()..range.start.saturating_neg() } else { range }
    }

    fn rect(self, PixelRect { rows, columns }: PixelRect) -> PixelRect {
        PixelRect { rows: Self::range(self.rows, rows), columns: Self::range(self.columns, columns) }
    }

    fn vertex(self, point: Point) -> Vertex {
        // The pixel mirrored at the edge of pixel 0.
        let axis = |is_mirrored: bool, pixel: i32| if is_mirrored { !pixel } else { pixel };
        Vertex::pixel(axis(self.columns, point.x), axis(self.rows, point.y))
    }
}

/// Mirrors blocks back and draws them.
struct Mirrored<'t, D: DrawTarget> {
    target: &'t mut D,
    colour: D::Color,
    mirrors: Mirrors,
    /// At the end of a block, if it is in one.
    drawn: Option<Point>,
}

impl<D: DrawTarget> BlockSink for Mirrored<'_, D> {
    type Error = D::Error;

    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), D::Error> {
        let PixelRect { mut rows, mut columns } = self.mirrors.rect(PixelRect { rows, columns });
        match self.drawn {
            Some(Point { x, y }) if rows.contains(&y) && columns.contains(&x) => {
                let axis = if columns.len() > 1 { (&mut columns, x) } else { (&mut rows, y) };
                match axis {
                    (range, pixel) if range.start == pixel => range.start += 1,
                    (range, _) => range.end -= 1,
                }
                if rows.is_empty() {
                    return Ok(());
                }
            }
            _ => {}
        }
        let size = Size::new(columns.end.abs_diff(columns.start), rows.end.abs_diff(rows.start));
        self.target.fill_solid(&Rectangle::new(Point::new(columns.start, rows.start), size), self.colour)
    }
}
