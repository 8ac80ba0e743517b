//! Targets in memory.

mod canvas;
mod view;

pub use canvas::Canvas;
pub use view::View;

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point};

/// A draw target whose pixels are in memory, row by row, each as a value of the target's colour: a framebuffer, a band of
/// one. [`InPlace`](crate::InPlace) blends on it.
///
/// ```text
///            start         the row's right end
///              |                |
///     . . . . [# # # # # # # # #]     the slice
/// ```
///
/// # Cost
///
/// Nothing is copied; a shape asks once for each of its runs and spans.
///
/// # Examples
///
/// A frame of 64 x 48 pixels. For a band, take the band's first row off `start.y`.
///
/// ```
/// use core::convert::Infallible;
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use spanfill::{InPlace, PixelRows, Triangle, prelude::*};
///
/// struct Frame([[Rgb565; 64]; 48]);
///
/// impl OriginDimensions for Frame {
///     fn size(&self) -> Size {
///         Size::new(64, 48)
///     }
/// }
///
/// impl PixelRows for Frame {
///     fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
///         let row = self.0.get_mut(usize::try_from(start.y).ok()?)?;
///         row.get_mut(usize::try_from(start.x).ok()?..)
///     }
/// }
///
/// impl DrawTarget for Frame {
///     type Color = Rgb565;
///     type Error = Infallible;
///
///     fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
///         for Pixel(point, colour) in pixels {
///             if let Some([pixel, ..]) = self.row_from(point) {
///                 *pixel = colour;
///             }
///         }
///         Ok(())
///     }
/// }
///
/// let mut frame = Frame([[Rgb565::BLACK; 64]; 48]);
/// let triangle = Triangle::new(Point::new(2, 1), Point::new(60, 20), Point::new(20, 45));
/// triangle.antialiased(Rgb565::RED, InPlace).opacity(128).draw_on(&mut frame)?;
/// assert_eq!(frame.0[20][30], Rgb565::new(16, 0, 0));
/// # Ok::<(), Infallible>(())
/// ```
pub trait PixelRows: DrawTarget {
    /// The pixels of a row from `start` to its right end, at least one of them; none where `start` is outside of the
    /// bounding box.
    fn row_from(&mut self, start: Point) -> Option<&mut [Self::Color]>;
}
