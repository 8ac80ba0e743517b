//! What the library's own tests hold it against: no line of code in common with the library's.

#![allow(dead_code, reason = "the tests need more of it")]

#[path = "../../../tests/oracle/area.rs"]
pub(crate) mod area;
#[path = "../../../tests/oracle/ring.rs"]
pub(crate) mod ring;
#[path = "../../../tests/oracle/rule.rs"]
pub(crate) mod rule;
