//! What can go wrong: too little scratch. Everything else (off-screen, degenerate, at the ends of the range) draws what
//! there is to draw and succeeds.

use core::fmt;

/// The scratch is too small for the outline's active edges; nothing has been drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TooManyEdges {
    /// How many active edges the outline needs.
    pub needed: usize,
    /// How many the scratch holds.
    pub available: usize,
}

impl fmt::Display for TooManyEdges {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { needed, available } = self;
        write!(
            f,
            "the outline needs scratch for {needed} edges, not {available}: with_capacity::<{needed}>, \
             coverage_with::<{needed}>, or a slice of {needed}"
        )
    }
}

impl core::error::Error for TooManyEdges {}

/// The scratch is too small for an anti-aliased polygon; nothing has been drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TooLittleScratch {
    /// For its active edges.
    Edges(TooManyEdges),
    /// There is not a single cell.
    NoCells,
}

impl fmt::Display for TooLittleScratch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edges(error) => error.fmt(f),
            Self::NoCells => f.write_str("an anti-aliased outline needs scratch for at least one cell, none available"),
        }
    }
}

impl core::error::Error for TooLittleScratch {}

impl From<TooManyEdges> for TooLittleScratch {
    fn from(error: TooManyEdges) -> Self {
        Self::Edges(error)
    }
}
