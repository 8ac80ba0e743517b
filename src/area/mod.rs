//! Exact areas.

mod accumulator;
mod chain;
mod contour_areas;
mod division;
mod far;
mod fill;
mod order;
mod outline_areas;
mod pixel;
mod rounded;
pub(crate) mod source;
mod sweep;
mod table;
mod winding;

pub(crate) use accumulator::WINDOW;
pub use chain::CoverageEdge;
pub(crate) use contour_areas::send_contours;
pub(crate) use fill::{AreaSink, Inside};
pub(crate) use outline_areas::send_outline;
pub(crate) use rounded::Rounded;
