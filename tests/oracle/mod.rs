//! What the tests hold the crate against.
//!
//! [`rule`] says for one pixel and one shape whether the pixel belongs: by signs of exact products, without a division
//! and without a line of code in common with `src/`. [`grid`] records what a shape sends into a sink and refuses
//! whatever breaks the sink's contract. [`area`] says how much of a pixel belongs, [`coverage_grid`] records how much a
//! shape says. [`random`] makes shapes of every kind from a seed, and windows that lie on
//! their outlines.

#![allow(dead_code, unused_imports, reason = "every test program compiles this module and takes the part it needs")]

pub(crate) mod area;
pub(crate) mod coverage_grid;
pub(crate) mod grid;
pub(crate) mod random;
pub(crate) mod ring;
pub(crate) mod rule;

pub(crate) use area::{Area, HasArea};
pub(crate) use coverage_grid::{
    CoverageGrid, Tolerance, Worst, check_coverage, check_same_coverage, coverage, coverage_within,
};
pub(crate) use grid::{Grid, block_pixels, check_exact, check_same, rect, span_pixels};
pub(crate) use random::{Rng, cases, for_each_case};
pub(crate) use rule::{Belongs, Outline};
