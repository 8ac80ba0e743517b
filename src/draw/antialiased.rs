//! Shapes in one colour, blended at their edges.

use embedded_graphics_core::{
    Drawable, draw_target::DrawTarget, geometry::Dimensions, pixelcolor::PixelColor, primitives::Rectangle,
};

use crate::{
    PixelRect,
    blend::{Blend, Dither, Linear, Mix, MixLinear, Over},
    draw::blended::BlendedFill,
    shape::Cover,
    span::visible,
};

/// Gives every shape that has [coverage](Cover) a colour and a way to blend it.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Over, Triangle, prelude::*};
///
/// let triangle = Triangle::new(Point::new(5, 3), Point::new(40, 12), Point::new(17, 35));
/// let mut display = MockDisplay::new();
/// triangle.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub trait AntiAlias: Cover + Sized {
    /// The shape in one colour, with edges blended by how much of each pixel it covers: see [`AntiAliased`].
    ///
    /// With [`Over`], [`Linear`]`(Over)` and [`Dither`] it is an embedded-graphics [`Drawable`] for any [`DrawTarget`];
    /// with any other [`Blend`] it goes to the targets that this can use by [`draw_on`](AntiAliased::draw_on).
    #[inline]
    fn antialiased<C: PixelColor, B>(self, colour: C, blend: B) -> AntiAliased<Self, C, B> {
        AntiAliased { shape: self, colour, blend, opacity: 255 }
    }
}

impl<S: Cover> AntiAlias for S {}

/// A shape in one colour, with anti-aliased edges.
///
/// A pixel is drawn with alpha `coverage * opacity / 255`, to the nearest 255th; what that makes of it is up to the
/// [`Blend`]. Where alpha is 255 it is always the colour itself: shapes that cover a pixel wholly replace what was
/// there, to the last bit, and whole spans of such pixels are neither read nor blended.
///
/// ```text
///              run                span               run
///          10  84 201 | 255 255 255 255 255 255 | 130  12      coverage of a row
///          `-------´    `---------------------´   `-----´
///      fill_contiguous         fill_solid      fill_contiguous      on a display, with Over
///       pixel by pixel         fill_solid      pixel by pixel       on a framebuffer, with ReadBack
/// ```
///
/// Drawing asks the target for its bounding box once, and sends it nothing outside. The target's errors pass through,
/// at once.
///
/// # On a display, a framebuffer, a band
///
/// - A display behind a bus cannot be read: [`Over`] its background, or [`Dither`].
/// - A framebuffer in memory can. It needs `GetPixel`, which embedded-graphics' `Framebuffer` has, and takes any number
///   of shapes on top of each other with [`ReadBack`](crate::ReadBack). One whose pixels are values of its colour can have
///   [`PixelRows`](crate::PixelRows), and takes the same faster with [`InPlace`](crate::InPlace).
/// - A band is a framebuffer of a few rows that stands for one part of the screen after the other. Let its bounding box
///   be that part, in the screen's coordinates, and its `GetPixel` take the same, and draw every shape on every band:
///   the bands together show what one framebuffer would.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, Over, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let dot = Circle::new(Point::new(8, 8), 6.5).antialiased(Gray8::WHITE, Over(Gray8::BLACK));
/// dot.opacity(128).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Gray8::new(128)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct AntiAliased<S, C, B> {
    shape: S,
    colour: C,
    blend: B,
    opacity: u8,
}

impl<S: Cover, C: PixelColor, B> AntiAliased<S, C, B> {
    /// The same, let through by what is behind: 255, as it is without, is opaque, 0 draws nothing.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
    /// use spanfill::{Circle, Over, prelude::*};
    ///
    /// let mut display = MockDisplay::new();
    /// let dot = Circle::new(Point::new(8, 8), 6.5).antialiased(Gray8::WHITE, Over(Gray8::new(100)));
    /// dot.opacity(51).draw(&mut display)?;
    /// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Gray8::new(131)));
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[inline]
    pub fn opacity(self, opacity: u8) -> Self {
        Self { opacity, ..self }
    }

    /// Draws on any target that the blending can use.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{
    ///     framebuffer::{Framebuffer, buffer_size},
    ///     image::GetPixel,
    ///     pixelcolor::{Gray8, raw::BigEndian},
    ///     prelude::*,
    /// };
    /// use spanfill::{Circle, ReadBack, prelude::*};
    ///
    /// let mut frame = Framebuffer::<Gray8, _, BigEndian, 16, 16, { buffer_size::<Gray8>(16, 16) }>::new();
    /// frame.clear(Gray8::new(100))?;
    /// let dot = Circle::new(Point::new(8, 8), 6.5).antialiased(Gray8::WHITE, ReadBack);
    /// dot.opacity(51).draw_on(&mut frame)?;
    /// assert_eq!(frame.pixel(Point::new(8, 8)), Some(Gray8::new(131)));
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[inline]
    pub fn draw_on<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error>
    where
        B: Blend<D>,
    {
        let clip = PixelRect::from(target.bounding_box());
        // Of a frame in bands, most shapes are not on most of the bands.
        if visible(&self.shape.touched(), &clip).is_none() {
            return Ok(());
        }
        self.blend_clipped(&clip, target)
    }

    /// What of it lies in the clip, which is the target's.
    #[inline]
    pub(super) fn blend_clipped<D: DrawTarget<Color = C>>(
        &self,
        clip: &PixelRect,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        B: Blend<D>,
    {
        let Self { ref shape, colour, blend, opacity } = *self;
        if opacity == 0 {
            return Ok(());
        }
        shape.coverage(clip, &mut BlendedFill { target, blend, colour, opacity })
    }
}

/// `Drawable` draws on every target there is, so only what blends on all of them has it; that is not a bound which
/// could be written down.
macro_rules! impl_drawable {
    ($($blend:ty where $colour:ident: $bound:ident;)+) => {
        $(impl<S: Cover, $colour: $bound> Drawable for AntiAliased<S, $colour, $blend> {
            type Color = $colour;
            type Output = ();

            #[inline]
            fn draw<D: DrawTarget<Color = $colour>>(&self, target: &mut D) -> Result<(), D::Error> {
                self.draw_on(target)
            }
        })+
    };
}

impl_drawable! {
    Over<C> where C: Mix;
    Linear<Over<C>> where C: MixLinear;
    Dither where C: PixelColor;
}

impl<S: Cover, C, B> Dimensions for AntiAliased<S, C, B> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.shape.touched().into()
    }
}
