//! Shapes of every kind from a seed, and windows that lie on their outlines.
//!
//! A failure names its seed and case, the shape to the last bit and the window; the case is then the same on every
//! machine. `SPANFILL_CASES=20 cargo test` runs twenty times as many, `SPANFILL_CASES=0.1` a tenth.

use std::{
    ops::RangeInclusive,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{
        Mutex,
        atomic::{AtomicU64, Ordering},
    },
    thread,
};

use spanfill::{Circle, FillRule, Line, PixelRect, Triangle, Vertex};

use super::{
    grid::rect,
    rule::{Outline, centre},
};

/// SplitMix64: small, and good from any seed.
#[derive(Debug, Clone)]
pub(crate) struct Rng(u64);

impl Rng {
    pub(crate) fn new(seed: u64, case: u64) -> Self {
        let mut rng = Self(seed ^ case.wrapping_mul(0xd134_2543_de82_ef95));
        rng.bits();
        rng
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn int(&mut self, range: RangeInclusive<i64>) -> i64 {
        let values = (range.end() - range.start() + 1) as u128;
        range.start() + ((u128::from(self.bits()) * values) >> 64) as i64
    }

    pub(crate) fn index(&mut self, length: usize) -> usize {
        self.int(0..=length as i64 - 1) as usize
    }

    pub(crate) fn one_in(&mut self, n: i64) -> bool {
        self.int(1..=n) == 1
    }

    pub(crate) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.index(from.len())]
    }

    /// Of any magnitude up to 2^`bits`, small ones as likely as large ones.
    pub(crate) fn magnitude(&mut self, bits: i64) -> i64 {
        let limit = 1 << self.int(0..=bits);
        self.int(-limit..=limit)
    }

    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.index(last + 1));
        }
    }
}

/// How many cases to run where `usual` are the usual number: `SPANFILL_CASES` multiplies.
pub(crate) fn cases(usual: u64) -> u64 {
    let factor =
        std::env::var("SPANFILL_CASES").map_or(1.0, |factor| factor.parse().expect("SPANFILL_CASES: a number"));
    (usual as f64 * factor).ceil() as u64
}

/// Runs `check` on all cores, each case with its own generator. The sum of what the checks answer.
///
/// Panics with the seed, the number and the message of the first case found to fail.
pub(crate) fn for_each_case(seed: u64, count: u64, check: impl Fn(&mut Rng) -> Result<u64, String> + Sync) -> u64 {
    // Blocks of cases keep the cores from meeting at the counter.
    const BLOCK: u64 = 64;
    let (next, sum, failure) = (AtomicU64::new(0), AtomicU64::new(0), Mutex::new(None));
    let work = || {
        loop {
            let start = next.fetch_add(BLOCK, Ordering::Relaxed);
            if start >= count || failure.lock().unwrap().is_some() {
                return;
            }
            for case in start..count.min(start + BLOCK) {
                let outcome = catch_unwind(AssertUnwindSafe(|| check(&mut Rng::new(seed, case))));
                let message = match outcome {
                    Ok(Ok(answer)) => {
                        sum.fetch_add(answer, Ordering::Relaxed);
                        continue;
                    }
                    Ok(Err(message)) => message,
                    Err(panic) => format!("panicked: {}", panic_message(&*panic)),
                };
                failure.lock().unwrap().get_or_insert(format!("seed {seed}, case {case}: {message}"));
                return;
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    if let Some(message) = failure.into_inner().unwrap() {
        panic!("{message}");
    }
    sum.into_inner()
}

pub(crate) fn panic_message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

pub(crate) const LOWEST: i64 = i32::MIN as i64;
pub(crate) const HIGHEST: i64 = i32::MAX as i64;

/// The nearest coordinate there is.
pub(crate) fn saturate(bits: i64) -> i32 {
    bits.clamp(LOWEST, HIGHEST) as i32
}

pub(crate) fn vertex(x: i64, y: i64) -> Vertex {
    Vertex::from_bits(saturate(x), saturate(y))
}

/// Where in the range a scene lies: half of them near the origin, the others anywhere and at the ends.
pub(crate) fn place(rng: &mut Rng) -> (i64, i64) {
    match rng.int(0..=5) {
        0..=2 => (rng.int(0..=16 * 256), rng.int(0..=16 * 256)),
        3 => (rng.int(LOWEST..=HIGHEST), rng.int(LOWEST..=HIGHEST)),
        4 => (rng.pick(&[LOWEST, HIGHEST]), rng.int(LOWEST..=HIGHEST)),
        _ => (rng.pick(&[LOWEST, 0, HIGHEST]), rng.pick(&[LOWEST, HIGHEST])),
    }
}

/// How the vertices of a shape lie around its place.
#[derive(Debug, Clone, Copy)]
enum Scatter {
    /// Within a pixel or two.
    Tiny,
    /// Within a small window.
    Small,
    /// On pixel centres, corners and middles of pixel sides, so that outlines run through centres.
    Lattice,
    /// From a sub-pixel to the whole range, every magnitude as likely.
    Wide,
    /// Heights at the powers of two where a product could outgrow its type.
    Tall,
    /// Widths at the same.
    Broad,
    /// At the ends of the range, and near them.
    Ends,
    /// Anywhere in the range.
    Anywhere,
}

const SCATTERS: [Scatter; 8] = [
    Scatter::Tiny,
    Scatter::Small,
    Scatter::Lattice,
    Scatter::Wide,
    Scatter::Tall,
    Scatter::Broad,
    Scatter::Ends,
    Scatter::Anywhere,
];

/// A length near a power of two where arithmetic may change its width.
fn critical_length(rng: &mut Rng) -> i64 {
    let length = (1 << rng.int(7..=32)) + rng.magnitude(10);
    if rng.one_in(2) { length } else { -length }
}

fn scattered(rng: &mut Rng, (x, y): (i64, i64), scatter: Scatter) -> Vertex {
    match scatter {
        Scatter::Tiny => vertex(x + rng.int(-300..=300), y + rng.int(-300..=300)),
        Scatter::Small => vertex(x + rng.int(-5000..=5000), y + rng.int(-5000..=5000)),
        Scatter::Lattice => {
            let step = rng.pick(&[64, 128, 128, 256]);
            // The centre of the pixel that holds the place, and steps from there.
            let mut coordinate = |at: i64| (at >> 8) * 256 + 128 + step * rng.int(-16..=16);
            vertex(coordinate(x), coordinate(y))
        }
        Scatter::Wide => vertex(x + rng.magnitude(32), y + rng.magnitude(32)),
        Scatter::Tall => vertex(x + rng.magnitude(16), y + critical_length(rng)),
        Scatter::Broad => vertex(x + critical_length(rng), y + rng.magnitude(16)),
        Scatter::Ends => {
            let ends = [LOWEST, LOWEST, HIGHEST, HIGHEST, 0, x, y, 128, LOWEST + 128, HIGHEST - 127];
            let mut coordinate = || rng.pick(&ends) + if rng.one_in(2) { 0 } else { rng.magnitude(9) };
            vertex(coordinate(), coordinate())
        }
        Scatter::Anywhere => vertex(rng.int(LOWEST..=HIGHEST), rng.int(LOWEST..=HIGHEST)),
    }
}

/// `count` vertices around a place: scattered in one manner or in many, some of them repeated, level with, above or
/// almost on the line between those before.
pub(crate) fn vertices(rng: &mut Rng, place: (i64, i64), count: usize) -> Vec<Vertex> {
    let manner = rng.pick(&SCATTERS);
    let mixed = rng.one_in(4);
    let mut vertices: Vec<Vertex> = Vec::with_capacity(count);
    for index in 0..count {
        let scatter = if mixed { rng.pick(&SCATTERS) } else { manner };
        let new = scattered(rng, place, scatter);
        let new = match (index, rng.int(0..=23)) {
            (1.., 0) => vertices[rng.index(index)],
            (1.., 1 | 2) => Vertex { x: vertices[index - 1].x, ..new },
            (1.., 3 | 4) => Vertex { y: vertices[index - 1].y, ..new },
            (2.., 5..=7) => {
                let (x, y) = between(rng, vertices[index - 2], vertices[index - 1]);
                vertex(x + rng.int(-2..=2), y + rng.int(-2..=2))
            }
            _ => new,
        };
        vertices.push(new);
    }
    vertices
}

/// A point of the line from a to b, to the nearest sub-pixel above and left; one in four times an end.
pub(crate) fn between(rng: &mut Rng, a: Vertex, b: Vertex) -> (i64, i64) {
    let share = if rng.one_in(4) { rng.pick(&[0, 1 << 32]) } else { rng.int(0..=1 << 32) };
    let coordinate = |a: i32, b: i32| {
        let (a, b) = (i128::from(a), i128::from(b));
        (a + (((b - a) * i128::from(share)) >> 32)) as i64
    };
    (coordinate(a.x.to_bits(), b.x.to_bits()), coordinate(a.y.to_bits(), b.y.to_bits()))
}

/// A window of a few hundred pixels that holds a point given in sub-pixels.
pub(crate) fn window_at(rng: &mut Rng, (x, y): (i64, i64)) -> PixelRect {
    let (width, height) = if rng.one_in(8) { (rng.int(1..=24), rng.int(1..=16)) } else { (24, 16) };
    let (left, top) = ((x >> 8) - rng.int(0..=width - 1), (y >> 8) - rng.int(0..=height - 1));
    rect(left as i32..(left + width) as i32, top as i32..(top + height) as i32)
}

/// The pixels that hold the vertices and all between them, one more or less on any side: whether a shape lies within
/// its clip is decided here. None if that is too much to count in.
fn window_around(rng: &mut Rng, vertices: impl Iterator<Item = (i64, i64)> + Clone) -> Option<PixelRect> {
    let mut side = |coordinate: fn((i64, i64)) -> i64| {
        let pixels = || vertices.clone().map(coordinate).map(|bits| bits >> 8);
        let start = pixels().min()? + rng.pick(&[-1, 0, 0, 0, 1]);
        let end = pixels().max()? + 1 + rng.pick(&[-1, 0, 0, 0, 1]);
        (start < end && end - start <= 48).then_some(start as i32..end as i32)
    };
    Some(rect(side(|(x, _)| x)?, side(|(_, y)| y)?))
}

/// A window on the outline through `vertices`; one in eight just around them, one in sixteen anywhere, to see nothing
/// or everything.
pub(crate) fn window_on(rng: &mut Rng, vertices: &[Vertex]) -> PixelRect {
    if rng.one_in(8) {
        let bits = |vertex: &Vertex| (vertex.x.to_bits().into(), vertex.y.to_bits().into());
        if let Some(window) = window_around(rng, vertices.iter().map(bits)) {
            return window;
        }
    }
    if vertices.is_empty() || rng.one_in(16) {
        let place = place(rng);
        return window_at(rng, place);
    }
    let from = rng.index(vertices.len());
    let (a, b) = (vertices[from], vertices[(from + 1) % vertices.len()]);
    let point = between(rng, a, b);
    window_at(rng, point)
}

pub(crate) fn triangle(rng: &mut Rng) -> (Triangle, PixelRect) {
    let place = place(rng);
    let vertices = vertices(rng, place, 3);
    let window = window_on(rng, &vertices);
    (Triangle::from_vertices([vertices[0], vertices[1], vertices[2]]), window)
}

pub(crate) fn line(rng: &mut Rng) -> (Line, PixelRect) {
    let place = place(rng);
    let ends = vertices(rng, place, 2);
    let (start, mut end) = (ends[0], ends[1]);
    if rng.one_in(8) {
        // Within a sub-pixel or two of the diagonal, where the major axis changes.
        let run = i64::from(end.x.to_bits()) - i64::from(start.x.to_bits());
        let rise = run * rng.pick(&[1, -1]) + rng.int(-2..=2);
        end = vertex(end.x.to_bits().into(), i64::from(start.y.to_bits()) + rise);
    }
    let window = window_on(rng, &[start, end]);
    (Line::new(start, end), window)
}

/// Whole sides and hypotenuses of right triangles: centres exactly on the circle.
const TRIPLES: [(i64, i64, i64); 6] = [(1, 0, 1), (0, 1, 1), (3, 4, 5), (5, 12, 13), (15, 8, 17), (21, 20, 29)];

pub(crate) fn circle(rng: &mut Rng) -> (Circle, PixelRect) {
    let (x, y) = place(rng);
    let (center, radius) = if rng.one_in(3) {
        let (a, b, hypotenuse) = rng.pick(&TRIPLES);
        let scale = rng.magnitude(26).abs() + 1;
        let pixel = centre((x >> 8) as i32, (y >> 8) as i32);
        let (a, b) = (a * scale * rng.pick(&[1, -1]), b * scale * rng.pick(&[1, -1]));
        (vertex(pixel.x + a, pixel.y + b), hypotenuse * scale)
    } else {
        let scatter = rng.pick(&SCATTERS);
        let radius = match rng.int(0..=5) {
            0 => rng.int(-300..=300),
            1 => rng.int(1..=2560),
            2 => 64 * rng.int(1..=80),
            3 => critical_length(rng).abs(),
            4 => rng.magnitude(31).abs(),
            _ => HIGHEST - rng.magnitude(31).abs(),
        };
        (scattered(rng, (x, y), scatter), radius)
    };
    let circle = Circle::from_bits(center, saturate(radius));
    let window = window_on_circle(rng, &circle);
    (circle, window)
}

/// A window on the circle: at its topmost, lowest, leftmost and rightmost points more often than anywhere else.
fn window_on_circle(rng: &mut Rng, circle: &Circle) -> PixelRect {
    let radius = i64::from(circle.radius.to_bits()).max(0);
    let (x, y) = (i64::from(circle.center.x.to_bits()), i64::from(circle.center.y.to_bits()));
    if rng.one_in(8) {
        let corners = [(x - radius, y - radius), (x + radius, y + radius)];
        if let Some(window) = window_around(rng, corners.into_iter()) {
            return window;
        }
    }
    let dx = match rng.int(0..=5) {
        0 => 0,
        1 => radius * rng.pick(&[1, -1]),
        2 => rng.magnitude(31).clamp(-radius, radius),
        _ => rng.int(-radius..=radius),
    };
    let dy = (radius * radius - dx * dx).isqrt() * rng.pick(&[1, -1]);
    window_at(rng, (x + dx, y + dy))
}

pub(crate) fn fill_rule(rng: &mut Rng) -> FillRule {
    rng.pick(&[FillRule::NonZero, FillRule::EvenOdd])
}

/// Contours of no vertex to a dozen, now and then of many; one to four of them around one place.
pub(crate) fn outline(rng: &mut Rng) -> (Outline, PixelRect) {
    let place = place(rng);
    let count = rng.pick(&[1, 1, 1, 2, 2, 3, 4]);
    let mut contours: Vec<Vec<Vertex>> = (0..count)
        .map(|_| {
            let length = match rng.int(0..=15) {
                0 => rng.index(3),
                1 => 13 + rng.index(40),
                2..=7 => 3 + rng.index(3),
                _ => 4 + rng.index(9),
            };
            vertices(rng, place, length)
        })
        .collect();
    if rng.one_in(8) {
        // The same contour again, in either direction: every edge coincides with another.
        let mut again = contours[rng.index(contours.len())].clone();
        if rng.one_in(2) {
            again.reverse();
        }
        contours.push(again);
    }
    let shown = rng.index(contours.len());
    let window = window_on(rng, &contours[shown]);
    (Outline::new(contours, fill_rule(rng)), window)
}

/// Spikes around a point, tens of pixels long, of a contour or several within each other, which go either way; on corners of
/// pixels, half pixels or anywhere, and shaken or not, so that some cross. Some tips are flat, with or without a loop; now
/// and then one is far away. All others are in the window.
pub(crate) fn spikes(rng: &mut Rng) -> (Outline, PixelRect) {
    let radius = rng.int(3..=50);
    let step = rng.pick(&[1, 1, 128, 256]);
    let shaken = if rng.one_in(3) { rng.int(1..=256 * radius / 4) } else { 0 };
    let contour = |rng: &mut Rng, outer: i64| {
        let count = rng.int(3..=40);
        let shortest = rng.int(1..=9);
        let mut vertices: Vec<Vertex> = (0..count)
            .map(|index| {
                let angle = (index as f64 + 0.3) / count as f64 * std::f64::consts::TAU;
                let length = 256 * outer * rng.int(shortest..=10) / 10;
                let coordinate = |rng: &mut Rng, part: f64| {
                    let exact = (length as f64 * part) as i64 + rng.int(-shaken..=shaken);
                    saturate(exact.div_euclid(step) * step)
                };
                Vertex::from_bits(coordinate(rng, angle.cos()), coordinate(rng, angle.sin()))
            })
            .collect();
        if rng.one_in(2) {
            vertices.reverse();
        }
        if rng.one_in(2) {
            vertices = vertices
                .into_iter()
                .flat_map(|vertex| {
                    let half = if rng.one_in(3) { rng.int(-200..=200) as i32 } else { 0 };
                    [-half, half].map(|by| Vertex::from_bits(vertex.x.to_bits() + by, vertex.y.to_bits()))
                })
                .collect();
        }
        if rng.one_in(8) {
            let vertex = rng.index(vertices.len());
            vertices[vertex] = Vertex::from_bits(saturate(rng.magnitude(31)), saturate(rng.magnitude(31)));
        }
        vertices
    };
    let contours = (0..1 + rng.index(3)).map(|within| contour(rng, (radius >> within).max(1))).collect();
    let reach = (radius + radius / 4 + 2) as i32;
    (Outline::new(contours, fill_rule(rng)), PixelRect { rows: -reach..reach, columns: -reach..reach })
}
