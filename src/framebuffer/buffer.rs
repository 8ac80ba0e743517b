//! A framebuffer over memory that it owns or borrows.

use core::{fmt, marker::PhantomData};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::framebuffer::{
    Surface,
    error::FramebufferError,
    grid::Grid,
    layout::{Layout, Values},
};

/// How many units of memory a framebuffer takes whose lines follow each other without a gap: bytes for
/// [`Rows`](crate::Rows) and [`Pages`](crate::Pages), pixels for [`Values`]; `usize::MAX` where that is more.
///
/// # Examples
///
/// ```
/// use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
/// use spanfill::{LsbFirst, MsbFirst, Pages, Rows, buffer_size};
///
/// assert_eq!(buffer_size::<Rgb565, Rows<MsbFirst>>(320, 240), 153_600);
/// assert_eq!(buffer_size::<BinaryColor, Rows<MsbFirst>>(122, 250), 4_000);
/// assert_eq!(buffer_size::<BinaryColor, Pages<LsbFirst>>(128, 64), 1_024);
/// ```
pub const fn buffer_size<C: PixelColor, L: Layout<C>>(width: u32, height: u32) -> usize {
    Grid::units::<C, L>(Size::new(width, height), Grid::line_units::<C, L>(width))
}

/// A picture in memory: a draw target, readable, that lies in memory as the display takes it.
///
/// `C` is the colour, `L` how its pixels lie in memory ([`Rows`](crate::Rows), [`Pages`](crate::Pages) or [`Values`]), and
/// `S` the memory: an array, or a slice that is borrowed. Width and height are 1 to 2147483647 pixels; (0, 0) is the
/// top-left pixel, and what is drawn outside is cut.
///
/// ```text
///            width
///        <----------->
///      . # # # # # # # - - -        # pixels, - the rest of a stride
///      : # # # # # # # - - -
///      ' # # # # # # #              which the last line need not have
///        <----stride------->
/// ```
///
/// Shapes go to it fastest by [`Filled::draw_on`](crate::Filled::draw_on), which fills memory where the shape is walked; as
/// for any draw target there is `draw`, to the same pixels. Anti-aliased shapes take [`InPlace`](crate::InPlace), or
/// [`ReadBack`](crate::ReadBack) to the same pixels.
///
/// It is an image, too: `Image::new(&framebuffer, point)` shows it on another target; so does [`show`](Self::show).
///
/// # Cost
///
/// Solid areas are filled by whole words, with parts of bytes only at the two ends of a row. An area as wide as a framebuffer
/// without gaps is filled at once.
///
/// # Examples
///
/// A whole screen for an SPI display, in a `static`; its size is checked by the compiler:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use spanfill::{Circle, Framebuffer, InPlace, MsbFirst, Rows, buffer_size, prelude::*};
///
/// type Memory = [u8; buffer_size::<Rgb565, Rows<MsbFirst>>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565, Rows<MsbFirst>, Memory>::blank::<64, 48>();
/// frame.clear(Rgb565::BLACK)?;
/// Circle::new(Point::new(30, 20), 9).filled(Rgb565::RED).draw_on(&mut frame)?;
/// Circle::new(Point::new(40, 20), 9).antialiased(Rgb565::BLUE, InPlace).draw_on(&mut frame)?;
/// assert_eq!(frame.units()[2 * (20 * 64 + 25)..][..2], [0xF8, 0x00]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// Pages of an SSD1306 in memory that somebody else owns:
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Framebuffer, FramebufferError, LsbFirst, Pages};
///
/// let mut bytes = [0; 1024];
/// let mut frame = Framebuffer::<BinaryColor, Pages<LsbFirst>, _>::new(&mut bytes[..], Size::new(128, 64))?;
/// frame.fill_solid(&Rectangle::new(Point::new(3, 6), Size::new(1, 4)), BinaryColor::On).unwrap();
/// assert_eq!((bytes[3], bytes[128 + 3]), (0b1100_0000, 0b0000_0011));
///
/// let error = Framebuffer::<BinaryColor, Pages<LsbFirst>, _>::new(&mut bytes[..], Size::new(128, 65)).unwrap_err();
/// assert_eq!(error, FramebufferError::PartialPage { height: 65, page_rows: 8 });
/// # use embedded_graphics::primitives::Rectangle;
/// # Ok::<(), FramebufferError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Framebuffer<C, L, S> {
    storage: S,
    grid: Grid,
    pixels: PhantomData<(C, L)>,
}

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]>> Framebuffer<C, L, S> {
    /// A framebuffer whose lines follow each other without a gap. The memory stays as it is.
    ///
    /// # Errors
    ///
    /// [`FramebufferError`]: no pixels, a part of a page, or too little memory, each with its numbers.
    #[inline]
    pub fn new(storage: S, size: Size) -> Result<Self, FramebufferError> {
        Self::with_stride(storage, size, Grid::line_units::<C, L>(size.width))
    }

    /// A framebuffer whose lines start `stride` units apart. The memory stays as it is.
    ///
    /// # Errors
    ///
    /// As of [`new`](Self::new); and a stride shorter than a line.
    #[inline]
    pub fn with_stride(storage: S, size: Size, stride: usize) -> Result<Self, FramebufferError> {
        let grid = Grid::new::<C, L>(size, stride, storage.as_ref().len())?;
        Ok(Self { storage, grid, pixels: PhantomData })
    }

    /// The memory, as it goes to a display.
    #[inline]
    pub fn units(&self) -> &[L::Unit] {
        self.storage.as_ref()
    }

    /// From a line to the next, in units.
    #[inline]
    pub fn stride(&self) -> usize {
        self.grid.stride
    }

    /// Gives the memory back.
    #[inline]
    pub fn into_storage(self) -> S {
        self.storage
    }

    /// The units that its lines take.
    #[inline]
    pub(crate) fn needed(&self) -> usize {
        Grid::units::<C, L>(self.grid.size(), self.grid.stride)
    }

    #[inline(always)]
    pub(crate) fn grid(&self) -> Grid {
        self.grid
    }

    /// The pixel at a point, if it is on it; `(0, 0)` is the first.
    #[inline(always)]
    pub(crate) fn get(&self, column: u32, row: u32) -> Option<C> {
        if column >= self.grid.width || row >= self.grid.height {
            return None;
        }
        let (line, column, row) = self.grid.place::<C, L>(column, row);
        L::get(self.storage.as_ref(), line, column, row)
    }
}

impl<C: PixelColor, L: Layout<C>, S: AsRef<[L::Unit]> + AsMut<[L::Unit]>> Framebuffer<C, L, S> {
    /// The memory, to be written to.
    #[inline]
    pub fn units_mut(&mut self) -> &mut [L::Unit] {
        self.storage.as_mut()
    }

    /// A part as a framebuffer of its own, whose (0, 0) is the part's top-left pixel; what of `area` lies outside is cut.
    /// None if nothing is left.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{image::GetPixel, pixelcolor::Gray2, prelude::*, primitives::Rectangle};
    /// use spanfill::{Framebuffer, MsbFirst, Rows};
    ///
    /// let mut frame = Framebuffer::<Gray2, Rows<MsbFirst>, _>::new([0; 40], Size::new(20, 8)).unwrap();
    /// let mut part = frame.view(&Rectangle::new(Point::new(5, 2), Size::new(6, 3))).unwrap();
    /// part.clear(Gray2::WHITE)?;
    /// assert_eq!(frame.pixel(Point::new(4, 2)), Some(Gray2::BLACK));
    /// assert_eq!(frame.pixel(Point::new(5, 2)), Some(Gray2::WHITE));
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    pub fn view(&mut self, area: &Rectangle) -> Option<Framebuffer<C, L, &mut [L::Unit]>> {
        let (rows, columns) = self.surface().clip(area);
        if rows.is_empty() || columns.is_empty() {
            return None;
        }
        let (start, grid) = self.grid.part::<C, L>(&rows, &columns);
        let storage = self.storage.as_mut().get_mut(start..)?;
        Some(Framebuffer { storage, grid, pixels: PhantomData })
    }

    /// What draws on it.
    #[inline(always)]
    pub(crate) fn surface(&mut self) -> Surface<'_, C, L> {
        self.surface_at(Point::zero())
    }

    /// What draws on it, its first pixel having these coordinates.
    #[inline(always)]
    pub(crate) fn surface_at(&mut self, top_left: Point) -> Surface<'_, C, L> {
        Surface { units: self.storage.as_mut(), grid: self.grid, top_left }
    }
}

/// Whether there could be a framebuffer of this size, in so many units.
pub(crate) fn check_size<C: PixelColor, L: Layout<C>>(size: Size, available: usize) -> Result<(), FramebufferError> {
    Grid::new::<C, L>(size, Grid::line_units::<C, L>(size.width), available).map(drop)
}

/// What the compiler checks of a framebuffer that owns its memory.
const fn owned<C: PixelColor, L: Layout<C>>(size: Size, available: usize) -> Grid {
    match Grid::new::<C, L>(size, Grid::line_units::<C, L>(size.width), available) {
        Ok(grid) => grid,
        #[allow(clippy::panic, reason = "run by the compiler, which fails")]
        Err(FramebufferError::BufferTooSmall { .. }) => {
            panic!("the framebuffer's array is too small: see `buffer_size`")
        }
        #[allow(clippy::panic, reason = "run by the compiler, which fails")]
        Err(FramebufferError::PartialPage { .. }) => panic!("the framebuffer's height is not a whole number of pages"),
        #[allow(clippy::panic, reason = "run by the compiler, which fails")]
        Err(_) => panic!("the framebuffer has no pixels, or too many"),
    }
}

impl<C: PixelColor, L: Layout<C, Unit = u8>, const N: usize> Framebuffer<C, L, [u8; N]> {
    /// A framebuffer that owns its memory, all of it zero: in a `static` it takes no flash.
    ///
    /// A size that the memory is too small for does not compile; [`buffer_size`] tells what is needed.
    ///
    /// ```compile_fail
    /// use embedded_graphics::pixelcolor::Rgb565;
    /// use spanfill::{Framebuffer, MsbFirst, Rows};
    ///
    /// let frame = Framebuffer::<Rgb565, Rows<MsbFirst>, [u8; 100]>::blank::<10, 6>();
    /// ```
    pub const fn blank<const WIDTH: u32, const HEIGHT: u32>() -> Self {
        let grid = const { owned::<C, L>(Size::new(WIDTH, HEIGHT), N) };
        Self { storage: [0; N], grid, pixels: PhantomData }
    }
}

impl<C: PixelColor, const N: usize> Framebuffer<C, Values, [C; N]>
where
    Values: Layout<C, Unit = C>,
{
    /// A framebuffer that owns its memory, all of it in one colour.
    ///
    /// A size that the memory is too small for does not compile; [`buffer_size`] tells what is needed.
    pub const fn filled<const WIDTH: u32, const HEIGHT: u32>(colour: C) -> Self {
        let grid = const { owned::<C, Values>(Size::new(WIDTH, HEIGHT), N) };
        Self { storage: [colour; N], grid, pixels: PhantomData }
    }
}

impl<C, L, S> fmt::Debug for Framebuffer<C, L, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Framebuffer").field("grid", &self.grid).finish_non_exhaustive()
    }
}
