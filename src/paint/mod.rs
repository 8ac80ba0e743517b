//! Colours that vary over the screen, for any shape, and shapes side by side without seams.
//!
//! ```text
//! Shape -> Span ------> Paint -a row of colours-> fill_contiguous
//! Cover -> coverage --> Paint -a row of colours-> Blend, pixel by pixel where a pixel is covered in part
//! Mosaic: coverage and colour of several shapes added up in a row of scratch, then Blend, once a pixel
//! ```

mod areas;
mod conical;
mod dither;
mod gouraud;
mod linear;
mod masked;
mod mosaic;
mod painted;
mod pattern;
mod plane;
mod radial;
mod stops;

pub use areas::{AreaSink, Areas, Rounded};
pub use conical::ConicalGradient;
pub use gouraud::GouraudPaint;
pub use linear::LinearGradient;
pub use masked::Masked;
pub use mosaic::{Cells, Mosaic, MosaicCell, MosaicError, MosaicScratchTooSmall, Tile, Tiles};
pub use painted::{Painted, PaintedAntiAliased, Painting};
pub use pattern::{EmptyPattern, Hatch, Pattern, Solid};
pub use radial::RadialGradient;
pub use stops::{BadStops, Spread, Stop, Stops};

/// A colour for every pixel of the screen.
///
/// # Examples
///
/// One method makes a paint; here a sky that darkens upwards:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, Paint, prelude::*};
///
/// struct Sky;
///
/// impl Paint<Gray8> for Sky {
///     fn row(&self, row: i32, _column: i32) -> impl Iterator<Item = Gray8> {
///         core::iter::repeat(Gray8::new(4 * row.clamp(0, 63) as u8))
///     }
/// }
///
/// let mut display = MockDisplay::new();
/// Circle::new(Point::new(8, 8), 6).painted(Sky).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(8, 10)), Some(Gray8::new(40)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub trait Paint<C> {
    /// The colours of the pixels of `row`, from `column` to the right: at least as many as the screen has.
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C>;
}

impl<C, P: Paint<C>> Paint<C> for &P {
    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        (*self).row(row, column)
    }
}
