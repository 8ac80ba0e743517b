//! The variants of `attribute`.
