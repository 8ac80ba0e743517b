//! Stroke and fill of one primitive blended together: each pixel is drawn once, in the mixture of both.
//!
//! Coverage comes shape by shape, and a pixel on the inner edge of a stroke needs that of two shapes. Both are
//! collected for a small tile at a time, twice 256 bytes on the stack, and the tile is drawn.
//!
//! ```text
//!     outer   0  96 255 255 255        stroke over the background where inner is 0,
//!     inner   0   0  40 210 255        then fill mixed into it: inner / outer of it
//! ```

use core::convert::Infallible;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    Blend, CoverageSink, Mix, PixelRect, Span,
    draw::{AntiAlias, faded},
    shape::Cover,
    span::visible,
};

use super::{Blended, boxes::Boxes, paint::Paint, pixel_box::PixelBox};

/// The size of a tile.
const ROWS: i32 = 4;
const COLUMNS: i32 = 64;
const WIDTH: usize = COLUMNS.cast_unsigned() as usize;
const PIXELS: usize = 4 * WIDTH;
const _: () = assert!(ROWS == 4);

/// Where the areas of a primitive go.
pub(super) trait Layers {
    type Error;

    /// Whether there is more than a fill.
    fn has_stroke(&self) -> bool;

    /// Whether pixels that are covered wholly need no blending.
    fn is_opaque(&self) -> bool;

    /// Draws an area in the colour of the stroke.
    fn stroke(&mut self, area: &impl Cover) -> Result<(), Self::Error>;

    /// Draws the stroke of what is in `outer`, and inside it the fill of what is in `inner`; or the fill alone.
    fn draw(&mut self, outer: &impl Cover, inner: &impl Cover) -> Result<(), Self::Error>;

    /// What `pixels` hold of a stroke and a fill, mixed.
    fn draw_tiles(&mut self, pixels: &PixelRect, outer: &impl Cover, inner: &impl Cover) -> Result<(), Self::Error>;

    /// What of a rectangle with a stroke lies in `pixels`, where none is covered in part.
    fn draw_whole(&mut self, boxes: &Boxes, pixels: &PixelBox) -> Result<(), Self::Error>;
}

/// Draws areas on a target.
pub(super) struct Blending<'a, D: DrawTarget, B> {
    pub(super) paint: &'a Paint<D::Color>,
    pub(super) blended: &'a Blended<B>,
    pub(super) target: &'a mut D,
}

impl<D: DrawTarget, B: Blend<D>> Layers for Blending<'_, D, B>
where
    D::Color: Mix,
{
    type Error = D::Error;

    fn has_stroke(&self) -> bool {
        self.paint.stroke.is_some()
    }

    fn is_opaque(&self) -> bool {
        self.blended.opacity == 255
    }

    fn stroke(&mut self, area: &impl Cover) -> Result<(), D::Error> {
        self.draw_area(self.paint.stroke, area)
    }

    #[inline(never)]
    fn draw(&mut self, outer: &impl Cover, inner: &impl Cover) -> Result<(), D::Error> {
        if self.has_stroke() {
            self.draw_tiles(&outer.touched(), outer, inner)
        } else {
            self.draw_area(self.paint.fill, inner)
        }
    }

    #[inline(never)]
    fn draw_tiles(&mut self, pixels: &PixelRect, outer: &impl Cover, inner: &impl Cover) -> Result<(), D::Error> {
        let Some((rows, columns)) = visible(pixels, &self.target.bounding_box().into()) else { return Ok(()) };
        for top in rows.clone().step_by(PIXELS / WIDTH) {
            for left in columns.clone().step_by(WIDTH) {
                let clip = PixelRect {
                    rows: top..top.saturating_add(ROWS).min(rows.end),
                    columns: left..left.saturating_add(COLUMNS).min(columns.end),
                };
                let [mut outside, mut inside] = [const { Tile::EMPTY }; 2];
                outside.collect(outer, &clip);
                inside.collect(inner, &clip);
                if !(outside.is_empty && inside.is_empty) {
                    self.draw_tile(&clip, &outside, &inside)?;
                }
            }
        }
        Ok(())
    }

    fn draw_whole(&mut self, boxes: &Boxes, pixels: &PixelBox) -> Result<(), D::Error> {
        boxes.draw(pixels, self.paint, self.target)
    }
}

impl<D: DrawTarget, B: Blend<D>> Blending<'_, D, B>
where
    D::Color: Mix,
{
    #[inline(never)]
    fn draw_area(&mut self, colour: Option<D::Color>, area: &impl Cover) -> Result<(), D::Error> {
        let Some(colour) = colour else { return Ok(()) };
        area.antialiased(colour, self.blended.blend).opacity(self.blended.opacity).draw_on(self.target)
    }

    fn draw_tile(&mut self, clip: &PixelRect, outer: &Tile, inner: &Tile) -> Result<(), D::Error> {
        let Self { paint, blended, target } = self;
        let Blended { blend, opacity } = **blended;
        for row in clip.rows.clone() {
            let pixel = |column: i32| {
                let (colour, coverage) = mixture(paint, outer.at(row, column), inner.at(row, column))?;
                let alpha = faded(coverage, opacity);
                (alpha > 0).then_some((colour, alpha))
            };
            let mut column = clip.columns.start;
            while column < clip.columns.end {
                let start = column;
                column += 1;
                let Some((colour, alpha)) = pixel(start) else { continue };
                // As far as the pixels are alike; if that is just one, as far as they have the same colour.
                while column < clip.columns.end && pixel(column) == Some((colour, alpha)) {
                    column += 1;
                }
                let (place, width) = (Point::new(start, row), column.abs_diff(start));
                if alpha == 255 {
                    target.fill_solid(&Rectangle::new(place, Size::new(width, 1)), colour)?;
                } else if width > 1 {
                    blend.span(target, place, width, colour, alpha)?;
                } else {
                    let goes_on = |column| pixel(column).is_some_and(|(other, alpha)| other == colour && alpha < 255);
                    while column < clip.columns.end && goes_on(column) {
                        column += 1;
                    }
                    // A tile is no wider than the room there is.
                    let mut alphas = [0; WIDTH];
                    let pixels = (start..column).filter_map(pixel);
                    alphas.iter_mut().zip(pixels).for_each(|(room, (_, alpha))| *room = alpha);
                    let count = column.abs_diff(start) as usize;
                    blend.run(target, place, colour, alphas.get(..count).unwrap_or_default())?;
                }
            }
        }
        Ok(())
    }
}

/// How much of the pixels of a tile is covered, in 255ths.
struct Tile {
    left: i32,
    top: i32,
    is_empty: bool,
    coverage: [u8; PIXELS],
}

impl Tile {
    const EMPTY: Self = Self { left: 0, top: 0, is_empty: true, coverage: [0; PIXELS] };

    /// Tiles are filled where they are: to return one would take its space twice.
    #[inline(never)]
    fn collect(&mut self, area: &impl Cover, clip: &PixelRect) {
        (self.left, self.top) = (clip.columns.start, clip.rows.start);
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

    /// At most 255 where areas overlap.
    fn add(&mut self, row: i32, column: i32, coverage: impl Iterator<Item = u8>) {
        self.is_empty = false;
        let first = self.index(row, column);
        let pixels = self.coverage.iter_mut().skip(first);
        pixels.zip(coverage).for_each(|(sum, coverage)| *sum = sum.saturating_add(coverage));
    }
}

impl CoverageSink for Tile {
    type Error = Infallible;

    fn span(&mut self, Span { row, columns }: Span, coverage: u8) -> Result<(), Infallible> {
        self.add(row, columns.start, columns.map(|_| coverage));
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        self.add(row, column, coverage.iter().copied());
        Ok(())
    }
}

/// The colour of what covers a pixel, and how much of it.
fn mixture<C: Mix>(paint: &Paint<C>, outer: u8, inner: u8) -> Option<(C, u8)> {
    let Some(stroke) = paint.stroke else { return Some((paint.fill?, inner)) };
    let Some(fill) = paint.fill else { return Some((stroke, outer.saturating_sub(inner))) };
    let inner = inner.min(outer);
    let colour = match inner {
        0 => stroke,
        _ if inner == outer => fill,
        _ => fill.over(stroke, share(inner, outer)),
    };
    Some((colour, outer))
}

/// `part / whole` in 255ths, to the nearest; `part` is less than `whole`.
fn share(part: u8, whole: u8) -> u8 {
    let (part, whole) = (u32::from(part), u32::from(whole));
    u8::try_from((2 * 255 * part + whole) / (2 * whole).max(1)).unwrap_or(u8::MAX)
}
