//! Seed fill: draw the outline, choose a pixel inside, grow until the whole polygon is filled.
//!
//! As the lecture notes "Rasterization" have it, on a [`Canvas`] that remembers which pixels are closed: boundary, or
//! filled. Each fill sends the outline first. What that touches belongs to the picture, which is half a pixel too
//! large; a polygon that crosses itself has more than one inside, of which one seed finds one.
//!
//! ```text
//!     . # # # # .       An outline as thin as a line has diagonal gaps (/): what grows by sides (o)
//!     # o o o # .       stays in, what grows by corners, too, gets out. For that, the outline has
//!     . # s / # .       to be closed by sides: "thick" in the columns where it changes rows.
//!     . . # # . .
//! ```

mod canvas;
mod outline;
mod pixels;
mod rescan;
mod spans;
mod walk;

pub use canvas::{Canvas, Touch};
pub use outline::{draw, seed};
pub use pixels::{Return, by_pixels};
pub use rescan::{Marker, by_spans_with_rescan};
pub use spans::{Entry, by_seeds, by_spans};
pub use walk::by_spans_with_walk;

use crate::methods::Method;

/// How the recursion is charted.
pub const PIXELS: Method = Method {
    name: "seed fill by pixels",
    options: &["4-connected", "8-connected", "8-connected, thin outline"],
    source: "Lecture notes \"Rasterization\": polygon fill; A. R. Smith, \"Tint fill\", 1979",
};

/// How the fills by spans are charted.
pub const SPANS: Method = Method {
    name: "seed fill by spans",
    options: &["Smith", "Heckbert", "Heckbert, 8-connected"],
    source: "A. R. Smith, \"Tint fill\", 1979; P. S. Heckbert, \"A seed fill algorithm\", Graphics Gems, 1990",
};

/// How the stack that drops entries is charted.
pub const RESCAN: Method = Method {
    name: "seed fill with rescan",
    options: &["1 entry", "4 entries", "16 entries", "1 entry, no marker"],
    source: "P. S. Heckbert, \"A seed fill algorithm\", Graphics Gems, 1990, with a bounded stack",
};

/// How the stack that drops nothing is charted.
pub const WALK: Method = Method {
    name: "seed fill with walk",
    options: &["no entry", "1 entry", "16 entries"],
    source: "D. Henrich, \"Space-efficient region filling in raster graphics\", 1994; this crate's SeedFill",
};
