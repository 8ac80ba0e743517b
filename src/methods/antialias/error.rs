//! What can go wrong: too little scratch, or the sink.

use core::fmt;

/// Why a method did not draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Error<E> {
    /// The scratch is too small; nothing has been drawn.
    Scratch {
        /// How many slots are needed.
        needed: usize,
        /// How many there are.
        available: usize,
    },
    /// The sink's own.
    Sink(E),
}

impl<E> Error<E> {
    pub(super) fn check(needed: usize, available: usize) -> Result<(), Self> {
        if needed <= available { Ok(()) } else { Err(Self::Scratch { needed, available }) }
    }
}

impl<E: fmt::Display> fmt::Display for Error<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scratch { needed, available } => {
                write!(f, "the method needs scratch of {needed} slots, {available} available")
            }
            Self::Sink(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for Error<E> {}
