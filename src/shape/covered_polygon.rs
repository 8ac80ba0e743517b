//! Anti-aliased polygon: strips that are as wide as there are cells.

use core::{cell::Cell as Shared, fmt};

use crate::{
    PixelRect, TooManyEdges,
    area::{CoverageEdge, Inside, send_contours},
    contours::Rows,
    coverage::{Cell, CoverageSink},
    error::TooLittleScratch,
    geometry::touched,
    limits::ONE,
    shape::{Cover, Polygon},
    span::clip_range,
};

impl<'a> Polygon<'a> {
    /// How much scratch the anti-aliased outline needs: the most edges that cross one row of 1/256 pixel.
    ///
    /// As [`active_edges`](Self::active_edges), which counts rows of pixel centres, it is meant for constants.
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
    /// When there are fewer slots than the outline has [`coverage_edges`](Self::coverage_edges), or not a single cell.
    pub fn coverage_in<'s>(
        self,
        edges: &'s mut [CoverageEdge],
        cells: &'s mut [Cell],
    ) -> Result<PolygonCoverageIn<'a, 's>, TooLittleScratch> {
        self.check_coverage(edges.len())?;
        if cells.is_empty() {
            return Err(TooLittleScratch::NoCells);
        }
        Ok(PolygonCoverageIn { polygon: self, edges: Shared::new(edges), cells: Shared::new(cells) })
    }

    /// Takes scratch for anti-aliasing from the stack, while drawing.
    ///
    /// # Errors
    ///
    /// When the outline has more than `EDGES` [`coverage_edges`](Self::coverage_edges).
    pub const fn coverage_with<const EDGES: usize, const CELLS: usize>(
        self,
    ) -> Result<PolygonCoverageWith<'a, EDGES, CELLS>, TooManyEdges> {
        const { assert!(CELLS > 0, "there must be a cell") };
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
        cells: &mut [Cell],
        sink: &mut S,
    ) -> Result<(), S::Error> {
        let _ = cells;
        send_contours(self.contours, Inside { mask: self.fill_rule.mask() }, clip, edges, sink)
    }
}

/// A polygon with scratch of the caller's to be anti-aliased in.
pub struct PolygonCoverageIn<'a, 's> {
    polygon: Polygon<'a>,
    /// Both are taken while drawing.
    edges: Shared<&'s mut [CoverageEdge]>,
    cells: Shared<&'s mut [Cell]>,
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
        let (edges, cells) = (self.edges.take(), self.cells.take());
        let result = self.polygon.cover(clip, edges, cells, sink);
        self.edges.set(edges);
        self.cells.set(cells);
        result
    }
}

/// A polygon that is anti-aliased in scratch on the stack, for `EDGES` active edges and a strip of `CELLS` columns.
#[derive(Debug, Clone, Copy)]
pub struct PolygonCoverageWith<'a, const EDGES: usize, const CELLS: usize> {
    polygon: Polygon<'a>,
}

impl<const EDGES: usize, const CELLS: usize> Cover for PolygonCoverageWith<'_, EDGES, CELLS> {
    fn touched(&self) -> PixelRect {
        self.polygon.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut edges = [CoverageEdge::EMPTY; EDGES];
        self.polygon.cover(clip, &mut edges, &mut [Cell::EMPTY; CELLS], sink)
    }
}
