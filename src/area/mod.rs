//! Exact areas.

mod accumulator;
mod chain;
mod fill;
mod order;
mod rounded;
pub(crate) mod source;
mod sweep;
mod table;
mod winding;

pub(crate) use accumulator::WINDOW;
pub use chain::CoverageEdge;
pub(crate) use fill::{AreaSink, Inside, fill};
pub(crate) use rounded::Rounded;
