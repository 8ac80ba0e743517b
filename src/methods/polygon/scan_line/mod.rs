//! Scan lines through an edge table and an active edge table.
//!
//! As the lecture notes "Rasterization" have it. The edge table (ET) holds every edge, by the scan line on which it
//! starts: its `Ymax`, `Xlow` where it starts, and `1/m`, what x grows by from one scan line to the next. The active
//! edge table (AET) holds those that cross the scan line, by x:
//!
//! ```text
//!   y := the smallest with an entry in the ET; the AET is empty        ET      Ymax | Xlow | 1/m
//!   until both are empty:                                                8      9   |  3   | -5/2
//!     move the edges with Ymin = y from the ET to the AET                9      .
//!     remove those with Ymax = y, sort the AET by x
//!     fill between pairs of x                                          AET at y: x0 x1 | x2 x3
//!     y := y + 1; add 1/m to each x                                                 ###   ###
//! ```
//!
//! - **Horizontal edges** have no `1/m`. They would be removed by `Ymax = y` on the scan line that they are entered on;
//!   they are not entered.
//! - **Vertices on scan lines** belong to the edge below them only, for `Ymax = y` is removed before anything is
//!   filled. Kept for one scan line more ([`Closed`]), edges meet twice in a vertex that the outline passes through:
//!   the pairs go out of step, and the rest of the row is filled where it should not be.
//! - The notes put vertices on whole coordinates, which are pixel centres. With fractions, `Xlow` is taken on the first
//!   scan line through centres at or below the vertex ([`Edge`]).
//! - The notes fill between pairs, which is the even-odd rule. The direction of an edge beside the three entries is
//!   all that the non-zero rule asks for.

mod exact;
mod fixed;
mod float;

use core::ops::Range;

pub use exact::Exact;
pub use fixed::Fixed;
pub use float::{Closed, Float};

use crate::{
    fragment::{Fragment, FragmentSink},
    geometry::PixelRect,
    methods::{
        Method,
        polygon::{Contours, Failure},
    },
    shape::FillRule,
};

/// How the method is charted.
pub const METHOD: Method = Method {
    name: "scan line",
    options: &["f32", "fixed 4", "fixed 8", "fixed 12", "fixed 16", "exact", "whole pixels", "whole pixels, Ymax kept"],
    source: "Lecture notes \"Rasterization\": scan-line algorithm, edge table and active edge table",
};

/// An edge's x on one scan line after the other, in one of the arithmetics.
pub trait Crossing: Copy {
    /// What vertices are in.
    type Number: Copy;

    /// Of no edge.
    const UNUSED: Self;

    /// The scan lines that an edge crosses, `Ymin..Ymax`, and whether it goes down; none for a horizontal one.
    fn rows(edge: [[Self::Number; 2]; 2]) -> Option<(Range<i32>, bool)>;

    /// Where it crosses one of them, and `1/m`.
    fn at_row(edge: [[Self::Number; 2]; 2], row: i32) -> Self;

    /// One scan line down: adds `1/m`.
    fn step(&mut self);

    /// Whether x lies to the left of another edge's.
    fn is_left_of(&self, other: &Self) -> bool;

    /// The first pixel whose centre lies at x or to the right of it.
    fn column(&self) -> i32;
}

/// An entry of the edge table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge<X> {
    y_min: i32,
    y_max: i32,
    x: X,
    winding: i32,
}

impl<X: Crossing> Edge<X> {
    /// What to make a table of.
    pub const EMPTY: Self = Self { y_min: 0, y_max: 0, x: X::UNUSED, winding: 0 };
}

/// Fills a polygon.
///
/// # Errors
///
/// When there are fewer slots than edges that cross a scan line of the clip; the sink's.
///
/// # Cost
///
/// A slot and a division an edge; for each scan line an addition and a comparison for each edge on it.
pub fn fill<X: Crossing, S: FragmentSink>(
    contours: &(impl Contours<X::Number> + ?Sized),
    rule: FillRule,
    clip: &PixelRect,
    slots: &mut [Edge<X>],
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    let table = edge_table(contours, clip, slots)?;
    scan(table, rule, clip, sink).map_err(Failure::Sink)
}

/// The edges that cross the clip's scan lines, by the first of those.
fn edge_table<'s, X: Crossing, E>(
    contours: &(impl Contours<X::Number> + ?Sized),
    clip: &PixelRect,
    slots: &'s mut [Edge<X>],
) -> Result<&'s mut [Edge<X>], Failure<E>> {
    let (mut needed, available) = (0, slots.len());
    for edge in contours.edges() {
        let Some((rows, down)) = X::rows(edge) else { continue };
        let (y_min, y_max) = (rows.start.max(clip.rows.start), rows.end.min(clip.rows.end));
        if y_min < y_max {
            if let Some(slot) = slots.get_mut(needed) {
                *slot = Edge { y_min, y_max, x: X::at_row(edge, y_min), winding: if down { 1 } else { -1 } };
            }
            needed += 1;
        }
    }
    let table = slots.get_mut(..needed).ok_or(Failure::TooLittleScratch { needed, available })?;
    table.sort_unstable_by_key(|edge| edge.y_min);
    Ok(table)
}

/// The AET is the front of the table, up to `active`; the ET its back, from `waiting`.
fn scan<X: Crossing, S: FragmentSink>(
    table: &mut [Edge<X>],
    rule: FillRule,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (mut active, mut waiting) = (0, 0);
    let Some(mut y) = table.first().map(|edge| edge.y_min) else { return Ok(()) };
    loop {
        while let Some(edge) = table.get(waiting).copied().filter(|edge| edge.y_min <= y) {
            if let Some(slot) = table.get_mut(active) {
                *slot = edge;
            }
            active += 1;
            waiting += 1;
        }
        active = remove_ended(table, active, y);
        if active == 0 {
            match table.get(waiting) {
                Some(edge) => y = edge.y_min,
                None => return Ok(()),
            }
            continue;
        }
        let edges = table.get_mut(..active).unwrap_or_default();
        sort_by_x(edges);
        fill_pairs(edges, rule, y, &clip.columns, sink)?;
        y = y.wrapping_add(1);
        edges.iter_mut().for_each(|edge| edge.x.step());
    }
}

/// Removes what has `Ymax = y`; how many are left.
fn remove_ended<X: Crossing>(table: &mut [Edge<X>], active: usize, y: i32) -> usize {
    let mut kept = 0;
    for index in 0..active {
        let Some(edge) = table.get(index).copied().filter(|edge| edge.y_max > y) else { continue };
        if let Some(slot) = table.get_mut(kept) {
            *slot = edge;
        }
        kept += 1;
    }
    kept
}

/// Insertion: from one scan line to the next, hardly anything changes.
fn sort_by_x<X: Crossing>(edges: &mut [Edge<X>]) {
    for end in 2..=edges.len() {
        let mut rest = edges.get_mut(..end).unwrap_or_default();
        while let [.., left, right] = rest {
            if !right.x.is_left_of(&left.x) {
                break;
            }
            core::mem::swap(left, right);
            let shorter = rest.len() - 1;
            rest = rest.get_mut(..shorter).unwrap_or_default();
        }
    }
}

fn fill_pairs<X: Crossing, S: FragmentSink>(
    edges: &[Edge<X>],
    rule: FillRule,
    y: i32,
    columns: &Range<i32>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let mut winding = 0_i32;
    let mut start = None;
    for edge in edges {
        winding = winding.wrapping_add(edge.winding);
        let is_inside = match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding & 1 != 0,
        };
        match (start, is_inside) {
            (None, true) => start = Some(edge.x.column()),
            (Some(from), false) => {
                for x in from.max(columns.start)..edge.x.column().min(columns.end) {
                    sink.visit(x, y);
                    sink.fragment(Fragment::pixel(x, y))?;
                }
                start = None;
            }
            _ => {}
        }
    }
    Ok(())
}
