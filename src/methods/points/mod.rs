//! The family `points`.

use crate::methods::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
