//! How a method's picture is held against the oracle's: what gallery, chart, stability report and tests have in common.

#![allow(dead_code, unused_imports, reason = "each program that takes this file in uses the part it needs")]

pub(crate) mod subjects;
pub(crate) mod suite;
pub(crate) mod truth;

pub(crate) use suite::{Aim, Entry, Scene, Subject, Suite, new_picture};
pub(crate) use truth::{Tally, Truth, Verdict, Wanted, levels_off, verdict};
