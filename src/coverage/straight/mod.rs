//! Shapes between two sides of at most two straight edges each, in the narrow zone: triangles and thin lines.
//!
//! Most rows are crossed by one edge on either side, from top to bottom. What the left one leaves of its pixels and what
//! the right one takes of its own are sent as they are, and all between is inside:
//!
//! ```text
//!        left          right
//!     |   /#|###|###|###\   |
//!     |  /##|###|###|####\  |        runs of one or two pixels, and a span
//!     | /###|###|###|#####\ |
//! ```
//!
//! Positions are in 2^-32 pixel: the upper half of one is its column. On a row boundary, an edge is where it is on the first
//! one, plus as many times its step as there are rows in between: it does not matter which of them are walked. A step is
//! rounded to 2^-32 pixel, and there are at most 2^14 rows: 2^-18 pixel.

mod far;
mod rows;
mod side;
mod walk;

pub(crate) use side::{Side, Straight};
pub(crate) use walk::send_straight;
