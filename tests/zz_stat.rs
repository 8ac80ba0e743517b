//! debugging
#![allow(warnings, clippy::all)]
