//! The variants of `polygon`.
