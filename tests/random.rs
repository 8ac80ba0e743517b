//! Millions of random shapes, pixel by pixel: tiny ones, slivers, vertices and edges exactly on centres, degenerate
//! ones, ones that lie off the screen or span the whole range, wherever the arithmetic could change its width.
//!
//! Each is compared in a window of a few hundred pixels that lies on its outline, anywhere in the range; the tests
//! make sure that most windows show both inside and outside. See `oracle::random` for the cases, and for
//! `SPANFILL_CASES`, which multiplies their number.

mod oracle;

use oracle::{Belongs, Grid, Outline, Rng, block_pixels, cases, check_exact, for_each_case, random, rect};
use proptest::{prelude::*, test_runner::RngSeed};
use spanfill::{Circle, FillRule, Line, PixelRect, Shape, Triangle, Vertex};

/// Compares `usual` cases and demands that at least one window in `one_in` shows an outline.
fn compare<S: Shape + Belongs>(seed: u64, usual: u64, one_in: u64, make: impl Fn(&mut Rng) -> (S, PixelRect) + Sync) {
    let count = cases(usual);
    let mixed = for_each_case(seed, count, |rng| {
        let (shape, window) = make(rng);
        // A panic would not say which shape it was.
        let checked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            let mixed = check_exact(&shape, &window)?;
            if rng.one_in(8) {
                check_blocks(&shape, &window)?;
            }
            Ok(u64::from(mixed))
        }));
        checked
            .unwrap_or_else(|panic| Err(format!("{} in {window:?}: {}", shape.code(), random::panic_message(&*panic))))
    });
    assert!(mixed * one_in >= count, "only {mixed} of {count} windows showed an outline");
}

fn check_blocks<S: Shape + Belongs>(shape: &S, window: &PixelRect) -> Result<(), String> {
    if block_pixels(shape, window) == Grid::of_rule(shape, window) {
        Ok(())
    } else {
        Err(format!("blocks of {} in {window:?}", shape.code()))
    }
}

#[test]
fn random_triangles() {
    compare(10, 2_000_000, 2, random::triangle);
}

#[test]
fn random_lines() {
    compare(11, 2_000_000, 2, random::line);
}

#[test]
fn random_circles() {
    compare(12, 2_000_000, 2, random::circle);
}

#[test]
fn random_polygons() {
    compare(13, 600_000, 2, random::outline);
}

#[test]
fn random_polygons_of_many_edges() {
    compare(14, 10_000, 2, |rng| {
        let place = random::place(rng);
        let count = 100 + rng.index(200);
        let contour = random::vertices(rng, place, count);
        let window = random::window_on(rng, &contour);
        (Outline::of(&contour, random::fill_rule(rng)), window)
    });
}

/// Stars: contours that go around their middle several times, on a circle of any size.
#[test]
fn random_stars() {
    compare(17, 100_000, 2, |rng| {
        let (x, y) = random::place(rng);
        let radius = 256 + rng.magnitude(29).abs();
        let points = 5 + 2 * rng.int(0..=6);
        // The corners lie on the circle by their x; every other one above the middle, then back below it.
        let rim: Vec<Vertex> = (0..2 * points)
            .map(|corner| {
                let dx = radius - 2 * radius * (corner % points) / points;
                let dy = (radius * radius - dx * dx).isqrt();
                if corner < points { random::vertex(x + dx, y - dy) } else { random::vertex(x - dx, y + dy) }
            })
            .collect();
        // A stride of k corners goes k times around before it is back; with a common factor it is back sooner, and
        // the contour covers itself.
        let stride = rng.int(1..=points - 1) as usize;
        let contour: Vec<Vertex> = (0..rim.len()).map(|step| rim[step * stride % rim.len()]).collect();
        let window = random::window_on(rng, &contour);
        (Outline::of(&contour, random::fill_rule(rng)), window)
    });
}

/// Slivers: two long edges a sub-pixel apart, or a pixel.
#[test]
fn random_slivers() {
    compare(15, 500_000, 6, |rng| {
        let place = random::place(rng);
        let ends = random::vertices(rng, place, 2);
        let (x, y) = random::between(rng, ends[0], ends[1]);
        let third = random::vertex(x + rng.magnitude(9), y + rng.magnitude(9));
        let window = random::window_on(rng, &[ends[0], third]);
        let mut vertices = [ends[0], ends[1], third];
        rng.shuffle(&mut vertices);
        (Triangle::from_vertices(vertices), window)
    });
}

/// Triangles whose every edge crosses the window, at slopes of every magnitude: the far vertices are a reflection of
/// the window in each other.
#[test]
fn random_large_triangles_around_a_pixel() {
    compare(16, 500_000, 2, |rng| {
        let mut far = || (rng.magnitude(31), rng.magnitude(31));
        let ((ax, ay), (bx, by)) = (far(), far());
        let near = (rng.int(-2000..=2000), rng.int(-2000..=2000));
        let vertices = [
            random::vertex(ax, ay),
            random::vertex(bx, by),
            random::vertex(near.0 - (ax + bx) / 2, near.1 - (ay + by) / 2),
        ];
        let from = rng.index(3);
        let point = random::between(rng, vertices[from], vertices[(from + 1) % 3]);
        (Triangle::from_vertices(vertices), random::window_at(rng, point))
    });
}

/// Coordinates that shrink to a few whole pixels: small ones on a lattice, small ones, any, and the ends of the range.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => (-16..=48).prop_map(|half_pixels| half_pixels * 128),
        4 => -1024..=4096,
        2 => any::<i32>(),
        1 => prop_oneof![Just(i32::MIN), Just(i32::MAX), Just(i32::MIN + 128), Just(i32::MAX - 127)],
    ]
}

fn vertex() -> impl Strategy<Value = Vertex> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Vertex::from_bits(x, y))
}

/// A window of 8 x 8 pixels around the point at `share` / 256 of the way from one vertex to the next.
fn window(vertices: &[Vertex], from: usize, share: i64, left: i32, above: i32) -> PixelRect {
    let Some(a) = vertices.get(from % vertices.len().max(1)) else { return rect(0..8, 0..8) };
    let b = vertices[(from + 1) % vertices.len()];
    let pixel = |a: i32, b: i32| {
        let (a, b) = (i64::from(a), i64::from(b));
        ((a * (256 - share) + b * share) >> 16) as i32
    };
    let column = pixel(a.x.to_bits(), b.x.to_bits()) - left;
    let row = pixel(a.y.to_bits(), b.y.to_bits()) - above;
    rect(column..column + 8, row..row + 8)
}

/// Where a window lies on an outline: which edge, how far along it, and how the window lies around that point.
fn on_outline() -> impl Strategy<Value = (usize, i64, i32, i32)> {
    (0..64_usize, 0..=256_i64, 0..8_i32, 0..8_i32)
}

fn holds<S: Shape + Belongs>(shape: &S, window: &PixelRect) -> Result<(), TestCaseError> {
    check_exact(shape, window).and_then(|_| check_blocks(shape, window)).map_err(TestCaseError::fail)
}

proptest! {
    // What fails here is shrunk to a small shape; the tests above have the numbers.
    #![proptest_config(ProptestConfig {
        cases: cases(50_000) as u32,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(17),
        ..ProptestConfig::default()
    })]

    #[test]
    fn triangles_shrink(vertices in [vertex(), vertex(), vertex()], (from, share, left, above) in on_outline()) {
        let window = window(&vertices, from, share, left, above);
        holds(&Triangle::from_vertices(vertices), &window)?;
    }

    #[test]
    fn lines_shrink(ends in [vertex(), vertex()], (from, share, left, above) in on_outline()) {
        holds(&Line::new(ends[0], ends[1]), &window(&ends, from, share, left, above))?;
    }

    #[test]
    fn circles_shrink(center in vertex(), radius in coordinate(), left in 0..8_i32, above in 0..8_i32) {
        let circle = Circle::from_bits(center, radius);
        let reach = i64::from(radius.max(0));
        let center = (i64::from(center.x.to_bits()), i64::from(center.y.to_bits()));
        for (x, y) in [(center.0 - reach, center.1), (center.0 + reach, center.1), (center.0, center.1 - reach),
            (center.0, center.1 + reach), (center.0 + reach * 3 / 5, center.1 - reach * 4 / 5)] {
            let (column, row) = ((x >> 8) as i32 - left, (y >> 8) as i32 - above);
            holds(&circle, &rect(column..column + 8, row..row + 8))?;
        }
    }

    #[test]
    fn polygons_shrink(
        contours in prop::collection::vec(prop::collection::vec(vertex(), 0..8), 1..4),
        even_odd in any::<bool>(),
        (from, share, left, above) in on_outline(),
    ) {
        let fill_rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let window = window(&contours[0], from, share, left, above);
        holds(&Outline::new(contours, fill_rule), &window)?;
    }
}
