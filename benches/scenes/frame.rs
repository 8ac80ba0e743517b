//! The frame that every library draws on.

use core::convert::Infallible;

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::{Rgb565, RgbColor},
    primitives::Rectangle,
};

/// The frame's width in pixels.
pub(crate) const FRAME_WIDTH: i32 = 320;
/// The frame's height in pixels.
pub(crate) const FRAME_HEIGHT: i32 = 240;

const COLUMNS: usize = FRAME_WIDTH as usize;
const ROWS: usize = FRAME_HEIGHT as usize;

/// An RGB565 picture of 320 x 240 pixels in memory.
///
/// What a firmware's own framebuffer does: solid fills go row by row, each by `slice::fill` in pieces of eight pixels
/// (see `fill`), pixels through a bounds check, everything else through the trait's defaults.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Frame {
    rows: [[Rgb565; COLUMNS]; ROWS],
}

impl Frame {
    /// A black frame, of 150 KB: keep it in a `static` or a box.
    pub(crate) const fn new() -> Self {
        Self { rows: [[Rgb565::BLACK; COLUMNS]; ROWS] }
    }

    /// The pixels, row by row.
    pub(crate) const fn rows(&self) -> &[[Rgb565; COLUMNS]; ROWS] {
        &self.rows
    }
}

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        Size::new(FRAME_WIDTH.unsigned_abs(), FRAME_HEIGHT.unsigned_abs())
    }
}

impl DrawTarget for Frame {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            // A negative coordinate becomes an index far beyond the end: one comparison checks both sides.
            if let Some(pixel) = self.rows.get_mut(point.y as usize).and_then(|row| row.get_mut(point.x as usize)) {
                *pixel = colour;
            }
        }
        Ok(())
    }

    /// What lies between the frame's left and right edges, as nearly everything does, is filled straight away, row by row
    /// down to where the frame ends.
    ///
    /// Never inlined: every library calls the same machine code.
    #[inline(never)]
    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let Rectangle { top_left: Point { x, y }, size: Size { width, height } } = *area;
        // A negative row is a huge unsigned number.
        if y as usize >= ROWS || !is_inside(x, width, FRAME_WIDTH) {
            return self.fill_solid_clipped(area, colour);
        }
        let pixels = self.rows.as_flattened_mut();
        let mut start = y as usize * COLUMNS + x as usize;
        for _ in 0..height {
            let Some(row) = pixels.get_mut(start..start + width as usize) else { break };
            fill(row, colour);
            start += COLUMNS;
        }
        Ok(())
    }
}

impl Frame {
    #[cold]
    #[inline(never)]
    fn fill_solid_clipped(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let (x, width) = clip(area.top_left.x, area.size.width, FRAME_WIDTH);
        let (y, height) = clip(area.top_left.y, area.size.height, FRAME_HEIGHT);
        self.fill_solid(&Rectangle::new(Point::new(x, y), Size::new(width, height)), colour)
    }
}

/// `slice::fill` for rows that are mostly short: one pixel by itself, else eights (below eight pixels, fours), and one
/// more that ends where the row does and may overlap the last, in place of a loop over what is left.
#[inline(always)]
fn fill(row: &mut [Rgb565], colour: Rgb565) {
    if let [pixel] = row {
        *pixel = colour;
    } else if let Some(last) = row.last_chunk_mut::<8>() {
        last.fill(colour);
        for eight in row.chunks_exact_mut(8) {
            eight.fill(colour);
        }
    } else if let Some(last) = row.last_chunk_mut::<4>() {
        last.fill(colour);
        if let Some(first) = row.first_chunk_mut::<4>() {
            first.fill(colour);
        }
    } else if let [first, .., last] = row {
        *first = colour;
        *last = colour;
        if let [_, middle, _] = row {
            *middle = colour;
        }
    }
}

/// Whether `start..start + length` lies in `0..=end`; a negative start is a huge unsigned number.
const fn is_inside(start: i32, length: u32, end: i32) -> bool {
    let (start, end) = (start as u32, end as u32);
    start <= end && length <= end - start
}

/// What of `start..start + length` lies in `0..end`: where it starts and how long it is. Nothing is `(0, 0)`.
fn clip(start: i32, length: u32, end: i32) -> (i32, u32) {
    let clipped_start = start.max(0);
    let clipped_end = start.saturating_add_unsigned(length).min(end);
    if clipped_start < clipped_end { (clipped_start, clipped_end.abs_diff(clipped_start)) } else { (0, 0) }
}
