//! Stroke and fill of one primitive blended together: each pixel is drawn once, in the mixture of both.
//!
//! Coverage comes shape by shape, and a pixel on the inner edge of a stroke needs that of two shapes. Both are
//! collected for a small tile at a time, twice 256 bytes on the stack, and the tile is drawn.
//!
//! ```text
//!     outer   0  96 255 255 255        stroke over the background where inner is 0,
//!     inner   0   0  40 210 255        then fill mixed into it: inner / outer of it
//! ```

use core::{convert::Infallible, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};
use heapless::Vec;

use crate::{Blend, CoverageSink, Mix, PixelRect, Span, draw::AntiAlias, shape::Cover};

use super::{Blended, paint::Paint, pixel_box::to_i32};

/// The size of a tile.
const ROWS: i32 = 4;
pub(super) const COLUMNS: i32 = 64;
const WIDTH: usize = COLUMNS.cast_unsigned() as usize;
const PIXELS: usize = 4 * WIDTH;
const _: () = assert!(ROWS == 4);

/// The coverage of the pixels of a tile by one or more areas that do not overlap, in 255ths.
#[derive(Debug)]
pub(super) struct Tile {
    left: i32,
    top: i32,
    is_empty: bool,
    coverage: [u8; PIXELS],
}

impl Tile {
    fn new(left: i32, top: i32) -> Self {
        Self { left, top, is_empty: true, coverage: [0; PIXELS] }
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

    /// A run of a row; `ExactSizeIterator` wants it in one place.
    fn alphas(columns: Range<i32>, alpha: impl Fn(i32) -> u8) -> Vec<u8, WIDTH> {
        let mut alphas = Vec::new();
        // A tile is no wider than the room there is.
        columns.for_each(|column| alphas.push(alpha(column)).unwrap_or_default());
        alphas
    }

    fn at(&self, row: i32, column: i32) -> u8 {
        self.coverage.get(self.index(row, column)).copied().unwrap_or_default()
    }
}

impl CoverageSink for Tile {
    type Error = Infallible;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
        self.is_empty = false;
        let first = self.index(span.row, span.columns.start);
        let pixels = self.coverage.iter_mut().skip(first).zip(span.columns);
        pixels.for_each(|(sum, _)| *sum = sum.saturating_add(coverage));
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        self.is_empty = false;
        let first = self.index(row, column);
        let pixels = self.coverage.iter_mut().skip(first).zip(coverage);
        pixels.for_each(|(sum, coverage)| *sum = sum.saturating_add(*coverage));
        Ok(())
    }
}

/// Draws an area of one colour.
pub(super) fn draw_area<D: DrawTarget, B: Blend<D>>(
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
            if !(outside.is_empty && inside.is_empty) {
                draw_tile(paint, blended, target, &clip, &outside, &inside)?;
            }
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
        let pixel = |column: i32| {
            let (colour, coverage) = mixture(paint, (outer.at(row, column), inner.at(row, column)))?;
            let alpha = divide_by_255(u32::from(coverage) * u32::from(blended.opacity));
            (alpha > 0).then_some((colour, alpha))
        };
        let mut column = clip.columns.start;
        while column < clip.columns.end {
            let start = column;
            let Some((colour, alpha)) = pixel(start) else {
                column += 1;
                continue;
            };
            // As far as the pixels are alike; if that is just one, as far as they have the same colour.
            while column < clip.columns.end && pixel(column) == Some((colour, alpha)) {
                column += 1;
            }
            let (place, width) = (Point::new(start, row), column.abs_diff(start));
            if alpha == 255 {
                target.fill_solid(&Rectangle::new(place, Size::new(width, 1)), colour)?;
            } else if width > 1 {
                blended.blend.span(target, place, width, colour, alpha)?;
            } else {
                let continues = |column| pixel(column).is_some_and(|(other, alpha)| other == colour && alpha < 255);
                while column < clip.columns.end && continues(column) {
                    column += 1;
                }
                let alphas = Tile::alphas(start..column, |column| pixel(column).map_or(0, |(_, alpha)| alpha));
                blended.blend.run(target, place, colour, &alphas)?;
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
    let axis = |a: &Range<i32>, b: &Range<i32>| a.start.min(b.start)..a.end.max(b.end);
    PixelRect { rows: axis(&a.rows, &b.rows), columns: axis(&a.columns, &b.columns) }
}

/// Grown by whole pixels on every side.
pub(super) fn grown(rect: &PixelRect, pixels: i64) -> PixelRect {
    let axis = |range: &Range<i32>| to_i32(i64::from(range.start) - pixels)..to_i32(i64::from(range.end) + pixels);
    PixelRect { rows: axis(&rect.rows), columns: axis(&rect.columns) }
}
