//! Coverage of every triangle, polygon, line and circle of a small grid, pixel by pixel.

mod oracle;

use std::{
    sync::atomic::{AtomicUsize, Ordering},
    thread,
};

use oracle::{Belongs, HasArea, Outline, Tolerance, Worst, check_coverage, check_same_coverage, coverage, rect};
use spanfill::{Circle, Cover, FillRule, Line, PixelRect, Triangle, Vertex};

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

/// The points of a grid, in sub-pixels: every pair of the coordinates given.
fn grid_points(coordinates: &[i32]) -> Vec<Vertex> {
    let row = |y: i32| coordinates.iter().map(move |x| Vertex::from_bits(*x, y));
    coordinates.iter().flat_map(|y| row(*y)).collect()
}

/// Steps of so many sub-pixels, up to and with `end`.
fn steps(step: i32, end: i32) -> Vec<i32> {
    (0..=end / step).map(|index| step * index).collect()
}

/// So many pixels in a square, and one more all around.
fn around(side: i32) -> PixelRect {
    rect(-1..side + 1, -1..side + 1)
}

fn check(shape: &(impl Cover + HasArea + Belongs), window: &PixelRect, tolerance: Tolerance) -> bool {
    check_coverage(shape, window, tolerance, &Worst::new()).unwrap_or_else(|message| panic!("{message}"))
}

/// Compares every triangle between the points, in one order of its vertices; how many are not empty.
fn every_triangle(points: &[Vertex], side: i32) -> usize {
    let (window, found) = (around(side), AtomicUsize::new(0));
    on_all_cores(points.len(), |first| {
        for second in first + 1..points.len() {
            for third in second + 1..points.len() {
                let mut vertices = [points[first], points[second], points[third]];
                // Upper and lower ends, left and right ones take turns at coming first.
                vertices.rotate_left((first + second + third) % 3);
                let is_seen = check(&Triangle::from_vertices(vertices), &window, Tolerance::EXACT);
                found.fetch_add(is_seen.into(), Ordering::Relaxed);
            }
        }
    });
    found.into_inner()
}

#[test]
fn every_triangle_of_half_pixels() {
    assert_eq!(every_triangle(&grid_points(&steps(128, 768)), 3), 17_600);
}

#[test]
fn every_triangle_of_eighths_of_a_pixel() {
    assert_eq!(every_triangle(&grid_points(&steps(32, 256)), 1), 82_608);
}

/// Compares every contour of `length` of the points, crossing itself or not, by both rules; how many are not empty. A vertex
/// may be a repeated one, so that all shorter contours are among them.
fn every_contour(points: &[Vertex], length: u32, side: i32) -> usize {
    let (window, found) = (around(side), AtomicUsize::new(0));
    on_all_cores(points.len(), |first| {
        // The others are no earlier than the first: as well could each of them be.
        let others = points.len() - first;
        for mut number in 0..others.pow(length - 1) {
            let mut contour = vec![points[first]];
            for _ in 1..length {
                contour.push(points[first + number % others]);
                number /= others;
            }
            for fill_rule in [FillRule::NonZero, FillRule::EvenOdd] {
                let is_seen = check(&Outline::of(&contour, fill_rule), &window, Tolerance::EXACT);
                found.fetch_add(is_seen.into(), Ordering::Relaxed);
            }
        }
    });
    found.into_inner()
}

#[test]
fn every_quadrilateral_of_half_pixels() {
    assert!(every_contour(&grid_points(&steps(128, 512)), 4, 2) > 150_000);
}

/// Edges cross in the middle of bands.
#[test]
fn every_quadrilateral_of_uneven_steps() {
    assert!(every_contour(&grid_points(&[0, 85, 200, 256]), 4, 1) > 30_000);
}

#[test]
fn every_hexagon_of_nine_points() {
    assert!(every_contour(&grid_points(&[10, 140, 250]), 6, 1) > 190_000);
}

#[test]
fn every_line_of_quarter_pixels() {
    let window = rect(-4..5, -4..5);
    let starts = grid_points(&[0, 64, 128, 192]);
    let ends = grid_points(&steps(64, 1536).iter().map(|at| at - 768).collect::<Vec<_>>());
    on_all_cores(starts.len(), |index| {
        for end in &ends {
            let line = Line::new(starts[index], *end);
            assert_eq!(check(&line, &window, Tolerance::EXACT), line.start != line.end, "{}", line.code());
            let back = Line::new(line.end, line.start);
            check_same_coverage(&coverage(&back, &window), &coverage(&line, &window), || back.code());
        }
    });
}

#[test]
fn every_circle_of_eighths_of_a_pixel() {
    let window = rect(-5..6, -5..6);
    let centers = grid_points(&steps(32, 255));
    on_all_cores(centers.len(), |index| {
        for radius in steps(16, 1024) {
            let circle = Circle::from_bits(centers[index], radius);
            assert_eq!(check(&circle, &window, Tolerance { few: 0.6, many: 0.6 }), radius > 0, "{}", circle.code());
        }
    });
}
