//! What the tests hold the crate against.
//!
//! [`rule`] says for one pixel and one shape whether the pixel belongs: by signs of exact products, without a division
//! and without a line of code in common with `src/`. [`grid`] records what a shape sends into a sink and refuses
//! whatever breaks the sink's contract. [`random`] makes shapes of every kind from a seed, and windows that lie on
//! their outlines.

#![allow(dead_code, unused_imports, reason = "every test program compiles this module and takes the part it needs")]

pub(crate) mod grid;
pub(crate) mod random;
pub(crate) mod rule;

pub(crate) use grid::{Grid, block_pixels, check_exact, check_same, rect, span_pixels};
pub(crate) use random::{Rng, cases, for_each_case};
pub(crate) use rule::{Belongs, Outline};
