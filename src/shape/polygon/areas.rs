//! Anti-aliased polygon.

use core::{cell::Cell, fmt};

use crate::{
    PixelRect, TooManyEdges,
    area::{CoverageEdge, PlacedAreaSink, send_areas, send_contours},
    contours::Rows,
    coverage::CoverageSink,
    geometry::touched,
    outline::WindingRule,
    shape::{Cover, Polygon},
};

impl<'a> Polygon<'a> {
    /// How much scratch the anti-aliased outline needs: the most chains that have a part in one row of pixels.
    ///
    /// A chain is a run of edges that follow each other downwards. As [`active_edges`](Self::active_edges), it takes a pass
    /// over the vertices for each of them, and is meant for constants.
    pub const fn coverage_edges(&self) -> usize {
        self.contours.most_in_a_row()
    }

    /// The same while the program runs, in room that is lent for
    /// [`coverage_edges_at_most`](Self::coverage_edges_at_most) numbers: 4 bytes each, where a slot is 80.
    ///
    /// # Cost
    ///
    /// For `n` turns, in the order of `n log n`. With less room, what [`coverage_edges`](Self::coverage_edges) costs.
    ///
    /// # Examples
    ///
    /// ```
    /// use spanfill::{Polygon, Vertex};
    ///
    /// // A saw of ten teeth, as a program would compute it.
    /// let saw: [Vertex; 20] = core::array::from_fn(|i| Vertex::new(3 * i as i32, 9 * (i as i32 % 2)));
    /// let polygon = Polygon::new(&saw);
    /// let mut room = [0; 20];
    /// assert!(polygon.coverage_edges_at_most() <= room.len());
    /// assert_eq!(polygon.coverage_edges_in(&mut room), polygon.coverage_edges());
    /// ```
    pub fn coverage_edges_in(&self, room: &mut [i32]) -> usize {
        self.contours.most_by_sorting(Rows::Subpixels, room).unwrap_or_else(|| self.coverage_edges())
    }

    /// An amount of scratch that is enough, and with which the vertices are looked over just once, as
    /// [`active_edges_at_most`](Self::active_edges_at_most).
    pub const fn coverage_edges_at_most(&self) -> usize {
        self.contours.chains(Rows::Subpixels)
    }

    /// Borrows scratch for anti-aliasing.
    ///
    /// # Errors
    ///
    /// When there are fewer slots than the outline has [`coverage_edges`](Self::coverage_edges).
    pub fn coverage_in(self, edges: &mut [CoverageEdge]) -> Result<PolygonCoverageIn<'a, '_>, TooManyEdges> {
        self.check_coverage(edges.len())?;
        Ok(PolygonCoverageIn::of(self, edges))
    }

    /// Takes scratch for anti-aliasing from the stack, while drawing.
    ///
    /// # Errors
    ///
    /// When the outline has more than `EDGES` [`coverage_edges`](Self::coverage_edges).
    pub const fn coverage_with<const EDGES: usize>(self) -> Result<PolygonCoverageWith<'a, EDGES>, TooManyEdges> {
        match self.check_coverage(EDGES) {
            Ok(()) => Ok(PolygonCoverageWith { polygon: self }),
            Err(error) => Err(error),
        }
    }

    pub(crate) const fn check_coverage(&self, available: usize) -> Result<(), TooManyEdges> {
        if self.coverage_edges_at_most() <= available {
            return Ok(());
        }
        let needed = self.coverage_edges();
        if needed <= available { Ok(()) } else { Err(TooManyEdges { needed, available }) }
    }

    fn touched(&self) -> PixelRect {
        touched((0..self.contours.len()).flat_map(|index| self.contours.contour(index)))
    }

    fn cover<S: CoverageSink>(
        &self,
        clip: &PixelRect,
        edges: &mut [CoverageEdge],
        sink: &mut S,
    ) -> Result<(), S::Error> {
        send_contours(self.contours, self.inside(), clip, edges, sink)
    }

    fn inside(&self) -> WindingRule {
        self.rule
    }
}

/// A polygon with scratch of the caller's to be anti-aliased in.
pub struct PolygonCoverageIn<'a, 's> {
    polygon: Polygon<'a>,
    /// Taken while drawing.
    edges: Cell<&'s mut [CoverageEdge]>,
}

impl<'a, 's> PolygonCoverageIn<'a, 's> {
    /// In scratch that is enough.
    pub(crate) fn of(polygon: Polygon<'a>, edges: &'s mut [CoverageEdge]) -> Self {
        Self { polygon, edges: Cell::new(edges) }
    }
}

impl fmt::Debug for PolygonCoverageIn<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PolygonCoverageIn").field("polygon", &self.polygon).finish_non_exhaustive()
    }
}

impl PolygonCoverageIn<'_, '_> {
    /// As its coverage, before it is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let edges = self.edges.take();
        send_areas(self.polygon.contours, self.polygon.inside(), clip, edges, sink);
        self.edges.set(edges);
    }
}

impl Cover for PolygonCoverageIn<'_, '_> {
    fn touched(&self) -> PixelRect {
        self.polygon.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let edges = self.edges.take();
        let result = self.polygon.cover(clip, edges, sink);
        self.edges.set(edges);
        result
    }
}

/// A polygon that is anti-aliased in scratch on the stack, for `EDGES` active edges.
#[derive(Debug, Clone, Copy)]
pub struct PolygonCoverageWith<'a, const EDGES: usize> {
    polygon: Polygon<'a>,
}

impl<const EDGES: usize> PolygonCoverageWith<'_, EDGES> {
    /// As its coverage, before it is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let mut edges = [CoverageEdge::EMPTY; EDGES];
        send_areas(self.polygon.contours, self.polygon.inside(), clip, &mut edges, sink);
    }
}

impl<const EDGES: usize> Cover for PolygonCoverageWith<'_, EDGES> {
    fn touched(&self) -> PixelRect {
        self.polygon.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut edges = [CoverageEdge::EMPTY; EDGES];
        self.polygon.cover(clip, &mut edges, sink)
    }
}
