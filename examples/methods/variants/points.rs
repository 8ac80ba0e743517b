//! Meshes of triangles, in 1/256 pixel.

use spanfill::{
    Shape, Triangle, Vertex,
    methods::points::{
        crossover, mesh_points, mesh_triangles,
        vertex::{self, Rounding},
    },
};

use crate::variants;
use crate::variants::line::{Fragments, drawn};

fn pixels(vertex: &Vertex) -> [f64; 2] {
    [vertex.x, vertex.y].map(|at| f64::from(at.to_bits()) / 256.0)
}

variants! {
    POINTS: [[Vertex; 3]];
    "points", "vertex as a pixel", "Math.Round" => |mesh, clip, sink| {
        let mut vertices = mesh.iter().flatten();
        drawn(vertices.try_for_each(|vertex| vertex::draw(pixels(vertex), Rounding::MathRound, clip, sink)))
    };
    "points", "vertex as a pixel", "floor" => |mesh, clip, sink| {
        let mut vertices = mesh.iter().flatten();
        drawn(vertices.try_for_each(|vertex| vertex::draw(pixels(vertex), Rounding::Floor, clip, sink)))
    };
    "points", "triangles as points", "" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| mesh_points::draw(triangle, clip, sink)));
    "points", "triangles", "" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| mesh_triangles::draw(triangle, clip, sink)));
    "points", "triangles against points", "below 1/2 px" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| crossover::draw(triangle, 128, clip, sink)));
    "points", "triangles against points", "below 1 px" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| crossover::draw(triangle, 256, clip, sink)));
    "points", "triangles against points", "below 2 px" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| crossover::draw(triangle, 512, clip, sink)));
    "points", "spanfill", "" => |mesh, clip, sink|
        drawn(mesh.iter().try_for_each(|triangle| {
            Triangle::from_vertices(*triangle).spans(clip, &mut Fragments(sink))
        }));
}
