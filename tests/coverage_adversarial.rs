//! Coverage of outlines that are made to go wrong: many edges in one pixel, many crossings in one band of 1/256 pixel,
//! crossings exactly where bands and pixels end, contours on top of each other.
//!
//! Each is drawn by both fill rules, upright and on its side, near the origin and far away, and held against the exact
//! areas.

mod oracle;

use oracle::{
    Belongs, HasArea, Outline, Rng, Tolerance, Worst, cases, check_coverage, coverage, for_each_case, random, rect,
};
use spanfill::{FillRule, PixelRect, Vertex};

const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

/// In sub-pixels.
type Point = (i64, i64);

/// Contours around (0, 0), to be drawn anywhere.
struct Figure {
    contours: Vec<Vec<Point>>,
    window: PixelRect,
}

/// Whole pixels from the origin: within the zone of narrow edges, outside of it, and near the ends of the range.
const PLACES: [Point; 3] = [(0, 0), (-40_000, 33_000), (8_300_000, -8_200_000)];

impl Figure {
    fn new(contours: Vec<Vec<Point>>, window: PixelRect) -> Self {
        Self { contours, window }
    }

    /// The figure at a place, upright or mirrored in the diagonal, and its window.
    fn at(&self, (x, y): Point, is_turned: bool, fill_rule: FillRule) -> (Outline, PixelRect) {
        let place = |(a, b): &Point| if is_turned { (*b, *a) } else { (*a, *b) };
        let vertex = |(a, b): Point| random::vertex(a + 256 * x, b + 256 * y);
        let contours = self.contours.iter().map(|contour| contour.iter().map(place).map(vertex).collect()).collect();
        let PixelRect { rows, columns } = self.window.clone();
        let (rows, columns) = if is_turned { (columns, rows) } else { (rows, columns) };
        let (x, y) = (x as i32, y as i32);
        (Outline::new(contours, fill_rule), rect(columns.start + x..columns.end + x, rows.start + y..rows.end + y))
    }

    /// One if there is something to be seen.
    fn check(&self, tolerance: Tolerance, worst: &Worst) -> Result<u64, String> {
        let mut mixed = false;
        for fill_rule in RULES {
            for is_turned in [false, true] {
                for place in PLACES {
                    let (outline, window) = self.at(place, is_turned, fill_rule);
                    mixed |= check_coverage(&outline, &window, tolerance, worst)?;
                }
            }
        }
        Ok(mixed.into())
    }
}

const EXACT: Tolerance = Tolerance::EXACT;

/// Checks `count` figures, of which at least a third have to be seen.
fn check_figures(seed: u64, count: u64, tolerance: Tolerance, make: impl Fn(&mut Rng) -> Figure + Sync) {
    let worst = Worst::new();
    let seen = for_each_case(seed, count, |rng| make(rng).check(tolerance, &worst));
    assert!(seen * 3 > count, "only {seen} of {count} figures were seen");
}

/// A point of a circle.
fn on_circle((x, y): (f64, f64), radius: f64, turn: f64) -> Point {
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    ((x + radius * cos).round() as i64, (y + radius * sin).round() as i64)
}

/// {n/k}: every k-th of n points of a circle; several contours where k and n have a divisor in common.
fn star(center: (f64, f64), radius: f64, turn: f64, n: usize, k: usize) -> Vec<Vec<Point>> {
    let mut is_used = vec![false; n];
    let mut contours = Vec::new();
    for start in 0..n {
        let mut contour = Vec::new();
        let mut at = start;
        while !is_used[at] {
            is_used[at] = true;
            contour.push(on_circle(center, radius, turn + at as f64 / n as f64));
            at = (at + k) % n;
        }
        if !contour.is_empty() {
            contours.push(contour);
        }
    }
    contours
}

/// The nine pixels around the one whose upper left corner is (0, 0).
fn nine() -> PixelRect {
    rect(-1..2, -1..2)
}

/// All edges of a star pass by its centre, at a distance that depends on k, and each crosses most others on its way.
#[test]
fn stars_around_a_pixel() {
    check_figures(300, cases(600), EXACT, |rng| {
        let n = rng.pick(&[5, 5, 6, 7, 7, 8, 9, 12, 16]);
        let k = 2 + rng.index((n - 1) / 2 - 1);
        let center = (rng.int(0..=256) as f64, rng.int(0..=256) as f64);
        let radius = rng.pick(&[100.0, 256.0, 1000.0, 20_000.0, 2_000_000.0]);
        Figure::new(star(center, radius, rng.int(0..=1000) as f64 / 1000.0, n, k), nine())
    });
}

#[test]
fn stars_of_many_points_around_a_pixel() {
    let stars = [(33, 16), (48, 20), (63, 31), (64, 31), (64, 24), (64, 30)];
    let count = cases(stars.len() as u64);
    check_figures(301, count, EXACT, |rng| {
        let (n, k) = rng.pick(&stars);
        let center = (rng.int(0..=256) as f64, rng.int(0..=256) as f64);
        // Upright, and so that the edges of (64, 31) are tangents of a circle within the pixel.
        Figure::new(star(center, rng.pick(&[300.0, 2500.0]), 0.0, n, k), rect(0..1, 0..1))
    });
}

/// Edges through one point of a pixel, or past it by a sub-pixel, from far away and from near by: they change their
/// order in one band, all of them.
#[test]
fn edges_through_a_point() {
    check_figures(302, cases(300), EXACT, |rng| {
        let (x, y) = (rng.int(0..=256), rng.int(0..=256));
        let bits = rng.int(6..=26);
        let apart = rng.pick(&[0, 0, 1, 1, 30]);
        let mut contour = Vec::new();
        for _ in 0..rng.int(2..=16) {
            let (dx, dy) = (rng.magnitude(bits), rng.magnitude(bits));
            let (x, y) = (x + rng.int(-apart..=apart), y + rng.int(-apart..=apart));
            contour.extend([(x - dx, y - dy), (x + dx, y + dy)]);
        }
        Figure::new(vec![contour], nine())
    });
}

#[test]
fn fans_of_slivers_that_meet_in_a_pixel() {
    check_figures(303, cases(100), EXACT, |rng| {
        let hub = (rng.int(0..=256), rng.int(0..=256));
        let bits = rng.int(6..=26);
        let contours = (0..rng.int(2..=40))
            .map(|_| {
                let (x, y) = (hub.0 + rng.magnitude(bits), hub.1 + rng.magnitude(bits));
                let mut sliver = vec![hub, (x, y), (x + rng.int(-2..=2), y + rng.int(-2..=2))];
                if rng.one_in(2) {
                    sliver.reverse();
                }
                sliver
            })
            .collect();
        Figure::new(contours, nine())
    });
}

#[test]
fn bow_ties_within_a_pixel() {
    check_figures(304, cases(4_000), EXACT, |rng| {
        let side = rng.pick(&[256, 256, 16, 4]);
        let (x, y) = (rng.int(0..=256 - side), rng.int(0..=256 - side));
        let mut point = || (x + rng.int(0..=side), y + rng.int(0..=side));
        let (a, b, c, d) = (point(), point(), point(), point());
        // Crossed in either way, and twice over.
        let contours = match rng.int(0..=2) {
            0 => vec![vec![a, b, c, d]],
            1 => vec![vec![a, c, b, d]],
            _ => vec![vec![a, b, c, d], vec![a, c, d, b]],
        };
        Figure::new(contours, rect(0..1, 0..1))
    });
}

/// Teeth of 1/256 pixel and wider, all in one column of pixels: their points, their roots and all between.
fn comb(rng: &mut Rng, height: i64) -> Figure {
    let pitch = rng.pick(&[1, 1, 2, 3]);
    let lean = rng.pick(&[0, 0, 1, 300, -50]);
    let top = -rng.int(0..=height);
    let mut contour = Vec::new();
    for tooth in 0..256 / pitch {
        let x = tooth * pitch;
        if rng.one_in(4) {
            contour.extend([(x, top), (x + lean, top + height), (x + lean + pitch, top + height)]);
        } else {
            contour.extend([(x, top), (x + lean + pitch / 2, top + height)]);
        }
    }
    contour.extend([(256, top), (256, top - 300), (0, top - 300)]);
    Figure::new(vec![contour], rect(-1..2, 0..3))
}

#[test]
fn combs_within_a_pixel() {
    check_figures(305, cases(9), EXACT, |rng| {
        let height = rng.pick(&[1, 200, 256, 700, 5000, 30_000, 1 << 20]);
        comb(rng, height)
    });
}

/// Edges longer than 8192 pixels are cut at points that are rounded by up to 2^-17 pixel. For 256 edges that are rounded the
/// same way in one pixel, that is half of a 255th.
const CUT_EDGES: Tolerance = Tolerance { few: 0.51, many: 1.01 };

#[test]
fn combs_of_the_longest_edges_within_a_pixel() {
    check_figures(305, cases(9), CUT_EDGES, |rng| comb(rng, 1 << 30));
}

#[test]
fn tall_combs_within_a_pixel() {
    check_figures(311, cases(8), CUT_EDGES, |rng| {
        // The slope of one sub-pixel over this height is just short of a multiple of 2^-32.
        comb(rng, 4_190_212)
    });
    let bottom = 200_000;
    let teeth = (0..128).map(|tooth| 2 * tooth);
    let contours = teeth.map(|x| vec![(x, bottom - 4_190_212), (x + 2, bottom - 4_190_212), (x + 1, bottom)]).collect();
    let spikes = Figure::new(contours, rect(0..1, 720..782));
    spikes.check(CUT_EDGES, &Worst::new()).unwrap();
}

/// Contours that lie on each other, in both directions: as long as the windings do not cancel out, they are one.
#[test]
fn a_hundred_copies_of_a_contour() {
    let count = cases(50);
    let seen = for_each_case(306, count, |rng| {
        let (single, window) = random::outline(rng);
        let forward = rng.pick(&[100, 99, 50, 37, 1]);
        let mut contours = vec![single.contours[0].clone(); forward];
        let backward: Vec<Vertex> = single.contours[0].iter().rev().copied().collect();
        contours.resize(100, backward);
        rng.shuffle(&mut contours);
        if rng.one_in(2) {
            contours.pop();
        }
        let count = contours.len();
        let copies = Outline::new(contours, single.fill_rule);
        let drawn = coverage(&copies, &window);
        let remain = match single.fill_rule {
            FillRule::NonZero => {
                copies.contours.iter().filter(|contour| **contour == single.contours[0]).count() * 2 != count
            }
            FillRule::EvenOdd => count % 2 == 1,
        };
        let single = Outline::of(&single.contours[0], single.fill_rule);
        for row in window.rows.clone() {
            let areas = single.areas_in_row(row, &window.columns);
            for ((area, coverage), column) in areas.iter().zip(drawn.row(row)).zip(window.columns.clone()) {
                let expected = if remain { 255.0 * area.value } else { 0.0 };
                if (f64::from(*coverage) - expected).abs() > 0.51 {
                    return Err(format!(
                        "({column}, {row}) has {coverage}, not {expected}: {count} of {}",
                        single.code()
                    ));
                }
            }
        }
        Ok(drawn.is_mixed().into())
    });
    assert!(seen * 4 > count, "only {seen} of {count} were seen");
}

/// A contour and another whose vertices are a sub-pixel off: slivers all along, and crossings at shallow angles.
#[test]
fn contours_a_sub_pixel_apart() {
    check_figures(307, cases(400), EXACT, |rng| {
        let bits = rng.int(7..=24);
        let mut contour: Vec<Point> =
            (0..3 + rng.index(5)).map(|_| (rng.magnitude(bits), rng.magnitude(bits))).collect();
        contour.push((rng.int(-300..=300), rng.int(-300..=300)));
        let contours = (0..rng.int(2..=3))
            .map(|_| {
                let mut shaken: Vec<Point> =
                    contour.iter().map(|(x, y)| (x + rng.int(-1..=1), y + rng.int(-1..=1))).collect();
                if rng.one_in(2) {
                    shaken.reverse();
                }
                shaken
            })
            .collect();
        Figure::new(contours, rect(-3..3, -2..2))
    });
}

/// Two edges and more that are almost one line, and cross in the window.
#[test]
fn edges_that_cross_at_shallow_angles() {
    check_figures(308, cases(700), EXACT, |rng| {
        let bits = rng.int(8..=29);
        let (dx, dy) = (rng.magnitude(bits), rng.magnitude(bits));
        let aside = rng.pick(&[1, 2, 10, 300]);
        let mut contour = Vec::new();
        for _ in 0..rng.int(2..=5) {
            let mut off = || rng.int(-aside..=aside);
            contour.extend([(-dx + off(), -dy + off()), (dx + off(), dy + off())]);
        }
        Figure::new(vec![contour], rect(-4..4, -2..2))
    });
}

/// Where a band, a row or a pixel ends.
#[test]
fn edges_that_cross_on_the_corners_of_pixels() {
    check_figures(309, cases(2_000), EXACT, |rng| {
        let grid = rng.pick(&[256, 256, 128, 1]);
        let mut contour = Vec::new();
        for _ in 0..rng.int(2..=4) {
            let (x, y) = (grid * rng.int(0..=1), grid * rng.int(0..=1));
            // Whole multiples of one step to either side lead exactly through the corner.
            let (dx, dy) = (rng.int(-9..=9), rng.int(-9..=9));
            let (before, after) = (rng.magnitude(8).abs(), rng.magnitude(8).abs());
            contour.extend([(x - before * dx, y - before * dy), (x + after * dx, y + after * dy)]);
        }
        Figure::new(vec![contour], rect(-2..3, -2..3))
    });
}

/// Edges that are a few sub-pixels high and up to thousands of pixels long, all in the same bands.
#[test]
fn almost_horizontal_edges_that_cross() {
    check_figures(310, cases(500), EXACT, |rng| {
        let bits = rng.int(8..=28);
        let y = rng.pick(&[0, 100, 253, 255, 256]);
        let contour = (0..rng.int(4..=14))
            .map(|index| {
                let x = rng.magnitude(bits).abs() + rng.int(0..=300);
                (if index % 2 == 0 { -x } else { x }, y + rng.int(-2..=2))
            })
            .collect();
        Figure::new(vec![contour], rect(-4..4, -1..2))
    });
}
