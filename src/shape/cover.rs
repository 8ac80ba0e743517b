//! TEMPORARY: aliased pixels at full coverage, until the kernels land.

use crate::{PixelRect, TooManyEdges, coverage::{Cell, CoverageSink}, error::TooLittleScratch, shape::{ActiveEdge, Circle, Cover, Line, Polygon, Shape, Triangle}, span::{Span, SpanSink}};

struct Full<'s, S>(&'s mut S);
impl<S: CoverageSink> SpanSink for Full<'_, S> {
    type Error = S::Error;
    fn span(&mut self, span: Span) -> Result<(), S::Error> { self.0.span(span, 255) }
}
impl Cover for Triangle {
    fn touched(&self) -> PixelRect { self.bounds() }
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> { self.spans(clip, &mut Full(sink)) }
}
impl Cover for Line {
    fn touched(&self) -> PixelRect { self.bounds() }
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> { self.spans(clip, &mut Full(sink)) }
}
impl Cover for Circle {
    fn touched(&self) -> PixelRect { self.bounds() }
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> { self.spans(clip, &mut Full(sink)) }
}
/// Scratch for one active edge of an anti-aliased polygon.
pub type CoverageEdge = ActiveEdge;
/// A polygon with scratch of the caller's.
pub struct PolygonCoverageIn<'a, 's> { polygon: core::cell::Cell<Option<crate::PolygonInScratch<'a, 's>>> , _cells: &'s mut [Cell] }
/// A polygon with scratch on the stack.
#[derive(Debug, Clone, Copy)]
pub struct PolygonCoverageWith<'a, const EDGES: usize, const CELLS: usize> { polygon: crate::PolygonWithCapacity<'a, EDGES> }
impl<'a> Polygon<'a> {
    /// Slots needed, exactly.
    pub const fn coverage_edges(&self) -> usize { self.active_edges_at_most() }
    /// Slots that are enough.
    pub const fn coverage_edges_at_most(&self) -> usize { self.active_edges_at_most() }
    /// In the caller's scratch.
    ///
    /// # Errors
    /// Too little.
    pub fn coverage_in<'s>(self, edges: &'s mut [CoverageEdge], cells: &'s mut [Cell]) -> Result<PolygonCoverageIn<'a, 's>, TooLittleScratch> {
        Ok(PolygonCoverageIn { polygon: core::cell::Cell::new(Some(self.in_scratch(edges).map_err(TooLittleScratch::Edges)?)), _cells: cells })
    }
    /// On the stack.
    ///
    /// # Errors
    /// Too little.
    pub const fn coverage_with<const EDGES: usize, const CELLS: usize>(self) -> Result<PolygonCoverageWith<'a, EDGES, CELLS>, TooManyEdges> {
        match self.with_capacity() { Ok(polygon) => Ok(PolygonCoverageWith { polygon }), Err(error) => Err(error) }
    }
}
impl Cover for PolygonCoverageIn<'_, '_> {
    fn touched(&self) -> PixelRect { let p = self.polygon.take(); let b = p.as_ref().map_or(PixelRect { rows: 0..0, columns: 0..0 }, |p| p.bounds()); self.polygon.set(p); b }
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> { let p = self.polygon.take(); let r = p.as_ref().map_or(Ok(()), |p| p.spans(clip, &mut Full(sink))); self.polygon.set(p); r }
}
impl<const EDGES: usize, const CELLS: usize> Cover for PolygonCoverageWith<'_, EDGES, CELLS> {
    fn touched(&self) -> PixelRect { self.polygon.bounds() }
    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> { self.polygon.spans(clip, &mut Full(sink)) }
}
impl core::fmt::Debug for PolygonCoverageIn<'_, '_> { fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result { f.write_str("PolygonCoverageIn") } }
