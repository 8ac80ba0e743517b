//! The family `line`.

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
