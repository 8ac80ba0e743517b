//! Shapes that share edges cover each pixel exactly once: no crack, no overlap, at any scale and anywhere in the range.
//!
//! The meshes are random: grids with every vertex shaken, strips, fans, and triangles split again and again at points
//! inside. What they must cover is the rule's answer for the outline around all of them.

mod oracle;

use std::cmp::Ordering;

use oracle::{
    Belongs, Grid, Outline, Rng, cases, check_same, for_each_case, random,
    random::{HIGHEST, LOWEST},
    rule::{At, cross},
    span_pixels,
};
use spanfill::{FillRule, PixelRect, Triangle, Vertex};

/// The coverage of pieces that meet at their edges, held against that of the outline around them all.
struct Mesh {
    window: PixelRect,
    coverage: Grid,
    pieces: Vec<String>,
}

impl Mesh {
    fn new(window: PixelRect) -> Self {
        Self { coverage: Grid::new(window.clone()), window, pieces: Vec::new() }
    }

    /// Adds a triangle, or one time in three the polygon of its vertices: they follow one rule.
    fn triangle(&mut self, rng: &mut Rng, mut vertices: [Vertex; 3]) {
        if rng.one_in(3) {
            self.polygon(rng, &vertices);
            return;
        }
        rng.shuffle(&mut vertices);
        let triangle = Triangle::from_vertices(vertices);
        self.coverage.add_all(&span_pixels(&triangle, &self.window));
        self.pieces.push(triangle.code());
    }

    fn polygon(&mut self, rng: &mut Rng, vertices: &[Vertex]) {
        let outline = Outline::of(vertices, random::fill_rule(rng));
        self.coverage.add_all(&span_pixels(&outline, &self.window));
        self.pieces.push(outline.code());
    }

    /// Holds the pieces against the outline around them. One if the window showed any of them.
    fn check(&self, around: &[Vertex]) -> u64 {
        let expected = Grid::of_rule(&Outline::of(around, FillRule::NonZero), &self.window);
        check_same(&self.coverage, &expected, || self.pieces.join("\n"));
        u64::from(expected.covered() > 0)
    }
}

/// The cells of a grid, from smaller than a pixel to a few thousand pixels.
fn cell_size(rng: &mut Rng) -> i64 {
    match rng.int(0..=3) {
        0 => rng.int(8..=256),
        1 => 512 * rng.int(1..=5),
        2 => rng.int(256..=4000),
        _ => rng.magnitude(20).abs() + 8,
    }
}

#[test]
fn shaken_grids_of_triangles_and_quadrilaterals() {
    let count = cases(40_000);
    let seen = for_each_case(20, count, |rng| {
        let (columns, rows) = (1 + rng.index(6), 1 + rng.index(6));
        let cell = cell_size(rng);
        // Less than a quarter of a cell leaves every quadrilateral convex. Half pixels keep to centres and corners.
        let reach = (cell - 1) / 4;
        let step = if cell % 512 == 0 && rng.one_in(2) { 128 } else { 1 };
        let (x, y) = grid_place(rng, cell * 8);
        let vertices: Vec<Vec<Vertex>> = (0..=rows as i64)
            .map(|row| {
                let mut shaken = |at: i64| at + step * rng.int(-(reach / step)..=reach / step);
                (0..=columns as i64)
                    .map(|column| random::vertex(shaken(x + column * cell), shaken(y + row * cell)))
                    .collect()
            })
            .collect();
        let (row, column) = (rng.index(rows), rng.index(columns));
        let seam = random::between(rng, vertices[row][column], vertices[row + 1][column + 1]);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for row in 0..rows {
            for column in 0..columns {
                let [a, b] = [vertices[row][column], vertices[row][column + 1]];
                let [d, c] = [vertices[row + 1][column], vertices[row + 1][column + 1]];
                match rng.int(0..=2) {
                    0 => mesh.polygon(rng, &[a, b, c, d]),
                    1 => {
                        mesh.triangle(rng, [a, b, c]);
                        mesh.triangle(rng, [a, c, d]);
                    }
                    _ => {
                        mesh.triangle(rng, [a, b, d]);
                        mesh.triangle(rng, [b, c, d]);
                    }
                }
            }
        }
        let mut around = vertices[0].clone();
        around.extend(vertices[1..].iter().map(|row| row[columns]));
        around.extend(vertices[rows][..columns].iter().rev());
        around.extend(vertices[1..rows].iter().rev().map(|row| row[0]));
        Ok(mesh.check(&around))
    });
    assert!(seen * 2 > count, "only {seen} of {count} windows saw a mesh");
}

/// A corner for a mesh of the size given: near the origin, anywhere, or at an end of the range; on whole pixels.
fn grid_place(rng: &mut Rng, size: i64) -> (i64, i64) {
    let mut coordinate = || {
        let margin = size + 1024;
        let at = match rng.int(0..=3) {
            0 | 1 => rng.int(-4096..=4096),
            2 => rng.int(LOWEST + margin..=HIGHEST - margin),
            _ => rng.pick(&[LOWEST + margin, HIGHEST - margin]),
        };
        at & !255
    };
    (coordinate(), coordinate())
}

#[test]
fn strips_between_two_edges() {
    let count = cases(40_000);
    let seen = for_each_case(21, count, |rng| {
        let scale = cell_size(rng);
        let (x, y) = grid_place(rng, scale * 16);
        let length = 3 + rng.index(10);
        // x never goes back and the upper edge stays above the lower: no two triangles overlap.
        let mut at = x;
        let vertices: Vec<Vertex> = (0..length)
            .map(|index| {
                at += rng.int(0..=scale);
                let height = if index % 2 == 0 { rng.int(0..=scale) } else { rng.int(scale + 1..=2 * scale) };
                random::vertex(at, y + height)
            })
            .collect();
        // Half of the strips run downwards.
        let turned = rng.one_in(2);
        let place = |vertex: Vertex| {
            let (along, across) = (i64::from(vertex.x.to_bits()) - x, i64::from(vertex.y.to_bits()) - y);
            if turned { random::vertex(x + across, y + along) } else { vertex }
        };
        let vertices: Vec<Vertex> = vertices.into_iter().map(place).collect();
        let from = rng.index(length - 1);
        let seam = random::between(rng, vertices[from], vertices[from + 1]);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for corners in vertices.windows(3) {
            mesh.triangle(rng, [corners[0], corners[1], corners[2]]);
        }
        let mut around: Vec<Vertex> = vertices.iter().copied().step_by(2).collect();
        let lower: Vec<Vertex> = vertices.iter().copied().skip(1).step_by(2).collect();
        around.extend(lower.iter().rev());
        Ok(mesh.check(&around))
    });
    assert!(seen * 2 > count, "only {seen} of {count} windows saw a strip");
}

/// By direction around (0, 0), a full turn: first the half that starts at (1, 0), then the other.
fn by_angle((ax, ay): (i64, i64), (bx, by): (i64, i64)) -> Ordering {
    let second_half = |x: i64, y: i64| y < 0 || y == 0 && x < 0;
    let turn = i128::from(bx) * i128::from(ay) - i128::from(ax) * i128::from(by);
    second_half(ax, ay).cmp(&second_half(bx, by)).then(turn.cmp(&0))
}

#[test]
fn fans_around_a_point_inside() {
    let count = cases(40_000);
    let seen = for_each_case(22, count, |rng| {
        let reach = match rng.int(0..=2) {
            0 => 40 * 256,
            1 => 512,
            _ => 1 << rng.int(8..=30),
        };
        let (x, y) = match rng.int(0..=2) {
            // Where a fan of the greatest reach still lies within the range.
            0 => (rng.int(-(1 << 29)..=1 << 29), rng.int(-(1 << 29)..=1 << 29)),
            1 => (128 + 256 * rng.int(0..=20), 128 + 256 * rng.int(0..=20)),
            _ => (rng.int(0..=5000), rng.int(0..=5000)),
        };
        let on_lattice = rng.one_in(3);
        let mut direction = |quadrant: (i64, i64)| {
            let mut length = || if on_lattice { 128 * rng.int(1..=(reach / 128)) } else { rng.int(1..=reach) };
            (quadrant.0 * length(), quadrant.1 * length())
        };
        // One in each quadrant keeps all the angles below half a turn.
        let mut spokes: Vec<(i64, i64)> = [(1, 1), (-1, 1), (-1, -1), (1, -1)].map(&mut direction).to_vec();
        for quadrant in [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1), (-1, 1)] {
            let spoke = direction(quadrant);
            spokes.push(spoke);
        }
        rng.shuffle(&mut spokes[4..]);
        let length = 4 + rng.index(10);
        spokes.truncate(length);
        spokes.sort_by(|a, b| by_angle(*a, *b));
        let hub = random::vertex(x, y);
        let rim: Vec<Vertex> = spokes.iter().map(|(dx, dy)| random::vertex(x + dx, y + dy)).collect();
        let seen_spoke = rng.index(rim.len());
        let seam = random::between(rng, hub, rim[seen_spoke]);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for index in 0..rim.len() {
            mesh.triangle(rng, [hub, rim[index], rim[(index + 1) % rim.len()]]);
        }
        Ok(mesh.check(&rim))
    });
    assert!(seen * 10 > count * 9, "only {seen} of {count} windows saw a fan");
}

#[test]
fn triangles_split_again_and_again() {
    let count = cases(40_000);
    let seen = for_each_case(23, count, |rng| {
        // Up to the whole range: there, splitting makes slivers from one of its ends to the other.
        let place = random::place(rng);
        let corners = random::vertices(rng, place, 3);
        let whole = [corners[0], corners[1], corners[2]];
        let mut parts = vec![whole];
        for _ in 0..rng.int(1..=24) {
            let split = parts.swap_remove(rng.index(parts.len()));
            let [a, b, c] = split;
            let middle = random::between(rng, a, b);
            let (x, y) = random::between(rng, random::vertex(middle.0, middle.1), c);
            let hub = random::vertex(x, y);
            if strictly_inside(split, hub) {
                parts.extend([[a, b, hub], [b, c, hub], [c, a, hub]]);
            } else {
                parts.push(split);
            }
        }
        let part = parts[rng.index(parts.len())];
        let window = random::window_on(rng, &part);
        let mut mesh = Mesh::new(window);
        for part in parts {
            mesh.triangle(rng, part);
        }
        Ok(mesh.check(&whole))
    });
    assert!(seen * 3 > count, "only {seen} of {count} windows saw a mesh");
}

/// Inside and not on an edge.
fn strictly_inside(triangle: [Vertex; 3], p: Vertex) -> bool {
    let [a, b, c] = triangle.map(At::from);
    let p = At::from(p);
    let crosses = [cross(a, b, p), cross(b, c, p), cross(c, a, p)];
    crosses.iter().all(|cross| *cross > 0) || crosses.iter().all(|cross| *cross < 0)
}

#[test]
fn both_sides_of_a_line_through_the_whole_range() {
    // Two triangles that share their longest edge, from end to end of the range and of every slope.
    let count = cases(100_000);
    let seen = for_each_case(24, count, |rng| {
        let ends = [rng.int(LOWEST..=HIGHEST), rng.int(LOWEST..=HIGHEST)];
        let (a, b) = (random::vertex(LOWEST, ends[0]), random::vertex(HIGHEST, ends[1]));
        let (above, below) =
            (random::vertex(rng.int(LOWEST..=HIGHEST), LOWEST), random::vertex(rng.int(LOWEST..=HIGHEST), HIGHEST));
        let swap = rng.one_in(2);
        let turn = |vertex: Vertex| if swap { Vertex { x: vertex.y, y: vertex.x } } else { vertex };
        let [a, b, above, below] = [a, b, above, below].map(turn);
        let seam = random::between(rng, a, b);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        mesh.triangle(rng, [a, b, above]);
        mesh.triangle(rng, [a, b, below]);
        Ok(mesh.check(&[a, above, b, below]))
    });
    assert!(seen * 10 > count * 9, "only {seen} of {count} windows saw the line");
}

#[test]
fn convex_polygons_and_fans_from_their_first_vertex() {
    let count = cases(40_000);
    let seen = for_each_case(25, count, |rng| {
        let bits = rng.int(6..=25);
        // Steps in the order of their directions, that add up to nothing, go once around a convex polygon.
        let mut steps: Vec<(i64, i64)> =
            (0..3 + rng.index(8)).map(|_| (rng.magnitude(bits), rng.magnitude(bits))).collect();
        let (x, y) = steps.iter().fold((0, 0), |(x, y), step| (x + step.0, y + step.1));
        steps.push((-x, -y));
        // What goes nowhere has no direction to be sorted by.
        steps.retain(|step| *step != (0, 0));
        if steps.is_empty() {
            return Ok(0);
        }
        steps.sort_by(|a, b| by_angle(*a, *b));
        let mut at = grid_place(rng, 12 << bits);
        let rim: Vec<Vertex> = steps
            .iter()
            .map(|(dx, dy)| {
                at = (at.0 + dx, at.1 + dy);
                random::vertex(at.0, at.1)
            })
            .collect();
        let seen_edge = rng.index(rim.len());
        let seam = random::between(rng, rim[0], rim[seen_edge]);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for pair in rim[1..].windows(2) {
            mesh.triangle(rng, [rim[0], pair[0], pair[1]]);
        }
        check_same(&span_pixels(&Outline::of(&rim, random::fill_rule(rng)), &mesh.window), &mesh.coverage, || {
            mesh.pieces.join("\n")
        });
        Ok(mesh.check(&rim))
    });
    assert!(seen * 2 > count, "only {seen} of {count} windows saw a polygon");
}
