//! Styles put together property by property.

use embedded_graphics::primitives::StrokeAlignment;

use super::Style;

/// Builds a [`Style`]: in place of `PrimitiveStyleBuilder`, with its names.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use spanfill::eg::StyleBuilder;
///
/// let style = StyleBuilder::new().fill_color(Rgb565::BLUE).stroke_color(Rgb565::RED).stroke_width(1).build();
/// let mut display = MockDisplay::new();
/// Rectangle::new(Point::zero(), Size::new(4, 3)).into_styled(style).draw(&mut display)?;
/// display.assert_pattern(&["RRRR", "RBBR", "RRRR"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct StyleBuilder<C> {
    style: Style<C>,
}

impl<C> StyleBuilder<C> {
    /// Starts from neither fill nor stroke.
    #[inline]
    pub const fn new() -> Self {
        Self { style: Style::new() }
    }

    /// Sets the width of the stroke, in pixels.
    #[inline]
    pub const fn stroke_width(mut self, stroke_width: u32) -> Self {
        self.style.stroke_width = stroke_width;
        self
    }

    /// Sets the side of the outline that the stroke lies on.
    #[inline]
    pub const fn stroke_alignment(mut self, stroke_alignment: StrokeAlignment) -> Self {
        self.style.stroke_alignment = stroke_alignment;
        self
    }
}

impl<C: Copy> StyleBuilder<C> {
    /// Sets the colour inside.
    #[inline]
    pub const fn fill_color(mut self, fill_color: C) -> Self {
        self.style.fill_color = Some(fill_color);
        self
    }

    /// Leaves the inside as it is.
    #[inline]
    pub const fn reset_fill_color(mut self) -> Self {
        self.style.fill_color = None;
        self
    }

    /// Sets the colour of the stroke.
    #[inline]
    pub const fn stroke_color(mut self, stroke_color: C) -> Self {
        self.style.stroke_color = Some(stroke_color);
        self
    }

    /// Draws no stroke.
    #[inline]
    pub const fn reset_stroke_color(mut self) -> Self {
        self.style.stroke_color = None;
        self
    }

    /// The style.
    #[inline]
    pub const fn build(self) -> Style<C> {
        self.style
    }
}

impl<C> Default for StyleBuilder<C> {
    #[inline]
    fn default() -> Self {
        Self::new()
    }
}

impl<C: Copy> From<&Style<C>> for StyleBuilder<C> {
    #[inline]
    fn from(style: &Style<C>) -> Self {
        Self { style: *style }
    }
}
