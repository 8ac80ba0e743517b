//! How pixels lie in memory.

use core::{fmt::Debug, marker::PhantomData, ops::Range};

use embedded_graphics_core::pixelcolor::PixelColor;

/// What comes first in memory: the most significant, or the least.
///
/// Below eight bits a pixel it tells which pixel of a byte is the first; above, which byte of a pixel. Eight bits are the
/// same either way.
pub trait Order: sealed::Sealed + Copy + Debug + 'static {
    /// Whether the most significant comes first.
    const MSB_FIRST: bool;
}

/// The first pixel of a byte is in its highest bits, and the first byte of a pixel holds its highest bits (big-endian): what
/// nearly all colour displays take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MsbFirst {}

/// The first pixel of a byte is in its lowest bits, and the first byte of a pixel holds its lowest bits (little-endian).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LsbFirst {}

impl Order for MsbFirst {
    const MSB_FIRST: bool = true;
}

impl Order for LsbFirst {
    const MSB_FIRST: bool = false;
}

/// Bytes that hold pixels beside each other: the layout of most displays and of most pictures.
///
/// ```text
///   1 bit a pixel, MsbFirst               RGB565, MsbFirst
///   bit      7 6 5 4 3 2 1 0 | 7 6 ..     byte     0         1         | 2 ..
///   column   0 1 2 3 4 5 6 7 | 8 9 ..     column   0: RRRRRGGG GGGBBBBB | 1 ..
/// ```
///
/// A row begins with a new byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rows<O>(PhantomData<O>);

/// Bytes that hold pixels above each other: the pages of an SSD1306 are `Pages<LsbFirst>`.
///
/// ```text
///   1 bit a pixel, LsbFirst
///             byte 0   byte 1
///   bit 0     row 0    row 0   ..
///   bit 1     row 1    row 1   ..
///    :         :        :
///   bit 7     row 7    row 7   ..
/// ```
///
/// A page has 8 rows at 1 bit a pixel, 4 at 2 and 2 at 4; with more bits it is the same as [`Rows`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Pages<O>(PhantomData<O>);

/// Values of the colour, row by row: what a framebuffer is that stays in memory, and the fastest to blend on a processor with
/// wide registers. It has [`PixelRows`](crate::PixelRows).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Values {}

/// How pixels of a colour lie in memory: [`Rows`], [`Pages`] or [`Values`].
///
/// Memory is a sequence of units, and lines lie in it a stride apart: a line holds the pixels of a row, or of the rows that
/// share bytes. Nobody else can implement it, and its methods are the crate's own.
pub trait Layout<C: PixelColor>: sealed::Sealed + 'static {
    /// What memory consists of: bytes or colours.
    type Unit: Copy + Debug;

    /// A colour, made ready to fill with.
    #[doc(hidden)]
    type Ink: Copy;

    /// How many rows a line holds.
    const LINE_ROWS: u32;

    /// How far a column is from the next, in eighths of a unit.
    const STEP: u32;

    /// A pixel of the line that starts at unit `line`.
    #[doc(hidden)]
    fn get(units: &[Self::Unit], line: usize, column: usize, row: u32) -> Option<C>;

    /// Sets a pixel of the line.
    #[doc(hidden)]
    fn set(units: &mut [Self::Unit], line: usize, column: usize, row: u32, colour: C);

    /// Makes a colour ready.
    #[doc(hidden)]
    fn ink(colour: C) -> Self::Ink;

    /// Fills columns of the line, in some of its rows.
    #[doc(hidden)]
    fn fill(units: &mut [Self::Unit], line: usize, columns: Range<usize>, rows: Range<u32>, ink: Self::Ink);

    /// Replaces each pixel of some columns by what `change` makes of it; it is called from left to right, once for each that
    /// there is.
    #[doc(hidden)]
    fn change(units: &mut [Self::Unit], line: usize, columns: Range<usize>, row: u32, mut change: impl FnMut(C) -> C) {
        for column in columns {
            let Some(colour) = Self::get(units, line, column, row) else { break };
            Self::set(units, line, column, row, change(colour));
        }
    }
}

mod sealed {
    #[allow(unnameable_types, reason = "nobody else implements what has it")]
    pub trait Sealed {}

    impl Sealed for super::MsbFirst {}
    impl Sealed for super::LsbFirst {}
    impl<O> Sealed for super::Rows<O> {}
    impl<O> Sealed for super::Pages<O> {}
    impl Sealed for super::Values {}
}
