//! Every shape there is on a small grid, pixel by pixel.
//!
//! For triangles and polygons the oracle is laid out beforehand: for every directed edge between two points of the grid,
//! one bit (or a small count) a pixel says on which side of the edge the pixel's centre is. A shape is then a handful
//! of bit operations, and twenty-four million of them take seconds.

mod oracle;

use std::{
    convert::Infallible,
    ops::Range,
    sync::atomic::{AtomicUsize, Ordering},
    thread,
};

use oracle::{
    Grid, Outline, check_exact, rect,
    rule::{self, At, centre},
    span_pixels,
};
use spanfill::{
    ActiveEdge, BlockSink, Circle, FillRule, I24F8, Line, PixelRect, Polygon, Shape, Span, SpanSink, Triangle, Vertex,
};

/// Calls `work` with every number below `count`, on all cores.
fn on_all_cores(count: usize, work: impl Fn(usize) + Sync) {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let item = next.fetch_add(1, Ordering::Relaxed);
                    if item >= count {
                        return;
                    }
                    work(item);
                }
            });
        }
    });
}

/// The points of a square grid, in sub-pixels: every pair of the coordinates given.
fn grid_points(coordinates: &[i32]) -> Vec<Vertex> {
    let row = |y: i32| coordinates.iter().map(move |x| Vertex::from_bits(*x, y));
    coordinates.iter().flat_map(|y| row(*y)).collect()
}

/// The pixels of a square of at most 4 x 4, each a nibble of a `u64`; refuses what leaves the square or comes in the
/// wrong order or twice.
struct Nibbles {
    side: i32,
    pixels: u64,
    last: (i32, i32),
}

impl Nibbles {
    fn new(side: i32) -> Self {
        Self { side, pixels: 0, last: (i32::MIN, i32::MIN) }
    }

    fn bit(column: i32, row: i32) -> u64 {
        1 << (16 * row + 4 * column)
    }

    fn run(&mut self, row: i32, columns: &Range<i32>) {
        let inside = 0 <= row && row < self.side && 0 <= columns.start && columns.end <= self.side;
        assert!(inside && !columns.is_empty(), "row {row}, columns {columns:?}");
        for column in columns.clone() {
            assert!(self.pixels & Self::bit(column, row) == 0, "({column}, {row}) came twice");
            self.pixels |= Self::bit(column, row);
        }
    }

    fn in_order(&mut self, row: i32, columns: &Range<i32>) {
        let (last_row, last_end) = self.last;
        assert!(row > last_row || row == last_row && columns.start >= last_end, "row {row}, columns {columns:?}");
        self.last = (row, columns.end);
    }
}

impl SpanSink for Nibbles {
    type Error = Infallible;

    fn span(&mut self, Span { row, columns }: Span) -> Result<(), Infallible> {
        self.in_order(row, &columns);
        self.run(row, &columns);
        Ok(())
    }
}

impl BlockSink for Nibbles {
    type Error = Infallible;

    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), Infallible> {
        assert!(!rows.is_empty());
        self.in_order(rows.start, &columns);
        for row in rows {
            self.run(row, &columns);
        }
        Ok(())
    }
}

/// A pixel more than the square on every side: nothing may be sent there.
fn around(side: i32) -> PixelRect {
    rect(-1..side + 1, -1..side + 1)
}

fn spans_in_nibbles(shape: &impl Shape, side: i32) -> u64 {
    let mut sink = Nibbles::new(side);
    let Ok(()) = shape.spans(&around(side), &mut sink);
    sink.pixels
}

fn blocks_in_nibbles(shape: &impl Shape, side: i32) -> u64 {
    let mut sink = Nibbles::new(side);
    let Ok(()) = shape.blocks(&around(side), &mut sink);
    sink.pixels
}

/// For every directed pair of points, the pixels that lie on its positive side.
fn sides(points: &[Vertex], side: i32) -> Vec<u64> {
    let mut table = Vec::with_capacity(points.len() * points.len());
    for a in points {
        for b in points {
            let mut pixels = 0;
            for row in 0..side {
                for column in 0..side {
                    if rule::side(At::from(*a), At::from(*b), centre(column, row)) > 0 {
                        pixels |= Nibbles::bit(column, row);
                    }
                }
            }
            table.push(pixels);
        }
    }
    table
}

/// Compares every triangle between the points, in every order of its vertices; how many covered a pixel.
fn every_triangle(points: &[Vertex], side: i32, drawn: impl Fn(&Triangle) -> u64 + Sync) -> usize {
    let sides = sides(points, side);
    let count = points.len();
    let covering = AtomicUsize::new(0);
    on_all_cores(count, |a| {
        let mut found = 0;
        for b in 0..count {
            for c in 0..count {
                let same_side =
                    |a: usize, b: usize, c: usize| sides[a * count + b] & sides[b * count + c] & sides[c * count + a];
                let expected = same_side(a, b, c) | same_side(a, c, b);
                let triangle = Triangle::from_vertices([points[a], points[b], points[c]]);
                let pixels = drawn(&triangle);
                assert_eq!(pixels, expected, "a nibble a pixel; {}", rule::Belongs::code(&triangle));
                found += usize::from(expected != 0);
            }
        }
        covering.fetch_add(found, Ordering::Relaxed);
    });
    covering.into_inner()
}

#[test]
fn every_triangle_of_a_quarter_pixel_grid_of_four_pixels() {
    let points = grid_points(&Vec::from_iter((0..=1024).step_by(64)));
    assert_eq!(points.len().pow(3), 24_137_569);
    let covering = every_triangle(&points, 4, |triangle| spans_in_nibbles(triangle, 4));
    assert_eq!(covering, 16_240_686, "triangles with a pixel");
}

#[test]
fn every_triangle_of_a_half_pixel_grid_in_blocks_and_clipped() {
    let points = grid_points(&Vec::from_iter((0..=1024).step_by(128)));
    assert_eq!(points.len().pow(3), 531_441);
    every_triangle(&points, 4, |triangle| blocks_in_nibbles(triangle, 4));
    // Four clips make up the square.
    every_triangle(&points, 4, |triangle| {
        let mut pixels = 0;
        for clip in [rect(0..1, 0..3), rect(0..1, 3..9), rect(1..4, 0..2), rect(1..4, 2..4)] {
            let mut sink = Nibbles::new(4);
            let Ok(()) = triangle.spans(&clip, &mut sink);
            for row in 0..4 {
                for column in 0..4 {
                    let sent = sink.pixels & Nibbles::bit(column, row) != 0;
                    assert!(!sent || clip.rows.contains(&row) && clip.columns.contains(&column), "{clip:?}");
                }
            }
            assert_eq!(pixels & sink.pixels, 0);
            pixels |= sink.pixels;
        }
        pixels
    });
}

#[test]
fn every_triangle_next_to_centres_and_pixel_corners() {
    // A sub-pixel before, on and behind what decides.
    let points = grid_points(&[-1, 0, 1, 127, 128, 129, 255, 256, 257, 383, 384, 385]);
    every_triangle(&points, 2, |triangle| spans_in_nibbles(triangle, 2));
}

#[test]
fn every_triangle_with_a_vertex_far_away_or_at_an_end_of_the_range() {
    let coordinates = [i32::MIN, i32::MIN + 1, -(1 << 24), -(1 << 16), 0, 127, 128, 129, 1 << 15, 1 << 23, i32::MAX];
    let points = grid_points(&coordinates);
    let in_square = |triangle: &Triangle| {
        let mut sink = Nibbles::new(4);
        let Ok(()) = triangle.spans(&rect(0..4, 0..4), &mut sink);
        sink.pixels
    };
    every_triangle(&points, 4, in_square);
}

/// For every directed pair of points, the winding it adds to each pixel, plus one, in the pixel's nibble.
fn windings(points: &[Vertex], side: i32) -> Vec<u64> {
    let mut table = Vec::with_capacity(points.len() * points.len());
    for a in points {
        for b in points {
            let mut pixels = 0;
            for row in 0..side {
                for column in 0..side {
                    pixels += Nibbles::bit(column, row) * (1 + edge_winding(*a, *b, column, row)) as u64;
                }
            }
            table.push(pixels);
        }
    }
    table
}

/// What one edge adds to the winding around a centre: that of the edge and the way back far to the left of everything.
fn edge_winding(a: Vertex, b: Vertex, column: i32, row: i32) -> i64 {
    let far_left = -(1 << 20);
    let (left_a, left_b) =
        (Vertex { x: I24F8::from_bits(far_left), ..a }, Vertex { x: I24F8::from_bits(far_left), ..b });
    rule::winding(&[vec![a, b, left_b, left_a]], centre(column, row))
}

/// The pixels that a fill rule takes, from the sum of `edges` entries of [`windings`].
fn filled(sum: u64, edges: u64, side: i32, fill_rule: FillRule) -> u64 {
    let every_pixel = (0..side).flat_map(|row| (0..side).map(move |column| Nibbles::bit(column, row))).sum::<u64>();
    // Nibbles hold 0 to 2 * edges, `edges` where the winding is 0; exclusive or makes that 0 and keeps the parity.
    let winding = sum ^ (every_pixel * edges);
    match fill_rule {
        FillRule::NonZero => (winding | winding >> 1 | winding >> 2 | winding >> 3) & every_pixel,
        FillRule::EvenOdd => winding & every_pixel,
    }
}

const FILL_RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn polygon_in_nibbles(contours: &[&[Vertex]], fill_rule: FillRule, side: i32) -> u64 {
    let polygon = Polygon::with_contours(contours).fill_rule(fill_rule);
    let mut scratch = [ActiveEdge::EMPTY; 8];
    let scratch = &mut scratch[..polygon.active_edges()];
    spans_in_nibbles(&polygon.in_scratch(scratch).unwrap(), side)
}

#[test]
fn every_quadrilateral_of_a_half_pixel_grid_of_three_pixels() {
    let points = grid_points(&Vec::from_iter((0..=768).step_by(128)));
    let count = points.len();
    assert_eq!(count.pow(4), 5_764_801);
    let windings = windings(&points, 3);
    on_all_cores(count, |a| {
        for b in 0..count {
            for c in 0..count {
                for d in 0..count {
                    let sum = windings[a * count + b]
                        + windings[b * count + c]
                        + windings[c * count + d]
                        + windings[d * count + a];
                    let contour = [points[a], points[b], points[c], points[d]];
                    for fill_rule in FILL_RULES {
                        let expected = filled(sum, 4, 3, fill_rule);
                        let pixels = polygon_in_nibbles(&[&contour], fill_rule, 3);
                        let code = || rule::Belongs::code(&Outline::of(&contour, fill_rule));
                        assert_eq!(pixels, expected, "a nibble a pixel; {}", code());
                    }
                }
            }
        }
    });
}

#[test]
fn every_pair_of_triangles_as_two_contours() {
    // Middles and corners of pixels, not evenly spaced: 2 x 560 triangles with area or without, 1,254,400 pairs.
    let points = grid_points(&[0, 128, 384, 512]);
    let count = points.len();
    let windings = windings(&points, 2);
    let mut contours = Vec::new();
    for a in 0..count {
        for b in a + 1..count {
            for c in b + 1..count {
                contours.push([a, b, c]);
                contours.push([a, c, b]);
            }
        }
    }
    assert_eq!(contours.len(), 1120);
    let winding = |contour: &[usize; 3]| {
        let [a, b, c] = *contour;
        windings[a * count + b] + windings[b * count + c] + windings[c * count + a]
    };
    on_all_cores(contours.len(), |first| {
        for second in 0..contours.len() {
            let sum = winding(&contours[first]) + winding(&contours[second]);
            let corners = |contour: &[usize; 3]| contour.map(|point| points[point]);
            let (one, two) = (corners(&contours[first]), corners(&contours[second]));
            for fill_rule in FILL_RULES {
                let expected = filled(sum, 6, 2, fill_rule);
                let pixels = polygon_in_nibbles(&[&one, &two], fill_rule, 2);
                let code = || rule::Belongs::code(&Outline::new(vec![one.to_vec(), two.to_vec()], fill_rule));
                assert_eq!(pixels, expected, "a nibble a pixel; {}", code());
            }
        }
    });
}

/// Compares a circle with its rule on a window around it.
fn check_circle(center: Vertex, radius: i32) {
    let reach = (radius >> 8) + 2;
    let (column, row) = (center.x.to_bits() >> 8, center.y.to_bits() >> 8);
    let window = rect(column - reach..column + reach + 1, row - reach..row + reach + 1);
    check_exact(&Circle::from_bits(center, radius), &window).unwrap_or_else(|message| panic!("{message}"));
}

#[test]
fn every_circle_of_a_sixteenth_pixel_grid_up_to_six_pixels() {
    on_all_cores(16 * 16, |center| {
        for radius in 0..=6 * 16 {
            let center = Vertex::from_bits(16 * (center as i32 % 16), 16 * (center as i32 / 16));
            check_circle(center, 16 * radius);
        }
    });
}

#[test]
fn every_centre_of_a_circle_within_a_pixel() {
    on_all_cores(256 * 256, |center| {
        for radius in [1, 127, 128, 129, 181, 182, 256, 640] {
            check_circle(Vertex::from_bits(center as i32 % 256, center as i32 / 256), radius);
        }
    });
}

#[test]
fn every_radius_of_a_circle_up_to_four_pixels() {
    on_all_cores(1024, |radius| {
        for center in grid_points(&[0, 1, 63, 64, 100, 127, 128, 129, 200, 255]) {
            check_circle(center, radius as i32);
        }
    });
}

/// Compares every line between the points, both ways, in spans and blocks.
fn every_line(coordinates: &[i32], window: &PixelRect) {
    let points = grid_points(coordinates);
    on_all_cores(points.len(), |start| {
        for end in start..points.len() {
            let (line, back) = (Line::new(points[start], points[end]), Line::new(points[end], points[start]));
            check_exact(&line, window).unwrap_or_else(|message| panic!("{message}"));
            // A clip of exactly the pixels that hold the ends: what is continued to a centre beyond them is cut off.
            let held = |a: I24F8, b: I24F8| a.min(b).to_bits() >> 8..(a.max(b).to_bits() >> 8) + 1;
            let around = rect(held(line.start.x, line.end.x), held(line.start.y, line.end.y));
            if around.columns.len() < 16 && around.rows.len() < 16 {
                check_exact(&line, &around).unwrap_or_else(|message| panic!("{message}"));
            }
            let pixels: Grid = span_pixels(&line, window);
            let what = || format!("{} and back", rule::Belongs::code(&line));
            oracle::check_same(&span_pixels(&back, window), &pixels, what);
            oracle::check_same(&oracle::block_pixels(&line, window), &pixels, what);
            oracle::check_same(&oracle::block_pixels(&back, window), &pixels, what);
        }
    });
}

#[test]
fn every_line_of_a_quarter_pixel_grid_of_six_pixels() {
    every_line(&Vec::from_iter((0..=1536).step_by(64)), &rect(-1..8, -1..8));
}

#[test]
fn every_line_of_a_sixteenth_pixel_grid_of_two_pixels() {
    every_line(&Vec::from_iter((-256..=256).step_by(16)), &rect(-3..4, -3..4));
}

#[test]
fn every_line_next_to_centres_and_pixel_corners() {
    every_line(&[-129, -128, -127, -1, 0, 1, 127, 128, 129, 255, 256, 257, 639, 640], &rect(-3..5, -3..5));
}

#[test]
fn every_line_with_ends_far_away() {
    let coordinates = [i32::MIN, -(1 << 24), -(1 << 16), 0, 127, 128, 129, 1 << 15, 1 << 23, i32::MAX - 128, i32::MAX];
    every_line(&coordinates, &rect(-4..5, -4..5));
    every_line(&coordinates, &rect(-8_388_610..-8_388_604, -8_388_610..-8_388_604));
    every_line(&coordinates, &rect(8_388_604..8_388_610, 8_388_604..8_388_610));
    every_line(&coordinates, &rect(8_388_604..8_388_610, -4..5));
}
