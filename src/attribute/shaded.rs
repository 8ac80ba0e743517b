//! Interpolated values to colours on a target.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    Fragment, FragmentSink, PixelRect, Triangle,
    attribute::{AttributeRow, AttributeSink, DepthBuffer, DepthTest},
    blend::PIECE,
    shape::Shape as _,
    span::Span,
    target::PixelRows,
};

/// A triangle with values that vary across it: [`Affine`](crate::Affine) or [`Perspective`](crate::Perspective).
pub trait Attributes<const N: usize>: Sized {
    /// Where it is.
    fn triangle(&self) -> &Triangle;

    /// Pushes the spans inside `clip`, with their values.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    fn interpolate<S: AttributeSink<N>>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error>;

    /// The same with a depth at each vertex, which varies linearly over the screen.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    fn interpolate_with_depth<S: AttributeSink<N>>(
        &self,
        depths: [u16; 3],
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error>;

    /// Pushes a fragment for each pixel inside `clip`: covered by 255, of depth 0.
    ///
    /// # Errors
    ///
    /// The sink's, at once.
    #[inline]
    fn fragments<S: FragmentSink<N>>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.interpolate(clip, &mut EachFragment(sink))
    }

    /// The triangle with a colour that `shade` makes of each pixel's values.
    #[inline]
    fn shaded<C: PixelColor, F: Fn([i32; N]) -> C + Copy>(self, shade: F) -> Shaded<Self, F> {
        Shaded { attributes: self, shade }
    }
}

struct EachFragment<'s, S>(&'s mut S);

impl<S: FragmentSink<N>, const N: usize> AttributeSink<N> for EachFragment<'_, S> {
    type Error = S::Error;

    #[inline]
    fn span(
        &mut self,
        span: Span,
        values: impl AttributeRow<N>,
        depths: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), S::Error> {
        let Span { row: y, columns } = span;
        for (x, (attributes, depth)) in columns.zip(values.zip(depths)) {
            self.0.fragment(Fragment { x, y, coverage: 255, depth, attributes })?;
        }
        Ok(())
    }
}

/// A triangle with a colour made of what varies across it.
///
/// On any target it is an embedded-graphics `Drawable`: one `fill_contiguous` for each row. On a target with
/// [`PixelRows`], [`draw_on`](Self::draw_on) writes into the rows. Nothing outside the target's bounding box is sent,
/// or computed.
#[derive(Debug, Clone, Copy)]
pub struct Shaded<A, F> {
    attributes: A,
    shade: F,
}

impl<A, F> Shaded<A, F> {
    /// Draws into the rows of a target's memory: the same pixels, in less time.
    pub fn draw_on<D, const N: usize>(&self, target: &mut D)
    where
        D: PixelRows,
        A: Attributes<N>,
        F: Fn([i32; N]) -> D::Color + Copy,
    {
        let clip = PixelRect::from(target.bounding_box());
        let Ok(()) = self.attributes.interpolate(&clip, &mut IntoRows { target, shade: self.shade });
    }

    /// With a depth at each vertex, 0 in front: to be tested against a buffer.
    #[inline]
    pub const fn depth_tested(self, depths: [u16; 3], test: DepthTest) -> DepthTested<A, F> {
        DepthTested { shaded: self, depths, test }
    }

    /// Draws on any target.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    pub fn draw<D, const N: usize>(&self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget,
        A: Attributes<N>,
        F: Fn([i32; N]) -> D::Color + Copy,
    {
        let clip = PixelRect::from(target.bounding_box());
        self.attributes.interpolate(&clip, &mut ToTarget { target, shade: self.shade })
    }
}

pub(crate) fn row_area(span: &Span) -> Rectangle {
    let width = span.columns.end.wrapping_sub(span.columns.start).cast_unsigned();
    Rectangle::new(Point::new(span.columns.start, span.row), Size::new(width, 1))
}

struct ToTarget<'t, D, F> {
    target: &'t mut D,
    shade: F,
}

impl<D: DrawTarget, F: Fn([i32; N]) -> D::Color + Copy, const N: usize> AttributeSink<N> for ToTarget<'_, D, F> {
    type Error = D::Error;

    #[inline]
    fn span(
        &mut self,
        span: Span,
        values: impl AttributeRow<N>,
        _: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), D::Error> {
        let area = row_area(&span);
        let width = usize::try_from(area.size.width).unwrap_or(usize::MAX);
        self.target.fill_contiguous(&area, values.map(self.shade).take(width))
    }
}

/// What of a target's row a span is.
#[inline(always)]
pub(crate) fn row_of<'t, D: PixelRows>(target: &'t mut D, span: &Span) -> &'t mut [D::Color] {
    let width = span.columns.end.wrapping_sub(span.columns.start).cast_unsigned();
    let row = target.row_from(Point::new(span.columns.start, span.row)).unwrap_or_default();
    let width = usize::try_from(width).unwrap_or(usize::MAX).min(row.len());
    row.get_mut(..width).unwrap_or_default()
}

struct IntoRows<'t, D, F> {
    target: &'t mut D,
    shade: F,
}

impl<D: PixelRows, F: Fn([i32; N]) -> D::Color + Copy, const N: usize> AttributeSink<N> for IntoRows<'_, D, F> {
    type Error = core::convert::Infallible;

    #[inline]
    fn span(
        &mut self,
        span: Span,
        mut values: impl AttributeRow<N>,
        _: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), core::convert::Infallible> {
        let shade = self.shade;
        values.write(row_of(self.target, &span), move |pixel, values| *pixel = shade(values));
        Ok(())
    }
}

/// A [`Shaded`] triangle of which only what is in front is drawn.
#[derive(Debug, Clone, Copy)]
pub struct DepthTested<A, F> {
    shaded: Shaded<A, F>,
    depths: [u16; 3],
    test: DepthTest,
}

impl<A, F> DepthTested<A, F> {
    /// Draws on any target what passes the test, cut to what the buffer knows the depth of.
    ///
    /// # Errors
    ///
    /// The target's, at once.
    pub fn draw<D, const N: usize>(&self, target: &mut D, buffer: &mut DepthBuffer<'_>) -> Result<(), D::Error>
    where
        D: DrawTarget,
        A: Attributes<N>,
        F: Fn([i32; N]) -> D::Color + Copy,
    {
        let clip = buffer.cut(target.bounding_box());
        let mut sink = TestedToTarget { target, buffer, shade: self.shaded.shade, test: self.test };
        self.shaded.attributes.interpolate_with_depth(self.depths, &clip, &mut sink)
    }

    /// Draws the same into the rows of a target's memory.
    pub fn draw_on<D, const N: usize>(&self, target: &mut D, buffer: &mut DepthBuffer<'_>)
    where
        D: PixelRows,
        A: Attributes<N>,
        F: Fn([i32; N]) -> D::Color + Copy,
    {
        let clip = buffer.cut(target.bounding_box());
        let Self { shaded: Shaded { attributes, shade }, depths, test } = self;
        let (depths, shade) = (*depths, *shade);
        let Ok(()) = match *test {
            // The loop knows its test: less is by far the most usual one.
            DepthTest { less: true, equal: false, write: true } => {
                let passes = |depth: u16, kept: &mut u16| {
                    let passes = depth < *kept;
                    *kept = depth.min(*kept);
                    passes
                };
                attributes.interpolate_with_depth(depths, &clip, &mut TestedIntoRows { target, buffer, shade, passes })
            }
            test => {
                let passes = move |depth: u16, kept: &mut u16| test.passes(depth, kept);
                attributes.interpolate_with_depth(depths, &clip, &mut TestedIntoRows { target, buffer, shade, passes })
            }
        };
    }
}

struct TestedIntoRows<'t, 'b, D, F, P> {
    target: &'t mut D,
    buffer: &'t mut DepthBuffer<'b>,
    shade: F,
    /// Whether a depth passes beside the one that is kept, which it may change.
    passes: P,
}

impl<D, F, P, const N: usize> AttributeSink<N> for TestedIntoRows<'_, '_, D, F, P>
where
    D: PixelRows,
    F: Fn([i32; N]) -> D::Color + Copy,
    P: Fn(u16, &mut u16) -> bool + Copy,
{
    type Error = core::convert::Infallible;

    #[inline]
    fn span(
        &mut self,
        span: Span,
        mut values: impl AttributeRow<N>,
        mut depths: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), core::convert::Infallible> {
        let Self { ref mut target, ref mut buffer, shade, passes } = *self;
        let mut kept = buffer.row_mut(&span);
        let mut row = row_of(*target, &span);
        while let Some((now, later)) = kept.split_at_mut_checked(kept.len().min(32)) {
            let Some((pixels, after)) = row.split_at_mut_checked(now.len()) else { break };
            let mut passed = test_pixels(now, &mut depths, passes);
            // Nothing is worked out for the end of a row that is hidden.
            if pixels.is_empty() || passed == 0 && after.is_empty() {
                break;
            }
            values.write(pixels, move |pixel, values| {
                if passed & 1 != 0 {
                    *pixel = shade(values);
                }
                passed >>= 1;
            });
            (kept, row) = (later, after);
        }
        Ok(())
    }
}

/// Which of up to 32 pixels pass, a bit each. Depths and colours each have a loop, and so enough registers.
#[inline(never)]
fn test_pixels<I: Iterator<Item = u16> + Clone>(
    kept: &mut [u16],
    depths: &mut I,
    passes: impl Fn(u16, &mut u16) -> bool,
) -> u32 {
    // In registers, not where they came from.
    let mut next = depths.clone();
    let mut passed = 0;
    for (kept, bit) in kept.iter_mut().zip(0_u32..) {
        let Some(depth) = next.next() else { break };
        passed |= u32::from(passes(depth, kept)).wrapping_shl(bit);
    }
    *depths = next;
    passed
}

struct TestedToTarget<'t, 'b, D, F> {
    target: &'t mut D,
    buffer: &'t mut DepthBuffer<'b>,
    shade: F,
    test: DepthTest,
}

impl<D: DrawTarget, F: Fn([i32; N]) -> D::Color + Copy, const N: usize> AttributeSink<N>
    for TestedToTarget<'_, '_, D, F>
{
    type Error = D::Error;

    /// Passing pixels go to the target in runs of at most `PIECE`.
    #[inline]
    fn span(
        &mut self,
        span: Span,
        values: impl AttributeRow<N>,
        depths: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), D::Error> {
        let Span { row, columns } = span.clone();
        let mut run = heapless::Vec::<D::Color, PIECE>::new();
        let kept = self.buffer.row_mut(&span);
        let mut end = columns.start;
        for ((column, kept), (values, depth)) in columns.zip(kept).zip(values.zip(depths)) {
            let passes = self.test.passes(depth, kept);
            if !passes || run.is_full() {
                send_run(self.target, row, end, &mut run)?;
            }
            if passes {
                let _ = run.push((self.shade)(values));
                end = column.wrapping_add(1);
            }
        }
        send_run(self.target, row, end, &mut run)
    }
}

/// Sends the pixels before column `end`, of which there may be none.
fn send_run<D: DrawTarget>(
    target: &mut D,
    row: i32,
    end: i32,
    run: &mut heapless::Vec<D::Color, PIECE>,
) -> Result<(), D::Error> {
    let Ok(length @ 1..) = i32::try_from(run.len()) else { return Ok(()) };
    let area = row_area(&Span { row, columns: end.wrapping_sub(length)..end });
    target.fill_contiguous(&area, run.iter().copied())?;
    run.clear();
    Ok(())
}

impl<A, F> Shaded<A, F> {
    /// The rectangle that has all pixels of it.
    #[inline]
    pub fn bounding_box<const N: usize>(&self) -> Rectangle
    where
        A: Attributes<N>,
    {
        self.attributes.triangle().bounds().into()
    }
}
