//! Filled polygon: scan lines through an active edge table.

pub(in crate::shape) mod active;
mod areas;
pub(in crate::shape) mod table;
pub(in crate::shape) mod waiting;

pub use active::ActiveEdge;
pub use areas::{PolygonCoverageIn, PolygonCoverageWith};

use core::{cell::Cell, fmt, ops::Range};

use crate::{
    PixelRect, TooManyEdges, Vertex,
    contours::{Contours, FillRule, Rows},
    outline::WindingRule,
    shape::{Shape, polygon::table::Table},
    span::{BlockSink, EachSpan, MergeRows, RowSink, SpanSink, clip_range},
    subpixel::first_centre_at_or_after,
};

/// A filled polygon of one or many closed contours, with vertices in 1/256 pixel.
///
/// Any outline is legal: convex, concave, self-intersecting, nested, with horizontal edges and coincident vertices, of
/// fewer than three vertices (it has no pixels), at the ends of the coordinate range. The last vertex of a contour is
/// joined to the first. A pixel belongs to the polygon when its centre does, by the [`FillRule`]; a centre on the
/// outline belongs when the inside lies to its right, or, on a horizontal edge, below.
///
/// ```text
///     # . . . #
///     # # . # #      one contour, five vertices,
///     # # # # #      concave
///     # # # # #
/// ```
///
/// The outline is borrowed. What changes while drawing is scratch: one [`Scratch`](crate::Scratch) that all shapes share
/// ([`within`](Self::within)), a slice for the edges that cross a row at once ([`in_scratch`](Self::in_scratch)), or as many
/// on the stack ([`with_capacity`](Self::with_capacity)). A constant outline says how much at compile time.
///
/// Anti-aliased, it needs a slot for each chain of edges that has a part in the same row of pixels, from the caller
/// ([`coverage_in`](Self::coverage_in)) or on the stack ([`coverage_with`](Self::coverage_with)). A pixel is covered by the
/// exact area within it, by the fill rule where contours overlap.
///
/// # Errors
///
/// Too little scratch is found before anything is drawn: [`TooManyEdges`] names what is needed.
///
/// # Cost
///
/// One division an edge, then an addition and a subtraction for each edge and visible row. A pass over the vertices at the start,
/// and, when there is just scratch for the active edges, one for each row on which contours turn down; two slots for each of
/// those save that. 32 bytes a slot. Anti-aliased, a division for each edge that leaves a row of pixels and for each that
/// leaves a column, 80 bytes a slot.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Polygon, Vertex, prelude::*};
///
/// const ARROW: Polygon = Polygon::new(&[
///     Vertex::from_bits(0, 0),
///     Vertex::from_bits(5 * 256, 2 * 256),
///     Vertex::from_bits(0, 4 * 256),
///     Vertex::from_bits(2 * 256, 2 * 256),
/// ]);
///
/// let mut display = MockDisplay::new();
/// ARROW.with_capacity::<{ ARROW.active_edges() }>()?.filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["#    ", " ### ", " ### ", "#    "]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// The same with anti-aliasing:
///
/// ```
/// # use embedded_graphics::prelude::*;
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4};
/// use spanfill::{Over, Polygon, Vertex, prelude::*};
///
/// # const ARROW: Polygon = Polygon::new(&[
/// #     Vertex::from_bits(0, 0),
/// #     Vertex::from_bits(5 * 256, 2 * 256),
/// #     Vertex::from_bits(0, 4 * 256),
/// #     Vertex::from_bits(2 * 256, 2 * 256),
/// # ]);
/// let mut display = MockDisplay::new();
/// let arrow = ARROW.coverage_with::<{ ARROW.coverage_edges() }>()?;
/// arrow.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
/// display.assert_pattern(&["561  ", " 8E93", " 8E93", "561  "]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Polygon<'a> {
    pub(in crate::shape) contours: Contours<'a>,
    pub(in crate::shape) rule: WindingRule,
}

impl<'a> Polygon<'a> {
    /// A polygon of one contour, non-zero.
    #[inline]
    pub const fn new(contour: &'a [Vertex]) -> Self {
        Self { contours: Contours::One(contour), rule: WindingRule::NON_ZERO }
    }

    /// A polygon of many contours, non-zero.
    #[inline]
    pub const fn with_contours(contours: &'a [&'a [Vertex]]) -> Self {
        Self { contours: Contours::Many(contours), rule: WindingRule::NON_ZERO }
    }

    /// The same outline with another rule for its inside.
    #[inline]
    pub const fn fill_rule(self, fill_rule: FillRule) -> Self {
        Self { rule: WindingRule::with_mask(fill_rule.mask()), ..self }
    }

    pub(crate) const fn winding_rule(self, rule: WindingRule) -> Self {
        Self { rule, ..self }
    }

    /// How much scratch the outline needs: the most edges that cross one row's centre, wherever it is clipped.
    ///
    /// Takes a pass over the vertices for each turn from up to down: meant for constants. For outlines made while the
    /// program runs, [`active_edges_at_most`](Self::active_edges_at_most) takes one pass.
    pub const fn active_edges(&self) -> usize {
        self.contours.most_crossings(Rows::Pixels)
    }

    /// The same while the program runs, in room that is lent for [`active_edges_at_most`](Self::active_edges_at_most)
    /// numbers: 4 bytes each, where a slot is 32. See [`coverage_edges_in`](Self::coverage_edges_in).
    pub fn active_edges_in(&self, room: &mut [i32]) -> usize {
        self.contours.most_by_sorting(Rows::Pixels, room).unwrap_or_else(|| self.active_edges())
    }

    /// An amount of scratch that is enough, and with which the vertices are looked over just once: two edges for each
    /// turn from up to down.
    pub const fn active_edges_at_most(&self) -> usize {
        self.contours.chains(Rows::Pixels)
    }

    /// Borrows scratch.
    ///
    /// # Errors
    ///
    /// When it has fewer slots than the outline has [`active_edges`](Self::active_edges).
    pub fn in_scratch<'s>(self, scratch: &'s mut [ActiveEdge]) -> Result<PolygonInScratch<'a, 's>, TooManyEdges> {
        self.check(scratch.len())?;
        Ok(PolygonInScratch::of(self, scratch))
    }

    /// Takes scratch for `N` active edges from the stack, while drawing.
    ///
    /// # Errors
    ///
    /// When the outline has more than `N` [`active_edges`](Self::active_edges).
    pub const fn with_capacity<const N: usize>(self) -> Result<PolygonWithCapacity<'a, N>, TooManyEdges> {
        match self.check(N) {
            Ok(()) => Ok(PolygonWithCapacity { polygon: self }),
            Err(error) => Err(error),
        }
    }

    const fn check(&self, available: usize) -> Result<(), TooManyEdges> {
        if self.active_edges_at_most() <= available {
            return Ok(());
        }
        let needed = self.active_edges();
        if needed <= available { Ok(()) } else { Err(TooManyEdges { needed, available }) }
    }

    fn bounds(&self) -> PixelRect {
        let mut low = (i32::MAX, i32::MAX);
        let mut high = (i32::MIN, i32::MIN);
        for index in 0..self.contours.len() {
            for vertex in self.contours.contour(index) {
                let (x, y) = (vertex.x.to_bits(), vertex.y.to_bits());
                low = (low.0.min(x), low.1.min(y));
                high = (high.0.max(x), high.1.max(y));
            }
        }
        if low.0 > high.0 {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        let pixels = |low, high| first_centre_at_or_after(low)..first_centre_at_or_after(high);
        PixelRect { rows: pixels(low.1, high.1), columns: pixels(low.0, high.0) }
    }

    /// Scan lines from top to bottom: the edges that cross a row's centre, in order, and between them the winding.
    fn scan<R: RowSink>(&self, clip: &PixelRect, slots: &mut [ActiveEdge], sink: &mut R) -> Result<(), R::Error> {
        if clip.rows.is_empty() || clip.columns.is_empty() {
            return Ok(());
        }
        let mut table = Table::new(self.contours, &clip.rows, slots);
        let mut row = clip.rows.start;
        while row < clip.rows.end {
            table.start(row);
            if table.is_idle() {
                row = table.next_start().max(row + 1);
                continue;
            }
            let event = table.next_event(row + 1, clip.rows.end);
            loop {
                let mut spans = RowSpans::new(row, self.rule, &clip.columns);
                table.cross_and_step(|column, winding| spans.cross(column, winding, sink))?;
                spans.finish(sink)?;
                row += 1;
                if row == event {
                    break;
                }
                table.sort();
            }
            table.turn(row);
        }
        Ok(())
    }
}

/// The spans of one row, from the edges that cross it.
struct RowSpans<'c> {
    row: i32,
    winding: i32,
    rule: WindingRule,
    /// The open span, or the last closed one: another that starts where it ends goes on with it.
    columns: Range<i32>,
    clip: &'c Range<i32>,
}

impl<'c> RowSpans<'c> {
    #[inline(always)]
    fn new(row: i32, rule: WindingRule, clip: &'c Range<i32>) -> Self {
        Self { row, winding: 0, rule, columns: clip.start..clip.start, clip }
    }

    #[inline(always)]
    fn cross<R: RowSink>(&mut self, column: i32, winding: i32, sink: &mut R) -> Result<(), R::Error> {
        let was_inside = self.rule.of(self.winding) != 0;
        self.winding += winding;
        if was_inside {
            self.columns.end = column;
        } else if column != self.columns.end {
            let columns = core::mem::replace(&mut self.columns, column..column);
            return self.send(columns, sink);
        }
        Ok(())
    }

    #[inline(always)]
    fn finish<R: RowSink>(self, sink: &mut R) -> Result<(), R::Error> {
        self.send(self.columns.clone(), sink)?;
        sink.end_row(self.row)
    }

    #[inline(always)]
    fn send<R: RowSink>(&self, columns: Range<i32>, sink: &mut R) -> Result<(), R::Error> {
        let columns = clip_range(&columns, self.clip);
        if columns.is_empty() { Ok(()) } else { sink.span(self.row, columns) }
    }
}

/// A polygon with scratch of the caller's to draw it in: a [`Shape`].
pub struct PolygonInScratch<'a, 's> {
    polygon: Polygon<'a>,
    /// Taken while drawing.
    scratch: Cell<&'s mut [ActiveEdge]>,
}

impl<'a, 's> PolygonInScratch<'a, 's> {
    /// In scratch that is enough.
    pub(crate) fn of(polygon: Polygon<'a>, scratch: &'s mut [ActiveEdge]) -> Self {
        Self { polygon, scratch: Cell::new(scratch) }
    }
}

impl fmt::Debug for PolygonInScratch<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PolygonInScratch").field("polygon", &self.polygon).finish_non_exhaustive()
    }
}

impl Shape for PolygonInScratch<'_, '_> {
    fn bounds(&self) -> PixelRect {
        self.polygon.bounds()
    }

    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let slots = self.scratch.take();
        let result = self.polygon.scan(clip, slots, &mut EachSpan(sink));
        self.scratch.set(slots);
        result
    }

    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let slots = self.scratch.take();
        let result = MergeRows::merged(sink, |merge| self.polygon.scan(clip, slots, merge));
        self.scratch.set(slots);
        result
    }
}

/// A polygon that is drawn in scratch on the stack, for `N` active edges: a [`Shape`].
#[derive(Debug, Clone, Copy)]
pub struct PolygonWithCapacity<'a, const N: usize> {
    polygon: Polygon<'a>,
}

impl<const N: usize> Shape for PolygonWithCapacity<'_, N> {
    fn bounds(&self) -> PixelRect {
        self.polygon.bounds()
    }

    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.polygon.scan(clip, &mut [ActiveEdge::EMPTY; N], &mut EachSpan(sink))
    }

    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut slots = [ActiveEdge::EMPTY; N];
        MergeRows::merged(sink, |merge| self.polygon.scan(clip, &mut slots, merge))
    }
}
