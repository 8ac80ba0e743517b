//! Where shapes, colours and targets meet.

mod antialiased;
mod blended;
mod connect;
mod filled;

pub use antialiased::{AntiAlias, AntiAliased};
pub use filled::{Fill, Filled};
