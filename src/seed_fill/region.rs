//! What a seed fill reads and writes.

use core::{fmt, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::geometry::PixelRect;

/// Which pixels are neighbours.
///
/// ```text
///     . # .        # # #
///     # o #        # o #
///     . # .        # # #
///     Four         Eight
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Connectivity {
    /// Those that share a side: an outline as thin as a line keeps the fill in.
    #[default]
    Four,
    /// Those that share a side or a corner: the fill goes through the diagonal gaps of a thin line.
    Eight,
}

/// Pixels that a seed fill can look at and fill: a bitmap, a framebuffer, one with a boundary of many colours.
///
/// A pixel is *open* while it is to be filled when it is reached. Only filling may change which pixels are open.
pub trait FillRegion {
    /// What can fail; it ends the fill and is handed to the caller.
    type Error;

    /// The rectangle that the fill stays in.
    fn bounds(&self) -> PixelRect;

    /// Whether a pixel within the bounds is open.
    fn is_open(&self, x: i32, y: i32) -> bool;

    /// Fills a run of open pixels, which are not open any more.
    ///
    /// # Errors
    ///
    /// Whatever the target cannot do; the fill stops at once.
    fn fill(&mut self, row: i32, columns: Range<i32>) -> Result<(), Self::Error>;
}

/// Why a seed fill did not come to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SeedFillError<E> {
    /// The target's own error.
    Target(E),
    /// A pixel that was filled is still open: the target does not show what was drawn.
    Unreadable {
        /// The pixel's column.
        x: i32,
        /// The pixel's row.
        y: i32,
    },
}

impl<E: fmt::Display> fmt::Display for SeedFillError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Target(error) => error.fmt(f),
            Self::Unreadable { x, y } => write!(f, "pixel ({x}, {y}) still has its old colour after it was filled"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for SeedFillError<E> {}

/// A region and what neighbours are in it, as the algorithms see it: nothing is open outside of the bounds.
pub(super) struct Open<'r, R> {
    region: &'r mut R,
    bounds: PixelRect,
}

impl<'r, R: FillRegion> Open<'r, R> {
    pub(super) fn new(region: &'r mut R) -> Self {
        let bounds = region.bounds();
        Self { region, bounds }
    }

    #[inline]
    pub(super) fn has(&self, x: i32, y: i32) -> bool {
        self.bounds.rows.contains(&y) && self.bounds.columns.contains(&x) && self.region.is_open(x, y)
    }

    /// Fills a run, not empty, and looks at one pixel of it: each call leaves fewer pixels open, hence there is an end.
    pub(super) fn fill(&mut self, row: i32, columns: Range<i32>) -> Result<(), SeedFillError<R::Error>> {
        let x = columns.start;
        self.region.fill(row, columns).map_err(SeedFillError::Target)?;
        if self.has(x, row) { Err(SeedFillError::Unreadable { x, y: row }) } else { Ok(()) }
    }
}

/// What has the seed's colour on a draw target that can be read.
pub(super) struct OnTarget<'t, D: DrawTarget> {
    target: &'t mut D,
    old: D::Color,
    new: D::Color,
}

impl<'t, D> OnTarget<'t, D>
where
    D: DrawTarget + GetPixel<Color = <D as DrawTarget>::Color>,
{
    /// None where there is nothing to do: outside of the target, or when the colour is there already.
    pub(super) fn new(target: &'t mut D, seed: Point, new: <D as DrawTarget>::Color) -> Option<Self> {
        let old = target.pixel(seed)?;
        (old != new).then_some(Self { target, old, new })
    }
}

impl<D> FillRegion for OnTarget<'_, D>
where
    D: DrawTarget + GetPixel<Color = <D as DrawTarget>::Color>,
{
    type Error = D::Error;

    fn bounds(&self) -> PixelRect {
        self.target.bounding_box().into()
    }

    #[inline]
    fn is_open(&self, x: i32, y: i32) -> bool {
        self.target.pixel(Point::new(x, y)) == Some(self.old)
    }

    fn fill(&mut self, row: i32, columns: Range<i32>) -> Result<(), D::Error> {
        let size = Size::new(columns.end.wrapping_sub(columns.start).cast_unsigned(), 1);
        self.target.fill_solid(&Rectangle::new(Point::new(columns.start, row), size), self.new)
    }
}
