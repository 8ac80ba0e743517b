//! skeleton
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used
)]

mod draw;
mod edge;
mod error;
mod geometry;
mod limits;
mod shape;
mod span;
mod subpixel;

pub use draw::{Fill, Filled};
pub use error::TooManyEdges;
pub use fixed::types::I24F8;
pub use geometry::{PixelRect, Vertex};
pub use shape::{
    ActiveEdge, ActiveEdges, Circle, FillRule, Line, Polygon, PolygonInScratch, PolygonWithCapacity, Shape, Triangle,
};
pub use span::{BlockSink, Span, SpanSink};

/// What a program that draws needs in scope.
pub mod prelude {
    pub use crate::{Fill as _, Shape as _};
}
