//! What is wrong with a framebuffer's memory or size.

use core::fmt;

/// There is no such framebuffer; memory is counted in the layout's units, which are bytes for [`Rows`](crate::Rows) and
/// [`Pages`](crate::Pages) and pixels for [`Values`](crate::Values).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FramebufferError {
    /// It would have no pixel.
    Empty {
        /// The width asked for, in pixels.
        width: u32,
        /// The height asked for, in pixels.
        height: u32,
    },
    /// A side is longer than coordinates can tell: 2147483647 pixels.
    TooLarge {
        /// The width asked for, in pixels.
        width: u32,
        /// The height asked for, in pixels.
        height: u32,
    },
    /// A line of the width asked for is longer than the distance between two.
    StrideTooShort {
        /// The units of a line.
        needed: usize,
        /// The stride asked for.
        stride: usize,
    },
    /// The memory is too small.
    BufferTooSmall {
        /// The units that all lines take; `usize::MAX` where that is more.
        needed: usize,
        /// The units that there are.
        available: usize,
    },
    /// The height is not a whole number of pages.
    PartialPage {
        /// The height asked for, in pixels.
        height: u32,
        /// The rows of a page: those that share a byte.
        page_rows: u32,
    },
}

impl fmt::Display for FramebufferError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty { width, height } => write!(f, "a framebuffer of {width} x {height} pixels has none"),
            Self::TooLarge { width, height } => {
                write!(f, "a framebuffer of {width} x {height} pixels is beyond what coordinates can tell")
            }
            Self::StrideTooShort { needed, stride } => {
                write!(f, "a line of the framebuffer takes {needed} units, the stride is {stride}")
            }
            Self::BufferTooSmall { needed, available } => {
                write!(f, "the framebuffer takes {needed} units of memory, {available} available")
            }
            Self::PartialPage { height, page_rows } => {
                write!(f, "a height of {height} rows is not a multiple of the {page_rows} rows of a page")
            }
        }
    }
}

impl core::error::Error for FramebufferError {}
