//! What ends a frame early.

use core::fmt;

/// A frame has not been sent whole. The next starts from the beginning and is complete.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FrameError<E, F> {
    /// There is no memory to draw in: transfers that were forgotten have it.
    NoBuffer,
    /// The scene's.
    Scene(E),
    /// The display's.
    Flush(F),
}

impl<E: fmt::Display, F: fmt::Display> fmt::Display for FrameError<E, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBuffer => f.write_str("no buffer is left to draw in"),
            Self::Scene(error) => error.fmt(f),
            Self::Flush(error) => error.fmt(f),
        }
    }
}

impl<E: core::error::Error, F: core::error::Error> core::error::Error for FrameError<E, F> {}
