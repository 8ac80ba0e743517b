//! Anti-aliased polygon.

use core::{cell::Cell, fmt};

use crate::{
    PixelRect, TooManyEdges,
    area::{CoverageEdge, Inside, send_contours},
    contours::Rows,
    coverage::CoverageSink,
    geometry::touched,
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
        Ok(PolygonCoverageIn { polygon: self, edges: Cell::new(edges) })
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

    const fn check_coverage(&self, available: usize) -> Result<(), TooManyEdges> {
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
        send_contours(self.contours, Inside::with_mask(self.fill_rule.mask()), clip, edges, sink)
    }
}

/// A polygon with scratch of the caller's to be anti-aliased in.
pub struct PolygonCoverageIn<'a, 's> {
    polygon: Polygon<'a>,
    /// Taken while drawing.
    edges: Cell<&'s mut [CoverageEdge]>,
}

impl fmt::Debug for PolygonCoverageIn<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PolygonCoverageIn").field("polygon", &self.polygon).finish_non_exhaustive()
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

impl<const EDGES: usize> Cover for PolygonCoverageWith<'_, EDGES> {
    fn touched(&self) -> PixelRect {
        self.polygon.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut edges = [CoverageEdge::EMPTY; EDGES];
        self.polygon.cover(clip, &mut edges, sink)
    }
}
