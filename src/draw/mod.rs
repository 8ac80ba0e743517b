//! Where shapes, colours and targets meet.

mod antialiased;
mod blended;
mod bounded;
mod connect;
mod filled;

pub use antialiased::{AntiAlias, AntiAliased};
pub(crate) use blended::faded;
pub use bounded::Bounded;
pub use filled::{Fill, Filled};
