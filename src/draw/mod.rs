//! Where shapes, colours and targets meet.

mod antialiased;
mod blended;
mod bounded;
mod filled;

pub use antialiased::{AntiAlias, AntiAliased};
pub use bounded::Bounded;
pub use filled::{Fill, Filled};
