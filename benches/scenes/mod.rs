//! The one list of scenes for speed: the host bench, the firmware's instruction counts and the tests all draw these.
//!
//! Taken in by `#[path]`, hence `no_std` and without dependencies beyond `embedded-graphics-core`. Shapes are plain
//! integers, so that each library builds its own primitive from them, outside of what is measured; each library then
//! draws on the same [`Frame`].
//!
//! | scene | size | what |
//! |---|---|---|
//! | [`Scene::Triangles`] | box, px | three random pixels of a box placed at random on the frame |
//! | [`Scene::Circles`] | radius, px | a filled circle around a random pixel corner, all of it on the frame |
//! | [`Scene::Lines`] | box, px | a thin line between two random pixels of a box placed at random on the frame |
//! | [`Scene::Stars`] | radius, px | a five-pointed star, self-crossing: the non-zero rule fills its pentagon |
//! | [`Scene::Concave64`] | radius, px | 64 vertices at irregular distances from the centre, each second one far in |
//!
//! [`STAR`] and [`CONCAVE_64`] are one such shape each, as constants.
//!
//! Every sequence is endless and starts from a seed of its own: the same shapes in every run, on every machine, in
//! whatever order the scenes are measured.

#![allow(dead_code, reason = "each program that takes this file in uses the part it measures")]
#![allow(unused_imports, reason = "each program that takes this file in uses the part it measures")]

mod blocks;
mod frame;
mod random;
mod shapes;

pub(crate) use blocks::{BlocksFull, RecordBlocks};
pub(crate) use frame::{FRAME_HEIGHT, FRAME_WIDTH, Frame};
pub(crate) use random::Random;
pub(crate) use shapes::{
    CONCAVE_64, CONCAVE_RADIUS_PX, PixelPoint, STAR, STAR_RADIUS_PX, Scene, SubpixelPoint, circles, concave_polygons,
    lines, stars, triangles,
};
