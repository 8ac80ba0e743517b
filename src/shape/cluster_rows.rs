//! Sends the clusters of a row, and what the edges beside them have of it.

use core::ops::Range;

use crate::{
    coverage::{
        Changes, CoverageSink, Extent, Runs, Slope, Steepness, Sum, column_of, height_of, send_left, send_right,
    },
    limits::ONE,
    shape::{
        active::CoverageEdge,
        clusters::{Cluster, Clusters, Kind, line_of},
        table::Table,
        trapezoids::send_up_to,
    },
};

/// Adds an edge from where it is down `height` scan lines, and takes it there.
#[inline(never)]
fn add(sum: &mut Sum, edge: &mut CoverageEdge, height: i32, leads_inside: bool) {
    let (from, to) = (edge.edge.position(), edge.below_by::<false>(height));
    edge.edge.move_to(to);
    sum.add(&edge.ramp::<false>(from, to, height_of(height)), leads_inside);
}

/// An edge beside a cluster, in the row, whose lower end it is taken to.
#[inline(always)]
fn beside(edge: &mut CoverageEdge, row: i32) -> (Extent, Steepness) {
    let from = edge.edge.position();
    let to = from + edge.edge.row_step();
    edge.edge.go_to_row(row + 1, to);
    (Extent::between(from, to), edge.edge.steepness)
}

/// Sends what is in clusters of a row, and the trapezoids that end there up to it.
///
/// The edges [alternate](super::trapezoids::alternate), before and after.
#[inline(never)]
pub(super) fn send_clusters<S: CoverageSink>(
    clusters: &mut Clusters,
    row: i32,
    table: &mut Table<'_, '_, Slope>,
    columns: &Range<i32>,
    changes: &mut Changes,
    runs: &mut Runs<'_, S>,
) -> Result<(), S::Error> {
    let Clusters { list, starting, .. } = clusters;
    let edges = table.active_mut();
    let mut inside = None;
    let mut place = 0;
    let mut rest = list.as_slice();
    while let [cluster, others @ ..] = rest {
        rest = others;
        let Cluster { start, end, .. } = *cluster;
        if let Some(column) = inside
            && place < start
            && let Some(edge) = edges.get_mut(place)
        {
            send_right(row, beside(edge, row), column, runs)?;
            inside = None;
        }
        // With what is beside it, a cluster is of whole trapezoids.
        let pairs = edges.get_mut(start & !1..end.next_multiple_of(2)).unwrap_or_default();
        for [left, right] in pairs.as_chunks_mut().0 {
            send_up_to(row, left, right, columns, changes, runs)?;
        }
        if start % 2 == 1
            && inside.is_none()
            && let Some(edge) = edges.get_mut(start - 1)
        {
            inside = Some(send_left(row, beside(edge, row), cluster.first, runs)?);
        }
        let mut sum = Sum::new(cluster.first, cluster.last);
        let mut leads_inside = start % 2 == 0;
        let below = line_of(row + 1) - cluster.event;
        let (members, height) = match cluster.kind {
            Kind::Started => (starting.get_mut(cluster.starting..cluster.starting + 2), below),
            Kind::Whole => (edges.get_mut(start..end), ONE),
            Kind::Ended | Kind::Turned => (edges.get_mut(start..end), cluster.event - line_of(row)),
        };
        for edge in members.unwrap_or_default() {
            add(&mut sum, edge, height, leads_inside);
            edge.edge.sent_to = row + 1;
            leads_inside = !leads_inside;
        }
        if cluster.kind == Kind::Turned
            && let Some(next) = starting.get_mut(cluster.starting)
        {
            add(&mut sum, next, below, !leads_inside);
            next.edge.sent_to = row + 1;
        }
        let limit = match others {
            [next, ..] if next.start == end => next.first,
            _ => edges.get(end).map_or(columns.end, |edge| column_of(edge.edge.ends(row).0)),
        };
        let column = sum.send(row, inside, limit, runs)?;
        inside = (end % 2 == 1).then_some(column);
        place = end;
    }
    if let Some(column) = inside
        && let Some(edge) = edges.get_mut(place)
    {
        send_right(row, beside(edge, row), column, runs)?;
    }
    for cluster in list.iter().rev() {
        let starting = starting.get(cluster.starting..).unwrap_or_default();
        match cluster.kind {
            Kind::Started => table.insert(cluster.start, starting.get(..2).unwrap_or_default()),
            Kind::Ended => table.remove(cluster.start),
            Kind::Turned => table.replace(cluster.start, starting.first()),
            Kind::Whole => {}
        }
    }
    Ok(())
}
