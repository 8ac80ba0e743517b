//! A strip of an anti-aliased polygon, on its way down, from one scan line on which edges start or end to the next.
//!
//! Where that is rows away, what is between edges is left to trapezoids. Elsewhere a row is sent as soon as it is complete: by pairs
//! of edges if it has none that start or end and none that share columns, else band by band through the cells.

use core::ops::Range;

use crate::{
    coverage::{Cell, Cells, Changes, CoverageSink, Extent, Runs, Slope, column_of, send_between},
    limits::{ONE, SUBPIXEL_BITS},
    shape::{
        Polygon,
        active::{CoverageEdge, contour_of},
        bands::{Band, Winding},
        cluster_rows::send_clusters,
        clusters::{Clusters, line_of},
        outline::{FillRule, next_index},
        table::Table,
        trapezoids::{alternate, rows_apart, send_all_up_to, set_all_sent_to},
    },
    subpixel::pixel_holding,
};

/// Trapezoids are begun where edges cross so many rows, all together, before one starts or ends.
const WORTHWHILE: usize = 12;

/// What it takes.
pub(super) struct Strip<'c, 's, S> {
    columns: Range<i32>,
    cells: Cells<'c>,
    clusters: Clusters,
    changes: Changes,
    runs: Runs<'s, S>,
}

impl<'c, 's, S: CoverageSink> Strip<'c, 's, S> {
    /// No wider than there are cells.
    pub(super) fn new(columns: Range<i32>, cells: &'c mut [Cell], sink: &'s mut S) -> Self {
        cells.fill(Cell::EMPTY);
        Self {
            cells: Cells::new(cells, columns.clone()),
            columns,
            clusters: Clusters::default(),
            changes: Changes::default(),
            runs: Runs::new(sink),
        }
    }

    /// Sends the scan lines of a polygon, from the top of a row of pixels on.
    pub(super) fn cover(
        mut self,
        polygon: &Polygon<'_>,
        rows: &Range<i32>,
        edges: &mut [CoverageEdge],
    ) -> Result<(), S::Error> {
        let fill_rule = polygon.fill_rule;
        let mut table = Table::new(polygon.contours, rows, edges);
        let mut y = rows.start;
        let mut next_trapezoids = y;
        while y < rows.end {
            table.start(y);
            if table.is_idle() {
                let next = table.next_start().max(y + 1).min(rows.end);
                // The last row of all ends where coordinates do.
                if next > y | (ONE - 1) || next == rows.end {
                    self.cells.sweep(pixel_holding(y), &mut self.runs)?;
                }
                y = next;
                continue;
            }
            let event = table.next_event(y + 1, rows.end);
            let is_wide = table.active_mut().iter().any(|edge| edge.edge.is_wide());
            while y < event {
                let row = pixel_holding(y);
                let row_end = (y | (ONE - 1)).saturating_add(1);
                let bottom = row_end.min(event);
                let band = Band { y, height: bottom - y };
                if band.height == ONE && !is_wide {
                    if is_worthwhile(event - y, table.active_mut().len())
                        && y >= next_trapezoids
                        && alternate(table.active_mut(), fill_rule)
                    {
                        y = self.send_trapezoids(row, rows.end, &mut table, fill_rule)?;
                        next_trapezoids = y + 1;
                        break;
                    }
                    if are_apart(table.active_mut(), &self.columns) {
                        send_pairs(row, table.active_mut(), fill_rule, &mut self.runs)?;
                        y = bottom;
                        continue;
                    }
                }
                y = bottom;
                if is_wide {
                    table.widen(band);
                    band.add::<true>(table.active_mut(), fill_rule, &mut self.cells);
                } else {
                    band.add::<false>(table.active_mut(), fill_rule, &mut self.cells);
                }
                if y == row_end {
                    self.cells.sweep(row, &mut self.runs)?;
                }
            }
            table.turn(y);
        }
        Ok(())
    }

    /// Sends trapezoids and the clusters between them, from the top of a row on, as far as it goes. The top of the row that all has
    /// been sent up to is returned; what starts or ends there is still to be done.
    #[inline(never)]
    fn send_trapezoids(
        &mut self,
        mut row: i32,
        end: i32,
        table: &mut Table<'_, '_, Slope>,
        fill_rule: FillRule,
    ) -> Result<i32, S::Error> {
        let Self { columns, clusters, changes, runs, .. } = self;
        set_all_sent_to(row, table.active_mut());
        let mut event = line_of(row);
        while !table.is_idle() {
            if event <= line_of(row) {
                event = table.next_event(line_of(row), end);
            }
            let of_event = pixel_holding(event);
            let mut are_apart = false;
            if of_event > row {
                row += rows_apart(row..of_event + 1, table.active_mut(), columns);
                are_apart = row > of_event;
                row = row.min(of_event);
            }
            // There is nothing below the clip, and the last row of all is cut where coordinates end.
            let is_whole = row < pixel_holding(end);
            if !is_whole || clusters.find(table, fill_rule, row, event, columns, are_apart).is_none() {
                break;
            }
            send_clusters(clusters, row, table, columns, changes, runs)?;
            row += 1;
        }
        send_all_up_to(row, table.active_mut(), columns, changes, runs)?;
        Ok(line_of(row))
    }
}

/// See [`WORTHWHILE`].
#[inline(always)]
fn is_worthwhile(scan_lines: i32, edges: usize) -> bool {
    let rows = (scan_lines >> SUBPIXEL_BITS).cast_unsigned() as usize;
    rows.saturating_mul(edges) >= WORTHWHILE
}

/// Whether none cross in a whole row of pixels, all are inside the clip, and no two share a column.
#[inline(always)]
fn are_apart(edges: &[CoverageEdge], columns: &Range<i32>) -> bool {
    let mut last = columns.start.saturating_sub(1);
    for edge in edges {
        let from = edge.edge.position();
        let to = from + edge.edge.row_step();
        if column_of(from.min(to)) <= last {
            return false;
        }
        last = column_of(from.max(to));
    }
    last < columns.end
}

/// Sends the edges of a whole row, and takes them to its lower end; some may have the inside, or none of it, on either side.
#[inline(never)]
fn send_pairs<S: CoverageSink>(
    row: i32,
    edges: &mut [CoverageEdge],
    fill_rule: FillRule,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let mut winding = Winding::new(fill_rule);
    let mut left = None;
    for edge in edges {
        let sign = winding.cross(edge.winding());
        let from = edge.edge.position();
        let to = from + edge.edge.row_step();
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
