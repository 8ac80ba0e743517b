//! Framebuffers: pixels in memory, packed as the display takes them.
//!
//! ```text
//! colour -ink-> Layout (rows, pages, values) <-address- Grid (size, stride) <-clip- Surface <- Framebuffer, Band
//! ```
//!
//! A [`Layout`] knows where in a line of memory a pixel lies and how to fill a piece of that line. A `Grid` knows where lines
//! begin. A `Surface` cuts what is drawn to the grid. What owns or borrows the memory is a [`Framebuffer`].

mod buffer;
mod color;
mod error;
mod grid;
mod image;
mod in_place;
mod layout;
mod pages;
mod rows;
mod surface;
mod target;
mod values;
mod words;

pub use buffer::{Framebuffer, buffer_size};
pub use color::PackedColor;
pub use error::FramebufferError;
pub use layout::{Layout, LsbFirst, MsbFirst, Order, Pages, Rows, Values};

pub(crate) use buffer::check_size;
pub(crate) use in_place::{impl_in_place, mix_run};
pub(crate) use surface::Surface;
