//! Filled circle: every centre nearer than the radius, by comparing squares.

mod areas;

use core::ops::Range;

use fixed::{traits::ToFixed, types::I24F8};

use crate::{
    PixelRect, Vertex,
    geometry::saturate,
    limits::{HALF, NARROW_REACH, ONE, STEPPED_RADIUS, SUBPIXEL_BITS},
    shape::Shape,
    span::{BlockSink, OpenBlock, SpanSink, SplitRows, clip_range},
    subpixel::{first_centre_at_or_after, first_centre_at_or_after_wide, pixel_holding},
};

/// A filled circle with its centre and radius in 1/256 pixel.
///
/// Every centre and radius is legal; one of zero or less draws nothing. A pixel belongs to the circle when its centre
/// is nearer to the circle's than the radius, exactly.
///
/// [Anti-aliased](crate::AntiAlias::antialiased), a pixel is covered by the area of the circle within it: off by at
/// most 0.1 of 1/255 before it is rounded to 255ths.
///
/// ```text
///     . # # # .
///     # # # # #        radius 2.5 around a pixel's centre:
///     # # + # #        dx^2 + dy^2 < 6.25
///     # # # # #
///     . # # # .
/// ```
///
/// # Cost
///
/// No division and no square root up to a radius of 2048 pixels (one square root where the top is cut off): additions
/// for each row, and for each column the outline moves. Larger circles take a 64-bit square root a visible row. No
/// scratch.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Circle, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Circle::new(Point::new(2, 2), 2.5).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&[" ### ", "#####", "#####", "#####", " ### "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// With anti-aliasing:
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// # use spanfill::{Over, Circle, prelude::*};
/// # let circle = Circle::new(Point::new(2, 2), 2.5);
/// # let mut display = MockDisplay::new();
/// circle.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Circle {
    /// The centre.
    pub center: Vertex,
    /// The radius, in pixels.
    pub radius: I24F8,
}

impl Circle {
    /// A circle from its centre and radius; a radius beyond the range saturates, NaN is 0.
    #[inline]
    pub fn new<R>(center: impl Into<Vertex>, radius: R) -> Self
    where
        R: ToFixed + Copy,
        I24F8: PartialOrd<R>,
    {
        Self { center: center.into(), radius: saturate(radius) }
    }

    /// A circle from its centre and its radius in sub-pixel bits, in a constant too.
    #[inline]
    pub const fn from_bits(center: Vertex, radius: i32) -> Self {
        Self { center, radius: I24F8::from_bits(radius) }
    }

    /// The pixels along one axis whose centres are within `reach` of the circle's centre at `middle`.
    #[inline]
    fn centres_within(middle: i32, reach: i64) -> Range<i32> {
        let middle = i64::from(middle);
        let first = first_centre_at_or_after_wide(middle - reach);
        let end = first_centre_at_or_after_wide(middle + reach + 1);
        // At most 2^24 pixels from the origin.
        #[allow(clippy::cast_possible_truncation, reason = "|middle +- reach| <= 2^32, so pixels are below 2^25")]
        let range = first as i32..end as i32;
        range
    }
}

impl Shape for Circle {
    #[inline]
    fn bounds(&self) -> PixelRect {
        let reach = i64::from(self.radius.to_bits()) - 1;
        PixelRect {
            rows: Self::centres_within(self.center.y.to_bits(), reach),
            columns: Self::centres_within(self.center.x.to_bits(), reach),
        }
    }

    #[inline]
    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.blocks(clip, &mut SplitRows(sink))
    }

    #[inline]
    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let (x, y, radius) = (self.center.x.to_bits(), self.center.y.to_bits(), self.radius.to_bits());
        let (rows, columns) = clip.narrow();
        let is_whole = radius > 0
            && radius <= STEPPED_RADIUS
            && y.wrapping_sub(rows.start) >= radius
            && rows.end.wrapping_sub(y) >= radius
            && x.wrapping_sub(columns.start) >= radius
            && columns.end.wrapping_sub(x) >= radius
            && y.unsigned_abs() <= NARROW_REACH.unsigned_abs()
            && x.unsigned_abs() <= NARROW_REACH.unsigned_abs();
        if is_whole {
            let rows = first_centre_at_or_after(y - radius + 1)..first_centre_at_or_after(y + radius);
            // A centre in the middle of a column or between two: the usual ones, and twice as cheap.
            if x & (HALF - 1) == 0 {
                self.by_steps::<S, true>(rows, None, sink)
            } else {
                self.by_steps::<S, false>(rows, None, sink)
            }
        } else {
            self.cut(clip, sink)
        }
    }
}

/// One end of the row's span: the first column outside, counted away from the column that holds the centre.
///
/// `value` is negative where that column is inside. The second difference along a row is constant.
#[derive(Debug, Clone, Copy)]
struct End {
    columns: i32,
    value: i32,
    step: i32,
}

impl End {
    /// `columns` away from the centre, whose own column has `value` there; `offset` is how far the column's centre
    /// lies ahead of the circle's.
    #[inline]
    fn at(columns: i32, value: i32, offset: i32) -> Self {
        Self { columns, value: value + columns * (HALF * columns + offset), step: HALF * (2 * columns + 1) + offset }
    }

    #[inline(always)]
    fn grow(&mut self) {
        while self.value < 0 {
            self.value += self.step;
            self.step += ONE;
            self.columns += 1;
        }
    }

    /// Only on a row where the centre's own column is inside.
    #[inline(always)]
    fn shrink(&mut self) {
        loop {
            let step = self.step - ONE;
            let value = self.value - step;
            if value < 0 {
                return;
            }
            (self.step, self.value) = (step, value);
            self.columns -= 1;
        }
    }
}

impl Circle {
    /// What the clip leaves of it, of any size.
    #[inline(never)]
    fn cut<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let rows = clip_range(&self.bounds().rows, &clip.rows);
        if rows.is_empty() || self.radius <= 0 {
            Ok(())
        } else if self.radius.to_bits() <= STEPPED_RADIUS {
            self.by_steps::<S, false>(rows, Some(&clip.columns), sink)
        } else {
            self.by_square_root(rows, &clip.columns, sink)
        }
    }

    /// The midpoint circle, for a centre anywhere in a pixel.
    ///
    /// With local columns `c` and rows `r` (0 holds the centre) and `a`, `b` from the circle's centre to that pixel's,
    /// `F(c, r) = (256 c + a)^2 + (256 r + b)^2 - R^2` is negative inside. All its differences are multiples of 512, so
    /// `F` modulo 512 is one constant, and `floor(F / 512)` has the same sign:
    /// `128 c^2 + c a + 128 r^2 + r b + floor((a^2 + b^2 - R^2) / 512)`. It fits `i32` (`limits::STEPPED_RADIUS`), and
    /// moving a pixel adds a first difference that itself grows by 256 (J. E. Bresenham, "A linear algorithm for
    /// incremental digital display of circular arcs", 1977).
    #[inline(always)]
    fn by_steps<S: BlockSink, const IS_MIRRORED: bool>(
        &self,
        mut rows: Range<i32>,
        clip: Option<&Range<i32>>,
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let (x, y, radius) = (self.center.x.to_bits(), self.center.y.to_bits(), self.radius.to_bits());
        let (column, row) = (pixel_holding(x), pixel_holding(y));
        let (a, b) = (HALF - (x & (ONE - 1)), HALF - (y & (ONE - 1)));
        let constant = {
            let (a, b, radius) = (i64::from(a), i64::from(b), i64::from(radius));
            #[allow(clippy::cast_possible_truncation, reason = "R^2 / 512 <= 2^29")]
            let constant = ((a * a + b * b - radius * radius) >> 9) as i32;
            constant
        };
        // F / 512 in the centre's own column, which is inside wherever any is.
        let middle = |local: i32| constant + local * (HALF * local + b);
        // Rows are 256 apart, and of those nearer than R only the last 128 at either end miss that column's centre.
        rows.start += i32::from(middle(rows.start - row) >= 0);
        rows.end -= i32::from(middle(rows.end - 1 - row) >= 0);
        if rows.is_empty() {
            return Ok(());
        }
        let mut local = rows.start - row;
        let value = middle(local);
        let mut down = HALF * (2 * local + 1) + b;
        let mut left = End::at(1, value, -a);
        let mut right = End::at(0, value, a);
        if clip.is_some() {
            let reach = half_width(radius, ONE * local + b);
            left = End::at(((reach + a) >> SUBPIXEL_BITS) + 1, value, -a);
            right = End::at(((reach - a) >> SUBPIXEL_BITS) + 1, value, a);
        }
        let mut block = OpenBlock::new();
        let end = rows.end;
        let on_boundary = i32::from(a == HALF);
        let mut emit = |row: i32, left: &End, right: &End| {
            let to_left = if IS_MIRRORED { right.columns + on_boundary } else { left.columns };
            let columns = column + 1 - to_left..column + right.columns;
            block.row(row, clip.map_or(columns.clone(), |clip| clip_range(&columns, clip)), sink)
        };
        while rows.start < end && local <= 0 {
            right.grow();
            if !IS_MIRRORED {
                left.grow();
            }
            emit(rows.start, &left, &right)?;
            left.value += down;
            right.value += down;
            down += ONE;
            local += 1;
            rows.start += 1;
        }
        while rows.start < end {
            right.shrink();
            if !IS_MIRRORED {
                left.shrink();
            }
            emit(rows.start, &left, &right)?;
            left.value += down;
            right.value += down;
            down += ONE;
            rows.start += 1;
        }
        block.finish(end, sink)
    }

    /// For radii whose squares leave `i32`: `(R - dy)(R + dy)` fits 64 bits for every radius.
    #[inline(never)]
    fn by_square_root<S: BlockSink>(&self, rows: Range<i32>, clip: &Range<i32>, sink: &mut S) -> Result<(), S::Error> {
        let (y, radius) = (i64::from(self.center.y.to_bits()), i64::from(self.radius.to_bits()));
        let mut block = OpenBlock::new();
        let end = rows.end;
        for row in rows {
            let dy = i64::from(row) * i64::from(ONE) + i64::from(HALF) - y;
            // Positive: the row is inside the bounds.
            let square = ((radius - dy) * (radius + dy)).cast_unsigned();
            let reach = square.saturating_sub(1).isqrt().cast_signed();
            let columns = Self::centres_within(self.center.x.to_bits(), reach);
            block.row(row, clip_range(&columns, clip), sink)?;
        }
        block.finish(end, sink)
    }
}

/// The largest whole distance along a row, `dy` from the centre, that is nearer than `radius`.
#[inline]
fn half_width(radius: i32, dy: i32) -> i32 {
    let (radius, dy) = (i64::from(radius), i64::from(dy));
    let square = ((radius - dy) * (radius + dy)).cast_unsigned();
    #[allow(clippy::cast_possible_truncation, reason = "at most the radius")]
    let reach = square.saturating_sub(1).isqrt() as i32;
    reach
}
