//! Shapes in one colour, blended at their edges.

use embedded_graphics_core::{
    Drawable, Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    blend::{Blend, Mix, Over},
    coverage::CoverageSink,
    shape::Cover,
    span::Span,
};

/// Gives every shape that has [coverage](Cover) a colour and a way to blend it.
pub trait AntiAlias: Cover + Sized {
    /// The shape in one colour, with edges blended by how much of each pixel it covers.
    #[inline]
    fn antialiased<C: PixelColor, B>(self, colour: C, blend: B) -> AntiAliased<Self, C, B> {
        AntiAliased { shape: self, colour, blend, opacity: 255 }
    }
}

impl<S: Cover> AntiAlias for S {}

/// A shape in one colour, with anti-aliased edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct AntiAliased<S, C, B> {
    shape: S,
    colour: C,
    blend: B,
    opacity: u8,
}

impl<S: Cover, C: PixelColor, B> AntiAliased<S, C, B> {
    /// The same, let through by what is below: 0 draws nothing, 255 is opaque.
    #[inline]
    pub fn opacity(self, opacity: u8) -> Self {
        Self { opacity, ..self }
    }

    /// Draws on any target that the blending can use.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    #[inline]
    pub fn draw_on<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error>
    where
        B: Blend<D>,
    {
        if self.opacity == 0 {
            return Ok(());
        }
        let clip = PixelRect::from(target.bounding_box());
        let Self { colour, opacity, .. } = *self;
        self.shape.coverage(&clip, &mut BlendedFill { target, blend: &self.blend, colour, opacity })
    }
}

impl<S: Cover, C: Mix> Drawable for AntiAliased<S, C, Over<C>> {
    type Color = C;
    type Output = ();

    #[inline]
    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.draw_on(target)
    }
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
    blend: &'t B,
    colour: D::Color,
    opacity: u8,
}

impl<D: DrawTarget, B: Blend<D>> BlendedFill<'_, D, B> {
    #[inline(always)]
    fn alpha(&self, coverage: u8) -> u8 {
        if self.opacity == 255 {
            return coverage;
        }
        let product = u32::from(coverage) * u32::from(self.opacity) + 128;
        ((product + (product >> 8)) >> 8).to_le_bytes()[0]
    }

    fn pixel(&mut self, point: Point, coverage: u8) -> Result<(), D::Error> {
        let alpha = self.alpha(coverage);
        match self.blend.at(self.target, point, self.colour, alpha) {
            Some(colour) => self.target.draw_iter(core::iter::once(Pixel(point, colour))),
            None => Ok(()),
        }
    }
}

impl<D: DrawTarget, B: Blend<D>> CoverageSink for BlendedFill<'_, D, B> {
    type Error = D::Error;

    #[inline]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), D::Error> {
        let Span { row, columns } = span;
        if let Some(colour) = self.blend.everywhere(self.colour, self.alpha(coverage)) {
            let size = Size::new(columns.end.wrapping_sub(columns.start).cast_unsigned(), 1);
            return self.target.fill_solid(&Rectangle::new(Point::new(columns.start, row), size), colour);
        }
        for column in columns {
            self.pixel(Point::new(column, row), coverage)?;
        }
        Ok(())
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), D::Error> {
        for (column, coverage) in (column..).zip(coverage) {
            self.pixel(Point::new(column, row), *coverage)?;
        }
        Ok(())
    }
}
