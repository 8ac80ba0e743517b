//! What a stroke is walked in.

use crate::stroke::run::Run;

/// A step of the path, or of a dash.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// The subpath has ended before it, or ends with it.
    pub(super) is_over: bool,
    pub(super) is_last: bool,
    /// None where it has no length.
    pub(super) run: Option<Run>,
}

impl Piece {
    pub(super) const NOTHING: Self = Self { is_over: true, is_last: true, run: None };
}
