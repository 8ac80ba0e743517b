//! Every family with its variants and the scenes that they are measured on.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use crate::{
    drawings,
    measure::{
        Aim, Scene, Suite,
        subjects::{Mesh, outline},
    },
    scenes,
    variants::{self, attribute::Shaded, polygon::Outline},
};

/// Every family. The last scene of each is the small one of the gallery.
pub(crate) fn suites() -> Vec<Suite> {
    vec![
        Suite::new("triangle: inside test", variants::triangle::INSIDE, triangles(), |_, _| Aim::Fill),
        Suite::new("triangle: traversal", variants::triangle::TRAVERSAL, triangles(), |_, _| Aim::Fill),
        Suite::new("shared edges", variants::triangle::SHARED, meshes(), |_, _| Aim::Fill),
        Suite::new("attributes", variants::attribute::ATTRIBUTES, shaded(), aim_of_attributes),
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

fn meshes() -> Vec<Scene<Mesh>> {
    let made = scenes::MESHES.iter().map(|&(name, count)| Scene {
        name,
        shapes: (0..count).map(|index| Mesh(scenes::mesh(name, index).to_vec())).collect(),
    });
    let [a, b, c, d, e, f] =
        [[384, 384], [2688, 384], [4992, 640], [1408, 2432], [384, 3968], [4736, 3712]];
    let gallery = Scene { name: GALLERY, shapes: vec![Mesh(vec![[a, b, d], [b, c, d], [c, f, d], [a, d, e], [d, f, e]])] };
    made.chain([gallery]).collect()
}

/// The first four scenes of triangles, and the large ones.
fn shaded() -> Vec<Scene<Shaded>> {
    let made = scenes::TRIANGLES.iter().map(|&(name, count)| Scene {
        name,
        shapes: (0..count).map(|index| shade(scenes::triangle(name, index), scenes::varying(name, index))).collect(),
    });
    let colours = [[255, 40, 40, 255], [40, 255, 60, 128], [30, 60, 255, 0]];
    let corners = [[[150, 180], [4900, 1300], [900, 3900]], [[3300, 3800], [4900, 3900], [4800, 2200]]];
    let gallery = Scene {
        name: GALLERY,
        shapes: corners.map(|corners| shade(corners, (colours, [65536, 262_144, 131_072], [0, 30000, 65535]))).to_vec(),
    };
    made.chain([gallery]).collect()
}

pub(crate) fn shade(vertices: [[i32; 2]; 3], (attributes, w, depth): scenes::Varying) -> Shaded {
    Shaded { vertices, attributes, w, depth }
}

fn aim_of_attributes(method: &str, _: &str) -> Aim {
    match method {
        "perspective" => Aim::Perspective,
        "depth" => Aim::Depth,
        _ => Aim::Attributes,
    }
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
