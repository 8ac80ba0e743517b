//! The families of triangles.

use crate::methods::Method;

/// Which pixels are inside.
pub const INSIDE: &[Method] = &[];
/// In which order pixels are looked at.
pub const TRAVERSAL: &[Method] = &[];
/// Who draws the pixels of a shared edge.
pub const SHARED: &[Method] = &[];
