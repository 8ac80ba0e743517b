//! The variants of `points`.
