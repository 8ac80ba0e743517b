//! Shapes in one colour, blended at their edges.

use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    blend::{Blend, Dither, Linear, Mix, MixLinear, Over, PIECE, right_of},
    coverage::CoverageSink,
    shape::Cover,
    span::Span,
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
        let Self { ref shape, colour, blend, opacity } = *self;
        if opacity == 0 {
            return Ok(());
        }
        let clip = PixelRect::from(target.bounding_box());
        shape.coverage(&clip, &mut BlendedFill { target, blend, colour, opacity })
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

/// Coverage to a draw target, in one colour.
struct BlendedFill<'t, D: DrawTarget, B> {
    target: &'t mut D,
    blend: B,
    colour: D::Color,
    opacity: u8,
}

/// Coverage let through, to the nearest 255th: 255 leaves the other as it is. See `mix_one` for the division.
#[inline(always)]
fn faded(coverage: u8, opacity: u8) -> u8 {
    let biased = u16::from(coverage) * u16::from(opacity) + 128;
    let [_, quotient] = (biased + (biased >> 8)).to_le_bytes();
    quotient
}

/// A run that is let through; apart, to keep what opaque shapes run in short and its values in registers.
#[inline(never)]
fn run_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    colour: D::Color,
    coverage: &[u8],
    opacity: u8,
) -> Result<(), D::Error> {
    let mut start = start;
    for piece in coverage.chunks(PIECE) {
        let mut alphas = [0; PIECE];
        for (alpha, coverage) in alphas.iter_mut().zip(piece) {
            *alpha = faded(*coverage, opacity);
        }
        blend.run(target, start, colour, alphas.get(..piece.len()).unwrap_or_default())?;
        start = right_of(start, piece.len());
    }
    Ok(())
}

/// The same for eight pixels.
#[inline(never)]
fn eights_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    colour: D::Color,
    coverage: &[[u8; 8]],
    opacity: u8,
) -> Result<(), D::Error> {
    let mut start = start;
    for eight in coverage {
        blend.eights(target, start, colour, &[eight.map(|coverage| faded(coverage, opacity))])?;
        start = right_of(start, 8);
    }
    Ok(())
}

/// The same for a span of at least eight pixels, and what is covered of the first four and the last four.
#[inline(never)]
fn sides_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    width: u32,
    colour: D::Color,
    sides: &[u8; 8],
    opacity: u8,
) -> Result<(), D::Error> {
    let [a, b, c, d, e, f, g, h] = sides.map(|coverage| faded(coverage, opacity));
    let inside = right_of(start, 4);
    let after = Point::new(inside.x.wrapping_add_unsigned(width.saturating_sub(8)), start.y);
    blend.eights(target, start, colour, &[[a, b, c, d, 0, 0, 0, 0]])?;
    if width > 8 {
        blend.span(target, inside, width - 8, colour, opacity)?;
    }
    blend.eights(target, after, colour, &[[e, f, g, h, 0, 0, 0, 0]])
}

/// A span that is let through, or covered in part.
#[inline(never)]
fn span_faded<D: DrawTarget, B: Blend<D>>(
    blend: B,
    target: &mut D,
    start: Point,
    width: u32,
    colour: D::Color,
    alpha: u8,
) -> Result<(), D::Error> {
    blend.span(target, start, width, colour, alpha)
}

impl<D: DrawTarget, B: Blend<D>> CoverageSink for BlendedFill<'_, D, B> {
    type Error = D::Error;

    #[inline(always)]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), D::Error> {
        let Span { row, columns } = span;
        let start = Point::new(columns.start, row);
        let width = columns.end.wrapping_sub(columns.start).cast_unsigned();
        if coverage == 255 && self.opacity == 255 {
            self.blend.fill(self.target, start, width, self.colour)
        } else {
            span_faded(self.blend, self.target, start, width, self.colour, faded(coverage, self.opacity))
        }
    }

    const EIGHTS: bool = B::EIGHTS;

    #[inline(always)]
    fn eights(&mut self, row: i32, column: i32, coverage: &[[u8; 8]]) -> Result<(), D::Error> {
        let Self { ref mut target, blend, colour, opacity } = *self;
        let start = Point::new(column, row);
        if opacity == 255 {
            blend.eights(target, start, colour, coverage)
        } else {
            eights_faded(blend, *target, start, colour, coverage, opacity)
        }
    }

    #[inline(always)]
    fn span_with_sides(&mut self, span: Span, sides: &[u8; 8]) -> Result<(), D::Error> {
        let Self { ref mut target, blend, colour, opacity } = *self;
        let Span { row, columns } = span;
        let start = Point::new(columns.start, row);
        let width = columns.end.wrapping_sub(columns.start).cast_unsigned();
        if opacity < 255 {
            return sides_faded(blend, *target, start, width, colour, sides, opacity);
        }
        blend.span_with_sides(target, start, width, colour, sides)
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), D::Error> {
        let Self { ref mut target, blend, colour, opacity } = *self;
        let start = Point::new(column, row);
        if opacity == 255 {
            blend.run(target, start, colour, coverage)
        } else {
            run_faded(blend, *target, start, colour, coverage, opacity)
        }
    }
}
