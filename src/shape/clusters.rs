//! Clusters: in a row of pixels, edges that share columns, or that start or end there; they are neighbours of each other.
//!
//! ```text
//!     share columns      end        start        turn
//!     |   \ /   |     |  \ /  |   |  .    |    |  \    |
//!     |    \ \  |     |   V   |   | / \   |    |   \   |
//!     |     \ \ |     |       |   |/   \  |    |   /   |
//! ```

use core::ops::Range;

use heapless::Vec;

use crate::{
    coverage::{NEAR, Slope, column_of},
    limits::ONE,
    shape::{active::{CoverageEdge, Track}, bands::SLACK, outline::FillRule, table::Table},
};

/// So many clusters a row; rows with more go by bands.
const MOST: usize = 4;

pub(super) type Clusters = Vec<Cluster, MOST>;

/// Edges that are neighbours of each other, and the columns that they have in the row.
#[derive(Debug)]
pub(super) struct Cluster {
    pub(super) places: Range<usize>,
    pub(super) first: i32,
    pub(super) last: i32,
    /// The scan line on which they start or end.
    pub(super) event: i32,
    pub(super) kind: Kind,
}

#[derive(Debug)]
pub(super) enum Kind {
    /// They cross the row, and share columns.
    Whole,
    /// They start.
    Started([CoverageEdge; 2]),
    /// They end.
    Ended,
    /// It ends, and another goes on.
    Turned(CoverageEdge),
}

/// A row of pixels, from one scan line to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct PixelRow {
    pub(super) row: i32,
    pub(super) start: i32,
    pub(super) end: i32,
}

impl Cluster {
    fn new(places: Range<usize>, event: i32, kind: Kind) -> Self {
        Self { places, first: i32::MAX, last: i32::MIN, event, kind }
    }

    fn include(&mut self, from: i64, to: i64) {
        self.first = self.first.min(column_of(from.min(to)));
        self.last = self.last.max(column_of(from.max(to)));
    }

    /// The edges of the top that waits in a place of the queue.
    fn started(table: &mut Table<'_, '_, Slope>, fill_rule: FillRule, index: usize, at: PixelRow) -> Option<Self> {
        let (event, [mut left, mut right]) = table.waiting_edges(index)?;
        if left.edge.is_right_of(&right.edge) {
            (left, right) = (right, left);
        }
        if left.until <= at.end || right.until <= at.end || left.edge.is_wide() || right.edge.is_wide() {
            return None;
        }
        let below = [&left, &right].map(|edge| edge.below_by::<false>(at.end - event));
        let [left_below, right_below] = below;
        if right_below + SLACK < left_below {
            return None;
        }
        let mut cluster = Self::new(0..0, event, Kind::Started([left, right]));
        cluster.include(left.edge.position(), left_below);
        cluster.include(right.edge.position(), right_below);
        let edges = &*table.active_mut();
        let place = edges.iter().take_while(|edge| column_of(edge.edge.at_row(at.row)) < cluster.first).count();
        cluster.places = place..place;
        // Inside of the shape, they lead outside first.
        let before = place.checked_sub(1).and_then(|before| edges.get(before)).filter(|_| place % 2 == 1);
        let alternates = before.is_none_or(|before| {
            fill_rule == FillRule::EvenOdd || before.winding() != left.winding()
        });
        alternates.then_some(cluster)
    }

    /// The edges that end in the row, from a place on.
    fn ended(table: &mut Table<'_, '_, Slope>, place: usize, at: PixelRow) -> Option<Self> {
        let (contours, rows) = (table.contours(), table.rows());
        let rest = table.active_mut().get(place..).unwrap_or_default();
        let [edge, others @ ..] = rest else { return None };
        let event = edge.until;
        if event == at.end {
            return None;
        }
        let top = edge.edge.at_row(at.row);
        let to = top + edge.edge.step() * i64::from(event - at.start);
        let mut cluster;
        if let Some(next) = CoverageEdge::below(contours, edge.vertex, edge.contour, event, rows) {
            if next.until <= at.end || next.edge.is_wide() {
                return None;
            }
            cluster = Self::new(place..place + 1, event, Kind::Turned(next));
            cluster.include(next.edge.position(), next.below_by::<false>(at.end - event));
        } else {
            let other = others.first()?;
            let other_top = other.edge.at_row(at.row);
            let other_to = other_top + other.edge.step() * i64::from(event - at.start);
            let ends = other.until == event
                && CoverageEdge::below(contours, other.vertex, other.contour, event, rows).is_none();
            if !ends || other_to + SLACK < to {
                return None;
            }
            cluster = Self::new(place..place + 2, event, Kind::Ended);
            cluster.include(other_top, other_to);
        }
        cluster.include(top, to);
        Some(cluster)
    }
}

/// Finds the clusters of a row, from left to right, if all other edges are apart from them and from each other, inside of the
/// clip, and each has slots of its own.
pub(super) fn find(
    table: &mut Table<'_, '_, Slope>,
    fill_rule: FillRule,
    at: PixelRow,
    event: i32,
    columns: &Range<i32>,
) -> Option<Clusters> {
    let mut clusters = Clusters::new();
    // The last row of all is cut where coordinates end.
    if at.end & (ONE - 1) != 0 {
        return None;
    }
    if event < at.end {
        find_events(table, fill_rule, at, &mut clusters)?;
    }
    let edges = &*table.active_mut();
    let mut last = columns.start.saturating_sub(1);
    let mut next = 0;
    let mut place = 0;
    // Where the edge before leaves the row, if it crosses all of it.
    let mut before = None;
    loop {
        if let Some(cluster) = clusters.get(next).filter(|cluster| cluster.places.start == place) {
            if cluster.first <= last {
                return None;
            }
            (last, place) = (cluster.last, cluster.places.end);
            next += 1;
            before = None;
            continue;
        }
        let Some(edge) = edges.get(place) else { break };
        let (from, to) = (edge.edge.at_row(at.row), edge.edge.at_row(at.row + 1));
        if column_of(from.min(to)) <= last {
            let (before_from, before_to) = before?;
            if to + SLACK < before_to {
                return None;
            }
            let is_next = next.checked_sub(1).and_then(|index| clusters.get(index));
            if is_next.is_none_or(|cluster| cluster.places.end != place) {
                let mut cluster = Cluster::new(place - 1..place, at.end, Kind::Whole);
                cluster.include(before_from, before_to);
                clusters.insert(next, cluster).ok()?;
                next += 1;
            }
            let cluster = clusters.get_mut(next - 1)?;
            cluster.places.end = place + 1;
            cluster.include(from, to);
        }
        last = last.max(column_of(from.max(to)));
        before = Some((from, to));
        place += 1;
    }
    let are_near = clusters.iter().all(|cluster| cluster.last - cluster.first < NEAR);
    (next == clusters.len() && are_near && last < columns.end).then_some(clusters)
}

fn find_events(
    table: &mut Table<'_, '_, Slope>,
    fill_rule: FillRule,
    at: PixelRow,
    clusters: &mut Clusters,
) -> Option<()> {
    let mut place = 0;
    while let Some(edge) = table.active_mut().get(place) {
        if edge.until > at.end {
            place += 1;
            continue;
        }
        let cluster = Cluster::ended(table, place, at)?;
        place = cluster.places.end;
        clusters.push(cluster).ok()?;
    }
    let starting = table.starting_before(at.end)?;
    for index in 0..starting {
        let cluster = Cluster::started(table, fill_rule, index, at)?;
        let order = |other: &Cluster| (other.places.start, other.first) < (cluster.places.start, cluster.first);
        let after = clusters.iter().take_while(|other| order(other)).count();
        clusters.insert(after, cluster).ok()?;
    }
    Some(())
}
