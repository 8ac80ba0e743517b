//! The frame that every library draws on.

use core::convert::Infallible;

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{Rgb565, RgbColor},
    primitives::Rectangle,
};
use spanfill::PixelRows;

/// The frame's width in pixels.
pub(crate) const FRAME_WIDTH: i32 = 320;
/// The frame's height in pixels.
pub(crate) const FRAME_HEIGHT: i32 = 240;

const COLUMNS: usize = FRAME_WIDTH as usize;
const ROWS: usize = FRAME_HEIGHT as usize;

/// An RGB565 picture of 320 x 240 pixels in memory.
///
/// What a firmware's own framebuffer does: solid fills go row by row, each by `slice::fill` in pieces of eight pixels
/// (see `fill`); areas of many colours row by row, each copied to a slice; single pixels, set or read, through a bounds
/// check; rows as slices for what blends in memory.
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

    /// A row that lies on the frame, as that of an anti-aliased edge does, is one slice; anything else is clipped once,
    /// and its rows are slices.
    #[inline]
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let Rectangle { top_left: Point { x, y }, size: Size { width, height } } = *area;
        if height != 1 || !is_inside(x, width, FRAME_WIDTH) {
            return self.fill_contiguous_clipped(area, &mut colours.into_iter());
        }
        if let Some(row) = self.rows.get_mut(y as usize) {
            copy(&mut row[x as usize..][..width as usize], &mut colours.into_iter());
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

    /// `colours` are those of the whole area, on the frame or not, row by row; it may end early.
    #[inline(never)]
    fn fill_contiguous_clipped(
        &mut self,
        area: &Rectangle,
        colours: &mut impl Iterator<Item = Rgb565>,
    ) -> Result<(), Infallible> {
        let (left, width) = clip(area.top_left.x, area.size.width, FRAME_WIDTH);
        let (top, height) = clip(area.top_left.y, area.size.height, FRAME_HEIGHT);
        if width == 0 || height == 0 {
            return Ok(());
        }
        let to_the_left = left.abs_diff(area.top_left.x);
        let to_the_right = area.size.width - to_the_left - width;
        for _above in area.top_left.y..top {
            skip(colours, area.size.width);
        }
        let rows = self.rows.iter_mut().skip(top as usize).take(height as usize);
        for row in rows {
            skip(colours, to_the_left);
            copy(&mut row[left as usize..][..width as usize], colours);
            skip(colours, to_the_right);
        }
        Ok(())
    }
}

impl GetPixel for Frame {
    type Color = Rgb565;

    #[inline]
    fn pixel(&self, point: Point) -> Option<Rgb565> {
        // As in `draw_iter`.
        self.rows.get(point.y as usize)?.get(point.x as usize).copied()
    }
}

impl PixelRows for Frame {
    #[inline]
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        // As in `draw_iter`.
        self.rows.get_mut(start.y as usize)?.get_mut(start.x as usize..)
    }
}

#[inline(always)]
fn copy(row: &mut [Rgb565], colours: &mut impl Iterator<Item = Rgb565>) {
    // In this order, the colour that follows the row's is left where it is.
    for (pixel, colour) in row.iter_mut().zip(colours) {
        *pixel = colour;
    }
}

fn skip(colours: &mut impl Iterator, count: u32) {
    if let Some(last) = count.checked_sub(1) {
        colours.nth(last as usize);
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

#[cfg(test)]
mod tests {
    use embedded_graphics_core::primitives::PointsIter;

    use super::*;

    /// One more on every side than what is asked for at the frame's edges and corners, and shorter lists of colours.
    #[test]
    fn areas_of_many_colours_are_clipped_as_single_pixels_are() {
        for (x, y) in
            [(0, 0), (-2, -1), (-3, 100), (318, 238), (317, -2), (-1, 239), (5, 7), (-9, 3), (320, 3), (3, 240)]
        {
            for size in [(0, 1), (1, 0), (1, 1), (3, 1), (5, 4), (400, 2), (400, 300)].map(|(w, h)| Size::new(w, h)) {
                let area = Rectangle::new(Point::new(x, y), size);
                for missing in [0, 3] {
                    let count = (size.width * size.height).saturating_sub(missing) as usize;
                    let colours =
                        || (1..=u16::MAX).cycle().take(count).map(|bits| Rgb565::new(0, (bits % 61) as u8, bits as u8));
                    let (mut expected, mut actual) = (Box::new(Frame::new()), Box::new(Frame::new()));
                    let Ok(()) =
                        expected.draw_iter(area.points().zip(colours()).map(|(point, colour)| Pixel(point, colour)));
                    let Ok(()) = actual.fill_contiguous(&area, colours());
                    assert!(expected == actual, "{area:?}, {missing} colours missing");
                }
            }
        }
    }

    #[test]
    fn a_pixel_is_read_where_it_was_set() {
        let mut frame = Box::new(Frame::new());
        let Ok(()) = frame.draw_iter([Pixel(Point::new(319, 239), Rgb565::WHITE)]);
        assert_eq!(frame.pixel(Point::new(319, 239)), Some(Rgb565::WHITE));
        assert_eq!(frame.pixel(Point::new(0, 0)), Some(Rgb565::BLACK));
        for outside in [(-1, 0), (0, -1), (320, 0), (0, 240)] {
            assert_eq!(frame.pixel(outside.into()), None);
        }
    }
}
