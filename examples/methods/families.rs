//! Every family with its variants and the scenes that they are measured on.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use crate::{
    measure::{Aim, Scene, Suite},
    scenes, variants,
};

/// Every family. The last scene of each is the small one of the gallery.
pub(crate) fn suites() -> Vec<Suite> {
    vec![
        Suite::new("triangle: inside test", variants::triangle::TRIANGLES, triangles(), |_, _| Aim::Fill),
    ]
}

/// The name of the scene that is for the gallery alone.
pub(crate) const GALLERY: &str = "gallery";

/// A name for files.
pub(crate) fn slug(family: &str) -> String {
    family.replace(": ", "-").replace(' ', "-")
}

fn triangles() -> Vec<Scene<[[i32; 2]; 3]>> {
    let made = scenes::TRIANGLES.iter().map(|&(name, count)| Scene {
        name,
        shapes: (0..count).map(|index| scenes::triangle(name, index)).collect(),
    });
    let gallery = Scene {
        name: GALLERY,
        shapes: vec![
            [[150, 180], [3500, 1300], [900, 2600]],
            [[1664, 3712], [4224, 3712], [4224, 1152]],
            [[300, 3030], [3700, 200], [3720, 290]],
        ],
    };
    made.chain([gallery]).collect()
}
