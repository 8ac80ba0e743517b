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
        write!(f, "the outline needs scratch for {} active edges, {} available", self.needed, self.available)
    }
}

impl core::error::Error for TooManyEdges {}
