//! Scratch for active edges: what one slot holds.

use core::ops::Range;

use crate::{
    Vertex,
    contours::{Contours, Rows, edge_below, next_index},
    edge::Edge,
    shape::polygon::waiting::Top,
};

/// What an active edge keeps of where it is.
pub trait Track: Copy {
    /// Of no edge.
    const EMPTY: Self;
    /// The rows that it is made for.
    const ROWS: Rows;

    /// The edge on `row`, which it crosses.
    fn on_row(upper: Vertex, lower: Vertex, row: i32) -> Self;

    /// Whether it belongs to the right of another.
    fn is_right_of(&self, left: &Self) -> bool;

    /// Whether it can be taken to the next row without its vertices.
    fn can_step(&self) -> bool;
}

impl Track for Edge {
    const EMPTY: Self = Self::EMPTY;
    const ROWS: Rows = Rows::Pixels;

    #[inline]
    fn on_row(upper: Vertex, lower: Vertex, row: i32) -> Self {
        Self::on_row(upper, lower, row)
    }

    #[inline(always)]
    fn is_right_of(&self, left: &Self) -> bool {
        self.column > left.column
    }

    #[inline(always)]
    fn can_step(&self) -> bool {
        self.can_step()
    }
}

/// Scratch for one active edge of a polygon; see [`Polygon`](crate::Polygon). 32 bytes.
#[derive(Debug, Clone, Copy, Default)]
pub struct ActiveEdge<T = Edge> {
    pub(in crate::shape) edge: T,
    /// The row it ends on; of a top that waits, the row it starts on.
    pub(in crate::shape) until: i32,
    /// The vertex it ends at; of a top that waits, the one it starts at.
    pub(in crate::shape) vertex: u32,
    /// The contour that it is part of, inverted where it runs up it.
    pub(in crate::shape) contour: i32,
}

const _: () = assert!(size_of::<ActiveEdge>() == 32);

impl<T: Track> ActiveEdge<T> {
    /// Unused scratch.
    pub const EMPTY: Self = Self { edge: T::EMPTY, until: 0, vertex: 0, contour: 0 };

    /// Makes it the edge that leaves `vertex` one way, if that goes down; `row` is the vertex's.
    #[inline]
    pub(in crate::shape) fn set_below(
        &mut self,
        contours: Contours<'_>,
        vertex: u32,
        contour: i32,
        row: i32,
        rows: &Range<i32>,
    ) -> bool {
        let below = edge_below(contour_of(contours, contour), vertex, contour >= 0, row, T::ROWS, rows);
        if let Some((upper, lower, vertex, until)) = below {
            *self = Self { edge: T::on_row(upper, lower, row), until, vertex, contour };
        }
        below.is_some()
    }

    /// 1 where the contour goes down, -1 where it goes up.
    #[inline(always)]
    pub(in crate::shape) fn winding(&self) -> i32 {
        (self.contour >> 31) | 1
    }

    /// A slot that waits uses three of its fields, and only those are moved.
    #[inline(always)]
    pub(in crate::shape) fn wait_for(&mut self, top: Top) {
        (self.until, self.vertex, self.contour) = (top.row, top.vertex, top.contour);
    }

    #[inline(always)]
    pub(in crate::shape) fn top(&self) -> Top {
        Top { row: self.until, vertex: self.vertex, contour: self.contour }
    }
}

#[inline]
pub(in crate::shape) fn contour_of(contours: Contours<'_>, contour: i32) -> &[Vertex] {
    contours.contour((contour ^ (contour >> 31)).unsigned_abs() as usize)
}

/// An edge too tall to be stepped, for another row.
#[inline(never)]
pub(in crate::shape) fn remade<T: Track>(contour: &[Vertex], lower: u32, is_forward: bool, row: i32) -> T {
    match (contour.get(next_index(contour, lower, !is_forward) as usize), contour.get(lower as usize)) {
        (Some(&upper), Some(&lower)) => T::on_row(upper, lower, row),
        _ => T::EMPTY,
    }
}
