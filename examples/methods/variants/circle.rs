//! The variants of `circle`.
