//! Colours taken apart and put together.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor, raw::RawData,
};

/// A colour of `N` channels that can be interpolated: every colour of embedded-graphics, and others by implementing it.
pub trait Channels<const N: usize>: PixelColor {
    /// The last step of each channel; the first is 0.
    const LAST: [i32; N];

    /// What one step of each channel adds to the colour's bits.
    const UNITS: [u32; N];

    /// The colour with these bits: the sum of each channel's step times its unit.
    fn from_bits(bits: u32) -> Self;

    /// The step of each channel: red, green and blue, or grey.
    fn channels(self) -> [i32; N];

    /// The colour with these steps, which are in range.
    fn from_channels(channels: [i32; N]) -> Self;
}

/// A step in range.
#[inline(always)]
const fn step(channel: i32) -> u8 {
    let [step, ..] = channel.to_le_bytes();
    step
}

macro_rules! impl_rgb {
    ($($colour:ident: $units:expr;)+) => {
        $(impl Channels<3> for $colour {
            const LAST: [i32; 3] = [Self::MAX_R as i32, Self::MAX_G as i32, Self::MAX_B as i32];
            const UNITS: [u32; 3] = $units;

            #[inline(always)]
            fn from_bits(bits: u32) -> Self {
                <Self as PixelColor>::Raw::from_u32(bits).into()
            }

            #[inline(always)]
            fn channels(self) -> [i32; 3] {
                [self.r(), self.g(), self.b()].map(i32::from)
            }

            #[inline(always)]
            fn from_channels([r, g, b]: [i32; 3]) -> Self {
                Self::new(step(r), step(g), step(b))
            }
        })+
    };
}

macro_rules! impl_grey {
    ($($colour:ident: $last:literal;)+) => {
        $(impl Channels<1> for $colour {
            const LAST: [i32; 1] = [$last];
            const UNITS: [u32; 1] = [1];

            #[inline(always)]
            fn from_bits(bits: u32) -> Self {
                <Self as PixelColor>::Raw::from_u32(bits).into()
            }

            #[inline(always)]
            fn channels(self) -> [i32; 1] {
                [i32::from(self.luma())]
            }

            #[inline(always)]
            fn from_channels([luma]: [i32; 1]) -> Self {
                Self::new(step(luma))
            }
        })+
    };
}

impl_rgb! {
    Rgb555: [1 << 10, 1 << 5, 1];
    Bgr555: [1, 1 << 5, 1 << 10];
    Rgb565: [1 << 11, 1 << 5, 1];
    Bgr565: [1, 1 << 5, 1 << 11];
    Rgb666: [1 << 12, 1 << 6, 1];
    Bgr666: [1, 1 << 6, 1 << 12];
    Rgb888: [1 << 16, 1 << 8, 1];
    Bgr888: [1, 1 << 8, 1 << 16];
}
impl_grey!(Gray2: 3; Gray4: 15; Gray8: 255;);

impl Channels<1> for BinaryColor {
    const LAST: [i32; 1] = [1];
    const UNITS: [u32; 1] = [1];

    #[inline(always)]
    fn from_bits(bits: u32) -> Self {
        Self::from(bits > 0)
    }

    #[inline(always)]
    fn channels(self) -> [i32; 1] {
        [i32::from(self.is_on())]
    }

    #[inline(always)]
    fn from_channels([on]: [i32; 1]) -> Self {
        Self::from(on > 0)
    }
}

/// The average of three colours, each channel to the nearest step: `(2 (a + b + c) + 3) / 6`.
///
/// It is the colour of a flat triangle in L. McMillan's lectures on computer graphics. Sums of three have no ties.
///
/// # Examples
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use spanfill::average;
///
/// assert_eq!(average([Rgb565::RED, Rgb565::GREEN, Rgb565::WHITE]), Rgb565::new(21, 42, 10));
/// ```
#[inline]
pub fn average<C: Channels<N>, const N: usize>(colours: [C; 3]) -> C {
    let [a, b, c] = colours.map(C::channels);
    let mut mean = a;
    for ((mean, b), c) in mean.iter_mut().zip(b).zip(c) {
        *mean = (2 * (*mean + b + c) + 3) / 6;
    }
    C::from_channels(mean)
}
