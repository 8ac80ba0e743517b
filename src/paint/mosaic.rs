//! Shapes side by side, without seams.
//!
//! Two shapes that share an edge cover a pixel on it by `a` and `1 - a`. Blended one after the other, the background
//! shows through by `a (1 - a)`, a quarter at worst: the seam. Added up before anything is rounded, they cover it
//! wholly, and the background does not show at all.
//!
//! ```text
//!   one after the other:   bg (1-a) + A a, then * a + B (1-a)    ->  bg  a (1-a)  is left
//!   a mosaic:              A a + B (1-a), covered by 1           ->  bg  0
//! ```
//!
//! A cell of scratch keeps, for one pixel, the area that is covered so far and the colours times their areas. A shape
//! that comes later covers what is there already where both do not fit: `min(1, total + a)` is covered then, `a` of it
//! by the later one, the rest by what was there, in its proportions. Where shapes share edges everything fits, and
//! the order does not matter.
//!
//! # How near
//!
//! Areas come from [`Areas`], in `2^-24` of a pixel, with a bound on their error. What is nearer to a whole pixel than
//! the errors of its shapes together is whole: within a partition the sum is exactly 255. Up to 32 tiles in a pixel, 5
//! circles, that is what rounding makes of it, too.
//!
//! An area is a sum over edges. Where two tiles share one, what it adds to the one is what it takes from the other, to the
//! last bit, as it is the same function of the same edge and pixel. So the sum over all tiles is that over the edges of
//! their union, and it is rounded once:
//!
//! - Polygons have the rim of the polygon around all of them, in every pixel.
//! - Triangles have one rim, however their union is cut. A polygon's rows are added up in another order, so that the level
//!   differs, by one, where the area is a tie: in 5 of 53,423 pixels of rims between multiples of 1/2 pixel, where many
//!   areas are ties, and in none of 99,786 between other vertices.
//!
//! For what knows its coverage alone, see [`Rounded`](crate::Rounded).

use core::{fmt, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    PixelRect,
    attribute::Channels,
    blend::{Blend, right_of},
    paint::{
        Paint,
        areas::{AreaSink, Areas, WHOLE},
    },
    span::{Span, visible},
};

/// What a mosaic keeps of a pixel: 8 bytes and 4 for each channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MosaicCell<const N: usize> {
    area: u32,
    error: u32,
    /// Channels times areas: 255 of a whole pixel at most.
    sums: [u32; N],
}

impl<const N: usize> MosaicCell<N> {
    /// Nothing yet.
    pub const EMPTY: Self = Self { area: 0, error: 0, sums: [0; N] };

    fn add(&mut self, area: u32, error: u32, channels: [i32; N]) {
        let area = area.min(WHOLE);
        let left = self.area.min(WHOLE - area);
        if left < self.area {
            for sum in &mut self.sums {
                *sum = scaled(*sum, left, self.area);
            }
        }
        for (sum, channel) in self.sums.iter_mut().zip(channels) {
            *sum = sum.saturating_add(channel.clamp(0, 255).cast_unsigned() * area);
        }
        self.area = left + area;
        self.error = if area == WHOLE { 0 } else { self.error.saturating_add(error) };
    }

    /// The pixel's colour and its coverage, none where that is 0.
    fn resolved<C: Channels<N>>(&self) -> Option<(C, u8)> {
        let whole = self.area.saturating_add(self.error) >= WHOLE;
        let rounded = (u64::from(self.area) * 255 + u64::from(WHOLE / 2)) >> 24;
        let coverage = if whole { 255 } else { u8::try_from(rounded).unwrap_or(255) };
        if self.area == 0 || coverage == 0 {
            return None;
        }
        let mut channels = C::LAST;
        for (channel, sum) in channels.iter_mut().zip(&self.sums) {
            let nearest = (u64::from(*sum) + u64::from(self.area / 2)) / u64::from(self.area.max(1));
            *channel = i32::try_from(nearest).unwrap_or(0).min(*channel);
        }
        Some((C::from_channels(channels), coverage))
    }
}

/// `sum * part / whole`, to the nearest.
fn scaled(sum: u32, part: u32, whole: u32) -> u32 {
    let product = u64::from(sum) * u64::from(part) + u64::from(whole / 2);
    u32::try_from(product / u64::from(whole.max(1))).unwrap_or(sum)
}

/// One shape of a mosaic, in its paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Tile<S, P> {
    shape: S,
    paint: P,
}

impl<S: Areas, P> Tile<S, P> {
    /// A shape that knows its areas: a triangle, a polygon with scratch for coverage, or, within the bounds of
    /// [`Rounded`](crate::Rounded), any other.
    #[inline]
    pub const fn new(shape: S, paint: P) -> Self {
        Self { shape, paint }
    }
}

/// The tiles of a mosaic: one, a slice of them, or two such one after the other.
pub trait Tiles<C, const N: usize> {
    /// A rectangle outside which there is nothing.
    fn touched(&self) -> PixelRect;

    /// Adds all of them to cells.
    fn add(&self, cells: &mut Cells<'_, N>);
}

impl<C: Channels<N>, S: Areas, P: Paint<C>, const N: usize> Tiles<C, N> for Tile<S, P> {
    fn touched(&self) -> PixelRect {
        self.shape.touched()
    }

    fn add(&self, cells: &mut Cells<'_, N>) {
        let area = PixelRect { rows: cells.rows.clone(), columns: cells.columns.clone() };
        if let Some((rows, columns)) = visible(&self.shape.touched(), &area) {
            let mut sink = Adding { cells, paint: &self.paint, error: S::ERROR, colour: core::marker::PhantomData };
            self.shape.push_areas(&PixelRect { rows, columns }, &mut sink);
        }
    }
}

fn union(a: PixelRect, b: PixelRect) -> PixelRect {
    let is_empty = |rect: &PixelRect| rect.rows.is_empty() || rect.columns.is_empty();
    if is_empty(&a) {
        return b;
    }
    if is_empty(&b) {
        return a;
    }
    let around = |a: Range<i32>, b: Range<i32>| a.start.min(b.start)..a.end.max(b.end);
    PixelRect { rows: around(a.rows, b.rows), columns: around(a.columns, b.columns) }
}

const NOTHING: PixelRect = PixelRect { rows: 0..0, columns: 0..0 };

impl<C, T: Tiles<C, N>, const N: usize> Tiles<C, N> for [T] {
    fn touched(&self) -> PixelRect {
        self.iter().map(T::touched).fold(NOTHING, union)
    }

    fn add(&self, cells: &mut Cells<'_, N>) {
        for tile in self {
            tile.add(cells);
        }
    }
}

impl<C, T: Tiles<C, N> + ?Sized, const N: usize> Tiles<C, N> for &T {
    fn touched(&self) -> PixelRect {
        T::touched(self)
    }

    fn add(&self, cells: &mut Cells<'_, N>) {
        T::add(self, cells);
    }
}

impl<C, A: Tiles<C, N>, B: Tiles<C, N>, const N: usize> Tiles<C, N> for (A, B) {
    fn touched(&self) -> PixelRect {
        union(self.0.touched(), self.1.touched())
    }

    fn add(&self, cells: &mut Cells<'_, N>) {
        self.0.add(cells);
        self.1.add(cells);
    }
}

/// Cells for some rows of the screen.
#[derive(Debug)]
pub struct Cells<'s, const N: usize> {
    rows: Range<i32>,
    columns: Range<i32>,
    width: usize,
    cells: &'s mut [MosaicCell<N>],
}

impl<const N: usize> Cells<'_, N> {
    /// Those of a row from a column on.
    fn from(&mut self, row: i32, column: i32) -> &mut [MosaicCell<N>] {
        let down = usize::try_from(row.wrapping_sub(self.rows.start)).unwrap_or(usize::MAX);
        let right = usize::try_from(column.wrapping_sub(self.columns.start)).unwrap_or(usize::MAX);
        let row = self.cells.chunks_exact_mut(self.width.max(1)).nth(down).unwrap_or_default();
        row.get_mut(right..).unwrap_or_default()
    }
}

struct Adding<'a, 's, P, C, const N: usize> {
    cells: &'a mut Cells<'s, N>,
    paint: &'a P,
    error: u32,
    colour: core::marker::PhantomData<C>,
}

impl<P: Paint<C>, C: Channels<N>, const N: usize> AreaSink for Adding<'_, '_, P, C, N> {
    #[inline]
    fn alike(&mut self, span: Span, area: u32) {
        let width = usize::try_from(span.columns.end.abs_diff(span.columns.start)).unwrap_or(0);
        self.areas(span.row, span.columns.start, core::iter::repeat_n(area, width));
    }

    #[inline]
    fn areas(&mut self, row: i32, column: i32, areas: impl Iterator<Item = u32>) {
        let cells = self.cells.from(row, column);
        for ((cell, area), colour) in cells.iter_mut().zip(areas).zip(self.paint.row(row, column)) {
            if area == 0 {
                continue;
            }
            // A whole pixel has no error.
            cell.add(area, if area == WHOLE { 0 } else { self.error }, colour.channels());
        }
    }
}

/// The scratch does not hold one row of the mosaic; nothing has been drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MosaicScratchTooSmall {
    /// How many cells a row needs.
    pub needed: usize,
    /// How many there are.
    pub available: usize,
}

impl fmt::Display for MosaicScratchTooSmall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a row of the mosaic needs {} cells, {} available", self.needed, self.available)
    }
}

impl core::error::Error for MosaicScratchTooSmall {}

/// Several shapes in their paints, blended as one: no background shows between neighbours.
///
/// Within shapes that leave no gap between them, every pixel is covered by 255 exactly, and is a mix of their colours
/// by how much of it each covers. Along the rim of all of them, coverage is that of their union: for polygons the same
/// bits, for triangles the same but for ties. Where shapes overlap, later ones cover earlier ones.
///
/// ```text
///      .---------.---------.       a pixel on the common edge:
///      |    A    |    B    |         A's share A, B's share B, background none
///      '---------'---------'
/// ```
///
/// # Errors
///
/// Scratch for less than one row: see [`MosaicScratchTooSmall`]. Nothing is drawn then. Then the target's.
///
/// # Cost
///
/// `8 + 4 N` bytes of scratch a column of the mosaic, for `N` channels; with scratch for more rows, each shape is
/// walked fewer times. A multiplication for each channel, shape and pixel, a division for each channel and pixel.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Mosaic, MosaicCell, Over, Solid, Tile, Triangle, Vertex};
///
/// let corner = |x: f32, y: f32| Vertex::new(x, y);
/// let (a, b, c, d) = (corner(0.0, 0.0), corner(9.0, 0.0), corner(9.0, 9.0), corner(0.0, 9.0));
/// let halves = [[a, b, c], [a, c, d]].map(Triangle::from_vertices);
/// let tiles = halves.map(|half| Tile::new(half, Solid(Gray8::WHITE)));
/// let mut display = MockDisplay::new();
/// let mut scratch = [MosaicCell::EMPTY; 9];
/// Mosaic::new(&tiles[..]).draw_on(&mut display, Over(Gray8::BLACK), &mut scratch).unwrap();
/// // Along the diagonal, too.
/// assert!((0..9).all(|i| display.get_pixel(Point::new(i, i)) == Some(Gray8::WHITE)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Mosaic<T> {
    tiles: T,
}

/// What can go wrong with a mosaic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MosaicError<E> {
    /// Too little scratch; nothing has been drawn.
    Scratch(MosaicScratchTooSmall),
    /// The target's.
    Target(E),
}

impl<T> Mosaic<T> {
    /// The tiles, later ones on top.
    #[inline]
    pub const fn new(tiles: T) -> Self {
        Self { tiles }
    }

    /// With more tiles on top.
    #[inline]
    pub fn with<U>(self, tiles: U) -> Mosaic<(T, U)> {
        Mosaic { tiles: (self.tiles, tiles) }
    }

    /// Draws on any target that the blending can use.
    ///
    /// # Errors
    ///
    /// Scratch for less than one row of what of the mosaic the target shows; the target's, at once.
    pub fn draw_on<D, B, const N: usize>(
        &self,
        target: &mut D,
        blend: B,
        scratch: &mut [MosaicCell<N>],
    ) -> Result<(), MosaicError<D::Error>>
    where
        D: DrawTarget,
        D::Color: Channels<N>,
        B: Blend<D>,
        T: Tiles<D::Color, N>,
    {
        let (clip, touched) = (PixelRect::from(target.bounding_box()), self.tiles.touched());
        let Some((rows, columns)) = visible(&touched, &clip) else { return Ok(()) };
        let width = usize::try_from(columns.end.abs_diff(columns.start)).unwrap_or(usize::MAX);
        let Some(height @ 1..) = scratch.len().checked_div(width) else {
            let available = scratch.len();
            return Err(MosaicError::Scratch(MosaicScratchTooSmall { needed: width, available }));
        };
        let height = i32::try_from(height).unwrap_or(i32::MAX);
        let mut top = rows.start;
        while top < rows.end {
            let bottom = top.saturating_add(height).min(rows.end);
            scratch.fill(MosaicCell::EMPTY);
            let mut cells = Cells { rows: top..bottom, columns: columns.clone(), width, cells: scratch };
            self.tiles.add(&mut cells);
            for (row, cells) in (top..bottom).zip(scratch.chunks_exact(width)) {
                emit_row(target, blend, Point::new(columns.start, row), cells).map_err(MosaicError::Target)?;
            }
            top = bottom;
        }
        Ok(())
    }
}

/// Runs of wholly covered pixels go to the target as one.
fn emit_row<D: DrawTarget, B: Blend<D>, const N: usize>(
    target: &mut D,
    blend: B,
    start: Point,
    cells: &[MosaicCell<N>],
) -> Result<(), D::Error>
where
    D::Color: Channels<N>,
{
    let resolved = |cell: &MosaicCell<N>| cell.resolved::<D::Color>();
    let (mut rest, mut at) = (cells, start);
    while let Some(cell) = rest.first() {
        let opaque = rest.iter().take_while(|cell| matches!(resolved(cell), Some((_, 255)))).count();
        let length = opaque.max(1);
        let (now, later) = rest.split_at_checked(length).unwrap_or_default();
        if opaque > 0 {
            let area = Rectangle::new(at, Size::new(u32::try_from(opaque).unwrap_or(0), 1));
            let colours = now.iter().filter_map(resolved).map(|(colour, _)| colour);
            target.fill_contiguous(&area, colours)?;
        } else if let Some((colour, coverage)) = resolved(cell) {
            blend.run(target, at, colour, &[coverage])?;
        }
        (rest, at) = (later, right_of(at, length));
    }
    Ok(())
}
