//! Mixing two colours.

use embedded_graphics_core::pixelcolor::{PixelColor, Rgb565, RgbColor};

/// A colour that can be mixed with another.
pub trait Mix: PixelColor {
    /// This colour, `alpha` 255ths opaque, over another: each channel to the nearest of its own steps.
    fn over(self, backdrop: Self, alpha: u8) -> Self;
}

impl Mix for Rgb565 {
    fn over(self, backdrop: Self, alpha: u8) -> Self {
        let channel = |top: u8, bottom: u8| {
            let sum = u32::from(top) * u32::from(alpha) + u32::from(bottom) * u32::from(255 - alpha);
            let rounded = (2 * sum + 255) / 510;
            rounded.to_le_bytes()[0]
        };
        Self::new(channel(self.r(), backdrop.r()), channel(self.g(), backdrop.g()), channel(self.b(), backdrop.b()))
    }
}
