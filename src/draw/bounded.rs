//! Drawings that know where they are.

use embedded_graphics_core::{
    Drawable, draw_target::DrawTarget, geometry::Dimensions, pixelcolor::PixelColor, primitives::Rectangle,
};

use crate::{
    PixelRect,
    blend::Blend,
    draw::{AntiAliased, Filled},
    shape::{Cover, Shape},
    span::visible,
    target::Canvas,
};

/// Anything drawable together with its bounds, worked out once: where a target shows nothing of them, drawing costs a
/// comparison. A shape, a text, an image.
///
/// It is for scenes that are drawn band after band ([`Bands`](crate::Bands)): there, most of what is drawn is not on most
/// of the bands. An outline is looked over as a whole for its bounds, a text laid out; both once, in place of once a band.
///
/// # Cost
///
/// 16 bytes of RAM, or of flash [in a constant](Self::within), and no code but the comparison. A map of 177 countries in 30
/// bands takes 1.4 times what it takes at once, in place of 2.3; blended 1.2 times, in place of 1.6.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{Bands, Bounded, InPlace, MsbFirst, Polygon, Rows, Vertex, prelude::*};
///
/// const ROOF: Polygon = Polygon::new(&[Vertex::from_bits(256, 4096), Vertex::from_bits(7680, 512), Vertex::from_bits(15360, 4096)]);
///
/// let roof = ROOF.coverage_with::<{ ROOF.coverage_edges() }>()?.antialiased(Gray4::WHITE, InPlace);
/// let roof = Bounded::new(roof);
/// let mut bands = Bands::<Gray4, Rows<MsbFirst>, _, 1>::new([[0; 128]], Size::new(64, 64), Gray4::BLACK)?;
/// let mut display = MockDisplay::<Gray4>::new();
/// bands.draw(|band| roof.draw_on(band), |band| band.show(&mut display)).unwrap();
/// assert_eq!(display.get_pixel(Point::new(30, 10)), Some(Gray4::WHITE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounded<T> {
    drawable: T,
    bounds: PixelRect,
}

impl<T> Bounded<T> {
    /// With bounds that are known, in a constant too. What is outside of them may be left out.
    #[inline]
    pub const fn within(drawable: T, bounds: PixelRect) -> Self {
        Self { drawable, bounds }
    }

    /// What the target shows, if anything of the bounds is there.
    #[inline(always)]
    fn clip(&self, target: &impl Dimensions) -> Option<PixelRect> {
        let clip = PixelRect::from(target.bounding_box());
        visible(&self.bounds, &clip).map(|_| clip)
    }
}

impl<T: Dimensions> Bounded<T> {
    /// With the bounds that it has now.
    #[inline]
    pub fn new(drawable: T) -> Self {
        let bounds = drawable.bounding_box().into();
        Self { drawable, bounds }
    }
}

impl<S: Shape, C: PixelColor> Bounded<Filled<S, C>> {
    /// Draws on a target in memory: see [`Filled::draw_on`].
    ///
    /// # Errors
    ///
    /// The target's, at once.
    #[inline]
    pub fn draw_on<D: Canvas<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        match self.clip(target) {
            Some(clip) => self.drawable.fill_clipped(&clip, target),
            None => Ok(()),
        }
    }
}

impl<S: Cover, C: PixelColor, B> Bounded<AntiAliased<S, C, B>> {
    /// Draws on any target that the blending can use: see [`AntiAliased::draw_on`].
    ///
    /// # Errors
    ///
    /// The target's, at once.
    #[inline]
    pub fn draw_on<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error>
    where
        B: Blend<D>,
    {
        match self.clip(target) {
            Some(clip) => self.drawable.blend_clipped(&clip, target),
            None => Ok(()),
        }
    }
}

impl<T: Drawable> Drawable for Bounded<T> {
    type Color = T::Color;
    /// Nothing where nothing of it is there.
    type Output = Option<T::Output>;

    #[inline]
    fn draw<D: DrawTarget<Color = T::Color>>(&self, target: &mut D) -> Result<Option<T::Output>, D::Error> {
        self.clip(target).map(|_| self.drawable.draw(target)).transpose()
    }
}

impl<T> Dimensions for Bounded<T> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.bounds.clone().into()
    }
}
