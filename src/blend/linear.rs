//! Mixing as light adds up.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565,
        Rgb666, Rgb888, RgbColor,
    },
    primitives::Rectangle,
};

use crate::{
    blend::{Blend, InPlace, Mix, Over, ReadBack, srgb::light},
    target::PixelRows,
};

/// A colour that can be mixed with another as light adds up: every colour of embedded-graphics.
///
/// `alpha` is how opaque the upper colour is, in 255ths: 0..=255.
///
/// The steps of a channel are taken for those of sRGB (IEC 61966-2-1), which are finer in the dark. Each channel is
/// turned into light, in 65535ths, mixed there, and turned into the step whose light is nearest to the exact mix. Both
/// ends are exact, and a greater alpha is never farther from the upper colour.
///
/// ```text
///   light                      #     half the light of white
///     |                     #        is step 188 of 255;
///     |- - - - - - - - - #           halfway between the steps,
///     |              #  :            at 128, is a fifth of it
///     |      #  #       :
///     +-----------------:------ step
/// ```
///
/// `BinaryColor` has two steps, of no light and of all: it is what [`Mix::over`] makes of it.
///
/// # Cost
///
/// A search in a table for each channel. The tables have two bytes for each step: 512 bytes for channels of eight bits;
/// a program has those that it uses.
///
/// # Examples
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use embedded_graphics::prelude::*;
/// use spanfill::{Mix, MixLinear};
///
/// assert_eq!(Gray8::WHITE.over(Gray8::BLACK, 128), Gray8::new(128));
/// assert_eq!(Gray8::WHITE.over_linear(Gray8::BLACK, 128), Gray8::new(188));
/// ```
pub trait MixLinear: PixelColor {
    /// This colour, `alpha` 255ths opaque, over another, in linear light.
    fn over_linear(self, backdrop: Self, alpha: u8) -> Self;
}

/// Blends as light adds up, not as the numbers of colours do: `Linear(Over(background))`, `Linear(ReadBack)` or
/// `Linear(InPlace)`.
///
/// Thin bright shapes on a dark background keep their weight; without it they look thinner than they are, and dark ones
/// on a bright background thicker. See [`MixLinear`] for the rule.
///
/// ```text
///   coverage                        0   64  128  191  255
///   white Over(BLACK)               0   64  128  191  255     steps of 255
///   white Linear(Over(BLACK))       0  137  188  224  255
/// ```
///
/// # Cost
///
/// That of what it holds, and a search in a table for each channel of each pixel at the edges.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Line, Linear, Over, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let hand = Line::new(Point::new(30, 30), Point::new(42, 11));
/// hand.antialiased(Gray8::WHITE, Linear(Over(Gray8::BLACK))).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Linear<B>(pub B);

impl<C: MixLinear, D: DrawTarget<Color = C>> Blend<D> for Linear<Over<C>> {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        let Self(Over(background)) = *self;
        Over::run_by(target, start, alphas, move |alpha| colour.over_linear(background, alpha))
    }

    #[inline]
    fn span(&self, target: &mut D, start: Point, width: u32, colour: C, alpha: u8) -> Result<(), D::Error> {
        let Self(Over(background)) = *self;
        target.fill_solid(&Rectangle::new(start, Size::new(width, 1)), colour.over_linear(background, alpha))
    }
}

impl<C: MixLinear, D: DrawTarget<Color = C> + GetPixel<Color = C>> Blend<D> for Linear<ReadBack> {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        ReadBack::run_by(target, start, alphas, move |backdrop, alpha| colour.over_linear(backdrop, alpha))
    }
}

/// Pixel by pixel: a search in a table is nothing for a register of eight lanes.
impl<C: MixLinear, D: PixelRows<Color = C>> Blend<D> for Linear<InPlace> {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        InPlace::run_by(target, start, alphas, move |backdrop, alpha| colour.over_linear(backdrop, alpha));
        Ok(())
    }

    #[inline]
    fn fill(&self, target: &mut D, start: Point, width: u32, colour: C) -> Result<(), D::Error> {
        InPlace::fill_row(target, start, width, colour);
        Ok(())
    }
}

static LIGHT_OF_2_BITS: [u16; 4] = light();
static LIGHT_OF_4_BITS: [u16; 16] = light();
static LIGHT_OF_5_BITS: [u16; 32] = light();
static LIGHT_OF_6_BITS: [u16; 64] = light();
static LIGHT_OF_8_BITS: [u16; 256] = light();

/// The step whose light is nearest to the mix of two; the darker of two that are equally near.
fn mix_light<const STEPS: usize>(light: &[u16; STEPS], top: u8, bottom: u8, alpha: u8) -> u8 {
    // Lights times 255: below 2^24.
    let light_of = |step: usize| 255 * light.get(step).copied().map_or(0, u32::from);
    let weight = u32::from(alpha);
    let mix = light.get(usize::from(top)).copied().map_or(0, u32::from) * weight
        + light.get(usize::from(bottom)).copied().map_or(0, u32::from) * (255 - weight);
    // The mix is at most the light of the last step, so there is a step at or above it.
    let above = light.partition_point(|&light| 255 * u32::from(light) < mix);
    let below = above.saturating_sub(1);
    let nearest = if mix.abs_diff(light_of(below)) <= mix.abs_diff(light_of(above)) { below } else { above };
    u8::try_from(nearest).unwrap_or(u8::MAX)
}

macro_rules! impl_mix_linear {
    ($($colour:ident: $($channel:ident $light:ident),+;)+) => {
        $(impl MixLinear for $colour {
            fn over_linear(self, backdrop: Self, alpha: u8) -> Self {
                Self::new($(mix_light(&$light, self.$channel(), backdrop.$channel(), alpha)),+)
            }
        })+
    };
}

impl_mix_linear! {
    Gray2: luma LIGHT_OF_2_BITS;
    Gray4: luma LIGHT_OF_4_BITS;
    Gray8: luma LIGHT_OF_8_BITS;
    Rgb555: r LIGHT_OF_5_BITS, g LIGHT_OF_5_BITS, b LIGHT_OF_5_BITS;
    Bgr555: r LIGHT_OF_5_BITS, g LIGHT_OF_5_BITS, b LIGHT_OF_5_BITS;
    Rgb565: r LIGHT_OF_5_BITS, g LIGHT_OF_6_BITS, b LIGHT_OF_5_BITS;
    Bgr565: r LIGHT_OF_5_BITS, g LIGHT_OF_6_BITS, b LIGHT_OF_5_BITS;
    Rgb666: r LIGHT_OF_6_BITS, g LIGHT_OF_6_BITS, b LIGHT_OF_6_BITS;
    Bgr666: r LIGHT_OF_6_BITS, g LIGHT_OF_6_BITS, b LIGHT_OF_6_BITS;
    Rgb888: r LIGHT_OF_8_BITS, g LIGHT_OF_8_BITS, b LIGHT_OF_8_BITS;
    Bgr888: r LIGHT_OF_8_BITS, g LIGHT_OF_8_BITS, b LIGHT_OF_8_BITS;
}

impl MixLinear for BinaryColor {
    #[inline]
    fn over_linear(self, backdrop: Self, alpha: u8) -> Self {
        self.over(backdrop, alpha)
    }
}
