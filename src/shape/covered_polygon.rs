//! Anti-aliased polygon: bands through an active edge table, added up in a row of cells.

use core::{cell::Cell as Shared, fmt, ops::Range};

use crate::{
    PixelRect, TooManyEdges,
    coverage::{Cell, Cells, Changes, CoverageSink, Extent, Runs, Slope, send_between},
    error::TooLittleScratch,
    geometry::touched,
    limits::{ONE, SUBPIXEL_BITS},
    shape::{
        ActiveEdges, Cover, Polygon,
        active::{CoverageEdge, contour_of},
        bands::{Band, Winding, are_apart},
        cluster_rows::send_clusters,
        clusters::{Clusters, PixelRow},
        outline::{FillRule, Rows, next_index},
        table::Table,
        trapezoids::{all_sent_up_to, alternate, rows_apart, send_all_up_to},
    },
    span::clip_range,
    subpixel::pixel_holding,
};

impl<'a> Polygon<'a> {
    /// How much scratch the anti-aliased outline needs: the most edges that cross one row of 1/256 pixel.
    ///
    /// As [`active_edges`](Self::active_edges), which counts rows of pixel centres, it is meant for constants.
    pub const fn coverage_edges(&self) -> usize {
        self.contours.most_crossings(Rows::Subpixels)
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
        let width = i32::try_from(cells.len()).unwrap_or(i32::MAX).max(1);
        let mut rest = clip.columns.clone();
        if rest.end.saturating_sub(rest.start) > width {
            rest = clip_range(&self.touched().columns, &rest);
        }
        while rest.start < rest.end {
            let end = rest.start.saturating_add(width).min(rest.end);
            self.cover_strip(&clip.rows, rest.start..end, edges, cells, sink)?;
            rest.start = end;
        }
        Ok(())
    }

    /// No wider than there are cells.
    fn cover_strip<S: CoverageSink>(
        &self,
        rows: &Range<i32>,
        columns: Range<i32>,
        edges: &mut [CoverageEdge],
        cells: &mut [Cell],
        sink: &mut S,
    ) -> Result<(), S::Error> {
        // No coordinate is beyond what saturates.
        let rows = rows.start.saturating_mul(ONE)..rows.end.saturating_mul(ONE);
        if rows.is_empty() {
            return Ok(());
        }
        cells.fill(Cell::EMPTY);
        let mut walk = Walk {
            fill_rule: self.fill_rule,
            columns: columns.clone(),
            table: Table::new(self.contours, &rows, edges),
            cells: Cells::new(cells, columns),
            clusters: Clusters::default(),
            changes: Changes::default(),
            runs: Runs::new(sink),
        };
        let mut y = rows.start;
        let mut alternate = true;
        while y < rows.end {
            let mut row = pixel_holding(y);
            if walk.table.next_event(y, rows.end) == y {
                walk.start_at_row(row, y)?;
                alternate = walk.alternate();
            }
            if walk.table.is_idle() {
                let next = walk.table.next_start().min(rows.end) & !(ONE - 1);
                if next > y {
                    y = next;
                    continue;
                }
            }
            let event = walk.table.next_event(y + 1, rows.end);
            let event_row = pixel_holding(event);
            let last_row = pixel_holding(event - 1);
            let mut are_apart = false;
            while row < event_row {
                if alternate {
                    row += walk.rows_apart(row..last_row + 1);
                    if row >= event_row {
                        are_apart = row > event_row;
                        break;
                    }
                }
                alternate = walk.send_row(row, rows.end, event, alternate, false)?;
                row += 1;
            }
            y = event_row << SUBPIXEL_BITS;
            if y < event {
                alternate = walk.send_row(event_row, rows.end, event, alternate, are_apart)?;
                y = y.saturating_add(ONE);
            }
        }
        walk.send_all_up_to(pixel_holding(rows.end))
    }
}

/// A strip of a polygon, on its way down.
struct Walk<'a, 's, 'r, S> {
    fill_rule: FillRule,
    columns: Range<i32>,
    table: Table<'a, 's, Slope>,
    cells: Cells<'s>,
    clusters: Clusters,
    changes: Changes,
    runs: Runs<'r, S>,
}

impl<S: CoverageSink> Walk<'_, '_, '_, S> {
    fn alternate(&mut self) -> bool {
        alternate(self.table.active_mut(), self.fill_rule)
    }

    fn send_all_up_to(&mut self, row: i32) -> Result<(), S::Error> {
        send_all_up_to(row, self.table.active_mut(), &self.columns, &mut self.changes, &mut self.runs)
    }

    fn rows_apart(&mut self, rows: Range<i32>) -> i32 {
        rows_apart(rows, self.table.active_mut(), &self.columns)
    }

    /// Starts and ends edges on the scan line at the top of a row.
    #[inline(never)]
    fn start_at_row(&mut self, row: i32, y: i32) -> Result<(), S::Error> {
        self.send_all_up_to(row)?;
        self.table.turn(y);
        self.table.start(y);
        all_sent_up_to(row, self.table.active_mut());
        Ok(())
    }

    /// Sends a row in which edges share columns, start or end, or some are not apart. Whether the edges alternate below it is
    /// returned.
    fn send_row(&mut self, row: i32, end: i32, event: i32, alternate: bool, are_all_apart: bool) -> Result<bool, S::Error> {
        let start = row << SUBPIXEL_BITS;
        let at = PixelRow { row, start, end: start.saturating_add(ONE).min(end) };
        let Self { fill_rule, table, columns, clusters, changes, runs, .. } = self;
        if alternate && clusters.find(table, *fill_rule, at, event, are_all_apart, columns).is_some() {
            send_clusters(clusters, at, table, columns, changes, runs)?;
            return Ok(true);
        }
        let edges = table.active_mut();
        send_all_up_to(row, edges, columns, changes, runs)?;
        let is_whole = event >= at.end && at.end.wrapping_sub(at.start) == ONE;
        if is_whole && !edges.iter().any(|edge| edge.edge.is_wide()) && are_apart(edges, columns) {
            send_pairs(row, edges, &mut Winding::new(*fill_rule), runs)?;
        } else {
            self.send_bands(at)?;
        }
        all_sent_up_to(row + 1, self.table.active_mut());
        Ok(self.alternate())
    }

    #[inline(never)]
    fn send_bands(&mut self, at: PixelRow) -> Result<(), S::Error> {
        let Self { fill_rule, table, cells, runs, .. } = self;
        let mut y = at.start;
        while y < at.end {
            let bottom = table.next_event(y + 1, at.end);
            let band = Band { y, height: bottom - y };
            y = bottom;
            if table.active_mut().iter().any(|edge| edge.edge.is_wide()) {
                table.widen(band);
                band.add::<true>(table.active_mut(), *fill_rule, cells);
            } else {
                band.add::<false>(table.active_mut(), *fill_rule, cells);
            }
            if y < at.end {
                table.turn(y);
                table.start(y);
            }
        }
        cells.sweep(at.row, runs)
    }
}

/// Sends the edges of a whole row, and takes them to its lower end; some may have the inside, or none of it, on either side.
#[inline(never)]
fn send_pairs<S: CoverageSink>(
    row: i32,
    edges: &mut [CoverageEdge],
    winding: &mut Winding,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let mut left = None;
    for edge in edges {
        let sign = winding.cross(edge.winding());
        let (from, to) = (edge.edge.position(), edge.below_by::<false>(ONE));
        edge.edge.move_to(to);
        let side = (Extent::between(from, to), edge.edge.steepness);
        match (sign, left.take()) {
            (1, _) => left = Some(side),
            (-1, Some(left)) => send_between(row, left, side, runs)?,
            (_, kept) => left = kept,
        }
    }
    Ok(())
}

impl Table<'_, '_, Slope> {
    /// Brings edges that are not in the narrow zone up to date for a band.
    fn widen(&mut self, band: Band) {
        let Band { y, height } = band;
        let bottom = y + height;
        let contours = self.contours();
        for slot in self.active_mut() {
            if slot.edge.is_wide() {
                let contour = contour_of(contours, slot.contour);
                let upper = next_index(contour, slot.vertex, slot.contour < 0);
                if let (Some(&upper), Some(&lower)) = (contour.get(upper as usize), contour.get(slot.vertex as usize)) {
                    slot.edge.widen(upper, lower, y, bottom);
                }
            }
        }
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
        let mut edges = ActiveEdges::<EDGES, _>::new();
        self.polygon.cover(clip, edges.as_mut_slice(), &mut [Cell::EMPTY; CELLS], sink)
    }
}
