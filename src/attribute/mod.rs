//! What varies across a triangle: colour, depth, coordinates in a texture.
//!
//! ```text
//!   triangle, values of its vertices -> spans, each with the values at its centres -> fragments
//!                                                                                  -> colours, into a target's rows
//! ```
//!
//! [`Affine`] values are planes over the screen; [`Perspective`] ones are quotients of planes. Both push spans into an
//! [`AttributeSink`]; the pixels are those of [`Triangle`](crate::Triangle), whatever is interpolated.

mod affine;
mod barycentric;
mod binary;
mod channels;
mod depth;
mod gouraud;
mod joined;
mod packed;
mod perspective;
mod pieces;
mod plane;
mod quotients;
mod shaded;
mod texture;
mod values;
mod walk;
mod word;

pub use affine::Affine;
pub use barycentric::{Barycentric, Weights};
pub use channels::{Channels, average};
pub use depth::{DepthBuffer, DepthBufferError, DepthTest};
pub use gouraud::{EXACT, Gouraud, PACKED};
pub use perspective::{NotInFront, Perspective};
pub use shaded::{Attributes, DepthTested, Shaded};
pub use texture::{EmptyTexture, Filter, Texture, Wrap};
pub use values::{AttributeRow, AttributeSink};
