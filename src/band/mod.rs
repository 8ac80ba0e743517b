//! A frame in bands: a few rows of memory that stand for one part of the screen after the other.
//!
//! ```text
//!   screen         +--------------------+
//!                  | sent               |
//!                  |--------------------|        scene -> band -> display
//!                  | band: drawn now    |  <-    the same scene, cut to each band
//!                  |--------------------|
//!                  | to come            |
//!                  +--------------------+
//! ```
//!
//! `Parts` tells which parts there are, a [`Band`] is what a scene draws on, and [`Bands`] runs the scene and hands the bands
//! over: to a function, to an `async` one, or to a transfer that owns the memory until it is done.

mod bands;
mod draw_async;
mod draw_by_transfers;
mod error;
mod part;
mod parts;

pub use bands::Bands;
pub use draw_by_transfers::{Transfer, Transmit};
pub use error::FrameError;
pub use part::Band;
pub use parts::Parts;
