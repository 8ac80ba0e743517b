//! Anti-aliased outlines of lines, curves and strokes.

use core::{cell::Cell, fmt};

use crate::{
    Path, PixelRect, Stroke, TooManyEdges,
    area::{CoverageEdge, send_outline},
    coverage::CoverageSink,
    outline::{Outline, most_chains},
    shape::Cover,
};

/// Any [`Outline`] anti-aliased, without memory for its vertices: in scratch for the chains of edges of one row of pixels.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use spanfill::{Cap, Over, Path, Stroke, StrokeStyle, path, prelude::*};
///
/// const HOOK: Stroke<Path> = Stroke::new(path!("M2 8V4a2 2 0 0 1 4 0"), StrokeStyle::pixels(2).cap(Cap::Round));
///
/// let mut display = MockDisplay::new();
/// let hook = HOOK.coverage_with::<{ HOOK.coverage_edges() }>()?;
/// hook.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(2, 6)), Some(Gray4::WHITE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait CoverOutline: Outline + Sized {
    /// Borrows scratch for anti-aliasing.
    ///
    /// # Errors
    ///
    /// When there are fewer slots than the outline has chains in a row. Walks the outline to find out.
    fn coverage_in(self, edges: &mut [CoverageEdge]) -> Result<OutlineCoverageIn<'_, Self>, TooManyEdges> {
        check(&self, edges.len())?;
        Ok(OutlineCoverageIn { outline: self, edges: Cell::new(edges) })
    }

    /// Takes scratch for anti-aliasing from the stack, while drawing.
    ///
    /// # Errors
    ///
    /// As [`coverage_in`](Self::coverage_in).
    fn coverage_with<const EDGES: usize>(self) -> Result<OutlineCoverageWith<Self, EDGES>, TooManyEdges> {
        check(&self, EDGES)?;
        Ok(OutlineCoverageWith { outline: self })
    }

    /// How many chains it has in a row of pixels at most: the scratch that it needs. Walks the outline.
    fn chains(&self) -> usize {
        self.with_vertices(|vertices| most_chains(vertices, self.extent()))
    }
}

impl<O: Outline> CoverOutline for O {}

impl Stroke<'_, Path<'_>> {
    /// How much scratch the anti-aliased stroke needs: as many chains of edges as are in a row of pixels at most, or a few
    /// more. Meant for constants; takes a pass over the elements.
    pub const fn coverage_edges(&self) -> usize {
        let (reach, more) = self.style().chains();
        self.curves().chains_at_most(Some(reach)).saturating_mul(more)
    }
}

fn check(outline: &impl Outline, available: usize) -> Result<(), TooManyEdges> {
    if outline.chains_at_most().is_some_and(|most| most <= available) {
        return Ok(());
    }
    let needed = outline.chains();
    if needed <= available { Ok(()) } else { Err(TooManyEdges { needed, available }) }
}

fn cover<S: CoverageSink>(
    outline: &impl Outline,
    clip: &PixelRect,
    edges: &mut [CoverageEdge],
    sink: &mut S,
) -> Result<(), S::Error> {
    let touched = outline.extent().pixels();
    outline.with_vertices(|vertices| send_outline(vertices, outline.winding_rule(), &touched, clip, edges, sink))
}

/// An outline with scratch of the caller's to be anti-aliased in.
pub struct OutlineCoverageIn<'s, O> {
    outline: O,
    /// Taken while drawing.
    edges: Cell<&'s mut [CoverageEdge]>,
}

impl<O: fmt::Debug> fmt::Debug for OutlineCoverageIn<'_, O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OutlineCoverageIn").field("outline", &self.outline).finish_non_exhaustive()
    }
}

impl<O: Outline> Cover for OutlineCoverageIn<'_, O> {
    fn touched(&self) -> PixelRect {
        self.outline.extent().pixels()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let edges = self.edges.take();
        let result = cover(&self.outline, clip, edges, sink);
        self.edges.set(edges);
        result
    }
}

/// An outline that is anti-aliased in scratch on the stack, for `EDGES` chains.
#[derive(Debug, Clone, Copy)]
pub struct OutlineCoverageWith<O, const EDGES: usize> {
    outline: O,
}

impl<O: Outline, const EDGES: usize> Cover for OutlineCoverageWith<O, EDGES> {
    fn touched(&self) -> PixelRect {
        self.outline.extent().pixels()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut edges = [CoverageEdge::EMPTY; EDGES];
        cover(&self.outline, clip, &mut edges, sink)
    }
}
