//! Shapes that share edges share the area of each pixel: their coverage adds up to that of the outline around them all,
//! but for half a 255th each.

mod oracle;

use oracle::{
    Belongs, HasArea, Outline, Rng, cases, coverage, for_each_case, random,
    random::{HIGHEST, LOWEST},
    rule::{At, cross},
};
use spanfill::{Cover, FillRule, PixelRect, Triangle, Vertex};

/// In sub-pixels.
type Point = (i64, i64);

/// What the parts of a mesh cover together.
struct Mesh {
    window: PixelRect,
    /// For each pixel: the sum, and how many parts have an edge in it.
    pixels: Vec<(u32, u32)>,
    parts: Vec<String>,
}

impl Mesh {
    fn new(window: PixelRect) -> Self {
        let pixels = vec![(0, 0); window.rows.len() * window.columns.len()];
        Self { window, pixels, parts: Vec::new() }
    }

    /// Adds a triangle, or one time in three the polygon of its vertices.
    fn triangle(&mut self, rng: &mut Rng, mut vertices: [Vertex; 3]) {
        rng.shuffle(&mut vertices);
        if rng.one_in(3) {
            self.add(&Outline::of(&vertices, random::fill_rule(rng)));
        } else {
            self.add(&Triangle::from_vertices(vertices));
        }
    }

    fn add(&mut self, part: &(impl Cover + HasArea + Belongs)) {
        let drawn = coverage(part, &self.window);
        let mut pixels = self.pixels.iter_mut();
        for row in self.window.rows.clone() {
            for (coverage, area) in drawn.row(row).iter().zip(part.areas_in_row(row, &self.window.columns)) {
                let (sum, parts) = pixels.next().unwrap();
                *sum += u32::from(*coverage);
                *parts += u32::from(area.edges > 0);
            }
        }
        self.parts.push(part.code());
    }

    /// Holds the parts against the outline around them. One if the window showed an edge between two of them.
    fn check(&self, around: &[Vertex]) -> Result<u64, String> {
        let around = Outline::of(around, FillRule::NonZero);
        let mut pixels = self.pixels.iter();
        let mut has_seam = false;
        for row in self.window.rows.clone() {
            for (column, area) in self.window.columns.clone().zip(around.areas_in_row(row, &self.window.columns)) {
                let (sum, parts) = *pixels.next().unwrap();
                let most = 0.51 * f64::from(parts) + 255.0 * area.error;
                if (f64::from(sum) - 255.0 * area.value).abs() > most {
                    let expected = 255.0 * area.value;
                    let parts = self.parts.join("\n");
                    return Err(format!("({column}, {row}) has {sum}, not {expected:.3} +- {most}:\n{parts}"));
                }
                has_seam |= parts > 1 && area.edges == 0;
            }
        }
        Ok(has_seam.into())
    }
}

fn vertex((x, y): Point) -> Vertex {
    random::vertex(x, y)
}

/// From a quarter of a pixel to a few thousand pixels.
fn scale(rng: &mut Rng) -> i64 {
    match rng.int(0..=3) {
        0 => rng.int(64..=256),
        1 | 2 => rng.int(256..=4000),
        _ => rng.magnitude(20).abs() + 64,
    }
}

/// Where a mesh of the size given lies within the range: near the origin, anywhere, or at an end.
fn place(rng: &mut Rng, size: i64) -> Point {
    let mut coordinate = || {
        let margin = size + 8192;
        match rng.int(0..=3) {
            0 | 1 => rng.int(-4096..=4096),
            2 => rng.int(LOWEST + margin..=HIGHEST - margin),
            _ => rng.pick(&[LOWEST + margin, HIGHEST - margin]),
        }
    };
    (coordinate(), coordinate())
}

#[test]
fn shaken_grids() {
    let count = cases(800);
    let seen = for_each_case(420, count, |rng| {
        let (columns, rows) = (1 + rng.index(5), 1 + rng.index(5));
        let cell = scale(rng);
        // Less than a quarter of a cell leaves every quadrilateral convex.
        let reach = rng.pick(&[0, (cell - 1) / 4, (cell - 1) / 4]);
        let (x, y) = place(rng, cell * 8);
        let vertices: Vec<Vec<Vertex>> = (0..=rows as i64)
            .map(|row| {
                let mut shaken = |at: i64| at + rng.int(-reach..=reach);
                (0..=columns as i64).map(|column| vertex((shaken(x + column * cell), shaken(y + row * cell)))).collect()
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
                    0 => mesh.add(&Outline::of(&[a, b, c, d], random::fill_rule(rng))),
                    1 => [[a, b, c], [a, c, d]].into_iter().for_each(|half| mesh.triangle(rng, half)),
                    _ => [[a, b, d], [b, c, d]].into_iter().for_each(|half| mesh.triangle(rng, half)),
                }
            }
        }
        let mut around = vertices[0].clone();
        around.extend(vertices[1..].iter().map(|row| row[columns]));
        around.extend(vertices[rows][..columns].iter().rev());
        around.extend(vertices[1..rows].iter().rev().map(|row| row[0]));
        mesh.check(&around)
    });
    assert!(seen * 2 > count, "only {seen} of {count} windows saw a seam");
}

#[test]
fn strips_between_two_edges() {
    let count = cases(1_500);
    let seen = for_each_case(421, count, |rng| {
        let (scale, is_turned) = (scale(rng), rng.one_in(2));
        let (x, y) = place(rng, scale * 16);
        // x never goes back and the upper edge stays above the lower: no two triangles overlap.
        let mut along = 0;
        let vertices: Vec<Vertex> = (0..4 + rng.index(10))
            .map(|index| {
                along += rng.int(0..=scale);
                let across = if index % 2 == 0 { rng.int(0..=scale) } else { rng.int(scale + 1..=2 * scale) };
                vertex(if is_turned { (x + across, y + along) } else { (x + along, y + across) })
            })
            .collect();
        let from = rng.index(vertices.len() - 1);
        let seam = random::between(rng, vertices[from], vertices[from + 1]);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for corners in vertices.windows(3) {
            mesh.triangle(rng, [corners[0], corners[1], corners[2]]);
        }
        let mut around: Vec<Vertex> = vertices.iter().copied().step_by(2).collect();
        let lower: Vec<Vertex> = vertices.iter().copied().skip(1).step_by(2).collect();
        around.extend(lower.iter().rev());
        mesh.check(&around)
    });
    assert!(seen * 2 > count, "only {seen} of {count} windows saw a seam");
}

/// Many parts in the pixel of the hub.
#[test]
fn fans_around_a_point() {
    let count = cases(600);
    let seen = for_each_case(422, count, |rng| {
        let bits = rng.int(7..=28);
        let (x, y) = place(rng, 1 << 29);
        // Points of the sides of a square, in the order of their angles; its corners are among them.
        let reach = 1 << bits;
        let mut at: Vec<i64> = (0..rng.int(0..=30)).map(|_| rng.int(0..=8 * reach - 1)).collect();
        at.extend([0, 2 * reach, 4 * reach, 6 * reach]);
        at.sort_unstable();
        at.dedup();
        let rim: Vec<Vertex> = at
            .into_iter()
            .map(|at| {
                let along = at % (2 * reach) - reach;
                let sides = [(along, -reach), (reach, along), (-along, reach), (-reach, -along)];
                let (dx, dy) = sides[(at / (2 * reach)) as usize];
                vertex((x + dx, y + dy))
            })
            .collect();
        let hub = vertex((x + rng.int(-reach / 2..=reach / 2), y + rng.int(-reach / 2..=reach / 2)));
        let spoke = rim[rng.index(rim.len())];
        let seam = if rng.one_in(2) {
            (hub.x.to_bits().into(), hub.y.to_bits().into())
        } else {
            random::between(rng, hub, spoke)
        };
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        for index in 0..rim.len() {
            mesh.triangle(rng, [hub, rim[index], rim[(index + 1) % rim.len()]]);
        }
        mesh.check(&rim)
    });
    assert!(seen * 10 > count * 8, "only {seen} of {count} windows saw a seam");
}

/// Up to slivers from one end of the range to the other.
#[test]
fn triangles_split_again_and_again() {
    let count = cases(900);
    let seen = for_each_case(423, count, |rng| {
        let place = random::place(rng);
        let corners = random::vertices(rng, place, 3);
        let whole = [corners[0], corners[1], corners[2]];
        let mut parts = vec![whole];
        for _ in 0..rng.int(1..=24) {
            let split = parts.swap_remove(rng.index(parts.len()));
            let [a, b, c] = split;
            let middle = random::between(rng, a, b);
            let hub = vertex(random::between(rng, vertex(middle), c));
            if is_strictly_inside(split, hub) {
                parts.extend([[a, b, hub], [b, c, hub], [c, a, hub]]);
            } else {
                parts.push(split);
            }
        }
        let part = parts[rng.index(parts.len())];
        let mut mesh = Mesh::new(random::window_on(rng, &part));
        for part in parts {
            mesh.triangle(rng, part);
        }
        mesh.check(&whole)
    });
    assert!(seen * 4 > count, "only {seen} of {count} windows saw a seam");
}

/// Inside and not on an edge.
fn is_strictly_inside(triangle: [Vertex; 3], p: Vertex) -> bool {
    let [a, b, c] = triangle.map(At::from);
    let p = At::from(p);
    let crosses = [cross(a, b, p), cross(b, c, p), cross(c, a, p)];
    crosses.iter().all(|cross| *cross > 0) || crosses.iter().all(|cross| *cross < 0)
}

/// Two triangles on either side of their longest edge, from end to end of the range and of every slope: no rounding of
/// that edge leaves a crack, and none makes an overlap.
#[test]
fn both_sides_of_a_line_through_the_whole_range() {
    let count = cases(2_000);
    let seen = for_each_case(424, count, |rng| {
        let mut anywhere = || rng.int(LOWEST..=HIGHEST);
        let points = [(LOWEST, anywhere()), (HIGHEST, anywhere()), (anywhere(), LOWEST), (anywhere(), HIGHEST)];
        let is_turned = rng.one_in(2);
        let [a, b, above, below] = points.map(|(x, y)| vertex(if is_turned { (y, x) } else { (x, y) }));
        let seam = random::between(rng, a, b);
        let mut mesh = Mesh::new(random::window_at(rng, seam));
        mesh.triangle(rng, [a, b, above]);
        mesh.triangle(rng, [a, b, below]);
        mesh.check(&[a, above, b, below])
    });
    assert!(seen * 10 > count * 9, "only {seen} of {count} windows saw the line");
}
