//! Supersampled circle and triangle: the same shapes without anti-aliasing, `n` times as large.

mod polygon;

pub use polygon::{PolygonEdges, SampleEdge};

use core::{cell::Cell as Shared, fmt, ops::Range};

use crate::{
    PixelRect, Vertex,
    coverage::{CoverageSink, SampleCell, Samples, Supersampler},
    error::TooLittleScratch,
    limits::{HALF, ONE, SUBPIXEL_BITS},
    shape::{Circle, Cover, Polygon, Shape, Triangle},
    span::{Span, SpanSink, clip_range},
    subpixel::first_centre_at_or_after_wide,
};

impl Circle {
    /// Borrows scratch to be supersampled in: one cell for each column of the clip saves passes.
    ///
    /// # Errors
    ///
    /// When there is not a single cell.
    pub fn supersampled_in(
        self,
        samples: Samples,
        cells: &mut [SampleCell],
    ) -> Result<SupersampledIn<'_, Self>, TooLittleScratch> {
        SupersampledIn::new(self, samples, cells)
    }
}

impl Triangle {
    /// Borrows scratch to be supersampled in: one cell for each column of the clip saves passes.
    ///
    /// # Errors
    ///
    /// When there is not a single cell.
    pub fn supersampled_in(
        self,
        samples: Samples,
        cells: &mut [SampleCell],
    ) -> Result<SupersampledIn<'_, Self>, TooLittleScratch> {
        SupersampledIn::new(self, samples, cells)
    }
}

/// A shape with scratch of the caller's to be supersampled in.
///
/// With fewer cells than columns, it is drawn in vertical strips, one after the other.
///
/// # Cost
///
/// What the shape costs without anti-aliasing at `n` times its size, less what fills it: lines of samples, not
/// samples. A row of pixels is added up once. 2 bytes a cell.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Circle, Over, SampleCell, Samples, Vertex, prelude::*};
///
/// let mut cells = [SampleCell::EMPTY; 64];
/// let dot = Circle::new(Vertex::new(4, 4), 3.3).supersampled_in(Samples::grid(4), &mut cells)?;
/// let mut display = MockDisplay::new();
/// dot.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(4, 4)), Some(Gray8::WHITE));
/// // 3 of the 16 samples.
/// assert_eq!(display.get_pixel(Point::new(6, 1)), Some(Gray8::new(48)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct SupersampledIn<'s, T> {
    shape: T,
    samples: Samples,
    /// Taken while drawing.
    cells: Shared<&'s mut [SampleCell]>,
}

impl<'s, T> SupersampledIn<'s, T> {
    pub(in crate::shape) fn new(
        shape: T,
        samples: Samples,
        cells: &'s mut [SampleCell],
    ) -> Result<Self, TooLittleScratch> {
        if cells.is_empty() {
            return Err(TooLittleScratch::NoCells);
        }
        Ok(Self { shape, samples, cells: Shared::new(cells) })
    }
}

impl<T: fmt::Debug> fmt::Debug for SupersampledIn<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shape, samples, .. } = self;
        f.debug_struct("SupersampledIn").field("shape", shape).field("samples", samples).finish_non_exhaustive()
    }
}

/// A shape that can send the spans of its samples.
pub(in crate::shape) trait Sampled {
    fn touched(&self) -> PixelRect;

    /// Those in a rectangle of pixels.
    fn sample<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error>;
}

#[allow(private_bounds, reason = "the shapes that can be made from the outside are named")]
impl<T: Sampled> Cover for SupersampledIn<'_, T> {
    fn touched(&self) -> PixelRect {
        self.shape.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let touched = self.shape.touched();
        let rows = clip_range(&touched.rows, &clip.rows);
        let mut rest = clip_range(&touched.columns, &clip.columns);
        if rows.is_empty() {
            return Ok(());
        }
        let cells = self.cells.take();
        let mut result = Ok(());
        while rest.start < rest.end && result.is_ok() {
            let width = usize::try_from(rest.end.abs_diff(rest.start)).unwrap_or(usize::MAX).min(cells.len());
            let end = rest.start.saturating_add_unsigned(u32::try_from(width).unwrap_or(u32::MAX));
            let pixels = PixelRect { rows: rows.clone(), columns: rest.start..end };
            let strip = cells.get_mut(..width).unwrap_or_default();
            let mut sampler = Supersampler::new(self.samples, rows.start, rest.start..end, strip, sink);
            result = self.shape.sample(self.samples, &pixels, &mut sampler).and_then(|()| sampler.finish());
            rest.start = end;
        }
        self.cells.set(cells);
        result
    }
}

/// A rectangle of pixels, `n` times as large. What a shape touches is at most 2^24 pixels from the origin.
fn enlarged(pixels: &PixelRect, samples: Samples) -> PixelRect {
    let times = |range: &Range<i32>| range.start.wrapping_mul(samples.side())..range.end.wrapping_mul(samples.side());
    PixelRect { rows: times(&pixels.rows), columns: times(&pixels.columns) }
}

/// A vertex `n` times as far from the origin, if there is one.
fn enlarged_vertex(vertex: Vertex, samples: Samples) -> Option<Vertex> {
    let side = samples.side();
    Some(Vertex::from_bits(vertex.x.to_bits().checked_mul(side)?, vertex.y.to_bits().checked_mul(side)?))
}

impl Sampled for Triangle {
    fn touched(&self) -> PixelRect {
        Cover::touched(self)
    }

    fn sample<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        match self.vertices.map(|vertex| enlarged_vertex(vertex, samples)) {
            [Some(a), Some(b), Some(c)] => Self::from_vertices([a, b, c]).spans(&enlarged(pixels, samples), sampler),
            _ => Polygon::new(&self.vertices).sample_in(samples, pixels, &mut [SampleEdge::EMPTY; 2], sampler),
        }
    }
}

impl Sampled for Circle {
    /// Also beyond what coordinates can name, as without anti-aliasing.
    fn touched(&self) -> PixelRect {
        let radius = i64::from(self.radius.to_bits());
        let pixels = |center: i32| {
            let pixel = |position: i64| {
                #[allow(clippy::cast_possible_truncation, reason = "a sum of two coordinates, less eight bits")]
                let pixel = (position >> SUBPIXEL_BITS) as i32;
                pixel
            };
            pixel(i64::from(center) - radius)..pixel(i64::from(center) + radius) + 1
        };
        if radius <= 0 {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        PixelRect { rows: pixels(self.center.y.to_bits()), columns: pixels(self.center.x.to_bits()) }
    }

    fn sample<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        let pixels = enlarged(pixels, samples);
        let radius = self.radius.to_bits().checked_mul(samples.side());
        match (enlarged_vertex(self.center, samples), radius) {
            (Some(center), Some(radius)) => Self::from_bits(center, radius).spans(&pixels, sampler),
            _ => self.sample_by_square_root(samples, &pixels, sampler),
        }
    }
}

impl Circle {
    /// For circles that are beyond the range when they are `n` times as large.
    #[inline(never)]
    fn sample_by_square_root<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        let times = |coordinate: i32| i64::from(coordinate) * i64::from(samples.side());
        let (x, y) = (times(self.center.x.to_bits()), times(self.center.y.to_bits()));
        let radius = times(self.radius.to_bits());
        for line in pixels.rows.clone() {
            let dy = i64::from(line) * i64::from(ONE) + i64::from(HALF) - y;
            if dy.abs() >= radius {
                continue;
            }
            // At most 2^35 each.
            let square = u128::from((radius - dy).unsigned_abs()) * u128::from((radius + dy).unsigned_abs()) - 1;
            let reach = u64::try_from(square).map_or_else(|_| square.isqrt(), |square| square.isqrt().into());
            let reach = i64::try_from(reach).unwrap_or(i64::MAX);
            let column = |x: i64| i32::try_from(first_centre_at_or_after_wide(x)).unwrap_or(0);
            let columns = clip_range(&(column(x - reach)..column(x + reach + 1)), &pixels.columns);
            if !columns.is_empty() {
                sampler.span(Span { row: line, columns })?;
            }
        }
        Ok(())
    }
}
