//! Framebuffers as images.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point},
    image::ImageDrawable,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    framebuffer::{Framebuffer, Layout},
    span::visible,
};

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]>> Framebuffer<C, L, S> {
    /// Shows it on another target, its top-left pixel at `top_left`: one `fill_contiguous`, so one address window.
    ///
    /// # Errors
    ///
    /// The target's.
    ///
    /// # Examples
    ///
    /// A simulator's window or a display behind a bus cannot be read: shapes that are to be blended over what is there are
    /// drawn here, and shown there.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
    /// use spanfill::{Circle, Framebuffer, InPlace, MsbFirst, Rows, prelude::*};
    ///
    /// let mut frame = Framebuffer::<Gray8, Rows<MsbFirst>, _>::new([0; 400], Size::new(20, 20)).unwrap();
    /// Circle::new(Point::new(8, 8), 6.5).antialiased(Gray8::WHITE, InPlace).draw_on(&mut frame)?;
    /// Circle::new(Point::new(12, 8), 6.5).antialiased(Gray8::new(99), InPlace).opacity(99).draw_on(&mut frame)?;
    ///
    /// let mut display = MockDisplay::new();
    /// frame.show(Point::new(5, 5), &mut display)?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[inline]
    pub fn show<D: DrawTarget<Color = C>>(&self, top_left: Point, target: &mut D) -> Result<(), D::Error> {
        self.show_part(0..self.size().height, 0..self.size().width, top_left, target)
    }

    fn show_part<D: DrawTarget<Color = C>>(
        &self,
        rows: core::ops::Range<u32>,
        columns: core::ops::Range<u32>,
        top_left: Point,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let size = embedded_graphics_core::geometry::Size::new(columns.end - columns.start, rows.end - rows.start);
        let (units, grid, width) = (self.units(), self.grid(), size.width as usize);
        let colours = rows.flat_map(move |row| {
            let (line, first, row) = grid.place::<C, L>(columns.start, row);
            (first..first + width).filter_map(move |column| L::get(units, line, column, row))
        });
        target.fill_contiguous(&Rectangle::new(top_left, size), colours)
    }
}

/// What `Image` of embedded-graphics shows.
impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]>> ImageDrawable for Framebuffer<C, L, S> {
    type Color = C;

    #[inline]
    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.show(Point::zero(), target)
    }

    /// The part comes to lie at the target's (0, 0); what of it is outside of the framebuffer is cut.
    fn draw_sub_image<D: DrawTarget<Color = C>>(&self, target: &mut D, area: &Rectangle) -> Result<(), D::Error> {
        let (area, all) = (PixelRect::from(*area), PixelRect::from(Rectangle::new(Point::zero(), self.size())));
        let Some((rows, columns)) = visible(&area, &all) else { return Ok(()) };
        let top_left =
            Point::new(columns.start.wrapping_sub(area.columns.start), rows.start.wrapping_sub(area.rows.start));
        let unsigned = |range: core::ops::Range<i32>| range.start.cast_unsigned()..range.end.cast_unsigned();
        self.show_part(unsigned(rows), unsigned(columns), top_left, target)
    }
}
