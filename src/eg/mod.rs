//! embedded-graphics' own primitives, drawn by this crate.

mod arc;
mod builder;
mod circle;
mod curve;
mod ellipse;
mod layers;
mod line;
mod normal;
mod outline;
mod paint;
mod pie;
mod pixel_box;
mod rectangle;
mod rounded_rectangle;
mod rows;
mod sector;
mod stroked;
mod style;
mod styled;
mod thin;
mod triangle;
mod wedge;

pub use builder::StyleBuilder;
pub use style::{Aliased, Blended, Style};
pub use styled::DrawOn;
