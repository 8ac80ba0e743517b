//! What a primitive looks like: colours, stroke, and how its edges are drawn.

use embedded_graphics::primitives::{PrimitiveStyle, StrokeAlignment};
use embedded_graphics_core::pixelcolor::PixelColor;

/// A style for embedded-graphics' primitives, drawn by this crate: in place of `PrimitiveStyle`.
///
/// The names are those of `PrimitiveStyle`, and mean the same. The stroke width is in pixels; above 65535 it counts as
/// 65535. A style that is only a stroke fills nothing, one that is only a fill has no stroke, one that is neither draws
/// nothing.
///
/// ```text
///     with_fill      with_stroke, 1     both
///     . # # # .      . # # # .          . # # # .
///     # # # # #      # . . . #          # o o o #
///     # # # # #      # . . . #          # o o o #
///     . # # # .      . # # # .          . # # # .
/// ```
///
/// `E` says how edges are drawn: [`Aliased`], or [`Blended`] after [`antialiased`](Self::antialiased).
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Circle};
/// use spanfill::eg::Style;
///
/// let mut display = MockDisplay::new();
/// Circle::new(Point::zero(), 6).into_styled(Style::with_stroke(BinaryColor::On, 1)).draw(&mut display)?;
/// display.assert_pattern(&[" #### ", "##  ##", "#    #", "#    #", "##  ##", " #### "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Style<C, E = Aliased> {
    /// The colour inside; none leaves the inside as it is.
    pub fill_color: Option<C>,
    /// The colour of the outline; none draws no outline.
    pub stroke_color: Option<C>,
    /// The width of the outline, in pixels; 0 draws none.
    pub stroke_width: u32,
    /// On which side of the outline of a closed primitive the stroke lies; lines and polylines ignore it.
    pub stroke_alignment: StrokeAlignment,
    /// How the edges are drawn.
    pub edges: E,
}

/// Pixels belong or do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Aliased;

/// Pixels on an edge are blended by how much of them is covered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Blended<B> {
    /// Over what.
    pub blend: B,
    /// How much of what is below is hidden, in 255ths.
    pub opacity: u8,
}

impl<C> Style<C> {
    /// Neither fill nor stroke.
    #[inline]
    pub const fn new() -> Self {
        Self {
            fill_color: None,
            stroke_color: None,
            stroke_width: 0,
            stroke_alignment: StrokeAlignment::Center,
            edges: Aliased,
        }
    }
}

impl<C: Copy> Style<C> {
    /// A fill without a stroke.
    #[inline]
    pub const fn with_fill(fill_color: C) -> Self {
        Self { fill_color: Some(fill_color), ..Self::new() }
    }

    /// A stroke without a fill, in the middle of the outline.
    #[inline]
    pub const fn with_stroke(stroke_color: C, stroke_width: u32) -> Self {
        Self { stroke_color: Some(stroke_color), stroke_width, ..Self::new() }
    }
}

impl<C> Default for Style<C> {
    #[inline]
    fn default() -> Self {
        Self::new()
    }
}

impl<C: PixelColor> From<PrimitiveStyle<C>> for Style<C> {
    #[inline]
    fn from(style: PrimitiveStyle<C>) -> Self {
        let PrimitiveStyle { fill_color, stroke_color, stroke_width, stroke_alignment, .. } = style;
        Self { fill_color, stroke_color, stroke_width, stroke_alignment, edges: Aliased }
    }
}

impl<C, E> Style<C, E> {
    /// The same with anti-aliased edges: over a [known background](crate::Over), which every target can be given, or
    /// over [what the target shows](crate::ReadBack), for targets that can be read; these are drawn by
    /// [`draw_on`](super::DrawOn::draw_on).
    #[inline]
    pub fn antialiased<B>(self, blend: B) -> Style<C, Blended<B>> {
        let Self { fill_color, stroke_color, stroke_width, stroke_alignment, .. } = self;
        Style { fill_color, stroke_color, stroke_width, stroke_alignment, edges: Blended { blend, opacity: 255 } }
    }

    /// Whether it draws nothing at all.
    #[inline]
    pub fn is_transparent(&self) -> bool {
        (self.stroke_color.is_none() || self.stroke_width == 0) && self.fill_color.is_none()
    }
}

impl<C, B> Style<C, Blended<B>> {
    /// The same, let through by what is below: 0 draws nothing, 255 is opaque.
    #[inline]
    pub fn opacity(self, opacity: u8) -> Self {
        Self { edges: Blended { opacity, ..self.edges }, ..self }
    }
}
