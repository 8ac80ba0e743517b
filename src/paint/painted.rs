//! Shapes in a paint.

use core::convert::Infallible;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    blend::{Blend, right_of},
    coverage::CoverageSink,
    paint::Paint,
    shape::{Cover, Shape},
    span::{Span, SpanSink},
    target::PixelRows,
};

/// Gives every shape a paint.
pub trait Painting: Sized {
    /// The shape in a paint.
    #[inline]
    fn painted<P>(self, paint: P) -> Painted<Self, P> {
        Painted::new(self, paint)
    }
}

impl<S: Shape> Painting for S {}

/// A shape in a paint.
///
/// Draws the pixels of the shape, one `fill_contiguous` for each span; [`draw_on`](Self::draw_on) writes into the rows
/// of a target's memory. [Anti-aliased](Self::antialiased), its edges are blended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Painted<S, P> {
    shape: S,
    paint: P,
}

impl<S: Shape, P> Painted<S, P> {
    /// Draws on any target.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    pub fn draw<D: DrawTarget>(&self, target: &mut D) -> Result<(), D::Error>
    where
        P: Paint<D::Color>,
    {
        let clip = PixelRect::from(target.bounding_box());
        self.shape.spans(&clip, &mut ToTarget { target, paint: &self.paint })
    }

    /// Draws the same pixels into the rows of a target's memory: the paint writes there itself.
    pub fn draw_on<D: PixelRows>(&self, target: &mut D)
    where
        P: Paint<D::Color>,
    {
        let clip = PixelRect::from(target.bounding_box());
        let Ok(()) = self.shape.spans(&clip, &mut IntoRows { target, paint: &self.paint });
    }
}

impl<S, P> Painted<S, P> {
    /// Any shape in a paint, also one that knows its coverage alone, as a
    /// [polygon with areas](crate::Polygon::coverage_in) does.
    #[inline]
    pub const fn new(shape: S, paint: P) -> Self {
        Self { shape, paint }
    }

    /// The same with edges blended by how much of each pixel the shape covers.
    #[inline]
    pub fn antialiased<B>(self, blend: B) -> PaintedAntiAliased<S, P, B>
    where
        S: Cover,
    {
        PaintedAntiAliased { painted: self, blend }
    }
}

impl<S: Shape, P> Dimensions for Painted<S, P> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.shape.bounds().into()
    }
}

struct ToTarget<'t, D, P> {
    target: &'t mut D,
    paint: &'t P,
}

/// A span's area, and how many pixels it has.
fn area_of(span: &Span) -> (Rectangle, usize) {
    let width = span.columns.end.wrapping_sub(span.columns.start).cast_unsigned();
    let area = Rectangle::new(Point::new(span.columns.start, span.row), Size::new(width, 1));
    (area, usize::try_from(width).unwrap_or(usize::MAX))
}

impl<D: DrawTarget, P: Paint<D::Color>> SpanSink for ToTarget<'_, D, P> {
    type Error = D::Error;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), D::Error> {
        let (area, width) = area_of(&span);
        self.target.fill_contiguous(&area, self.paint.row(span.row, span.columns.start).take(width))
    }
}

struct IntoRows<'t, D, P> {
    target: &'t mut D,
    paint: &'t P,
}

impl<D: PixelRows, P: Paint<D::Color>> SpanSink for IntoRows<'_, D, P> {
    type Error = Infallible;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), Infallible> {
        let (area, width) = area_of(&span);
        let row = self.target.row_from(area.top_left).unwrap_or_default();
        for (pixel, colour) in row.iter_mut().take(width).zip(self.paint.row(span.row, span.columns.start)) {
            *pixel = colour;
        }
        Ok(())
    }
}

/// A shape in a paint, with blended edges.
///
/// Pixels that are wholly covered have the paint's colour, a `fill_contiguous` for each run of them; the others go to the
/// [`Blend`] one by one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PaintedAntiAliased<S, P, B> {
    painted: Painted<S, P>,
    blend: B,
}

impl<S: Cover, P, B> PaintedAntiAliased<S, P, B> {
    /// Draws on any target that the blending can use.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    pub fn draw_on<D: DrawTarget>(&self, target: &mut D) -> Result<(), D::Error>
    where
        P: Paint<D::Color>,
        B: Blend<D>,
    {
        let clip = PixelRect::from(target.bounding_box());
        let Self { painted: Painted { shape, paint }, blend } = self;
        shape.coverage(&clip, &mut Blended { target, paint, blend: *blend })
    }
}

struct Blended<'t, D, P, B> {
    target: &'t mut D,
    paint: &'t P,
    blend: B,
}

impl<D: DrawTarget, P: Paint<D::Color>, B: Blend<D>> CoverageSink for Blended<'_, D, P, B> {
    type Error = D::Error;

    #[inline]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), D::Error> {
        let (area, width) = area_of(&span);
        let colours = self.paint.row(span.row, span.columns.start).take(width);
        if coverage == 255 {
            return self.target.fill_contiguous(&area, colours);
        }
        let mut at = area.top_left;
        for colour in colours {
            self.blend.run(self.target, at, colour, &[coverage])?;
            at = right_of(at, 1);
        }
        Ok(())
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), D::Error> {
        let mut at = Point::new(column, row);
        for (colour, coverage) in self.paint.row(row, column).zip(coverage) {
            self.blend.run(self.target, at, colour, &[*coverage])?;
            at = right_of(at, 1);
        }
        Ok(())
    }
}
