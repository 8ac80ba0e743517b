//! The traits of embedded-graphics for each of its primitives.

use embedded_graphics::primitives::{
    Arc, Circle, Ellipse, Line, Polyline, RoundedRectangle, Sector, Styled, StyledDimensions, StyledDrawable, Triangle,
};
use embedded_graphics_core::{draw_target::DrawTarget, pixelcolor::PixelColor, primitives::Rectangle};

use crate::{
    Blend, Mix, Over,
    blend::{Dither, Linear, MixLinear},
};

use super::{
    Blended, Style,
    boxes::Boxes,
    layers::{Blending, Layers},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
};

/// A primitive that this crate can draw.
pub(super) trait Primitive {
    /// Whether there is something to fill.
    const HAS_INSIDE: bool;

    /// Pixels that belong or do not, in the order that suits the primitive.
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error>;

    /// Hands over what the stroke ends at and what it leaves to fill.
    fn draw_areas<L: Layers>(&self, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error>;

    /// A rectangle outside which nothing is drawn.
    fn styled_box(&self, stroke: &Stroke, is_blended: bool) -> Rectangle;

    /// Whether there is nothing to blend, or too far away for it.
    fn is_aliased(&self, _stroke: &Stroke, _opacity: u8) -> bool {
        false
    }
}

/// A primitive that lies in a box of whole pixels, which its stroke moves the sides of.
pub(super) trait Boxed {
    const HAS_INSIDE: bool = true;

    /// Without the stroke.
    fn pixels(&self) -> PixelBox;

    /// As [`Primitive::draw_aliased`].
    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error>;

    /// As [`Primitive::draw_areas`].
    fn draw_layers<L: Layers>(&self, boxes: &Boxes, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error>;

    /// Whether it covers no pixel in part.
    fn is_whole(&self) -> bool {
        false
    }
}

impl<P: Boxed> Primitive for P {
    const HAS_INSIDE: bool = P::HAS_INSIDE;

    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        self.draw_pixels(&Boxes::new(self.pixels(), &paint.sides), paint, target)
    }

    fn draw_areas<L: Layers>(&self, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        self.draw_layers(&Boxes::new(self.pixels(), stroke), stroke, layers)
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        Boxes::new(self.pixels(), stroke).outer.rectangle()
    }

    fn is_aliased(&self, stroke: &Stroke, opacity: u8) -> bool {
        !Boxes::new(self.pixels(), stroke).outer.can_be_blended() || (self.is_whole() && opacity == 255)
    }
}

/// Each pixel at most once.
fn draw_blended<P: Primitive, D: DrawTarget, B: Blend<D>>(
    primitive: &P,
    style: &Style<D::Color, Blended<B>>,
    target: &mut D,
) -> Result<(), D::Error>
where
    D::Color: Mix,
{
    let (paint, blended) = (Paint::new(style, P::HAS_INSIDE), &style.edges);
    if blended.opacity == 0 {
        return Ok(());
    }
    if primitive.is_aliased(&paint.sides, blended.opacity) {
        return primitive.draw_aliased(&paint, target);
    }
    primitive.draw_areas(&paint.sides, &mut Blending { paint: &paint, blended, target })
}

/// Draws styled primitives whose blending needs more than a `DrawTarget`: [`ReadBack`](crate::ReadBack) needs
/// `GetPixel`.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{
///     framebuffer::{Framebuffer, buffer_size},
///     image::GetPixel,
///     pixelcolor::{Rgb565, raw::LittleEndian},
///     prelude::*,
///     primitives::Circle,
/// };
/// use spanfill::{ReadBack, eg::{DrawOn, Style}};
///
/// let mut frame = Framebuffer::<Rgb565, _, LittleEndian, 32, 32, { buffer_size::<Rgb565>(32, 32) }>::new();
/// let style = Style::with_fill(Rgb565::RED).antialiased(ReadBack).opacity(128);
/// Circle::new(Point::new(4, 4), 20).into_styled(style).draw_on(&mut frame)?;
/// assert_eq!(frame.pixel(Point::new(14, 14)), Some(Rgb565::new(16, 0, 0)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub trait DrawOn<C, B> {
    /// Draws on any target that the blending can use.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    fn draw_on<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error>
    where
        B: Blend<D>;
}

macro_rules! styled {
    ($($primitive:ty),+) => {$(
        impl<C: PixelColor> StyledDrawable<Style<C>> for $primitive {
            type Color = C;
            type Output = ();

            fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &Style<C>, target: &mut D) -> Result<(), D::Error> {
                self.draw_aliased(&Paint::new(style, <$primitive as Primitive>::HAS_INSIDE), target)
            }
        }

        impl<C: PixelColor> StyledDimensions<Style<C>> for $primitive {
            fn styled_bounding_box(&self, style: &Style<C>) -> Rectangle {
                self.styled_box(&Stroke::new(style), false)
            }
        }

        // `draw_styled` draws on every target there is, so only what blends on all of them has it.
        styled!($primitive, Over<C> where C: Mix);
        styled!($primitive, Linear<Over<C>> where C: Mix + MixLinear);
        styled!($primitive, Dither where C: Mix);

        impl<C: PixelColor, B> StyledDimensions<Style<C, Blended<B>>> for $primitive {
            fn styled_bounding_box(&self, style: &Style<C, Blended<B>>) -> Rectangle {
                self.styled_box(&Stroke::new(style), true)
            }
        }

        impl<C: Mix, B> DrawOn<C, B> for Styled<$primitive, Style<C, Blended<B>>> {
            fn draw_on<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error>
            where
                B: Blend<D>,
            {
                draw_blended(&self.primitive, &self.style, target)
            }
        }
    )+};
    ($primitive:ty, $blend:ty where $colour:ident: $($bound:tt)+) => {
        impl<$colour: $($bound)+> StyledDrawable<Style<$colour, Blended<$blend>>> for $primitive {
            type Color = $colour;
            type Output = ();

            fn draw_styled<D: DrawTarget<Color = $colour>>(
                &self,
                style: &Style<$colour, Blended<$blend>>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                draw_blended(self, style, target)
            }
        }
    };
}

styled!(Rectangle, Circle, Ellipse, RoundedRectangle, Triangle, Line, Polyline<'_>, Arc, Sector);
