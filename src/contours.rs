//! An outline by rows: where its contours turn from going up to going down.
//!
//! Where only row centres count, a vertex stands for the first row whose centre is at or below it, kept within the rows
//! asked for; where areas count, rows are of 1/256 pixel. An edge between vertices on rows `a < b` crosses the centres of rows `a..b`; one on a single row crosses
//! none. What lies above the rows asked for thus becomes flat, and costs no more than a look.

use core::ops::Range;

use crate::{Vertex, limits::SUBPIXEL_BITS, subpixel::first_centre_at_or_after};

/// Which points are inside where contours overlap or nest.
///
/// ```text
///    winding of a      NonZero       EvenOdd
///    star's regions
///         1               #             #
///       1 2 1           # # #         # . #
///        1 1             # #           # #
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum FillRule {
    /// Inside where the outline winds around the point, in either direction.
    #[default]
    NonZero,
    /// Inside where a ray from the point crosses the outline an odd number of times.
    EvenOdd,
}

impl FillRule {
    /// What decides of a winding number: any bit of it, or whether it is odd.
    #[inline(always)]
    pub(crate) const fn mask(self) -> i32 {
        match self {
            Self::NonZero => !0,
            Self::EvenOdd => 1,
        }
    }
}

/// The rows that vertices are told apart by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rows {
    /// Of pixel centres: a vertex is on the first at or below it.
    Pixels,
    /// Of 1/256 pixel: a vertex is on its own.
    Subpixels,
}

/// One or many closed contours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Contours<'a> {
    One(&'a [Vertex]),
    Many(&'a [&'a [Vertex]]),
}

/// Indexing that is a constant function and cannot panic: an index out of range reads the origin.
const fn vertex_at(contour: &[Vertex], index: usize) -> Vertex {
    if index < contour.len() {
        #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
        let vertex = contour[index];
        vertex
    } else {
        Vertex::from_bits(0, 0)
    }
}

impl<'a> Contours<'a> {
    #[inline]
    pub(crate) const fn len(self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Many(contours) => contours.len(),
        }
    }

    /// A contour out of range is empty.
    #[inline]
    pub(crate) const fn contour(self, index: usize) -> &'a [Vertex] {
        match self {
            Self::One(contour) if index == 0 => contour,
            Self::Many(contours) if index < contours.len() => {
                #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
                let contour = contours[index];
                contour
            }
            _ => &[],
        }
    }

    /// For each local top, in the order of the contours, the contour, the last vertex before it goes down, and the row.
    ///
    /// Indices are of 31 and 32 bits, as scratch stores them: an outline that needs more fills 16 GB.
    #[inline]
    pub(crate) fn for_each_top(self, kind: Rows, rows: &Range<i32>, mut found: impl FnMut(i32, u32, i32)) {
        for (index, contour) in (0..self.len()).zip(0..i32::MAX) {
            let mut tops = Tops::new(self.contour(index), kind, rows.start, rows.end);
            while let Some((vertex, row)) = tops.next() {
                found(contour, u32::try_from(vertex).unwrap_or(u32::MAX), row);
            }
        }
    }

    /// How many edges cross the row's centre.
    const fn crossings(self, kind: Rows, row: i32) -> usize {
        let mut crossings = 0;
        let mut index = 0;
        while index < self.len() {
            let contour = self.contour(index);
            if let Some(last) = contour.last() {
                let mut above = row_of(*last, kind) <= row;
                let mut vertex = 0;
                while vertex < contour.len() {
                    let is_above = row_of(vertex_at(contour, vertex), kind) <= row;
                    crossings += (above != is_above) as usize;
                    above = is_above;
                    vertex += 1;
                }
            }
            index += 1;
        }
        crossings
    }

    /// The most edges that cross one row's centre. It is reached on a row where a contour turns down.
    pub(crate) const fn most_crossings(self, kind: Rows) -> usize {
        let mut most = 0;
        let mut index = 0;
        while index < self.len() {
            let mut tops = Tops::new(self.contour(index), kind, i32::MIN, i32::MAX);
            while let Some((_, row)) = tops.next() {
                let crossings = self.crossings(kind, row);
                if crossings > most {
                    most = crossings;
                }
            }
            index += 1;
        }
        most
    }

    /// How many chains, runs of edges that go one way, have a part in a row of pixels.
    const fn chains_in_row(self, row: i32) -> usize {
        let mut chains = 0;
        let mut index = 0;
        while index < self.len() {
            let contour = self.contour(index);
            let last = contour.len().saturating_sub(1);
            // How the contour arrives at its last vertex: by its last edge that is not flat.
            let (mut goes_down, mut meets) = (false, false);
            let mut from = vertex_at(contour, last).y.to_bits();
            let mut before = last;
            while before > 0 {
                before -= 1;
                let y = vertex_at(contour, before).y.to_bits();
                if y != from {
                    (goes_down, meets) = (y < from, meets_row(y, from, row));
                    break;
                }
            }
            let mut vertex = 0;
            while vertex < contour.len() {
                let to = vertex_at(contour, vertex).y.to_bits();
                if from != to {
                    let meets_now = meets_row(from, to, row);
                    chains += (meets_now && !(meets && goes_down == (from < to))) as usize;
                    (goes_down, meets) = (from < to, meets_now);
                }
                from = to;
                vertex += 1;
            }
            index += 1;
        }
        chains
    }

    /// The most chains that have a part in one row of pixels. It is reached on a row where a contour turns down.
    pub(crate) const fn most_in_a_row(self) -> usize {
        let mut most = 0;
        let mut index = 0;
        while index < self.len() {
            let mut tops = Tops::new(self.contour(index), Rows::Subpixels, i32::MIN, i32::MAX);
            let mut last_row = None;
            while let Some((_, y)) = tops.next() {
                let row = y >> SUBPIXEL_BITS;
                if !matches!(last_row, Some(last) if last == row) {
                    last_row = Some(row);
                    let chains = self.chains_in_row(row);
                    if chains > most {
                        most = chains;
                    }
                }
            }
            index += 1;
        }
        most
    }

    /// What `most_crossings` or, for rows of 1/256 pixel, `most_in_a_row` says, by sorting: none with less room than a number
    /// for each of the [`chains`](Self::chains).
    ///
    /// Two chains start at each top and two end at each bottom, and a contour has as many of one as of the other. So the
    /// chains that have a part in a row are twice the tops down to it, less twice the bottoms that lie above its part.
    pub(crate) fn most_by_sorting(self, kind: Rows, room: &mut [i32]) -> Option<usize> {
        let turns = room.get_mut(..self.chains(kind))?;
        let (firsts, lasts) = turns.split_at_mut_checked(turns.len() / 2)?;
        let (mut free_first, mut free_last) = (firsts.iter_mut(), lasts.iter_mut());
        for index in 0..self.len() {
            for_each_turn(self.contour(index), kind, |is_top, row| {
                let (slot, row) = match (is_top, kind) {
                    (true, Rows::Pixels) => (free_first.next(), row),
                    (true, Rows::Subpixels) => (free_first.next(), row >> SUBPIXEL_BITS),
                    // A bottom is below a top, so that there is a row above it.
                    (false, Rows::Pixels) => (free_last.next(), row.saturating_sub(1)),
                    (false, Rows::Subpixels) => (free_last.next(), row.saturating_sub(1) >> SUBPIXEL_BITS),
                };
                if let Some(slot) = slot {
                    *slot = row;
                }
            });
        }
        sort(firsts);
        sort(lasts);
        let (mut most, mut active) = (0, 0_usize);
        let mut lasts = lasts.iter().peekable();
        for first in firsts {
            active += 2;
            while lasts.next_if(|last| **last < *first).is_some() {
                active = active.saturating_sub(2);
            }
            most = most.max(active);
        }
        Some(most)
    }

    /// Two edges leave every top: as many as could ever be active at once.
    pub(crate) const fn chains(self, kind: Rows) -> usize {
        let mut chains = 0;
        let mut index = 0;
        while index < self.len() {
            let mut tops = Tops::new(self.contour(index), kind, i32::MIN, i32::MAX);
            while tops.next().is_some() {
                chains += 2;
            }
            index += 1;
        }
        chains
    }
}

/// Names the row of each vertex where a contour turns, and whether it turns down there.
fn for_each_turn(contour: &[Vertex], kind: Rows, mut found: impl FnMut(bool, i32)) {
    let mut rows = contour.iter().map(|vertex| row_of(*vertex, kind));
    let Some(mut row) = rows.next_back() else { return };
    // By its last edge that is not flat. A contour without one has no turns.
    let Some(mut goes_down) = rows.rev().find(|before| *before != row).map(|before| before < row) else { return };
    for next in contour.iter().map(|vertex| row_of(*vertex, kind)) {
        if next != row {
            if goes_down != (next > row) {
                goes_down = next > row;
                found(goes_down, row);
            }
            row = next;
        }
    }
}

/// Heapsort: in place, without a worst case, without a panic path, and small.
fn sort(numbers: &mut [i32]) {
    for parent in (0..numbers.len() / 2).rev() {
        sift(numbers, parent);
    }
    let mut heap = numbers;
    while let [greatest, .., last] = heap {
        core::mem::swap(greatest, last);
        let Some((_, rest)) = heap.split_last_mut() else { return };
        heap = rest;
        sift(heap, 0);
    }
}

/// Moves a number down below all that are greater.
fn sift(heap: &mut [i32], mut parent: usize) {
    while let Some(&number) = heap.get(parent) {
        let child = 2 * parent + 1;
        let (left, right) = (heap.get(child).copied(), heap.get(child + 1).copied());
        let (child, greater) = match (left, right) {
            (Some(left), Some(right)) if left < right => (child + 1, right),
            (Some(left), _) => (child, left),
            _ => return,
        };
        if greater <= number {
            return;
        }
        for (index, value) in [(parent, greater), (child, number)] {
            if let Some(slot) = heap.get_mut(index) {
                *slot = value;
            }
        }
        parent = child;
    }
}

/// Whether an edge between two heights has a part in a row of pixels.
#[inline(always)]
const fn meets_row(a: i32, b: i32, row: i32) -> bool {
    let (top, bottom) = if a < b { (a, b) } else { (b, a) };
    top >> SUBPIXEL_BITS <= row && (bottom - 1) >> SUBPIXEL_BITS >= row
}

#[inline(always)]
const fn row_of(vertex: Vertex, kind: Rows) -> i32 {
    match kind {
        Rows::Pixels => first_centre_at_or_after(vertex.y.to_bits()),
        Rows::Subpixels => vertex.y.to_bits(),
    }
}

/// Walks a contour for the vertices where it turns down, its rows kept within `first..=end`.
struct Tops<'a> {
    contour: &'a [Vertex],
    kind: Rows,
    first: i32,
    end: i32,
    next: usize,
    /// The row of the vertex before `next`.
    row: i32,
    went_up: bool,
}

impl<'a> Tops<'a> {
    #[inline]
    const fn new(contour: &'a [Vertex], kind: Rows, first: i32, end: i32) -> Self {
        let mut tops = Self { contour, kind, first, end, next: 0, row: 0, went_up: false };
        let Some(last) = contour.last() else { return tops };
        tops.row = tops.clamped_row(*last);
        // How the contour arrives at its last vertex: by its last edge that is not flat.
        let mut before = contour.len() - 1;
        while before > 0 {
            before -= 1;
            let row = tops.clamped_row(vertex_at(contour, before));
            if row != tops.row {
                tops.went_up = row > tops.row;
                break;
            }
        }
        tops
    }

    #[inline]
    const fn clamped_row(&self, vertex: Vertex) -> i32 {
        let row = row_of(vertex, self.kind);
        if row < self.first {
            self.first
        } else if row > self.end {
            self.end
        } else {
            row
        }
    }

    #[inline]
    const fn next(&mut self) -> Option<(usize, i32)> {
        while self.next < self.contour.len() {
            let index = self.next;
            let (above, row) = (self.row, self.clamped_row(vertex_at(self.contour, index)));
            self.next += 1;
            self.row = row;
            if row < above {
                self.went_up = true;
            } else if row > above {
                let is_top = self.went_up;
                self.went_up = false;
                if is_top {
                    let before = if index == 0 { self.contour.len() - 1 } else { index - 1 };
                    return Some((before, above));
                }
            }
        }
        None
    }
}

/// The vertex after `index`, or before it, around the contour.
#[inline]
pub(crate) fn next_index<T>(contour: &[T], index: u32, is_forward: bool) -> u32 {
    let last = u32::try_from(contour.len().saturating_sub(1)).unwrap_or(u32::MAX);
    if is_forward {
        if index < last { index + 1 } else { 0 }
    } else if index > 0 {
        index - 1
    } else {
        last
    }
}

/// The edge that goes down one way from `vertex`, which is on `row`, past flat edges: its ends, the index of the lower
/// one, and that one's row. `None` where the contour turns up.
#[inline(always)]
pub(crate) fn edge_below(
    contour: &[Vertex],
    vertex: u32,
    is_forward: bool,
    row: i32,
    kind: Rows,
    rows: &Range<i32>,
) -> Option<(Vertex, Vertex, u32, i32)> {
    let mut index = vertex;
    let mut upper = *contour.get(index as usize)?;
    // A contour all of whose vertices are on one row has no edges; it is not walked around twice.
    for _ in 0..contour.len() {
        index = next_index(contour, index, is_forward);
        let lower = *contour.get(index as usize)?;
        let lower_row = row_of(lower, kind).min(rows.end).max(rows.start);
        if lower_row != row {
            return if lower_row > row { Some((upper, lower, index, lower_row)) } else { None };
        }
        upper = lower;
    }
    None
}
