//! The variants of `triangle`.
