//! Vertices in sub-pixels and rectangles in whole pixels.

use core::ops::Range;

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use fixed::{traits::ToFixed, types::I24F8};

use crate::limits::{NARROW_REACH, ONE, SUBPIXEL_BITS};

/// A point of an outline, in 1/256 pixel.
///
/// (0, 0) is the top-left corner of the top-left pixel, y grows downwards, pixel centres lie at half integers. Every
/// bit pattern is a legal coordinate: -8388608 to 8388607.996 pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Vertex {
    /// Pixels to the right of the left edge of column 0.
    pub x: I24F8,
    /// Pixels below the top edge of row 0.
    pub y: I24F8,
}

impl Vertex {
    /// A vertex from anything `fixed` converts: integers, floats, other fixed-point numbers.
    ///
    /// What lies beyond the range saturates to its end; a float goes to the nearest 1/256; NaN is 0.
    #[inline]
    pub fn new<X, Y>(x: X, y: Y) -> Self
    where
        X: ToFixed + Copy,
        Y: ToFixed + Copy,
        I24F8: PartialOrd<X> + PartialOrd<Y>,
    {
        Self { x: saturate(x), y: saturate(y) }
    }

    /// A vertex from sub-pixel bits: 256 to the pixel.
    #[inline]
    pub const fn from_bits(x: i32, y: i32) -> Self {
        Self { x: I24F8::from_bits(x), y: I24F8::from_bits(y) }
    }

    /// The centre of pixel (x, y); saturating. The `const` form of `Vertex::from(Point::new(x, y))`.
    #[inline]
    pub const fn pixel(x: i32, y: i32) -> Self {
        Self::from_bits(x.saturating_mul(256).saturating_add(128), y.saturating_mul(256).saturating_add(128))
    }
}

/// The upper of two vertices and the lower, without a jump: one here would be mispredicted every other time.
#[inline(always)]
pub(crate) fn by_height(a: Vertex, b: Vertex) -> (Vertex, Vertex) {
    let swap = (a.x.to_bits() ^ b.x.to_bits()) & -i32::from(a.y > b.y);
    let upper = Vertex::from_bits(a.x.to_bits() ^ swap, a.y.min(b.y).to_bits());
    let lower = Vertex::from_bits(b.x.to_bits() ^ swap, a.y.max(b.y).to_bits());
    (upper, lower)
}

impl From<Point> for Vertex {
    #[inline]
    fn from(point: Point) -> Self {
        Self::pixel(point.x, point.y)
    }
}

/// The nearest coordinate; NaN is 0. Of `fixed`'s conversions, only the checked one never panics.
#[inline]
pub(crate) fn saturate<T: ToFixed + Copy>(value: T) -> I24F8
where
    I24F8: PartialOrd<T>,
{
    match value.checked_to_fixed() {
        Some(coordinate) => coordinate,
        None if I24F8::ZERO < value => I24F8::MAX,
        None if I24F8::ZERO > value => I24F8::MIN,
        None => I24F8::ZERO,
    }
}

/// A rectangle of whole pixels, half-open.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct PixelRect {
    /// The rows.
    pub rows: Range<i32>,
    /// The columns.
    pub columns: Range<i32>,
}

impl PixelRect {
    /// What of it lies in the narrow zone, in sub-pixels: rows, columns. See `limits::NARROW_REACH`.
    #[inline]
    pub(crate) fn narrow(&self) -> (Range<i32>, Range<i32>) {
        const REACH_PX: i32 = NARROW_REACH >> SUBPIXEL_BITS;
        let narrow = |range: &Range<i32>| {
            let subpixels = |pixel: i32| pixel.clamp(-REACH_PX, REACH_PX) << SUBPIXEL_BITS;
            subpixels(range.start)..subpixels(range.end)
        };
        (narrow(&self.rows), narrow(&self.columns))
    }
}

/// The pixels that have anything in common with the bounding box of vertices.
pub(crate) fn touched<'a>(vertices: impl Iterator<Item = &'a Vertex>) -> PixelRect {
    let mut low = (i32::MAX, i32::MAX);
    let mut high = (i32::MIN, i32::MIN);
    for vertex in vertices {
        let (x, y) = (vertex.x.to_bits(), vertex.y.to_bits());
        low = (low.0.min(x), low.1.min(y));
        high = (high.0.max(x), high.1.max(y));
    }
    if low.0 >= high.0 || low.1 >= high.1 {
        return PixelRect { rows: 0..0, columns: 0..0 };
    }
    let pixels = |low: i32, high: i32| low >> SUBPIXEL_BITS..((high - 1) >> SUBPIXEL_BITS) + 1;
    PixelRect { rows: pixels(low.1, high.1), columns: pixels(low.0, high.0) }
}

/// The pixels between two places that may be beyond the range of coordinates, along either axis, as far as they are inside it.
#[inline]
pub(crate) fn pixels_between(low: i64, high: i64) -> Range<i32> {
    let pixel = |position: i64| {
        let one = i64::from(ONE);
        let clamped = position.clamp(i64::from(i32::MIN), i64::from(i32::MAX) + 1);
        #[allow(clippy::cast_possible_truncation, reason = "a coordinate, less eight bits")]
        let pixel = clamped.div_euclid(one) as i32;
        pixel
    };
    pixel(low)..pixel(high + i64::from(ONE) - 1)
}

impl From<Rectangle> for PixelRect {
    #[inline]
    fn from(rectangle: Rectangle) -> Self {
        let Rectangle { top_left, size } = rectangle;
        Self {
            rows: top_left.y..top_left.y.saturating_add_unsigned(size.height),
            columns: top_left.x..top_left.x.saturating_add_unsigned(size.width),
        }
    }
}

impl From<PixelRect> for Rectangle {
    #[inline]
    fn from(rect: PixelRect) -> Self {
        if rect.rows.is_empty() || rect.columns.is_empty() {
            return Self::new(Point::new(rect.columns.start, rect.rows.start), Size::zero());
        }
        Self::new(
            Point::new(rect.columns.start, rect.rows.start),
            Size::new(rect.columns.end.abs_diff(rect.columns.start), rect.rows.end.abs_diff(rect.rows.start)),
        )
    }
}
