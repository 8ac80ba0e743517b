//! Clusters: in a row of pixels, edges that share columns, or that start or end there; they are neighbours of each other.
//!
//! ```text
//!     share columns      end        start        turn
//!     |   \ /   |     |  \ /  |   |  .    |    |  \    |
//!     |    \ \  |     |   V   |   | / \   |    |   \   |
//!     |     \ \ |     |       |   |/   \  |    |   /   |
//! ```

use core::{mem::swap, ops::Range};

use heapless::Vec;

use crate::{
    coverage::{NEAR, Slope, column_of},
    limits::SUBPIXEL_BITS,
    shape::{
        active::{CoverageEdge, Track},
        bands::SLACK,
        outline::FillRule,
        table::Table,
    },
};

/// So many clusters a row; rows with more go by bands.
const MOST: usize = 4;

/// Those of a row, from left to right.
#[derive(Debug, Default)]
pub(super) struct Clusters {
    pub(super) list: Vec<Cluster, MOST>,
    /// The edges that start in the row, and one slot more.
    pub(super) starting: [CoverageEdge; 2 * MOST + 1],
    started: usize,
}

/// Edges that are neighbours of each other, and the columns that they have in the row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cluster {
    pub(super) kind: Kind,
    /// Their places.
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) first: i32,
    pub(super) last: i32,
    /// The scan line on which they start or end.
    pub(super) event: i32,
    /// Where those that start are among all that do.
    pub(super) starting: usize,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// They cross the row, and share columns.
    Whole,
    /// Two start.
    Started,
    /// Two end.
    Ended,
    /// One ends, and another goes on.
    Turned,
}

/// The scan line at the top of a row.
#[inline(always)]
pub(super) fn line_of(row: i32) -> i32 {
    row << SUBPIXEL_BITS
}

impl Cluster {
    fn new(kind: Kind, start: usize, end: usize, event: i32) -> Self {
        Self { kind, start, end, first: i32::MAX, last: i32::MIN, event, starting: 0 }
    }

    #[inline(always)]
    fn include(&mut self, from: i64, to: i64) {
        self.first = self.first.min(column_of(from.min(to)));
        self.last = self.last.max(column_of(from.max(to)));
    }
}

impl Clusters {
    /// Finds those of a row, if all other edges are apart from them and from each other, inside of the clip, and each has slots
    /// of its own. `are_apart`: edges that do not start or end there are known to be apart from each other.
    pub(super) fn find(
        &mut self,
        table: &mut Table<'_, '_, Slope>,
        fill_rule: FillRule,
        row: i32,
        event: i32,
        columns: &Range<i32>,
        are_apart: bool,
    ) -> Option<()> {
        self.list.clear();
        self.started = 0;
        if event < line_of(row + 1) {
            self.find_ended(table, row)?;
            self.find_started(table, fill_rule, row)?;
        }
        if are_apart {
            self.are_beside_none(table.active_mut(), row, columns)?;
        } else {
            self.find_whole(table.active_mut(), row, columns)?;
        }
        self.list.iter().all(|cluster| cluster.last - cluster.first < NEAR).then_some(())
    }

    fn find_ended(&mut self, table: &mut Table<'_, '_, Slope>, row: i32) -> Option<()> {
        let mut place = 0;
        while let Some(before) = table.active_mut().iter().skip(place).position(|edge| edge.until <= line_of(row + 1)) {
            place = self.add_ended(table, place + before, row)?;
        }
        Some(())
    }

    /// The edges that end in the row, from a place on. The place after them is returned.
    fn add_ended(&mut self, table: &mut Table<'_, '_, Slope>, place: usize, row: i32) -> Option<usize> {
        let (contours, rows) = (table.contours(), table.rows());
        let [edge, others @ ..] = table.active_mut().get(place..)? else { return None };
        let event = edge.until;
        let height = i64::from(event - line_of(row));
        let top = edge.edge.at_row(row);
        let to = top + edge.edge.step() * height;
        let mut cluster = Cluster::new(Kind::Ended, place, place + 2, event);
        cluster.include(top, to);
        let next = self.starting.get_mut(self.started)?;
        if next.set_below(contours, edge.vertex, edge.contour, event, rows) {
            if next.until <= line_of(row + 1) || next.edge.is_wide() {
                return None;
            }
            (cluster.kind, cluster.end, cluster.starting) = (Kind::Turned, place + 1, self.started);
            cluster.include(next.edge.position(), next.below_by::<false>(line_of(row + 1) - event));
            self.started += 1;
        } else {
            let other = others.first()?;
            let other_top = other.edge.at_row(row);
            let other_to = other_top + other.edge.step() * height;
            let goes_on = other.until != event || next.set_below(contours, other.vertex, other.contour, event, rows);
            if goes_on || other_to + SLACK < to {
                return None;
            }
            cluster.include(other_top, other_to);
        }
        self.list.push(cluster).ok()?;
        Some(cluster.end)
    }

    fn find_started(&mut self, table: &mut Table<'_, '_, Slope>, fill_rule: FillRule, row: i32) -> Option<()> {
        let count = table.starting_before(line_of(row + 1))?;
        for index in 0..count {
            self.add_started(table, fill_rule, index, row)?;
        }
        Some(())
    }

    /// The edges of the top that waits in a place of the queue.
    fn add_started(
        &mut self,
        table: &mut Table<'_, '_, Slope>,
        fill_rule: FillRule,
        index: usize,
        row: i32,
    ) -> Option<()> {
        let starting = self.started;
        let [left, right] = self.starting.get_mut(starting..)?.first_chunk_mut()?.each_mut();
        let event = table.waiting_edges(index, [left, right])?;
        self.started += 2;
        if left.edge.is_right_of(&right.edge) {
            swap(left, right);
        }
        let (left_below, right_below) =
            (left.below_by::<false>(line_of(row + 1) - event), right.below_by::<false>(line_of(row + 1) - event));
        let is_long = |edge: &CoverageEdge| edge.until > line_of(row + 1) && !edge.edge.is_wide();
        if !is_long(left) || !is_long(right) || right_below + SLACK < left_below {
            return None;
        }
        let mut cluster = Cluster::new(Kind::Started, 0, 0, event);
        cluster.starting = starting;
        cluster.include(left.edge.position(), left_below);
        cluster.include(right.edge.position(), right_below);
        let edges = &*table.active_mut();
        let place = edges.iter().take_while(|edge| column_of(edge.edge.at_row(row)) < cluster.first).count();
        (cluster.start, cluster.end) = (place, place);
        // Inside of the shape, they lead outside first.
        if fill_rule == FillRule::NonZero
            && place % 2 == 1
            && edges.get(place - 1).is_none_or(|before| before.winding() == left.winding())
        {
            return None;
        }
        let is_before = |other: &&Cluster| (other.start, other.first) < (place, cluster.first);
        let after = self.list.iter().take_while(is_before).count();
        self.insert(after, cluster)
    }

    /// As `Vec::insert`, which panics where the index is out of range.
    fn insert(&mut self, index: usize, cluster: Cluster) -> Option<()> {
        let mut place = self.list.len();
        self.list.push(cluster).ok()?;
        while place > index
            && let Some([.., before, last]) = self.list.get_mut(..=place)
        {
            swap(before, last);
            place -= 1;
        }
        Some(())
    }

    /// Whether they share no column with the edges beside them, nor with each other.
    fn are_beside_none(&self, edges: &[CoverageEdge], row: i32, columns: &Range<i32>) -> Option<()> {
        let mut last = columns.start.saturating_sub(1);
        let mut place = 0;
        let mut rest = self.list.as_slice();
        while let [cluster, others @ ..] = rest {
            rest = others;
            if cluster.start > place {
                last = column_of(edges.get(cluster.start - 1)?.edge.ends(row).1);
            }
            if cluster.first <= last {
                return None;
            }
            (last, place) = (cluster.last, cluster.end);
            if others.first().is_none_or(|next| next.start > place)
                && edges.get(place).is_some_and(|edge| column_of(edge.edge.ends(row).0) <= last)
            {
                return None;
            }
        }
        (last < columns.end).then_some(())
    }

    /// Those that share columns, between the others.
    fn find_whole(&mut self, edges: &[CoverageEdge], row: i32, columns: &Range<i32>) -> Option<()> {
        let mut last = columns.start.saturating_sub(1);
        let mut next = 0;
        let mut start = 0;
        loop {
            let cluster = self.list.get(next).copied();
            let end = cluster.map_or(edges.len(), |cluster| cluster.start);
            let mut before = (0, 0);
            for (index, edge) in edges.get(start..end)?.iter().enumerate() {
                let from = edge.edge.at_row(row);
                let to = from + edge.edge.row_step();
                let (first, before_last) = (column_of(from.min(to)), last);
                last = column_of(from.max(to));
                if first <= before_last {
                    // The clip, and clusters of edges that do not cross the whole row, are shared with none.
                    if index == 0 {
                        return None;
                    }
                    next = self.add_whole(next, start + index, before, (from, to), line_of(row + 1))?;
                    last = last.max(before_last);
                }
                before = (from, to);
            }
            let Some(cluster) = cluster else { break };
            if cluster.first <= last {
                return None;
            }
            (last, start) = (cluster.last, cluster.end);
            next += 1;
        }
        (last < columns.end).then_some(())
    }

    /// The edge in a place shares columns with the one before it. Where the next cluster is in the list is returned.
    fn add_whole(
        &mut self,
        mut next: usize,
        place: usize,
        before: (i64, i64),
        edge: (i64, i64),
        event: i32,
    ) -> Option<usize> {
        if edge.1 + SLACK < before.1 {
            return None;
        }
        if next == 0 || self.list.get(next - 1)?.end != place {
            let mut cluster = Cluster::new(Kind::Whole, place - 1, place, event);
            cluster.include(before.0, before.1);
            self.insert(next, cluster)?;
            next += 1;
        }
        let cluster = self.list.get_mut(next - 1)?;
        cluster.end = place + 1;
        cluster.include(edge.0, edge.1);
        Some(next)
    }
}
