//! Colours as bits.

use embedded_graphics_core::pixelcolor::{IntoStorage, PixelColor, raw::RawData};

/// A colour that has a place in a byte or more: every colour of embedded-graphics, and others whose `Raw` is one of
/// `RawU1` to `RawU32`.
///
/// # Examples
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use spanfill::PackedColor;
///
/// assert_eq!(Rgb565::RED.to_bits(), 0xF800);
/// assert_eq!(Rgb565::from_bits(0x07E0), Rgb565::GREEN);
/// ```
pub trait PackedColor: PixelColor {
    /// How many bits a pixel has: 1, 2, 4, 8, 16, 24 or 32.
    const BITS: u32;

    /// The colour in the lowest bits.
    fn to_bits(self) -> u32;

    /// The colour of the lowest bits.
    fn from_bits(bits: u32) -> Self;
}

impl<C> PackedColor for C
where
    C: PixelColor + IntoStorage + From<C::Raw>,
    u32: From<C::Storage>,
{
    #[allow(clippy::cast_possible_truncation, reason = "at most 32")]
    const BITS: u32 = C::Raw::BITS_PER_PIXEL as u32;

    #[inline(always)]
    fn to_bits(self) -> u32 {
        self.into_storage().into()
    }

    #[inline(always)]
    fn from_bits(bits: u32) -> Self {
        C::Raw::from_u32(bits).into()
    }
}
