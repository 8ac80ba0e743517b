//! The family `antialias`.

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
