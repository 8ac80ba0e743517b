//! What the methods are given, and what can go wrong.

use core::fmt;

/// Closed contours with vertices `[x, y]` in the method's own numbers; the last vertex of each is joined to the first.
pub trait Contours<N: Copy> {
    /// How many there are.
    fn contours(&self) -> usize;

    /// How many vertices one of them has.
    fn vertices(&self, contour: usize) -> usize;

    /// One of its vertices; none where there is no such one.
    fn vertex(&self, contour: usize, index: usize) -> Option<[N; 2]>;

    /// The edges of all contours, in their order.
    fn edges(&self) -> impl Iterator<Item = [[N; 2]; 2]> {
        (0..self.contours()).flat_map(move |contour| {
            let vertices = self.vertices(contour);
            (0..vertices).filter_map(move |index| {
                let next = if index + 1 < vertices { index + 1 } else { 0 };
                Some([self.vertex(contour, index)?, self.vertex(contour, next)?])
            })
        })
    }
}

impl<N: Copy> Contours<N> for [&[[N; 2]]] {
    fn contours(&self) -> usize {
        self.len()
    }

    fn vertices(&self, contour: usize) -> usize {
        self.get(contour).map_or(0, |contour| contour.len())
    }

    fn vertex(&self, contour: usize, index: usize) -> Option<[N; 2]> {
        self.get(contour)?.get(index).copied()
    }
}

/// Why a method has not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Failure<E> {
    /// The scratch is too small; nothing has been drawn.
    TooLittleScratch {
        /// How many slots are enough.
        needed: usize,
        /// How many there are.
        available: usize,
    },
    /// The sink's own error.
    Sink(E),
}

impl<E: fmt::Display> fmt::Display for Failure<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLittleScratch { needed, available } => {
                write!(f, "the method needs scratch of {needed} slots, {available} available")
            }
            Self::Sink(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for Failure<E> {}
