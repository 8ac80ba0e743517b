//! Exact areas.

mod accumulator;
mod chain;
mod circle;
mod contour_areas;
mod convex;
pub(crate) mod division;
mod edge;
mod emission;
mod far;
mod fill;
mod line;
mod lines;
mod order;
mod outline_areas;
mod pair;
mod piece;
mod pixel;
pub(crate) mod root;
mod rounded;
mod row;
mod sink;
pub(crate) mod source;
mod sweep;
mod table;
mod tiles;
mod winding;

pub(crate) use accumulator::WINDOW;
pub use chain::CoverageEdge;
pub(crate) use circle::send_circle;
pub(crate) use contour_areas::{send_areas, send_contours};
pub(crate) use convex::send_convex;
pub(crate) use outline_areas::send_outline;
pub(crate) use rounded::Rounded;
pub(crate) use sink::{AreaSink, PlacedAreaSink};
pub(crate) use source::vertex_position;
