//! What the page draws, and the host: the dashboard, and shapes and scenes by every method of the literature.
//!
//! ```text
//! subject (shapes) · choice (a method) -> drawing -> judge (exact rule, by the tests' oracle) -> page -> exports
//! ```

pub mod canvas;
pub mod catalogue;
#[path = "../../firmware/pico/src/dashboard.rs"]
pub mod dashboard;
pub mod drawing;
#[cfg(target_arch = "wasm32")]
mod exports;
pub mod judge;
mod oracle;
pub mod page;
pub mod subject;
#[allow(clippy::new_without_default, reason = "of several megabytes: nobody's default")]
#[path = "../../methods/variants/mod.rs"]
pub mod variants;
