//! Coverage of random shapes, pixel by pixel: each is the exact area, rounded once.
//!
//! Each shape is compared in a window of a few hundred pixels that lies on its outline, anywhere in the range; the
//! tests make sure that most windows show an outline. `SPANFILL_CASES` multiplies the number of cases, and
//! `cargo test --test coverage_random -- --nocapture` prints the greatest errors that were met.

mod oracle;

use oracle::{Belongs, HasArea, Outline, Rng, Tolerance, Worst, cases, check_coverage, for_each_case, random, rect};
use spanfill::{Circle, Cover, FillRule, Line, PixelRect, Triangle, Vertex};

/// Compares `usual` cases and demands that at least one window in `one_in` shows an outline.
fn compare<S: Cover + HasArea + Belongs>(
    name: &str,
    seed: u64,
    usual: u64,
    one_in: u64,
    tolerance: Tolerance,
    make: impl Fn(&mut Rng) -> (S, PixelRect) + Sync,
) {
    let (count, worst) = (cases(usual), Worst::new());
    let mixed = for_each_case(seed, count, |rng| {
        let (shape, window) = make(rng);
        // A panic would not say which shape it was.
        let checked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            check_coverage(&shape, &window, tolerance, &worst).map(u64::from)
        }));
        checked
            .unwrap_or_else(|panic| Err(format!("{} in {window:?}: {}", shape.code(), random::panic_message(&*panic))))
    });
    println!("{name}: off by {:.4} at most, where there are many edges by {:.4}", worst.few(), worst.many());
    assert!(mixed * one_in >= count, "only {mixed} of {count} windows showed an outline");
}

const EXACT: Tolerance = Tolerance::EXACT;
/// Anti-aliased circles are not made of edges.
const CIRCLES: Tolerance = Tolerance { few: 0.6, many: 0.6 };

/// Whether coordinates lie within 8192 pixels of the origin.
fn are_near(vertices: &[Vertex]) -> bool {
    vertices.iter().flat_map(|vertex| [vertex.x, vertex.y]).all(|at| at.to_bits().unsigned_abs() <= 1 << 21)
}

/// The first of the shapes that is near.
fn near<S>(rng: &mut Rng, make: impl Fn(&mut Rng) -> (S, PixelRect), is_near: impl Fn(&S) -> bool) -> (S, PixelRect) {
    loop {
        let (shape, window) = make(rng);
        if is_near(&shape) {
            return (shape, window);
        }
    }
}

fn line_is_near(line: &Line) -> bool {
    are_near(&[line.start, line.end])
}

fn circle_is_near(circle: &Circle) -> bool {
    are_near(&[circle.center, Vertex { x: circle.radius, y: circle.radius }])
}

#[test]
fn random_triangles() {
    compare("triangles", 210, 15_000, 2, EXACT, random::triangle);
}

#[test]
fn random_lines_near_the_origin() {
    compare("near lines", 211, 6_000, 2, EXACT, |rng| near(rng, random::line, line_is_near));
}

#[test]
fn random_lines_anywhere() {
    compare("lines", 214, 10_000, 2, EXACT, random::line);
}

#[test]
fn random_circles_near_the_origin() {
    compare("near circles", 212, 6_000, 2, CIRCLES, |rng| near(rng, random::circle, circle_is_near));
}

#[test]
fn random_circles_anywhere() {
    compare("circles", 215, 10_000, 2, CIRCLES, random::circle);
}

#[test]
fn random_polygons() {
    compare("polygons", 213, 2_500, 2, EXACT, random::outline);
}

/// Of a few pixels and near the origin: what is drawn most.
#[test]
fn random_small_shapes() {
    let vertex = |rng: &mut Rng| Vertex::from_bits(rng.int(-900..=2600) as i32, rng.int(-900..=2600) as i32);
    let window = |rng: &mut Rng| rect(0..rng.int(4..=9) as i32, 0..rng.int(4..=9) as i32);
    compare("small triangles", 220, 10_000, 3, EXACT, |rng| {
        (Triangle::from_vertices([vertex(rng), vertex(rng), vertex(rng)]), window(rng))
    });
    compare("small lines", 221, 10_000, 3, EXACT, |rng| (Line::new(vertex(rng), vertex(rng)), window(rng)));
    compare("small circles", 222, 10_000, 3, CIRCLES, |rng| {
        (Circle::from_bits(vertex(rng), rng.int(1..=1500) as i32), window(rng))
    });
    compare("small polygons", 223, 2_500, 3, EXACT, |rng| {
        let contours = (0..1 + rng.index(3)).map(|_| (0..3 + rng.index(5)).map(|_| vertex(rng)).collect()).collect();
        (Outline::new(contours, random::fill_rule(rng)), window(rng))
    });
}

/// As large as a screen, and all of it: what is far apart in a row, and how one part of it follows the other.
#[test]
fn random_shapes_on_a_whole_screen() {
    let screen = rect(0..320, 0..240);
    let vertex = |rng: &mut Rng| Vertex::from_bits(rng.int(-30_000..=110_000) as i32, rng.int(-30_000..=90_000) as i32);
    compare("large triangles", 224, 60, 2, EXACT, |rng| {
        (Triangle::from_vertices([vertex(rng), vertex(rng), vertex(rng)]), screen.clone())
    });
    compare("large lines", 225, 60, 2, EXACT, |rng| (Line::new(vertex(rng), vertex(rng)), screen.clone()));
    compare("large circles", 226, 120, 2, CIRCLES, |rng| {
        (Circle::from_bits(vertex(rng), rng.int(1..=70_000) as i32), screen.clone())
    });
    compare("large polygons", 227, 60, 2, EXACT, |rng| {
        let contours = (0..1 + rng.index(3)).map(|_| (0..3 + rng.index(9)).map(|_| vertex(rng)).collect()).collect();
        (Outline::new(contours, random::fill_rule(rng)), screen.clone())
    });
}

/// Edges of many rows, and few that start or end in each.
#[test]
fn random_spikes() {
    compare("spikes", 228, 3_000, 2, EXACT, random::spikes);
}

/// Runs are sent when they are full: wherever that is, nothing is lost, left or right.
#[test]
fn edges_across_any_number_of_columns() {
    let worst = Worst::new();
    for columns in 1..=100 {
        let across = 4 * 256 * columns;
        let [left, right, tip] = [(300, 51), (300 + 2 * across, 51), (300 + across + 90, 51 + 4 * 256)];
        let vertices = [left, right, tip].map(|(x, y)| Vertex::from_bits(x, y));
        let window = rect(0..8 * columns + 4, -1..6);
        for triangle in [vertices, vertices.map(|vertex| Vertex { y: -vertex.y, ..vertex })] {
            let window = PixelRect { rows: window.rows.start.min(-6)..window.rows.end, ..window.clone() };
            check_coverage(&Triangle::from_vertices(triangle), &window, EXACT, &worst).expect("the exact areas");
        }
    }
}

/// The corner of a pixel, near the origin or anywhere.
fn corner(rng: &mut Rng) -> (i64, i64) {
    let (x, y) = random::place(rng);
    (x & !255, y & !255)
}

/// On half pixels from the corner of a pixel, or a sub-pixel beside.
fn on_corners(rng: &mut Rng, (x, y): (i64, i64)) -> Vertex {
    let coordinate = |rng: &mut Rng| 128 * rng.int(-2..=16) + if rng.one_in(8) { rng.int(-1..=1) } else { 0 };
    random::vertex(x + coordinate(rng), y + coordinate(rng))
}

fn window_on_corners(rng: &mut Rng, (x, y): (i64, i64)) -> PixelRect {
    random::window_at(rng, (x + 1024, y + 1024))
}

fn line_on_corners(rng: &mut Rng) -> (Line, PixelRect) {
    let at = corner(rng);
    (Line::new(on_corners(rng, at), on_corners(rng, at)), window_on_corners(rng, at))
}

fn circle_on_corners(rng: &mut Rng) -> (Circle, PixelRect) {
    let at = corner(rng);
    (Circle::from_bits(on_corners(rng, at), 64 * rng.int(1..=20) as i32), window_on_corners(rng, at))
}

/// Vertices at the corners of pixels, horizontal edges between rows, vertical ones between columns, edges that cross
/// there, and edges on top of each other.
#[test]
fn random_shapes_on_the_corners_of_pixels() {
    compare("triangles on corners", 230, 5_000, 2, EXACT, |rng| {
        let at = corner(rng);
        let vertices = [on_corners(rng, at), on_corners(rng, at), on_corners(rng, at)];
        (Triangle::from_vertices(vertices), window_on_corners(rng, at))
    });
    compare("polygons on corners", 233, 2_000, 2, EXACT, |rng| {
        let at = corner(rng);
        let contours =
            (0..1 + rng.index(3)).map(|_| (0..3 + rng.index(8)).map(|_| on_corners(rng, at)).collect()).collect();
        (Outline::new(contours, random::fill_rule(rng)), window_on_corners(rng, at))
    });
    compare("near lines on corners", 231, 3_000, 2, EXACT, |rng| near(rng, line_on_corners, line_is_near));
    compare("near circles on corners", 232, 3_000, 2, CIRCLES, |rng| near(rng, circle_on_corners, circle_is_near));
}

#[test]
fn random_lines_on_the_corners_of_pixels_anywhere() {
    compare("lines on corners", 234, 3_000, 2, EXACT, line_on_corners);
}

#[test]
fn random_circles_on_the_corners_of_pixels_anywhere() {
    compare("circles on corners", 235, 3_000, 2, CIRCLES, circle_on_corners);
}

/// Within a pixel or two of its corner.
fn tiny_vertex(rng: &mut Rng, (x, y): (i64, i64)) -> Vertex {
    let (least, most) = rng.pick(&[(0, 256), (0, 256), (-40, 40), (100, 104), (-256, 256)]);
    random::vertex(x + rng.int(least..=most), y + rng.int(least..=most))
}

fn window_of_nine((x, y): (i64, i64)) -> PixelRect {
    let (column, row) = ((x >> 8) as i32, (y >> 8) as i32);
    rect(column - 1..column + 2, row - 1..row + 2)
}

fn tiny_line(rng: &mut Rng) -> (Line, PixelRect) {
    let at = corner(rng);
    (Line::new(tiny_vertex(rng, at), tiny_vertex(rng, at)), window_of_nine(at))
}

fn tiny_circle(rng: &mut Rng) -> (Circle, PixelRect) {
    let at = corner(rng);
    (Circle::from_bits(tiny_vertex(rng, at), rng.int(1..=160) as i32), window_of_nine(at))
}

#[test]
fn random_shapes_within_a_pixel() {
    compare("tiny triangles", 240, 30_000, 3, EXACT, |rng| {
        let at = corner(rng);
        let vertices = [tiny_vertex(rng, at), tiny_vertex(rng, at), tiny_vertex(rng, at)];
        (Triangle::from_vertices(vertices), window_of_nine(at))
    });
    compare("tiny polygons", 243, 10_000, 3, EXACT, |rng| {
        let at = corner(rng);
        let contours =
            (0..1 + rng.index(2)).map(|_| (0..3 + rng.index(4)).map(|_| tiny_vertex(rng, at)).collect()).collect();
        (Outline::new(contours, random::fill_rule(rng)), window_of_nine(at))
    });
    compare("near tiny lines", 241, 15_000, 3, EXACT, |rng| near(rng, tiny_line, line_is_near));
    compare("near tiny circles", 242, 15_000, 3, CIRCLES, |rng| near(rng, tiny_circle, circle_is_near));
}

#[test]
fn random_lines_within_a_pixel_anywhere() {
    compare("tiny lines", 244, 15_000, 3, EXACT, tiny_line);
}

#[test]
fn random_circles_within_a_pixel_anywhere() {
    compare("tiny circles", 245, 15_000, 3, CIRCLES, tiny_circle);
}

/// Two long edges a sub-pixel apart, or a pixel.
#[test]
fn random_slivers_and_spikes() {
    let sliver = |rng: &mut Rng| {
        let place = random::place(rng);
        let ends = random::vertices(rng, place, 2);
        let (x, y) = random::between(rng, ends[0], ends[1]);
        let third = random::vertex(x + rng.magnitude(9), y + rng.magnitude(9));
        let window = random::window_on(rng, &[ends[0], third]);
        ([ends[0], ends[1], third], window)
    };
    compare("slivers", 250, 10_000, 6, EXACT, |rng| {
        let (mut vertices, window) = sliver(rng);
        rng.shuffle(&mut vertices);
        (Triangle::from_vertices(vertices), window)
    });
    compare("slivers and spikes of polygons", 251, 3_000, 6, EXACT, |rng| {
        let ([a, b, c], window) = sliver(rng);
        let d = random::vertex(i64::from(b.x.to_bits()) + rng.int(-2..=2), i64::from(b.y.to_bits()) + rng.int(-2..=2));
        (Outline::of(&[a, b, c, a, d], random::fill_rule(rng)), window)
    });
}

/// Edges of tens of thousands of pixels and more through the window, at slopes of every magnitude.
#[test]
fn random_large_shapes_around_a_pixel() {
    compare("large triangles", 252, 7_500, 3, EXACT, |rng| {
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
    compare("large polygons", 254, 3_000, 3, EXACT, |rng| {
        let mut contour = Vec::new();
        for _ in 0..2 + rng.index(3) {
            // Edges from one far vertex through the neighbourhood of the origin to the next.
            let (dx, dy) = (rng.magnitude(31), rng.magnitude(31));
            let near = (rng.int(-1000..=1000), rng.int(-1000..=1000));
            contour.extend([random::vertex(near.0 - dx, near.1 - dy), random::vertex(near.0 + dx, near.1 + dy)]);
        }
        let window = if rng.one_in(2) { random::window_at(rng, (0, 0)) } else { random::window_on(rng, &contour) };
        (Outline::of(&contour, random::fill_rule(rng)), window)
    });
}

#[test]
fn random_large_lines_around_a_pixel() {
    compare("large lines", 253, 6_000, 3, EXACT, |rng| {
        let (dx, dy) = (rng.magnitude(31), rng.magnitude(31));
        let near = (rng.int(-2000..=2000), rng.int(-2000..=2000));
        let line = Line::new(random::vertex(near.0 - dx, near.1 - dy), random::vertex(near.0 + dx, near.1 + dy));
        let point = random::between(rng, line.start, line.end);
        (line, random::window_at(rng, point))
    });
}

/// Teeth of a sub-pixel and wider, upright or on their side.
#[test]
fn random_combs() {
    compare("combs", 255, 4_000, 3, EXACT, |rng| {
        let (x, y) = random::place(rng);
        let (pitch, height) = (rng.int(1..=200), rng.int(1..=1500));
        let teeth = rng.int(2..=20);
        let shaken = rng.pick(&[0, 0, 1, 100]);
        let swap = rng.one_in(2);
        let mut contour = Vec::new();
        let mut push = |x: i64, y: i64| contour.push(if swap { random::vertex(y, x) } else { random::vertex(x, y) });
        for tooth in 0..=teeth {
            push(x + tooth * pitch, y + rng.int(0..=shaken));
            if tooth < teeth {
                push(x + tooth * pitch + rng.int(0..=pitch), y + height + rng.int(0..=shaken));
            }
        }
        push(x + teeth * pitch, y + 2 * height);
        push(x, y + 2 * height);
        let window = random::window_on(rng, &contour);
        (Outline::of(&contour, random::fill_rule(rng)), window)
    });
}

/// Contours around each other, in either direction, sub-pixels apart or pixels.
#[test]
fn random_nested_contours() {
    compare("nested contours", 256, 3_000, 3, EXACT, |rng| {
        let (x, y) = random::place(rng);
        let corners: Vec<(i64, i64)> = (0..3 + rng.index(6)).map(|_| (rng.magnitude(12), rng.magnitude(12))).collect();
        let step = rng.int(1..=64);
        let contours: Vec<Vec<Vertex>> = (0..rng.int(1..=8))
            .map(|ring| {
                let share = 256 - step * ring;
                let mut contour: Vec<Vertex> =
                    corners.iter().map(|(dx, dy)| random::vertex(x + dx * share / 256, y + dy * share / 256)).collect();
                if rng.one_in(2) {
                    contour.reverse();
                }
                contour
            })
            .collect();
        let window = random::window_on(rng, &contours[0]);
        (Outline::new(contours, random::fill_rule(rng)), window)
    });
}

#[test]
fn random_polygons_of_many_edges() {
    compare("polygons of many edges", 257, 150, 2, EXACT, |rng| {
        let place = random::place(rng);
        let count = 50 + rng.index(100);
        let contour = random::vertices(rng, place, count);
        let window = random::window_on(rng, &contour);
        (Outline::of(&contour, random::fill_rule(rng)), window)
    });
}

#[test]
fn shapes_beside_above_and_below_the_clip_cover_nothing_and_those_around_it_everything() {
    let clip = rect(0..12, 0..7);
    let beside = [(-40_000, 900), (40_000, 900), (900, -40_000), (900, 40_000), (-40_000, -40_000), (2_000_000_000, 0)];
    let worst = Worst::new();
    for (x, y) in beside {
        let corners = [(x, y), (x + 3000, y + 100), (x + 100, y + 3000)].map(|(x, y)| random::vertex(x, y));
        assert!(oracle::coverage(&Triangle::from_vertices(corners), &clip).is_empty());
        assert!(oracle::coverage(&Outline::of(&corners, FillRule::NonZero), &clip).is_empty());
        assert!(oracle::coverage(&Line::new(corners[0], corners[1]), &clip).is_empty());
        assert!(oracle::coverage(&Circle::from_bits(corners[0], 3000), &clip).is_empty());
    }
    let around = [(-9_000_000, -9_000_000), (30_000_000, -9_000_000), (-9_000_000, 30_000_000)];
    let around = around.map(|(x, y)| random::vertex(x, y));
    check_coverage(&Triangle::from_vertices(around), &clip, EXACT, &worst).unwrap();
    check_coverage(&Outline::of(&around, FillRule::EvenOdd), &clip, EXACT, &worst).unwrap();
    check_coverage(&Circle::from_bits(around[0], i32::MAX), &clip, EXACT, &worst).unwrap();
}
