//! How much of each pixel a shape covers, before that is rounded to 8 bits.

use core::{convert::Infallible, ops::Range};

use crate::{
    PixelRect,
    area::{self, PlacedAreaSink},
    coverage::CoverageSink,
    shape::{Circle, Cover, Line, PolygonCoverageIn, PolygonCoverageWith, Triangle},
    span::Span,
};

/// A whole pixel, in units of areas.
pub(super) const WHOLE: u32 = 1 << 24;

/// Receives how much of each pixel a shape covers, in `2^-24` of it.
pub trait AreaSink {
    /// Takes the pixels of a span, which are all covered alike.
    fn alike(&mut self, span: Span, area: u32);

    /// Takes the pixels of `row` from `column` on, one for each of the areas.
    fn areas(&mut self, row: i32, column: i32, areas: impl Iterator<Item = u32>);
}

/// A shape that can tell how much of each pixel it covers, before that is rounded to 8 bits.
pub trait Areas {
    /// How far an area may be off, in `2^-24` of a pixel.
    const ERROR: u32;

    /// A rectangle outside which the shape covers nothing of any pixel.
    fn touched(&self) -> PixelRect;

    /// Pushes the areas of the pixels inside `clip`, each pixel at most once.
    fn push_areas(&self, clip: &PixelRect, sink: &mut impl AreaSink);
}

/// 1/64 of a 255th: what ten edges of 8192 px can be off together, or four crossings.
const EXACT: u32 = WHOLE / (255 * 64);

struct FromAreas<'s, S> {
    sink: &'s mut S,
    corner: (i32, i32),
}

/// What is off the range by the arithmetic goes back into it.
#[inline(always)]
fn in_range(area: i32) -> u32 {
    area.clamp(0, WHOLE.cast_signed()).cast_unsigned()
}

impl<S: AreaSink> area::AreaSink for FromAreas<'_, S> {
    fn span(&mut self, row: i32, columns: Range<i32>, area: i32) -> bool {
        let (x, y) = self.corner;
        let columns = x.wrapping_add(columns.start)..x.wrapping_add(columns.end);
        if area > 0 {
            self.sink.alike(Span { row: y.wrapping_add(row), columns }, in_range(area));
        }
        true
    }

    fn run(&mut self, row: i32, column: i32, areas: &[i32]) -> bool {
        let (x, y) = self.corner;
        let areas = areas.iter().map(|area| in_range(*area));
        self.sink.areas(y.wrapping_add(row), x.wrapping_add(column), areas);
        true
    }
}

impl<S: AreaSink> PlacedAreaSink for FromAreas<'_, S> {
    fn place(&mut self, corner: (i32, i32)) {
        self.corner = corner;
    }
}

macro_rules! by_areas {
    ($($error:expr => [$($generic:tt)*] $shape:ty;)+) => {
        $(impl<$($generic)*> Areas for $shape {
            const ERROR: u32 = $error;

            fn touched(&self) -> PixelRect {
                Cover::touched(self)
            }

            fn push_areas(&self, clip: &PixelRect, sink: &mut impl AreaSink) {
                self.areas(clip, &mut FromAreas { sink, corner: (0, 0) });
            }
        })+
    };
}

/// 0.1 of a 255th.
const OF_CIRCLE: u32 = WHOLE / (255 * 10);

by_areas! {
    EXACT => [] Triangle;
    EXACT => [] Line;
    OF_CIRCLE => [] Circle;
    EXACT => ['a, 's] PolygonCoverageIn<'a, 's>;
    EXACT => ['a, const EDGES: usize] PolygonCoverageWith<'a, EDGES>;
}

/// Any [`Cover`] by its coverage in 255ths.
///
/// Within a partition the sum is still exactly 255; along the rim of the union, coverage is that of the union within
/// 3/510 for each shape that has a part in the pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rounded<S>(pub S);

impl<S: Cover> Areas for Rounded<S> {
    /// Half a 255th by rounding, and as much for each of two neighbours whose area was rounded to nothing, which nobody
    /// tells of.
    const ERROR: u32 = 3 * WHOLE / 510 + 1;

    fn touched(&self) -> PixelRect {
        self.0.touched()
    }

    fn push_areas(&self, clip: &PixelRect, sink: &mut impl AreaSink) {
        let Ok(()) = self.0.coverage(clip, &mut FromCoverage(sink));
    }
}

struct FromCoverage<'s, S>(&'s mut S);

/// 255 is the whole.
#[inline(always)]
fn area_of(coverage: u8) -> u32 {
    (u32::from(coverage) * WHOLE + 127) / 255
}

impl<S: AreaSink> CoverageSink for FromCoverage<'_, S> {
    type Error = Infallible;

    #[inline]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
        self.0.alike(span, area_of(coverage));
        Ok(())
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        self.0.areas(row, column, coverage.iter().map(|coverage| area_of(*coverage)));
        Ok(())
    }
}
