//! Shapes in one colour, pixels covered or not.

use core::ops::Range;

use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{PixelRect, shape::Shape, span::BlockSink, target::Canvas};

/// Gives every [`Shape`] a colour.
pub trait Fill: Shape + Sized {
    /// The shape in one colour: an embedded-graphics [`Drawable`] for any [`DrawTarget`].
    #[inline]
    fn filled<C: PixelColor>(self, colour: C) -> Filled<Self, C> {
        Filled { shape: self, colour }
    }
}

impl<S: Shape> Fill for S {}

/// A shape in one colour.
///
/// Drawing asks the target for its bounding box once, and sends it nothing outside: one `fill_solid` for each span,
/// equal consecutive rows as one. The target's errors pass through, at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Filled<S, C> {
    shape: S,
    colour: C,
}

impl<S: Shape, C: PixelColor> Filled<S, C> {
    /// Draws on a target in memory, without a `fill_solid` for each span: the pixels of [`draw`](Drawable::draw), in less
    /// time.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray4, prelude::*};
    /// use spanfill::{Framebuffer, MsbFirst, Rows, Triangle, prelude::*};
    ///
    /// let mut frame = Framebuffer::<Gray4, Rows<MsbFirst>, _>::new([0; 32], Size::new(8, 8)).unwrap();
    /// let triangle = Triangle::new(Point::new(0, 0), Point::new(7, 0), Point::new(0, 7));
    /// triangle.filled(Gray4::WHITE).draw_on(&mut frame)?;
    /// assert_eq!(frame.units()[..8], [0xFF, 0xFF, 0xFF, 0xF0, 0xFF, 0xFF, 0xFF, 0x00]);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[inline]
    pub fn draw_on<D: Canvas<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let clip = PixelRect::from(target.bounding_box());
        if D::IS_PART {
            let rows = self.shape.bounds().rows;
            if rows.start >= clip.rows.end || rows.end <= clip.rows.start {
                return Ok(());
            }
        }
        self.fill_clipped(&clip, target)
    }

    /// What of it lies in the clip, which is the target's.
    #[inline]
    pub(super) fn fill_clipped<D: Canvas<Color = C>>(&self, clip: &PixelRect, target: &mut D) -> Result<(), D::Error> {
        self.shape.blocks(clip, &mut target.solid(self.colour))
    }
}

impl<S: Shape, C: PixelColor> Drawable for Filled<S, C> {
    type Color = C;
    type Output = ();

    #[inline]
    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let clip = PixelRect::from(target.bounding_box());
        self.shape.blocks(&clip, &mut SolidFill { target, colour: self.colour })
    }
}

impl<S: Shape, C> Dimensions for Filled<S, C> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.shape.bounds().into()
    }
}

/// Blocks to a draw target, in one colour.
struct SolidFill<'t, D: DrawTarget> {
    target: &'t mut D,
    colour: D::Color,
}

impl<D: DrawTarget> BlockSink for SolidFill<'_, D> {
    type Error = D::Error;

    #[inline]
    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), D::Error> {
        let size = Size::new(
            columns.end.wrapping_sub(columns.start).cast_unsigned(),
            rows.end.wrapping_sub(rows.start).cast_unsigned(),
        );
        self.target.fill_solid(&Rectangle::new(Point::new(columns.start, rows.start), size), self.colour)
    }
}
