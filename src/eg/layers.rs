//! Stroke and fill of one primitive blended together: each pixel is drawn once, in the mixture of both.
//!
//! Coverage comes shape by shape, and a pixel on the inner edge of a stroke needs that of two shapes. Both are collected
//! for a small tile at a time, 512 bytes on the stack, and the tile is drawn.
//!
//! ```text
//!     outer   0  96 255 255 255        stroke over the background where inner is 0,
//!     inner   0   0  40 210 255        then fill mixed into it: inner / outer of it
//! ```

use core::{convert::Infallible, iter::once};

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{AntiAlias, Blend, Cover, CoverageSink, Mix, PixelRect, Span};

use super::{Blended, paint::Paint, pixel_box::to_i32};

/// The size of a tile.
const ROWS: i32 = 8;
pub(super) const COLUMNS: i32 = 32;
const PIXELS: usize = 8 * 32;
const _: () = assert!(ROWS * COLUMNS == 8 * 32);

/// The coverage of the pixels of a tile by one or more areas that do not overlap, in 255ths.
#[derive(Debug)]
pub(super) struct Tile {
    left: i32,
    top: i32,
    coverage: [u8; PIXELS],
}

impl Tile {
    fn new(left: i32, top: i32) -> Self {
        Self { left, top, coverage: [0; PIXELS] }
    }

    /// Adds what `area` covers. The sum is exact where areas meet, and at most 255 where they overlap.
    pub(super) fn add(&mut self, area: &impl Cover, clip: &PixelRect) {
        match area.coverage(clip, self) {
            Ok(()) => {}
            Err(never) => match never {},
        }
    }

    fn index(&self, row: i32, column: i32) -> usize {
        let (row, column) = (row.wrapping_sub(self.top), column.wrapping_sub(self.left));
        usize::try_from(row * COLUMNS + column).unwrap_or(PIXELS)
    }

    fn at(&self, row: i32, column: i32) -> u8 {
        self.coverage.get(self.index(row, column)).copied().unwrap_or_default()
    }
}

impl CoverageSink for Tile {
    type Error = Infallible;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
        let first = self.index(span.row, span.columns.start);
        let pixels = self.coverage.iter_mut().skip(first).zip(span.columns);
        pixels.for_each(|(sum, _)| *sum = sum.saturating_add(coverage));
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        let first = self.index(row, column);
        let pixels = self.coverage.iter_mut().skip(first).zip(coverage);
        pixels.for_each(|(sum, coverage)| *sum = sum.saturating_add(*coverage));
        Ok(())
    }
}

/// Draws an area of one colour.
pub(super) fn draw_area<D: DrawTarget, B: Blend<D> + Copy>(
    area: impl Cover,
    colour: D::Color,
    blended: &Blended<B>,
    target: &mut D,
) -> Result<(), D::Error> {
    area.antialiased(colour, blended.blend).opacity(blended.opacity).draw_on(target)
}

/// Draws the stroke of what `outer` adds to a tile, and inside it the fill of what `inner` adds; all of it lies in
/// `bounds`. A fill without a stroke is what `inner` adds alone.
pub(super) fn draw_layers<D: DrawTarget, B: Blend<D>>(
    paint: &Paint<D::Color>,
    blended: &Blended<B>,
    target: &mut D,
    bounds: &PixelRect,
    outer: impl Fn(&PixelRect, &mut Tile),
    inner: impl Fn(&PixelRect, &mut Tile),
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    if paint.is_transparent(blended) {
        return Ok(());
    }
    let clip = PixelRect::from(target.bounding_box());
    let columns = bounds.columns.start.max(clip.columns.start)..bounds.columns.end.min(clip.columns.end);
    let rows = bounds.rows.start.max(clip.rows.start)..bounds.rows.end.min(clip.rows.end);
    let mut top = rows.start;
    while top < rows.end {
        let bottom = top.saturating_add(ROWS).min(rows.end);
        let mut left = columns.start;
        while left < columns.end {
            let right = left.saturating_add(COLUMNS).min(columns.end);
            let clip = PixelRect { rows: top..bottom, columns: left..right };
            let (mut outside, mut inside) = (Tile::new(left, top), Tile::new(left, top));
            outer(&clip, &mut outside);
            inner(&clip, &mut inside);
            draw_tile(paint, blended, target, &clip, &outside, &inside)?;
            left = right;
        }
        top = bottom;
    }
    Ok(())
}

fn draw_tile<D: DrawTarget, B: Blend<D>>(
    paint: &Paint<D::Color>,
    blended: &Blended<B>,
    target: &mut D,
    clip: &PixelRect,
    outer: &Tile,
    inner: &Tile,
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    for row in clip.rows.clone() {
        let mut column = clip.columns.start;
        while column < clip.columns.end {
            let covered = (outer.at(row, column), inner.at(row, column));
            let start = column;
            while column < clip.columns.end && (outer.at(row, column), inner.at(row, column)) == covered {
                column += 1;
            }
            let Some((colour, coverage)) = mixture(paint, covered) else { continue };
            let alpha = divide_by_255(u32::from(coverage) * u32::from(blended.opacity));
            if alpha == 0 {
                continue;
            }
            if let Some(colour) = blended.blend.everywhere(colour, alpha) {
                let size = Size::new(column.abs_diff(start), 1);
                target.fill_solid(&Rectangle::new(Point::new(start, row), size), colour)?;
                continue;
            }
            for column in start..column {
                let point = Point::new(column, row);
                if let Some(colour) = blended.blend.at(target, point, colour, alpha) {
                    target.draw_iter(once(Pixel(point, colour)))?;
                }
            }
        }
    }
    Ok(())
}

/// The colour of what covers a pixel, and how much of it.
fn mixture<C: Mix>(paint: &Paint<C>, (outer, inner): (u8, u8)) -> Option<(C, u8)> {
    match (paint.stroke, paint.fill) {
        (Some(stroke), Some(fill)) => {
            let inner = inner.min(outer);
            let colour = match inner {
                0 => stroke,
                _ if inner == outer => fill,
                _ => fill.over(stroke, share(inner, outer)),
            };
            Some((colour, outer))
        }
        (Some(stroke), None) => Some((stroke, outer.saturating_sub(inner))),
        (None, Some(fill)) => Some((fill, inner)),
        (None, None) => None,
    }
}

/// `part / whole` in 255ths, to the nearest; `part` is less than `whole`.
fn share(part: u8, whole: u8) -> u8 {
    let (part, whole) = (u32::from(part), u32::from(whole));
    u8::try_from((2 * 255 * part + whole) / (2 * whole).max(1)).unwrap_or(u8::MAX)
}

/// To the nearest; the product is at most 255 x 255.
fn divide_by_255(product: u32) -> u8 {
    let product = product + 128;
    u8::try_from((product + (product >> 8)) >> 8).unwrap_or(u8::MAX)
}

/// A rectangle around areas.
pub(super) fn union(a: &PixelRect, b: &PixelRect) -> PixelRect {
    let axis = |a: &core::ops::Range<i32>, b: &core::ops::Range<i32>| a.start.min(b.start)..a.end.max(b.end);
    PixelRect { rows: axis(&a.rows, &b.rows), columns: axis(&a.columns, &b.columns) }
}

/// Grown by whole pixels on every side.
pub(super) fn grown(rect: &PixelRect, pixels: i64) -> PixelRect {
    let axis = |range: &core::ops::Range<i32>| {
        to_i32(i64::from(range.start) - pixels)..to_i32(i64::from(range.end) + pixels)
    };
    PixelRect { rows: axis(&rect.rows), columns: axis(&rect.columns) }
}
