//! Shapes of curves: exact by the rule of centres without anti-aliasing, and outlines to fill, stroke and blend.
//!
//! Each is a [`Shape`](crate::Shape), whose rows are worked out one by one in integers, and [`Curves`](crate::Curves),
//! which anti-aliasing and strokes take.

mod circle_outline;
mod ellipse;
mod quadrilateral;
mod rectangle;
mod ring;
mod rounded_rectangle;
mod rows;
mod sector;
mod tapered;

pub use circle_outline::CircleOutline;
pub use ellipse::Ellipse;
#[cfg(feature = "embedded-graphics")]
pub(crate) use quadrilateral::Quadrilateral;
pub use rectangle::Rectangle;
pub use ring::Ring;
pub use rounded_rectangle::RoundedRectangle;
pub use sector::{Arc, ArcLine, Sector};
pub use tapered::TaperedLine;
