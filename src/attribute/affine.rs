//! Attributes that are planes over the screen.

use core::iter::repeat;

use crate::{
    PixelRect, Triangle,
    attribute::{
        AttributeRow, AttributeSink, Attributes,
        plane::{Planes, Rightwards},
        walk::{Oriented, walk},
        word::Word,
    },
};

/// A triangle with `N` attributes that vary linearly over the screen.
///
/// The vertices' values may be any `i32`, in any unit; so may the coordinates. The value at a pixel centre is the exact
/// one, rounded to the nearest whole unit (halves upwards), and so never outside the range of the three values.
/// Triangles that share an edge and its values agree along it. The pixels are those of [`Triangle`].
///
/// ```text
///    0 *
///      | \                  1
///      |   \       gives    2 3
///      |     \              3 4 5
///    5 *-------* 10         4 5 6 7
/// ```
///
/// A triangle without area has no pixels. There are no errors but the sink's.
///
/// # Cost
///
/// Three divisions for each attribute, by 32 bits where numbers are small, and by 64 where not. Then four instructions
/// for each attribute and pixel, in words of 32 bits up to a doubled area of 2^32 (256 x 256 px), in words of 64 bits
/// beyond. No scratch.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{Affine, Triangle, prelude::*};
///
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(5, 5), Point::new(0, 5));
/// let ramp = Affine::new(triangle, [[0], [10], [5]]);
/// let mut display = MockDisplay::new();
/// ramp.shaded(|[grey]| Gray4::new(grey as u8)).draw(&mut display)?;
/// display.assert_pattern(&["    ", "1   ", "23  ", "345 ", "4567"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Affine<const N: usize> {
    /// Where it is.
    pub triangle: Triangle,
    /// The values of each vertex.
    pub values: [[i32; N]; 3],
}

impl<const N: usize> Affine<N> {
    /// A triangle with the values of each of its vertices.
    #[inline]
    pub const fn new(triangle: Triangle, values: [[i32; N]; 3]) -> Self {
        Self { triangle, values }
    }
}

impl Affine<3> {
    /// A triangle with its barycentric weights in 1/65536: how near a centre is to each vertex.
    ///
    /// Each is the nearest to the exact one, so the three may add up to one more or less than 65536.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
    /// use spanfill::{Affine, Triangle, prelude::*};
    ///
    /// let triangle = Triangle::new(Point::new(0, 0), Point::new(8, 8), Point::new(0, 8));
    /// let mut display = MockDisplay::new();
    /// // What is nearer than half to the first vertex.
    /// Affine::weights(triangle).shaded(|[a, _, _]| BinaryColor::from(a > 32768)).draw(&mut display)?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[inline]
    pub const fn weights(triangle: Triangle) -> Self {
        Self::new(triangle, [[1 << 16, 0, 0], [0, 1 << 16, 0], [0, 0, 1 << 16]])
    }
}

impl<W: Word, const N: usize> AttributeRow<N> for Rightwards<'_, W, N> {
    /// Out of line: within a walk, its registers would be taken.
    #[inline(never)]
    fn write<T>(&mut self, into: &mut [T], mut write: impl FnMut(&mut T, [i32; N])) {
        let mut values = self.clone();
        for item in into {
            let Some(values) = values.next() else { return };
            write(item, values);
        }
        *self = values;
    }
}

/// A depth that an exact interpolation of 16 bits gave.
#[inline(always)]
pub(crate) fn depth([depth]: [i32; 1]) -> u16 {
    let [low, high, ..] = depth.to_le_bytes();
    u16::from_le_bytes([low, high])
}

impl<const N: usize> Attributes<N> for Affine<N> {
    #[inline]
    fn triangle(&self) -> &Triangle {
        &self.triangle
    }

    #[inline]
    fn interpolate<S: AttributeSink<N>>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        match oriented.narrow(&self.values) {
            Some(area) => self.rows(&oriented, area, clip, sink),
            None => self.rows(&oriented, oriented.area, clip, sink),
        }
    }

    #[inline]
    fn interpolate_with_depth<S: AttributeSink<N>>(
        &self,
        depths: [u16; 3],
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        match oriented.narrow(&self.values) {
            Some(area) => self.rows_with_depth(&oriented, area, depths, clip, sink),
            None => self.rows_with_depth(&oriented, oriented.area, depths, clip, sink),
        }
    }
}

impl<const N: usize> Affine<N> {
    #[inline]
    fn rows<W: Word, S: AttributeSink<N>>(
        &self,
        oriented: &Oriented,
        area: W,
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let mut planes = Planes::new(&oriented.vertices, &oriented.ordered(&self.values), area);
        walk(&self.triangle, clip, &mut planes, |span, planes| sink.span(span, planes.to_the_right(), repeat(0)))
    }

    #[inline]
    fn rows_with_depth<W: Word, S: AttributeSink<N>>(
        &self,
        oriented: &Oriented,
        area: W,
        depths: [u16; 3],
        clip: &PixelRect,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let depths = oriented.ordered(&depths).map(|depth| [i32::from(depth)]);
        let values = Planes::new(&oriented.vertices, &oriented.ordered(&self.values), area);
        let mut planes = (values, Planes::new(&oriented.vertices, &depths, area));
        walk(&self.triangle, clip, &mut planes, |span, (values, depths)| {
            sink.span(span, values.to_the_right(), depths.to_the_right().map(depth))
        })
    }
}
