//! One scene, band after band.

use core::{fmt, marker::PhantomData};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};
use heapless::Vec;

use crate::{
    PixelRect,
    band::{Band, FrameError, Parts},
    framebuffer::{FramebufferError, Layout, buffer_size, check_size},
    span::visible,
};

/// Memory for a few rows of the screen, in which a whole frame is drawn, band after band.
///
/// `C` is the colour, `L` how pixels lie in memory, `B` a buffer (an array, or a slice that is borrowed), and `N` how many
/// there are: with two, the next band is drawn while one is being sent.
///
/// The scene is a function that draws everything on the band it is given; it is called once a band, from the top downwards,
/// and what is not on the band is cut, as it is at the border of any target. So every split shows the same picture. Each band
/// starts in the colour of the background.
///
/// | | sends by | the buffer is |
/// |---|---|---|
/// | [`draw`](Self::draw) | a function that returns when it has sent | lent |
/// | [`draw_async`](Self::draw_async) | an `async` function; by two buffers, while the next band is drawn | lent |
/// | [`draw_by_transfers`](Self::draw_by_transfers) | a [`Transmit`](crate::Transmit), as DMA; by two buffers, while the next band is drawn | owned by the transfer |
///
/// # Cost
///
/// A shape costs its rows in the band. Where it has none, a triangle, a circle or a line costs a comparison or two; an outline
/// is looked over, unless it is [`Bounded`](crate::Bounded). The whole frame goes over the bus once, in one address window a
/// band.
///
/// # Examples
///
/// Any height of the bands; the last one has what is left:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{Bands, Circle, InPlace, MsbFirst, Rows, prelude::*};
///
/// // Five rows of 64 pixels, two pixels a byte.
/// let mut buffer = [0; 160];
/// let mut bands = Bands::<Gray4, Rows<MsbFirst>, _, 1>::new([&mut buffer[..]], Size::new(64, 64), Gray4::BLACK)?;
/// let mut display = MockDisplay::<Gray4>::new();
/// bands.draw(
///     |band| {
///         Circle::new(Point::new(30, 30), 20).filled(Gray4::new(6)).draw_on(band)?;
///         Circle::new(Point::new(40, 30), 12).antialiased(Gray4::WHITE, InPlace).draw_on(band)
///     },
///     |band| band.show(&mut display),
/// ).unwrap();
/// assert_eq!(display.get_pixel(Point::new(15, 30)), Some(Gray4::new(6)));
/// assert_eq!(display.get_pixel(Point::new(40, 30)), Some(Gray4::WHITE));
/// # Ok::<(), spanfill::FramebufferError>(())
/// ```
pub struct Bands<C, L, B, const N: usize> {
    pub(super) buffers: Vec<B, N>,
    screen: Size,
    /// The units that each buffer has.
    available: usize,
    background: C,
    layout: PhantomData<L>,
}

impl<C, L, B, const N: usize> Bands<C, L, B, N>
where
    C: PixelColor,
    L: Layout<C>,
    B: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
{
    /// Bands as high as the smallest of the buffers has room for.
    ///
    /// # Errors
    ///
    /// [`FramebufferError`]: a screen without pixels or too large, a screen whose height is not a whole number of pages, or a
    /// buffer that is too small for a single line.
    pub fn new(buffers: [B; N], screen: Size, background: C) -> Result<Self, FramebufferError> {
        const { assert!(N > 0, "bands need a buffer to draw in") }
        let available = buffers.iter().map(|buffer| buffer.as_ref().len()).min().unwrap_or(0);
        check_size::<C, L>(screen, usize::MAX)?;
        check_size::<C, L>(Size::new(screen.width, L::LINE_ROWS), available)?;
        Ok(Self { buffers: Vec::from_array(buffers), screen, available, background, layout: PhantomData })
    }

    /// Bands of so many rows.
    ///
    /// # Errors
    ///
    /// [`FramebufferError`]: no rows, rows that are not a whole number of pages, or a buffer that is too small for them.
    pub fn with_rows(mut self, rows: u32) -> Result<Self, FramebufferError> {
        check_size::<C, L>(Size::new(self.screen.width, rows), self.available)?;
        self.available = buffer_size::<C, L>(self.screen.width, rows);
        Ok(self)
    }

    /// All of the screen.
    #[inline]
    pub fn screen(&self) -> Rectangle {
        Rectangle::new(Point::zero(), self.screen)
    }

    /// How many rows a band has that is as wide as the screen.
    #[inline]
    pub fn rows(&self) -> u32 {
        self.rows_of(self.screen.width)
    }

    /// How many rows of so many pixels the buffers have room for.
    fn rows_of(&self, width: u32) -> u32 {
        let lines = self.available / buffer_size::<C, L>(width, 1).max(1);
        u32::try_from(lines).unwrap_or(u32::MAX).saturating_mul(L::LINE_ROWS)
    }

    /// The bands of an area: what of it is on the screen, and to whole bytes: pixels that share a byte with the area's are drawn
    /// and sent, too.
    ///
    /// Areas that are not as wide as the screen have higher bands.
    pub fn parts(&self, area: &Rectangle) -> Parts {
        let (area, screen) = (PixelRect::from(*area), PixelRect::from(self.screen()));
        let Some((rows, columns)) = visible(&area, &screen) else { return Parts::new(Rectangle::zero(), 0) };
        let whole = |range: core::ops::Range<i32>, step: u32, end: i32| {
            // Nothing is negative, and at most eight pixels share a byte.
            let step = step.cast_signed();
            range.start - range.start % step..range.end.saturating_add((step - range.end % step) % step).min(end)
        };
        let beside = if L::LINE_ROWS == 1 && L::STEP < 8 { 8 / L::STEP } else { 1 };
        let rows = whole(rows, L::LINE_ROWS, screen.rows.end);
        let columns = whole(columns, beside, screen.columns.end);
        let area = Rectangle::from(PixelRect { rows, columns });
        Parts::new(area, self.rows_of(area.size.width))
    }

    /// Draws the frame and sends it, band after band.
    ///
    /// # Errors
    ///
    /// The scene's or the display's, at once; what has been sent remains on the display, and the next frame is complete.
    pub fn draw<E, F>(
        &mut self,
        scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
        flush: impl FnMut(&Band<'_, C, L>) -> Result<(), F>,
    ) -> Result<(), FrameError<E, F>> {
        self.draw_area(&self.screen(), scene, flush)
    }

    /// The same for a part of the screen, as where something has changed: see [`Damage`](crate::Damage).
    ///
    /// # Errors
    ///
    /// As of [`draw`](Self::draw).
    pub fn draw_area<E, F>(
        &mut self,
        area: &Rectangle,
        mut scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
        mut flush: impl FnMut(&Band<'_, C, L>) -> Result<(), F>,
    ) -> Result<(), FrameError<E, F>> {
        let (parts, background) = (self.parts(area), self.background);
        let buffer = self.buffers.first_mut().ok_or(FrameError::NoBuffer)?.as_mut();
        for part in parts {
            let band = draw_band(buffer, &part, background, &mut scene)?;
            flush(&band).map_err(FrameError::Flush)?;
        }
        Ok(())
    }

    /// Takes a buffer out, to be drawn in and sent by hand; [`give_back`](Self::give_back) puts it back. Without it, frames are
    /// drawn in the others.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*};
    /// use spanfill::{Band, Bands, MsbFirst, Rows};
    ///
    /// let mut bands = Bands::<Gray8, Rows<MsbFirst>, _, 2>::new([[0; 64]; 2], Size::new(16, 16), Gray8::BLACK)?;
    /// let mut buffer = bands.take_buffer().unwrap();
    /// for part in bands.parts(&bands.screen()) {
    ///     let mut band = Band::<Gray8, Rows<MsbFirst>>::new(&mut buffer, &part)?;
    ///     band.clear(Gray8::WHITE).unwrap();
    ///     // Now it could be sent.
    ///     assert_eq!(band.units(), [255; 64]);
    /// }
    /// assert!(bands.give_back(buffer).is_ok());
    /// # Ok::<(), spanfill::FramebufferError>(())
    /// ```
    #[inline]
    pub fn take_buffer(&mut self) -> Option<B> {
        self.buffers.pop()
    }

    /// Puts a buffer back.
    ///
    /// # Errors
    ///
    /// The buffer itself, if it is too small or all are there.
    #[inline]
    pub fn give_back(&mut self, buffer: B) -> Result<(), B> {
        if buffer.as_ref().len() < self.available { Err(buffer) } else { self.buffers.push(buffer) }
    }

    #[inline]
    pub(super) fn background(&self) -> C {
        self.background
    }
}

/// Draws a band over the background.
#[inline]
pub(super) fn draw_band<'b, C: PixelColor, L: Layout<C>, E, F>(
    buffer: &'b mut [L::Unit],
    part: &Rectangle,
    background: C,
    scene: &mut impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
) -> Result<Band<'b, C, L>, FrameError<E, F>> {
    // It has room for it: checked when it came.
    let mut band = Band::new(buffer, part).map_err(|_| FrameError::NoBuffer)?;
    band.start(background);
    scene(&mut band).map_err(FrameError::Scene)?;
    Ok(band)
}

impl<C, L, B, const N: usize> fmt::Debug for Bands<C, L, B, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let buffers = self.buffers.len();
        f.debug_struct("Bands").field("screen", &self.screen).field("buffers", &buffers).finish_non_exhaustive()
    }
}
