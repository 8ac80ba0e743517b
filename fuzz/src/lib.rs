//! Outlines of all kinds, from bytes, and what must hold of each: see [`Target`].

mod areas;
mod case;
#[path = "../../tests/memory/mod.rs"]
mod memory;
#[path = "../../tests/oracle/mod.rs"]
mod oracle;
mod outlines;
mod picture;
mod shrink;
mod source;
mod targets;

pub use targets::{Target, worst};
