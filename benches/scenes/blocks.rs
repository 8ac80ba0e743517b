//! The floor: the rectangles of a drawing, recorded, to be filled again by themselves.

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::Rgb565,
    primitives::Rectangle,
};

use super::{FRAME_HEIGHT, FRAME_WIDTH};

/// A target that writes no pixel but the list of rectangles that it is asked to fill.
///
/// Sending that list to a [`Frame`](super::Frame) costs what any rasterizer that sends these rectangles must at least cost.
#[derive(Debug)]
pub(crate) struct RecordBlocks<'a> {
    blocks: &'a mut [Rectangle],
    recorded: usize,
}

/// The list was too short for a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct BlocksFull;

impl<'a> RecordBlocks<'a> {
    /// Records into `blocks`, from its start.
    pub(crate) fn new(blocks: &'a mut [Rectangle]) -> Self {
        Self { blocks, recorded: 0 }
    }

    /// What was recorded, in the order of drawing.
    pub(crate) fn into_blocks(self) -> &'a [Rectangle] {
        &self.blocks[..self.recorded]
    }
}

impl OriginDimensions for RecordBlocks<'_> {
    fn size(&self) -> Size {
        Size::new(FRAME_WIDTH.unsigned_abs(), FRAME_HEIGHT.unsigned_abs())
    }
}

impl DrawTarget for RecordBlocks<'_> {
    type Color = Rgb565;
    type Error = BlocksFull;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), BlocksFull> {
        pixels
            .into_iter()
            .try_for_each(|Pixel(point, colour)| self.fill_solid(&Rectangle::new(point, Size::new_equal(1)), colour))
    }

    fn fill_solid(&mut self, area: &Rectangle, _colour: Rgb565) -> Result<(), BlocksFull> {
        *self.blocks.get_mut(self.recorded).ok_or(BlocksFull)? = *area;
        self.recorded += 1;
        Ok(())
    }
}
