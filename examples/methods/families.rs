//! Every family with its variants and the scenes that they are measured on.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use crate::{
    drawings,
    measure::{Aim, Scene, Suite, subjects::outline},
    scenes,
    variants::{self, polygon::Outline},
};

/// Every family. The last scene of each is the small one of the gallery.
pub(crate) fn suites() -> Vec<Suite> {
    vec![
        Suite::new("triangle: inside test", variants::triangle::TRIANGLES, triangles(), |_, _| Aim::Fill),
        Suite::new("polygon", variants::polygon::POLYGONS, polygons(), |_, _| Aim::Fill),
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
            [[150, 180], [3200, 900], [800, 2500]],
            [[2176, 3712], [4736, 3712], [4736, 1152]],
            [[150, 3700], [4500, 500], [4540, 590]],
        ],
    };
    made.chain([gallery]).collect()
}

/// Made ones, and two drawings of thousands of vertices.
fn polygons() -> Vec<Scene<Outline>> {
    let made = scenes::POLYGONS.iter().map(|&(name, count)| Scene {
        name,
        shapes: (0..count).map(|index| polygon(name, index)).collect(),
    });
    let drawn = [("countries", drawings::COUNTRIES), ("peeps", drawings::PEEPS)].map(|(name, drawing)| Scene {
        name,
        shapes: drawings::load(drawing).shapes.into_iter().map(|shape| outline(shape.contours, shape.even_odd)).collect(),
    });
    let gallery = Scene {
        name: GALLERY,
        shapes: vec![
            outline(vec![vec![[384, 384], [2176, 384], [2176, 1664], [1408, 1664], [1280, 896], [900, 2100], [384, 1900]]], false),
            outline(vec![vec![[3400, 300], [4700, 2700], [2400, 1000], [4900, 1100], [2500, 2500]]], false),
            outline(vec![vec![[300, 2900], [4800, 3000], [4700, 3900], [400, 3150]], vec![[3300, 3200], [4300, 3250], [4200, 3600]]], true),
        ],
    };
    made.chain(drawn).chain([gallery]).collect()
}

/// A polygon of a scene; every second by the other rule.
pub(crate) fn polygon(scene: &str, index: usize) -> Outline {
    let mut vertices = [[0; 2]; scenes::MOST_VERTICES];
    let count = scenes::polygon(scene, index, &mut vertices);
    outline(vec![vertices[..count].to_vec()], index % 2 == 1)
}
