//! Supersampled shapes: every sample counted by the exact rule for points.

mod oracle;

use std::ops::Range;

use oracle::{
    Belongs, CoverageGrid, Outline, Rng, cases, check_same_coverage, coverage, coverage_within, for_each_case, random,
    rect,
    rule::{At, edges, product, side},
};
use spanfill::{
    Circle, Cover, CoverageSink, FillRule, PixelRect, Polygon, SampleCell, SampleEdge, Samples, Shape,
    TooLittleScratch, Triangle, Vertex,
};

/// A pattern of samples, and what the test knows about it.
#[derive(Debug, Clone, Copy)]
struct Pattern {
    samples: Samples,
    side: i64,
    /// Of the sample in a line and a column.
    weight: fn(i64, i64) -> u32,
}

const WEIGHTED: Pattern = Pattern {
    samples: Samples::WEIGHTED,
    side: 4,
    weight: |line, column| [[1, 2, 2, 1], [2, 3, 3, 2], [2, 3, 3, 2], [1, 2, 2, 1]][line as usize][column as usize],
};

fn grid(side: i64) -> Pattern {
    Pattern { samples: Samples::grid(side as u8), side, weight: |_, _| 1 }
}

/// The usual ones more often than the others.
fn pattern(rng: &mut Rng) -> Pattern {
    match rng.int(0..=5) {
        0 => WEIGHTED,
        1 => grid(4),
        2 => grid(rng.pick(&[1, 2, 16])),
        _ => grid(rng.int(1..=16)),
    }
}

/// Whether a point belongs to a shape that is `times` as large; all in sub-pixels.
trait HasPoint: Belongs {
    fn has_point(&self, times: i64, p: At) -> bool;
}

fn enlarged(vertex: impl Into<At>, times: i64) -> At {
    let At { x, y } = vertex.into();
    At { x: times * x, y: times * y }
}

impl HasPoint for Outline {
    fn has_point(&self, times: i64, p: At) -> bool {
        let edges = self.contours.iter().flat_map(|contour| edges(contour));
        let mut winding = 0;
        for (a, b) in edges.map(|(a, b)| (enlarged(a, times), enlarged(b, times))) {
            // The ray to the right from the point moved by (+e, +e^2).
            if (a.y <= p.y) != (b.y <= p.y) {
                let direction = if a.y < b.y { 1 } else { -1 };
                winding += if side(a, b, p) == direction { direction } else { 0 };
            }
        }
        match self.fill_rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding & 1 == 1,
        }
    }
}

impl HasPoint for Triangle {
    fn has_point(&self, times: i64, p: At) -> bool {
        let [a, b, c] = self.vertices.map(|vertex| enlarged(vertex, times));
        let first = side(a, b, p);
        first != 0 && side(b, c, p) == first && side(c, a, p) == first
    }
}

impl HasPoint for Circle {
    fn has_point(&self, times: i64, p: At) -> bool {
        let (center, radius) = (enlarged(self.center, times), times * i64::from(self.radius.to_bits()));
        let (dx, dy) = (p.x - center.x, p.y - center.y);
        radius > 0 && product(dx, dx) + product(dy, dy) < product(radius, radius)
    }
}

/// Every sample of every pixel, one at a time.
fn counted(shape: &impl HasPoint, pattern: Pattern, window: &PixelRect) -> CoverageGrid {
    let mut grid = CoverageGrid::new(window.clone());
    let side = pattern.side;
    let middle = |pixel: i32, sample: i64| 256 * (side * i64::from(pixel) + sample) + 128;
    for row in window.rows.clone() {
        for column in window.columns.clone() {
            let (mut inside, mut all) = (0, 0);
            for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
                let weight = (pattern.weight)(i, j);
                all += weight;
                if shape.has_point(side, At { x: middle(column, j), y: middle(row, i) }) {
                    inside += weight;
                }
            }
            let share = (2 * 255 * inside + all) / (2 * all);
            if share > 0 {
                grid.set(column, row, share as u8);
            }
        }
    }
    grid
}

/// A shape in scratch of its own: of a polygon as many edges as it asks for, and so many cells.
struct Supersampled<'t, T> {
    shape: &'t T,
    samples: Samples,
    cells: usize,
}

impl Cover for Supersampled<'_, Outline> {
    fn touched(&self) -> PixelRect {
        self.shape.touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.shape.with_polygon(|polygon| {
            let mut edges = vec![SampleEdge::EMPTY; polygon.coverage_edges()];
            let mut cells = vec![SampleCell::EMPTY; self.cells];
            let shape = polygon.supersampled_in(self.samples, &mut edges, &mut cells);
            shape.expect("scratch of the size asked for").coverage(clip, sink)
        })
    }
}

impl Cover for Supersampled<'_, Triangle> {
    fn touched(&self) -> PixelRect {
        let mut cells = [SampleCell::EMPTY; 1];
        self.shape.supersampled_in(self.samples, &mut cells).expect("a cell").touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut cells = vec![SampleCell::EMPTY; self.cells];
        self.shape.supersampled_in(self.samples, &mut cells).expect("cells").coverage(clip, sink)
    }
}

impl Cover for Supersampled<'_, Circle> {
    fn touched(&self) -> PixelRect {
        let mut cells = [SampleCell::EMPTY; 1];
        self.shape.supersampled_in(self.samples, &mut cells).expect("a cell").touched()
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut cells = vec![SampleCell::EMPTY; self.cells];
        self.shape.supersampled_in(self.samples, &mut cells).expect("cells").coverage(clip, sink)
    }
}

/// Holds a shape against its samples, in one piece and in strips. Whether an outline is seen.
fn check<'t, T: HasPoint>(shape: &'t T, pattern: Pattern, window: &PixelRect, strip: usize) -> Result<bool, String>
where
    Supersampled<'t, T>: Cover,
{
    let expected = counted(shape, pattern, window);
    let width = window.columns.len().max(1);
    let supersampled = |cells| Supersampled { shape, samples: pattern.samples, cells };
    let whole = coverage(&supersampled(width), window);
    let in_strips = coverage(&supersampled(strip), window);
    for (drawn, what) in [(whole, "in one piece".into()), (in_strips, format!("in strips of {strip}"))] {
        if drawn != expected {
            let code = shape.code();
            return Err(format!("{:?} of {code}, {what}:\n{drawn:?}\nand not\n{expected:?}", pattern.samples));
        }
    }
    let outside = expected.covered().find(|&(column, row)| {
        let touched = supersampled(1).touched();
        !touched.rows.contains(&row) || !touched.columns.contains(&column)
    });
    match outside {
        Some(pixel) => Err(format!("{pixel:?} is not touched by {}", shape.code())),
        None => Ok(expected.is_mixed()),
    }
}

/// A part of a window with few samples in it: counting them one at a time takes long.
fn part(rng: &mut Rng, window: &PixelRect, pattern: Pattern) -> PixelRect {
    let most = (24 / pattern.side).max(3);
    let mut narrowed = |range: &Range<i32>| {
        let length = i64::from(range.end) - i64::from(range.start);
        let start = rng.int(0..=(length - most).max(0));
        let start = i64::from(range.start) + start;
        start as i32..(start + most.min(length)) as i32
    };
    rect(narrowed(&window.columns), narrowed(&window.rows))
}

/// Runs `check` on random shapes; one in `seldom` windows must show an outline.
fn compare<T: HasPoint>(seed: u64, count: u64, seldom: u64, make: impl Fn(&mut Rng) -> (T, PixelRect) + Sync)
where
    for<'t> Supersampled<'t, T>: Cover,
{
    let count = cases(count);
    let seen = for_each_case(seed, count, |rng| {
        let (shape, window) = make(rng);
        let pattern = pattern(rng);
        let window = part(rng, &window, pattern);
        check(&shape, pattern, &window, 1 + rng.index(9)).map(u64::from)
    });
    assert!(seen * seldom >= count, "only {seen} of {count} windows show an outline");
}

#[test]
fn random_triangles() {
    compare(300, 60_000, 6, random::triangle);
}

#[test]
fn random_circles() {
    compare(301, 60_000, 6, random::circle);
}

#[test]
fn random_polygons() {
    compare(302, 30_000, 6, random::outline);
}

/// Vertices where samples of all the usual patterns lie, so that outlines run through samples.
#[test]
fn outlines_through_samples() {
    let vertex = |rng: &mut Rng, step: i64| {
        Vertex::from_bits(
            (step * rng.int(-4..=40) + 32 * rng.int(0..=1)) as i32,
            (step * rng.int(-4..=40) + 32 * rng.int(0..=1)) as i32,
        )
    };
    let window = |rng: &mut Rng| rect(0..rng.int(4..=9) as i32, 0..rng.int(4..=9) as i32);
    let step = |rng: &mut Rng| rng.pick(&[8, 16, 32, 64, 128]);
    compare(310, 60_000, 6, |rng| {
        let step = step(rng);
        (Triangle::from_vertices([vertex(rng, step), vertex(rng, step), vertex(rng, step)]), window(rng))
    });
    compare(311, 60_000, 6, |rng| {
        let step = step(rng);
        (Circle::from_bits(vertex(rng, step), (step * rng.int(1..=30)) as i32), window(rng))
    });
    compare(312, 30_000, 6, |rng| {
        let step = step(rng);
        let contours = (0..1 + rng.index(3)).map(|_| (0..3 + rng.index(6)).map(|_| vertex(rng, step)).collect());
        (Outline::new(contours.collect(), random::fill_rule(rng)), window(rng))
    });
}

/// Edges that start and end between the same two lines of samples, and contours of hundreds of them.
#[test]
fn outlines_finer_than_the_samples() {
    compare(320, 10_000, 6, |rng| {
        let (reach, count) = rng.pick(&[(20, 60), (90, 40), (400, 200), (2, 9)]);
        let (x, y) = (rng.int(0..=1024), rng.int(0..=1024));
        let mut at = (x, y);
        let contour = (0..count).map(|_| {
            at = (at.0 + rng.int(-reach..=reach), at.1 + rng.int(-reach..=reach));
            random::vertex(at.0, at.1)
        });
        let outline = Outline::of(&contour.collect::<Vec<_>>(), random::fill_rule(rng));
        (outline, random::window_at(rng, (x, y)))
    });
}

/// The one sample of `grid(1)` is the pixel's centre.
#[test]
fn one_sample_is_the_shape_without_anti_aliasing() {
    fn check<'t, T: Belongs + Shape>(shape: &'t T, window: &PixelRect)
    where
        Supersampled<'t, T>: Cover,
    {
        let mut expected = CoverageGrid::new(window.clone());
        let pixels = oracle::span_pixels(shape, window);
        for row in window.rows.clone() {
            for column in window.columns.clone().filter(|&column| pixels.count(column, row) > 0) {
                expected.set(column, row, 255);
            }
        }
        let drawn = coverage(&Supersampled { shape, samples: Samples::grid(1), cells: 64 }, window);
        check_same_coverage(&drawn, &expected, || shape.code());
    }
    for_each_case(330, cases(20_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        check(&triangle, &window);
        let (circle, window) = random::circle(rng);
        check(&circle, &window);
        let (outline, window) = random::outline(rng);
        check(&outline, &window);
        Ok(0)
    });
}

/// A polygon of three vertices and the triangle; whatever the clip is cut into.
#[test]
fn triangles_are_polygons_and_tiles_are_the_whole() {
    for_each_case(340, cases(20_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let samples = pattern(rng).samples;
        let outline = Outline::of(&triangle.vertices, FillRule::NonZero);
        let whole = coverage(&Supersampled { shape: &outline, samples, cells: 48 }, &window);
        let (row, column) = (random_split(rng, &window.rows), random_split(rng, &window.columns));
        let mut tiled = CoverageGrid::new(window.clone());
        for rows in [window.rows.start..row, row..window.rows.end] {
            for columns in [window.columns.start..column, column..window.columns.end] {
                let tile = rect(columns, rows.clone());
                tiled.add(&coverage(&Supersampled { shape: &triangle, samples, cells: 48 }, &tile));
            }
        }
        check_same_coverage(&tiled, &whole, || triangle.code());
        Ok(0)
    });
}

fn random_split(rng: &mut Rng, range: &Range<i32>) -> i32 {
    rng.int(range.start.into()..=range.end.into()) as i32
}

/// Far from exact, and not farther than samples may be: with 16 x 16 of them, an edge misjudges at most one a line.
#[test]
fn many_samples_come_close_to_the_area() {
    for_each_case(350, cases(4_000), |rng| {
        let mut vertex = || Vertex::from_bits(rng.int(-900..=2600) as i32, rng.int(-900..=2600) as i32);
        let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
        let window = rect(0..8, 0..8);
        let exact = coverage(&triangle, &window);
        let sampled = coverage(&Supersampled { shape: &triangle, samples: Samples::grid(16), cells: 8 }, &window);
        for (row, column) in window.rows.clone().flat_map(|row| window.columns.clone().map(move |x| (row, x))) {
            let (exact, sampled) = (exact.at(column, row), sampled.at(column, row));
            if exact.abs_diff(sampled) > 20 {
                return Err(format!("({column}, {row}) is {sampled}, not {exact}: {}", triangle.code()));
            }
        }
        Ok(0)
    });
}

#[test]
fn rows_and_columns_beyond_every_coordinate_are_empty() {
    let everything = rect(i32::MIN..i32::MAX, i32::MIN..i32::MAX);
    let window = rect(0..8, 0..8);
    let triangle =
        Triangle::from_vertices([(300, 200), (1900, 700), (500, 1800)].map(|(x, y)| Vertex::from_bits(x, y)));
    let circle = Circle::from_bits(Vertex::from_bits(1000, 1100), 700);
    let outline = Outline::of(&triangle.vertices, FillRule::EvenOdd);
    for samples in [Samples::grid(16), Samples::WEIGHTED] {
        fn check<'t, T: Belongs>(shape: &'t T, samples: Samples, everything: &PixelRect, window: &PixelRect)
        where
            Supersampled<'t, T>: Cover,
        {
            let shape_in = |cells| Supersampled { shape, samples, cells };
            let expected = coverage(&shape_in(8), window);
            assert!(expected.is_mixed());
            let drawn = coverage_within(&shape_in(8), everything, window);
            check_same_coverage(&drawn, &expected, || shape.code());
            for far in [rect(i32::MAX - 4..i32::MAX, 0..8), rect(0..8, i32::MIN..i32::MIN + 4), rect(4..4, 0..8)] {
                assert!(coverage(&shape_in(1), &far).is_empty(), "{far:?} of {}", shape.code());
            }
        }
        check(&triangle, samples, &everything, &window);
        check(&circle, samples, &everything, &window);
        check(&outline, samples, &everything, &window);
    }
}

/// The ends of the range: a square of all coordinates, and a circle of the largest radius.
#[test]
fn the_largest_shapes_reach_their_corners() {
    let (low, high) = (i32::MIN, i32::MAX);
    let corners = [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| Vertex::from_bits(x, y));
    let square = Outline::of(&corners, FillRule::NonZero);
    let half = Triangle::from_vertices([corners[0], corners[1], corners[2]]);
    let circle = Circle::from_bits(Vertex::from_bits(0, 0), high);
    let (first, last) = (low >> 8, high >> 8);
    let windows = [(first, first), (last - 2, last - 2), (first, last - 2), (-1, -1), (last - 2, -1), (-1, first)];
    for (x, y) in windows {
        let window = rect(x..x + 3, y..y + 3);
        for pattern in [grid(1), grid(3), grid(16), WEIGHTED] {
            check(&square, pattern, &window, 2).expect("the square");
            check(&half, pattern, &window, 2).expect("the triangle");
            check(&circle, pattern, &window, 2).expect("the circle");
        }
    }
}

#[test]
fn too_little_scratch_is_refused() {
    let star: Vec<Vertex> = [(4, 0), (7, 9), (0, 3), (8, 3), (1, 9)].map(|(x, y)| Vertex::new(x, y)).to_vec();
    let polygon = Polygon::new(&star);
    let needed = polygon.coverage_edges();
    let mut edges = vec![SampleEdge::EMPTY; needed];
    let mut cells = [SampleCell::EMPTY; 1];
    let refused = polygon.supersampled_in(Samples::grid(4), &mut edges[1..], &mut cells).expect_err("one too few");
    assert_eq!(
        refused.to_string(),
        format!(
            "the outline needs scratch for {needed} edges, not {}: with_capacity::<{needed}>, coverage_with::<{needed}>, \
             or a slice of {needed}",
            needed - 1
        )
    );
    let refused = polygon.supersampled_in(Samples::grid(4), &mut edges, &mut []).expect_err("no cells");
    assert_eq!(refused, TooLittleScratch::NoCells);
    assert!(polygon.supersampled_in(Samples::grid(4), &mut edges, &mut cells).is_ok());
    let circle = Circle::from_bits(Vertex::from_bits(0, 0), 256);
    assert_eq!(circle.supersampled_in(Samples::WEIGHTED, &mut []).expect_err("no cells"), TooLittleScratch::NoCells);
}
