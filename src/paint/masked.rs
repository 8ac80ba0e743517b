//! Shapes that are see-through by a paint.

use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};

use crate::{PixelRect, blend::PIECE, coverage::CoverageSink, draw::faded, paint::Paint, shape::Cover, span::Span};

/// A shape whose coverage is multiplied, pixel by pixel, by a paint: 255 lets all of it through, 0 nothing.
///
/// It is a [`Cover`] again, for one colour, for a paint, or for a [`Mosaic`](crate::Mosaic). A gradient with opacities
/// in its stops is two: one of its colours, and in the mask one of their opacities, with the same offsets.
///
/// # Cost
///
/// The mask's, and a multiplication a pixel; whole spans become runs.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{LinearGradient, Masked, Over, Spread, Stop, Stops, Triangle, Vertex, prelude::*};
///
/// let fading = [Stop::new(0, Gray8::new(255)), Stop::new(65536, Gray8::new(0))];
/// let fading = LinearGradient::new(Vertex::pixel(0, 0), Vertex::pixel(5, 0), Stops::new(&fading, Spread::Pad)?);
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(8, 0), Point::new(0, 8));
/// let mut display = MockDisplay::new();
/// Masked::new(triangle, fading).antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display).unwrap();
/// assert_eq!(display.get_pixel(Point::new(1, 1)), Some(Gray8::new(204)));
/// # Ok::<(), spanfill::BadStops>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Masked<S, P> {
    shape: S,
    opacity: P,
}

impl<S: Cover, P: Paint<Gray8>> Masked<S, P> {
    /// A shape, and how much of it is let through where.
    #[inline]
    pub const fn new(shape: S, opacity: P) -> Self {
        Self { shape, opacity }
    }
}

impl<S: Cover, P: Paint<Gray8>> Cover for Masked<S, P> {
    fn touched(&self) -> PixelRect {
        self.shape.touched()
    }

    fn coverage<T: CoverageSink>(&self, clip: &PixelRect, sink: &mut T) -> Result<(), T::Error> {
        self.shape.coverage(clip, &mut Masking { sink, opacity: &self.opacity })
    }
}

struct Masking<'s, T, P> {
    sink: &'s mut T,
    opacity: &'s P,
}

impl<T: CoverageSink, P: Paint<Gray8>> Masking<'_, T, P> {
    fn pieces(&mut self, row: i32, column: i32, coverage: impl Iterator<Item = u8>) -> Result<(), T::Error> {
        let mut through = coverage.zip(self.opacity.row(row, column));
        let mut column = column;
        loop {
            let (mut piece, mut length) = ([0; PIECE], 0);
            for (place, (coverage, opacity)) in piece.iter_mut().zip(through.by_ref()) {
                *place = faded(coverage, opacity.luma());
                length += 1;
            }
            let piece = piece.get(..length).unwrap_or_default();
            if piece.is_empty() {
                return Ok(());
            }
            let mut rest = piece;
            while let Some(first) = rest.first().map(|first| kind(*first)) {
                let length = rest.iter().position(|other| kind(*other) != first).unwrap_or(rest.len());
                let (part, after) = rest.split_at_checked(length).unwrap_or_default();
                let end = column.wrapping_add_unsigned(u32::try_from(length).unwrap_or(0));
                match first {
                    0 => {}
                    255 => self.sink.span(Span { row, columns: column..end }, 255)?,
                    _ => self.sink.run(row, column, part)?,
                }
                (rest, column) = (after, end);
            }
        }
    }
}

/// Nothing, in part or wholly covered.
fn kind(coverage: u8) -> u8 {
    match coverage {
        0 | 255 => coverage,
        _ => 1,
    }
}

impl<T: CoverageSink, P: Paint<Gray8>> CoverageSink for Masking<'_, T, P> {
    type Error = T::Error;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), T::Error> {
        let width = usize::try_from(span.columns.end.abs_diff(span.columns.start)).unwrap_or(0);
        self.pieces(span.row, span.columns.start, core::iter::repeat_n(coverage, width))
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), T::Error> {
        self.pieces(row, column, coverage.iter().copied())
    }
}
