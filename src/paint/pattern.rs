//! One colour, and colours that repeat.

use core::fmt;

use embedded_graphics_core::{
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::PixelColor,
};

use crate::paint::Paint;

/// One colour everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Solid<C>(pub C);

impl<C: Copy> Paint<C> for Solid<C> {
    #[inline]
    fn row(&self, _: i32, _: i32) -> impl Iterator<Item = C> {
        core::iter::repeat(self.0)
    }
}

/// A pattern has to have at least one pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct EmptyPattern;

impl fmt::Display for EmptyPattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the pattern has no pixel")
    }
}

impl core::error::Error for EmptyPattern {}

/// A picture, over and over, in every direction. Where it has a hole, the row ends there.
///
/// Its top-left pixel lies at `origin`, and again every width and height of it.
///
/// # Errors
///
/// A picture without pixels.
///
/// # Cost
///
/// Two remainders a row, one read a pixel.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{image::ImageRaw, mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Pattern, Triangle, prelude::*};
///
/// let board = ImageRaw::<BinaryColor>::new(&[0b1000_0000, 0b0100_0000], 2);
/// let mut display = MockDisplay::new();
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(4, 0), Point::new(0, 4));
/// triangle.painted(Pattern::new(board, Point::zero())?).draw(&mut display).unwrap();
/// display.assert_pattern(&["#.#.", ".#. ", "#.  ", ".   "]);
/// # Ok::<(), spanfill::EmptyPattern>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pattern<T> {
    picture: T,
    origin: Point,
    corner: Point,
    size: [i32; 2],
}

impl<T: GetPixel + Dimensions> Pattern<T> {
    /// A picture's bounding box, repeated.
    ///
    /// # Errors
    ///
    /// See [`EmptyPattern`].
    pub fn new(picture: T, origin: Point) -> Result<Self, EmptyPattern> {
        let area = picture.bounding_box();
        let size = [area.size.width, area.size.height].map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        if size.contains(&0) {
            return Err(EmptyPattern);
        }
        Ok(Self { picture, origin, corner: area.top_left, size })
    }
}

impl<C: PixelColor, T: GetPixel<Color = C>> Paint<C> for Pattern<T> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let [width, height] = self.size.map(|side| i64::from(side.max(1)));
        let within = |at: i32, origin: i32, side: i64| {
            let offset = (i64::from(at) - i64::from(origin)).rem_euclid(side);
            i32::try_from(offset).unwrap_or(0)
        };
        let y = self.corner.y.wrapping_add(within(row, self.origin.y, height));
        let mut x = within(column, self.origin.x, width);
        core::iter::from_fn(move || {
            let pixel = self.picture.pixel(Point::new(self.corner.x.wrapping_add(x), y));
            x += 1;
            if i64::from(x) >= width {
                x = 0;
            }
            pixel
        })
    }
}

/// Two colours in a pattern of 8 x 8 pixels that belongs to the screen: a byte a row, the highest bit left.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Hatch, Triangle, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(6, 0), Point::new(0, 6));
/// triangle.painted(Hatch::new(Hatch::DIAGONAL, BinaryColor::On, BinaryColor::Off)).draw(&mut display)?;
/// display.assert_pattern(&["...#..", "..#.. ", ".#..  ", "#..   ", "..    ", ".     "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Hatch<C> {
    rows: [u8; 8],
    set: C,
    clear: C,
}

/// Patterns.
impl Hatch<()> {
    /// Lines from the lower left to the upper right, every four pixels.
    pub const DIAGONAL: [u8; 8] = [0x11, 0x22, 0x44, 0x88, 0x11, 0x22, 0x44, 0x88];
    /// The same from the upper left to the lower right.
    pub const BACK_DIAGONAL: [u8; 8] = [0x88, 0x44, 0x22, 0x11, 0x88, 0x44, 0x22, 0x11];
    /// Both.
    pub const CROSS: [u8; 8] = [0x99, 0x66, 0x66, 0x99, 0x99, 0x66, 0x66, 0x99];
    /// Every second pixel.
    pub const HALF: [u8; 8] = [0xaa, 0x55, 0xaa, 0x55, 0xaa, 0x55, 0xaa, 0x55];
}

impl<C> Hatch<C> {
    /// Bits, and the colours of those that are set and those that are not.
    #[inline]
    pub const fn new(rows: [u8; 8], set: C, clear: C) -> Self {
        Self { rows, set, clear }
    }
}

impl<C: Copy> Paint<C> for Hatch<C> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let index = usize::try_from(row & 7).unwrap_or(0);
        let mut bits = self.rows.get(index).copied().unwrap_or(0).rotate_left((column & 7).unsigned_abs());
        let (set, clear) = (self.set, self.clear);
        core::iter::repeat_with(move || {
            let colour = if bits & 0x80 == 0 { clear } else { set };
            bits = bits.rotate_left(1);
            colour
        })
    }
}
