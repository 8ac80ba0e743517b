//! Mixing two colours, channel by channel, two channels to a multiplication.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, IntoStorage, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888, raw::RawData,
};

use crate::blend::lanes::{grey_lane, mix_eight, mix_eight_here, narrow_lane, wide_lane};

/// A colour that can be mixed with another: every colour of embedded-graphics, and others by implementing it.
///
/// `alpha` is how opaque the upper colour is, in 255ths: 0..=255.
///
/// Each channel is mixed by itself, in its own steps, to the nearest of them. There are no ties, and both ends are
/// exact:
///
/// ```text
///                   top * alpha + bottom * (255 - alpha)
/// channel = round ( ------------------------------------ )
///                                   255
/// ```
///
/// `BinaryColor` has two steps: the upper colour from alpha 128 on. [`Dither`](crate::Dither) suits it better.
///
/// # Cost
///
/// Four multiplications and no division for three channels.
///
/// # Examples
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565, RgbColor};
/// use spanfill::Mix;
///
/// // A third of 31 and of 63 steps: 10.33 and 21.
/// assert_eq!(Rgb565::WHITE.over(Rgb565::BLACK, 85), Rgb565::new(10, 21, 10));
/// assert_eq!(Gray8::new(200).over(Gray8::new(100), 255), Gray8::new(200));
/// ```
pub trait Mix: PixelColor {
    /// This colour, `alpha` 255ths opaque, over another.
    fn over(self, backdrop: Self, alpha: u8) -> Self;

    /// This colour over each of eight, by an alpha for each: the same as eight times [`over`](Self::over).
    ///
    /// For the colours of embedded-graphics the compiler does it in registers of eight lanes, where there are any.
    #[inline]
    fn over_eight(self, backdrops: &mut [Self; 8], alphas: &[u8; 8]) {
        mix_eight(backdrops, alphas, |backdrop, alpha| self.over(backdrop, alpha));
    }
}

/// A channel of at most 255 steps, mixed.
///
/// The sum `t` is at most 255 * 255. Division by the odd 255 rounds without ties: `t = 255 q + r` with `|r| <= 127`
/// and `q <= 255`. Then `u = t + 128 = 256 q + (r + 128 - q)`, and `u >> 8` is `q` where `r + 128 >= q` and else
/// `q - 1`, as `r + 128 - q >= 1 - 255`. So `u + (u >> 8)` is `256 q + (r + 128)` or `256 q + (r + 127)`, and either
/// is `q` after the last shift, as `1 <= r + 128 <= 255` (J. F. Blinn, "Three Wrongs Make a Right", 1995).
#[inline(always)]
fn mix_one(top: u32, bottom: u32, alpha: u8) -> u32 {
    let alpha = u32::from(alpha);
    let biased = top * alpha + bottom * (255 - alpha) + 128;
    (biased + (biased >> 8)) >> 8
}

/// Two channels, each under its part of `mask`, in bits 0..=7 and 16..=23, mixed as in [`mix_one`].
///
/// What is largest in a lane, `u + (u >> 8)`, has 16 bits, so none runs over into the next. Between them, `u >> 8` is
/// at most the channel's last step `m`, as `u <= 255 m + 128 < 256 (m + 1)`: the channel's own mask cuts it out.
#[inline(always)]
fn mix_two(top: u32, bottom: u32, alpha: u8, mask: u32) -> u32 {
    const LARGEST: u32 = 255 * 255 + 128;
    const _: () = assert!(LARGEST + (LARGEST >> 8) < 1 << 16);
    let alpha = u32::from(alpha);
    let biased = top * alpha + bottom * (255 - alpha) + ((128 << 16) | 128);
    ((biased + ((biased >> 8) & mask)) >> 8) & mask
}

/// Three channels of so many bits each, from the lowest up, mixed: the outer two together.
#[inline(always)]
fn mix_three<const LOW: u32, const MIDDLE: u32, const HIGH: u32>(top: u32, bottom: u32, alpha: u8) -> u32 {
    if cfg!(target_pointer_width = "64") {
        return mix_three_at_once::<LOW, MIDDLE, HIGH>(top.into(), bottom.into(), alpha);
    }
    // From where the high channel lies to its lane.
    let shift = 16 - (LOW + MIDDLE);
    let (low, middle, high) = ((1 << LOW) - 1, (1 << MIDDLE) - 1, ((1 << HIGH) - 1) << 16);
    // In 16 bits `shift` is at least a channel's width: no bit of one falls on the other, and one step does for both.
    let narrow = LOW + MIDDLE + HIGH <= 16;
    let spread = |raw: u32| {
        if narrow { (raw | (raw << shift)) & (low | high) } else { (raw & low) | ((raw << shift) & high) }
    };
    let outer = mix_two(spread(top), spread(bottom), alpha, low | high);
    // What is left above a narrow colour's 16 bits is not stored.
    let joined = if narrow { outer | (outer >> shift) } else { (outer & low) | ((outer & high) >> shift) };
    joined | (mix_one((top >> LOW) & middle, (bottom >> LOW) & middle, alpha) << LOW)
}

/// The same three in the lanes of a word of 64 bits: a third fewer instructions where there are such words.
#[inline(always)]
fn mix_three_at_once<const LOW: u32, const MIDDLE: u32, const HIGH: u32>(top: u64, bottom: u64, alpha: u8) -> u32 {
    const HALVES: u64 = (128 << 32) | (128 << 16) | 128;
    // From where the upper channels lie to their lanes.
    let (to_middle, to_high) = (16 - LOW, 32 - (LOW + MIDDLE));
    let (low, middle, high) = ((1 << LOW) - 1, ((1 << MIDDLE) - 1) << 16, ((1 << HIGH) - 1) << 32);
    let spread = |raw: u64| (raw & low) | ((raw << to_middle) & middle) | ((raw << to_high) & high);
    let alpha = u64::from(alpha);
    let biased = spread(top) * alpha + spread(bottom) * (255 - alpha) + HALVES;
    let mask = low | middle | high;
    let mixed = ((biased + ((biased >> 8) & mask)) >> 8) & mask;
    let joined = (mixed & low) | ((mixed & middle) >> to_middle) | ((mixed & high) >> to_high);
    #[allow(clippy::cast_possible_truncation, reason = "24 bits at most")]
    let joined = joined as u32;
    joined
}

macro_rules! impl_mix {
    ($mix:expr, $mix_lane:expr, $over_eight:tt => $($colour:ident)+) => {
        $(impl Mix for $colour {
            #[inline]
            fn over(self, backdrop: Self, alpha: u8) -> Self {
                let mixed = $mix(self.into_storage().into(), backdrop.into_storage().into(), alpha);
                <Self as PixelColor>::Raw::from_u32(mixed).into()
            }

            over_eight!($over_eight, $mix_lane);
        })+
    };
}

macro_rules! over_eight {
    // Eight narrow ones are mixed where they are, with what is needed of the colour worked out before the loop around it.
    (here, $mix_lane:expr) => {
        #[inline(always)]
        fn over_eight(self, backdrops: &mut [Self; 8], alphas: &[u8; 8]) {
            mix_eight_here(backdrops, alphas, |backdrop, alpha| $mix_lane(self, backdrop, alpha));
        }
    };
    // Of the others, the compiler makes vectors in a function of their own only.
    (apart, $mix_lane:expr) => {
        #[inline(never)]
        fn over_eight(self, backdrops: &mut [Self; 8], alphas: &[u8; 8]) {
            mix_eight(backdrops, alphas, |backdrop, alpha| $mix_lane(self, backdrop, alpha));
        }
    };
}

impl_mix!(mix_one, grey_lane::<_, 8, 0, 0>, apart => Gray2 Gray4 Gray8);
impl_mix!(mix_three::<5, 5, 5>, narrow_lane::<_, 5, 5, 5>, here => Rgb555 Bgr555);
impl_mix!(mix_three::<5, 6, 5>, narrow_lane::<_, 5, 6, 5>, here => Rgb565 Bgr565);
impl_mix!(mix_three::<6, 6, 6>, wide_lane::<_, 6, 6, 6>, apart => Rgb666 Bgr666);
impl_mix!(mix_three::<8, 8, 8>, wide_lane::<_, 8, 8, 8>, apart => Rgb888 Bgr888);

impl Mix for BinaryColor {
    #[inline]
    fn over(self, backdrop: Self, alpha: u8) -> Self {
        if alpha >= 128 { self } else { backdrop }
    }
}
