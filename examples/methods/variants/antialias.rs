//! The variants of `antialias`.
