//! Every family with its variants and the scenes that they are measured on.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use spanfill::{FillRule, Vertex};

use crate::{
    drawings,
    measure::{
        Aim, Scene, Suite,
        subjects::{Mesh, Specks, outline},
    },
    scenes,
    variants::{self, antialias, attribute::Shaded, polygon::Outline},
};

/// Every family. The last scene of each is the small one of the gallery.
pub(crate) fn suites() -> Vec<Suite> {
    vec![
        Suite::new("triangle: inside test", variants::triangle::INSIDE, triangles(), |_, _| Aim::Fill),
        Suite::new("triangle: traversal", variants::triangle::TRAVERSAL, triangles(), |_, _| Aim::Fill),
        Suite::new("shared edges", variants::triangle::SHARED, meshes(), |_, _| Aim::Fill),
        Suite::new("attributes", variants::attribute::ATTRIBUTES, shaded(), Aim::of_attributes),
        Suite::new("line", variants::line::LINES, lines(), aim_of_lines),
        Suite::new("circle", variants::circle::CIRCLES, circles(), |_, option| {
            if option.ends_with("outline") { Aim::Outline } else { Aim::Fill }
        }),
        Suite::new("polygon", variants::polygon::POLYGONS, polygons(), |_, _| Aim::Fill),
        smooth("outlines", outlines(), |method| !method.contains("texture") && !method.starts_with("line's")),
        smooth("lines", smooth_lines(), |method| !method.contains("texture")),
        smooth("textures", textures(), |method| method.contains("texture")),
        Suite::new("points", variants::points::POINTS, specks(), |_, _| Aim::Fill),
    ]
}

/// Anti-aliasing's methods on shapes that those of `draws` can draw.
fn smooth(part: &'static str, scenes: Vec<Scene<antialias::Scene>>, draws: fn(&str) -> bool) -> Suite {
    let mut suite = Suite::new("anti-aliasing", antialias::ANTIALIAS, scenes, |_, _| Aim::Coverage);
    suite.part = part;
    suite.entries.retain(|entry| draws(entry.method));
    suite
}

/// The name of the scene that is for the gallery alone.
pub(crate) const GALLERY: &str = "gallery";

/// A name for files.
pub(crate) fn slug(family: &str) -> String {
    family.replace(": ", "-").replace(' ', "-")
}

fn triangles() -> Vec<Scene<[[i32; 2]; 3]>> {
    let made = scenes::TRIANGLES
        .iter()
        .map(|&(name, count)| Scene { name, shapes: (0..count).map(|index| scenes::triangle(name, index)).collect() });
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
    let [a, b, c, d, e, f] = [[384, 384], [2688, 384], [4992, 640], [1408, 2432], [384, 3968], [4736, 3712]];
    let gallery =
        Scene { name: GALLERY, shapes: vec![Mesh(vec![[a, b, d], [b, c, d], [c, f, d], [a, d, e], [d, f, e]])] };
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

fn lines() -> Vec<Scene<[[i32; 2]; 2]>> {
    let made = scenes::LINES
        .iter()
        .map(|&(name, count)| Scene { name, shapes: (0..count).map(|index| scenes::line(name, index)).collect() });
    let gallery = Scene {
        name: GALLERY,
        shapes: vec![[[1, 1], [18, 4]], [[2, 7], [4, 14]], [[7, 13], [17, 7]], [[18, 9], [9, 15]]],
    };
    made.chain([gallery]).collect()
}

fn aim_of_lines(method: &str, option: &str) -> Aim {
    let is_smooth = ["Wu", "Gupta-Sproull"].contains(&method) || option == "exact coverage";
    if is_smooth { Aim::Coverage } else { Aim::Fill }
}

fn circles() -> Vec<Scene<[i32; 3]>> {
    let made = scenes::CIRCLES
        .iter()
        .map(|&(name, count)| Scene { name, shapes: (0..count).map(|index| scenes::circle(name, index)).collect() });
    let gallery = Scene { name: GALLERY, shapes: vec![[6, 7, 6], [15, 4, 3], [16, 12, 2], [11, 14, 1]] };
    made.chain([gallery]).collect()
}

fn vertex([x, y]: [i32; 2]) -> Vertex {
    Vertex::from_bits(x, y)
}

/// An outline that lasts, with vertices for the methods of anti-aliasing.
fn smooth_outline(contours: &[&[[i32; 2]]], even_odd: bool) -> antialias::Scene {
    let lasting =
        |contour: &&[[i32; 2]]| -> &'static [Vertex] { Vec::leak(contour.iter().copied().map(vertex).collect()) };
    let contours: Vec<&'static [Vertex]> = contours.iter().map(lasting).collect();
    antialias::Scene::Polygon(Vec::leak(contours), if even_odd { FillRule::EvenOdd } else { FillRule::NonZero })
}

/// Triangles, polygons, and each fourth shape of two drawings: thousands of vertices.
fn outlines() -> Vec<Scene<antialias::Scene>> {
    let triangles = [("triangles", "typical", 24), ("small triangles", "small", 60), ("slivers", "slivers", 24)];
    let triangles = triangles.map(|(name, scene, count)| Scene {
        name,
        shapes: (0..count)
            .map(|index| antialias::Scene::Triangle(scenes::triangle(scene, index).map(vertex)))
            .collect(),
    });
    let polygons = [("polygons", "typical", 12), ("self-intersecting", "self-intersecting", 12)];
    let polygons = polygons.map(|(name, scene, count)| Scene {
        name,
        shapes: (0..count)
            .map(|index| polygon(scene, index))
            .map(|outline| smooth_outline(outline.contours, outline.even_odd))
            .collect(),
    });
    let drawn = [("countries", drawings::COUNTRIES), ("peeps", drawings::PEEPS)].map(|(name, drawing)| Scene {
        name,
        shapes: drawings::load(drawing)
            .shapes
            .into_iter()
            .step_by(4)
            .map(|shape| {
                let contours: Vec<&[[i32; 2]]> = shape.contours.iter().map(Vec::as_slice).collect();
                smooth_outline(&contours, shape.even_odd)
            })
            .collect(),
    });
    let star: &[[i32; 2]] = &[[3700, 300], [4500, 2300], [2500, 1000], [4900, 1000], [2900, 2400]];
    let gallery = Scene {
        name: GALLERY,
        shapes: vec![
            antialias::Scene::Triangle([[150, 180], [2300, 900], [800, 2500]].map(vertex)),
            smooth_outline(&[star], false),
            antialias::Scene::Triangle([[300, 3800], [4800, 2900], [4810, 3060]].map(vertex)),
        ],
    };
    triangles.into_iter().chain(polygons).chain(drawn).chain([gallery]).collect()
}

/// The lines of the family of lines.
fn smooth_lines() -> Vec<Scene<antialias::Scene>> {
    const NAMES: [(&str, &str, usize); 3] =
        [("lines", "typical", 24), ("short lines", "short", 60), ("nearly level lines", "nearly level", 24)];
    let made = NAMES.map(|(name, scene, count)| Scene {
        name,
        shapes: (0..count)
            .map(|index| scenes::line(scene, index))
            .map(|ends| antialias::Scene::Line(ends.map(|[x, y]| Vertex::pixel(x, y))))
            .collect(),
    });
    let line = |from: [i32; 2], to: [i32; 2]| antialias::Scene::Line([vertex(from), vertex(to)]);
    let shapes =
        vec![line([384, 384], [4700, 1200]), line([600, 1600], [1100, 3700]), line([2000, 3600], [4600, 1900])];
    made.into_iter().chain([Scene { name: GALLERY, shapes }]).collect()
}

/// Texels of a pattern, many to a pixel.
fn textures() -> Vec<Scene<antialias::Scene>> {
    let texture = |size: u16, corner: [i32; 2], pixels: u16, pattern: fn(u16, u16) -> bool| {
        let texels = (0..size).flat_map(|y| (0..size).map(move |x| if pattern(x, y) { 255 } else { 0 }));
        antialias::Scene::Texture {
            texels: Vec::leak(texels.collect::<Vec<u8>>()),
            size: [size, size],
            corner,
            pixels: [pixels, pixels],
        }
    };
    let checks: fn(u16, u16) -> bool = |x, y| (x + y) % 2 == 0;
    let stripes: fn(u16, u16) -> bool = |x, _| x % 3 == 0;
    let rings: fn(u16, u16) -> bool = |x, y| (x * x + y * y) / 200 % 2 == 0;
    let patterns = [("checks", checks), ("stripes", stripes), ("rings", rings)];
    let mut scenes: Vec<Scene<antialias::Scene>> = patterns
        .into_iter()
        .map(|(name, pattern)| Scene {
            name,
            shapes: [(64, 20), (96, 13), (50, 31)]
                .map(|(size, pixels)| texture(size, [40, 40], pixels, pattern))
                .to_vec(),
        })
        .collect();
    scenes.push(Scene { name: GALLERY, shapes: vec![texture(60, [2, 1], 14, rings)] });
    scenes
}

fn specks() -> Vec<Scene<Specks>> {
    let triangles = 2 * scenes::SPECKS_ACROSS * scenes::SPECKS_ACROSS;
    let made = scenes::SPECKS.iter().map(|&(name, square)| Scene {
        name,
        shapes: vec![Specks((0..triangles).map(|index| scenes::speck(square, index).map(vertex)).collect())],
    });
    let gallery = (0..242_i32).map(|index| {
        let [column, row] = [index / 2 % 11, index / 2 / 11];
        let at = |x: i32, y: i32| vertex([200 + x * 250 + x * x * 13 + y * 27, 190 + y * 240 + y * y * 9 - x * 13]);
        let [a, b] = [at(column, row), at(column + 1, row + 1)];
        [a, b, if index % 2 == 0 { at(column + 1, row) } else { at(column, row + 1) }]
    });
    made.chain([Scene { name: GALLERY, shapes: vec![Specks(gallery.collect())] }]).collect()
}

/// Made ones, and two drawings of thousands of vertices.
fn polygons() -> Vec<Scene<Outline>> {
    let made = scenes::POLYGONS
        .iter()
        .map(|&(name, count)| Scene { name, shapes: (0..count).map(|index| polygon(name, index)).collect() });
    let drawn = [("countries", drawings::COUNTRIES), ("peeps", drawings::PEEPS)].map(|(name, drawing)| Scene {
        name,
        shapes: drawings::load(drawing)
            .shapes
            .into_iter()
            .map(|shape| outline(shape.contours, shape.even_odd))
            .collect(),
    });
    let gallery = Scene {
        name: GALLERY,
        shapes: vec![
            outline(
                vec![vec![[384, 384], [2176, 384], [2176, 1664], [1408, 1664], [1280, 896], [900, 2100], [384, 1900]]],
                false,
            ),
            outline(vec![vec![[3400, 300], [4700, 2700], [2400, 1000], [4900, 1100], [2500, 2500]]], false),
            outline(
                vec![
                    vec![[300, 2900], [4800, 3000], [4700, 3900], [400, 3150]],
                    vec![[3300, 3200], [4300, 3250], [4200, 3600]],
                ],
                true,
            ),
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
