//! The variants of `line`.
