//! Supersampled polygon: lines of samples through an active edge table.
//!
//! A sample is the centre of a pixel of the outline `n` times as large. An edge is as steep there as here, so it makes the
//! same exact steps from line to line as from row to row (see `edge`), and only starts elsewhere. The table goes by
//! rows of 1/256 pixel: a line at the height `Y` is crossed by the edges that cross the row `floor(Y)`.

use core::{cell::Cell as Shared, fmt, ops::Range};

use crate::{
    PixelRect, TooManyEdges, Vertex,
    contours::{Rows, next_index},
    coverage::{CoverageSink, SampleCell, Samples, Supersampler},
    edge::{Descent, Edge, divide_product},
    error::TooLittleScratch,
    geometry::touched,
    limits::{HALF, NARROW_REACH, ONE},
    outline::WindingRule,
    shape::{
        Polygon,
        polygon::{
            active::{ActiveEdge, Track, contour_of},
            table::Table,
        },
        supersampled::{Sampled, SupersampledIn},
    },
    subpixel::first_centre_at_or_after_wide,
};

/// Scratch for one active edge of a supersampled polygon. 32 bytes.
pub type SampleEdge = ActiveEdge<SampledEdge>;

/// An edge on its current line of samples.
#[derive(Debug, Clone, Copy, Default)]
pub struct SampledEdge(Edge);

/// The column of an edge that has met no line.
const NOWHERE: i32 = i32::MIN;

impl Track for SampledEdge {
    const EMPTY: Self = Self(Edge::EMPTY);
    const ROWS: Rows = Rows::Subpixels;

    /// Its first line may be farther down, or below its end: it waits to be [`placed`](Self::placed).
    #[inline(always)]
    fn on_row(_: Vertex, _: Vertex, _: i32) -> Self {
        let mut edge = Edge::EMPTY;
        edge.column = NOWHERE;
        Self(edge)
    }

    /// Edges that are nowhere stay where they are until they are somewhere.
    #[inline(always)]
    fn is_right_of(&self, left: &Self) -> bool {
        self.0.column > left.0.column && left.0.column != NOWHERE
    }

    /// Edges that cannot be are placed on each line.
    #[inline(always)]
    fn can_step(&self) -> bool {
        true
    }
}

// In the narrow zone, x and all that is added to it on the way to a first line (see `limits::NARROW_REACH`).
const _: () = assert!(16 * NARROW_REACH as i64 + 256 * (2 * NARROW_REACH as i64) < 1 << 31);

impl SampledEdge {
    /// On `line`, which it crosses.
    #[inline]
    fn placed(upper: Vertex, lower: Vertex, line: i32, side: i32) -> Self {
        let descent = Descent::between(upper, lower);
        let below = height_of(line) - i64::from(upper.y.to_bits()) * i64::from(side);
        if !descent.is_narrow() {
            return Self::wide(descent, below.cast_unsigned(), side);
        }
        // As long as the edge itself: the line through it is what counts.
        let x0 = descent.x0.wrapping_mul(side);
        let x1 = x0.wrapping_add(descent.x1.wrapping_sub(descent.x0));
        let enlarged = Descent { x0, x1, ..descent };
        match i32::try_from(below) {
            Ok(below) if below <= ONE => Self(enlarged.near_top(below)),
            _ => Self(enlarged.at(below)),
        }
    }

    /// Outside of the narrow zone.
    #[inline(never)]
    fn wide(descent: Descent, below: u64, side: i32) -> Self {
        let Descent { x0, x1, dy } = descent;
        // `below` is less than `side dy`; of a product of 36 and 32 bits, the whole heights are taken out.
        let height = u64::from(dy.max(1));
        let (whole, part) = divide_product(below % height, x1.abs_diff(x0), dy);
        let heights = (below / height).cast_signed();
        let from = i64::from(x0) * i64::from(side) + (i64::from(x1) - i64::from(x0)) * heights;
        // Rounded up.
        let x = if x1 >= x0 {
            from.wrapping_add_unsigned(whole) + i64::from(part > 0)
        } else {
            from.wrapping_sub_unsigned(whole)
        };
        let mut edge = Edge::EMPTY;
        edge.column = i32::try_from(first_centre_at_or_after_wide(x)).unwrap_or_default();
        Self(edge)
    }
}

/// Of a line of samples, in 1/256 of a sample.
#[inline]
fn height_of(line: i32) -> i64 {
    i64::from(line) * i64::from(ONE) + i64::from(HALF)
}

/// The first line at or below a height in 1/256 pixel.
#[inline]
fn first_line(y: i32, side: i32) -> i32 {
    // At most 2^27.
    i32::try_from(first_centre_at_or_after_wide(i64::from(y) * i64::from(side))).unwrap_or_default()
}

impl<'a> Polygon<'a> {
    /// Borrows scratch to be supersampled in: as many edges as for [areas](Self::coverage_in), and one cell for each
    /// column of the clip to save passes.
    ///
    /// # Errors
    ///
    /// When there are fewer slots than the outline has [`coverage_edges`](Self::coverage_edges), or not a single cell.
    ///
    /// # Cost
    ///
    /// One division an edge, then an addition and a subtraction for each edge and line of samples, and two cells for each
    /// edge where the inside begins or ends. 32 bytes a slot, 2 bytes a cell.
    pub fn supersampled_in<'s>(
        self,
        samples: Samples,
        edges: &'s mut [SampleEdge],
        cells: &'s mut [SampleCell],
    ) -> Result<SupersampledIn<'s, PolygonEdges<'a, 's>>, TooLittleScratch> {
        let available = edges.len();
        if available < self.coverage_edges_at_most() {
            let needed = self.coverage_edges();
            if available < needed {
                return Err(TooManyEdges { needed, available }.into());
            }
        }
        SupersampledIn::new(PolygonEdges { polygon: self, edges: Shared::new(edges) }, samples, cells)
    }

    /// Sends the samples in a rectangle of pixels; there are slots for all edges.
    pub(in crate::shape) fn sample_in<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        edges: &mut [SampleEdge],
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        // No coordinate is beyond what saturates.
        let rows = pixels.rows.start.saturating_mul(ONE)..pixels.rows.end.saturating_mul(ONE);
        let side = samples.side();
        let mut table = Table::new(self.contours, &rows, edges);
        let mut y = rows.start;
        while y < rows.end {
            table.start(y);
            let event = if table.is_idle() {
                table.next_start().max(y + 1).min(rows.end)
            } else {
                let event = table.next_event(y + 1, rows.end);
                let lines = first_line(y, side)..first_line(event, side);
                table.sample(lines, side, Winding::new(self.rule), sampler)?;
                event
            };
            y = event;
            table.turn(y);
        }
        Ok(())
    }
}

impl Table<'_, '_, SampledEdge> {
    /// Sends lines on which no edge starts or ends, and takes the edges to the next.
    fn sample<S: CoverageSink>(
        &mut self,
        lines: Range<i32>,
        side: i32,
        winding: Winding,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        let mut are_placed = false;
        let mut is_sorted = false;
        for line in lines {
            if !are_placed {
                are_placed = self.place(line, side);
                is_sorted = false;
            }
            if !is_sorted {
                self.sort_active();
                is_sorted = true;
            }
            sampler.start(line)?;
            let mut winding = winding;
            let mut previous = NOWHERE;
            for slot in self.active_mut() {
                let sign = winding.cross(slot.winding());
                if sign != 0 {
                    sampler.add_from(slot.edge.0.column, sign);
                }
                slot.edge.0.step();
                if slot.edge.0.column < previous {
                    is_sorted = false;
                }
                previous = slot.edge.0.column;
            }
        }
        Ok(())
    }

    /// Places the edges that are not on `line`. Whether none has to be placed on the next.
    fn place(&mut self, line: i32, side: i32) -> bool {
        let contours = self.contours();
        let mut all_step = true;
        for slot in self.active_mut() {
            if slot.edge.0.can_step() {
                continue;
            }
            let contour = contour_of(contours, slot.contour);
            let upper = next_index(contour, slot.vertex, slot.contour < 0);
            if let (Some(&upper), Some(&lower)) = (contour.get(upper as usize), contour.get(slot.vertex as usize)) {
                slot.edge = SampledEdge::placed(upper, lower, line, side);
                all_step &= slot.edge.0.can_step();
            }
        }
        all_step
    }
}

/// A polygon with scratch for its active edges: the shape of a [`SupersampledIn`].
pub struct PolygonEdges<'a, 's> {
    polygon: Polygon<'a>,
    /// Taken while drawing.
    edges: Shared<&'s mut [SampleEdge]>,
}

impl fmt::Debug for PolygonEdges<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PolygonEdges").field("polygon", &self.polygon).finish_non_exhaustive()
    }
}

impl Sampled for PolygonEdges<'_, '_> {
    fn touched(&self) -> PixelRect {
        let contours = self.polygon.contours;
        touched((0..contours.len()).flat_map(|index| contours.contour(index)))
    }

    fn sample<S: CoverageSink>(
        &self,
        samples: Samples,
        pixels: &PixelRect,
        sampler: &mut Supersampler<'_, '_, S>,
    ) -> Result<(), S::Error> {
        let edges = self.edges.take();
        let result = self.polygon.sample_in(samples, pixels, edges, sampler);
        self.edges.set(edges);
        result
    }
}

/// Adds up windings from left to right.
#[derive(Debug, Clone, Copy)]
struct Winding {
    number: i32,
    rule: WindingRule,
}

impl Winding {
    fn new(rule: WindingRule) -> Self {
        Self { number: 0, rule }
    }

    /// 1 where the next edge leads inside, -1 where it leads outside, 0 where it does neither.
    #[inline(always)]
    fn cross(&mut self, winding: i32) -> i32 {
        let before = self.rule.of(self.number);
        self.number += winding;
        self.rule.of(self.number) - before
    }
}
