//! Scratch that all shapes share.

use core::fmt;

use crate::{
    PixelRect, Polygon, PolygonCoverageIn, PolygonInScratch, TooManyEdges, Vertex,
    area::CoverageEdge,
    collected::collect_and_count,
    coverage::CoverageSink,
    outline::Outline,
    shape::{ActiveEdge, Cover, Shape},
    span::{BlockSink, SpanSink},
};

/// Scratch for polygons and outlines of up to `EDGES` edges in a row of pixels, filled or anti-aliased, one after the other.
///
/// Triangles, lines and circles need none. What a [`Polygon`] needs is its [`coverage_edges`](Polygon::coverage_edges), known
/// in a constant where the outline is one; [`edges_for`] is what several need. A [`Path`](crate::Path), a
/// [`Stroke`](crate::Stroke) or any other [`Outline`] needs room for its vertices, too.
///
/// ```text
///                       .-- edges of a row --.-- the same, anti-aliased --.-- vertices --.
///    Scratch<12, 40>    |     12 x 32 bytes  |        12 x 80 bytes       |  40 x 8 bytes |
///                       '--------------------'----------------------------'---------------'
///                  STAR.within(&mut scratch)?.filled(colour)   .antialiased(colour, blend)
/// ```
///
/// It is made by a constant function of nothing but zeros, so that a `static` holds it without a copy of it in flash.
///
/// # Errors
///
/// What is too large for it is refused before anything is drawn, and [`ScratchTooSmall`] says what to write instead.
///
/// # Cost
///
/// 112 bytes an edge, 8 bytes a vertex. Where memory is short and nothing but filled, or nothing but anti-aliased,
/// [`Polygon::in_scratch`] and [`Polygon::coverage_in`] take a slice of 32 or of 80 bytes an edge. These are also for hosts,
/// where an outline says how much is allocated.
///
/// # Examples
///
/// In a `static`, by a lock: `critical_section::Mutex<RefCell<_>>` on a board, or `static_cell::ConstStaticCell<_>` where one
/// task draws.
///
/// ```
/// use std::sync::Mutex;
///
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{Over, Path, Polygon, Scratch, Vertex, edges_for, path, prelude::*};
///
/// const ARROW: Polygon = Polygon::new(&[Vertex::pixel(0, 0), Vertex::pixel(4, 2), Vertex::pixel(0, 4)]);
/// const ROOF: Polygon = Polygon::new(&[Vertex::pixel(6, 4), Vertex::pixel(8, 0), Vertex::pixel(10, 4), Vertex::pixel(8, 2)]);
/// const FLAG: Path = path!("M12 0h4l-2 2l2 2h-4z");
///
/// static SCRATCH: Mutex<Scratch<{ edges_for(&[ARROW, ROOF]) }, 8>> = Mutex::new(Scratch::new());
///
/// let mut scratch = SCRATCH.lock()?;
/// let mut display = MockDisplay::new();
/// ARROW.within(&mut scratch)?.filled(Gray4::WHITE).draw(&mut display)?;
/// ROOF.within(&mut scratch)?.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
/// FLAG.within(&mut scratch)?.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "        2   FFF8",
///     "FF     1D1  FF8 ",
///     "FFFF   8B8  FF8 ",
///     "FF    17 71 FFF8",
///     "      1   1     ",
/// ]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Scratch<const EDGES: usize, const VERTICES: usize = 0> {
    active: [ActiveEdge; EDGES],
    covered: [CoverageEdge; EDGES],
    vertices: [Vertex; VERTICES],
}

impl<const EDGES: usize, const VERTICES: usize> Scratch<EDGES, VERTICES> {
    const SIZE: ScratchSize = ScratchSize { edges: EDGES, vertices: VERTICES };

    /// Unused scratch.
    pub const fn new() -> Self {
        Self {
            active: [ActiveEdge::EMPTY; EDGES],
            covered: [CoverageEdge::EMPTY; EDGES],
            vertices: [Vertex::from_bits(0, 0); VERTICES],
        }
    }
}

impl<const EDGES: usize, const VERTICES: usize> Default for Scratch<EDGES, VERTICES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const EDGES: usize, const VERTICES: usize> fmt::Debug for Scratch<EDGES, VERTICES> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Self::SIZE.fmt(f)
    }
}

/// The most edges that any of the polygons needs scratch for, anti-aliased or not: the `EDGES` of a [`Scratch`].
///
/// # Cost
///
/// That of [`Polygon::coverage_edges`] for each: meant for constants.
pub const fn edges_for(polygons: &[Polygon<'_>]) -> usize {
    let mut most = 0;
    let mut rest = polygons;
    while let [polygon, after @ ..] = rest {
        let edges = polygon.coverage_edges();
        if edges > most {
            most = edges;
        }
        rest = after;
    }
    most
}

/// How large a [`Scratch`] is, or has to be.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct ScratchSize {
    /// In edges.
    pub edges: usize,
    /// In vertices.
    pub vertices: usize,
}

/// As it is written in a program.
impl fmt::Display for ScratchSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { edges, vertices } = self;
        if *vertices == 0 { write!(f, "Scratch<{edges}>") } else { write!(f, "Scratch<{edges}, {vertices}>") }
    }
}

impl fmt::Debug for ScratchSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The scratch is too small for the outline; nothing has been drawn.
///
/// It says what to write: `the outline needs a Scratch<12, 40>, not a Scratch<12, 32>`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ScratchTooSmall {
    /// What is enough for the outline, and for all that was small enough before. Of an outline whose vertices did not fit, the
    /// edges may be more than it needs.
    pub needed: ScratchSize,
    /// What there is.
    pub available: ScratchSize,
}

impl fmt::Display for ScratchTooSmall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the outline needs a {}, not a {}", self.needed, self.available)
    }
}

impl core::error::Error for ScratchTooSmall {}

impl ScratchTooSmall {
    fn new(edges: usize, vertices: usize, available: ScratchSize) -> Self {
        let needed = ScratchSize { edges: edges.max(available.edges), vertices: vertices.max(available.vertices) };
        Self { needed, available }
    }
}

impl<'a> Polygon<'a> {
    /// Borrows scratch to be drawn in, filled or anti-aliased.
    ///
    /// # Errors
    ///
    /// When the outline has more than `EDGES` [`coverage_edges`](Self::coverage_edges). There are never more
    /// [`active_edges`](Self::active_edges) than these.
    pub fn within<const EDGES: usize, const VERTICES: usize>(
        self,
        scratch: &mut Scratch<EDGES, VERTICES>,
    ) -> Result<PolygonWithin<'a, '_>, ScratchTooSmall> {
        PolygonWithin::new(self, &mut scratch.active, &mut scratch.covered, VERTICES)
    }
}

/// Draws any [`Outline`] in a [`Scratch`]: as a polygon, by [`collect`](crate::collect).
pub trait Within: Outline {
    /// Borrows scratch to be drawn in, filled or anti-aliased.
    ///
    /// # Errors
    ///
    /// When it has too few vertices or edges. The first error says how many of both are enough.
    ///
    /// # Examples
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
    /// use spanfill::{Cap, Scratch, Stroke, StrokeStyle, path, prelude::*};
    ///
    /// let corner = Stroke::new(path!("M2 8V2h5"), StrokeStyle::pixels(2).cap(Cap::Square));
    /// let error = corner.within(&mut Scratch::<2>::new()).unwrap_err();
    /// assert_eq!(error.to_string(), "the outline needs a Scratch<2, 12>, not a Scratch<2>");
    /// ```
    fn within<'s, const EDGES: usize, const VERTICES: usize>(
        &self,
        scratch: &'s mut Scratch<EDGES, VERTICES>,
    ) -> Result<PolygonWithin<'s, 's>, ScratchTooSmall>
    where
        Self: Sized,
    {
        let Scratch { active, covered, vertices } = scratch;
        let polygon = collect_and_count(self, vertices)
            .map_err(|(error, edges)| ScratchTooSmall::new(edges, error.needed, Scratch::<EDGES, VERTICES>::SIZE))?;
        PolygonWithin::new(polygon, active, covered, VERTICES)
    }
}

impl<O: Outline> Within for O {}

/// A polygon with scratch to draw it in: a [`Shape`] and a [`Cover`].
#[derive(Debug)]
pub struct PolygonWithin<'a, 's> {
    filled: PolygonInScratch<'a, 's>,
    covered: PolygonCoverageIn<'a, 's>,
}

impl<'a, 's> PolygonWithin<'a, 's> {
    fn new(
        polygon: Polygon<'a>,
        active: &'s mut [ActiveEdge],
        covered: &'s mut [CoverageEdge],
        vertices: usize,
    ) -> Result<Self, ScratchTooSmall> {
        // An edge that crosses the centre of a row is of a chain that has a part in it, and no chain crosses it twice.
        match polygon.check_coverage(active.len().min(covered.len())) {
            Ok(()) => Ok(Self {
                filled: PolygonInScratch::of(polygon, active),
                covered: PolygonCoverageIn::of(polygon, covered),
            }),
            Err(TooManyEdges { needed, available }) => {
                Err(ScratchTooSmall::new(needed, 0, ScratchSize { edges: available, vertices }))
            }
        }
    }
}

impl Shape for PolygonWithin<'_, '_> {
    fn bounds(&self) -> PixelRect {
        self.filled.bounds()
    }

    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.filled.spans(clip, sink)
    }

    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.filled.blocks(clip, sink)
    }
}

impl Cover for PolygonWithin<'_, '_> {
    fn touched(&self) -> PixelRect {
        self.covered.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.covered.coverage(clip, sink)
    }
}
