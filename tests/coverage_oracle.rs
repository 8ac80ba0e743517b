//! The oracle for coverage held against other ways to the same areas: what the other tests of coverage rest on.

mod oracle;

use std::f64::consts::PI;

use oracle::{
    Area, HasArea, Outline, Rng,
    area::weighted_areas,
    cases, for_each_case, random, rect,
    rule::{At, cross, edges, product, winding},
};
use spanfill::{Circle, FillRule, Line, PixelRect, Vertex};

/// Compares the areas of every pixel of a window; one if some pixel lies on an outline.
fn compare(
    window: &PixelRect,
    one: impl Fn(i32) -> Vec<Area>,
    other: impl Fn(i32, i32) -> f64,
    most: f64,
) -> Result<u64, String> {
    let mut mixed = false;
    for row in window.rows.clone() {
        for (column, area) in window.columns.clone().zip(one(row)) {
            let expected = other(column, row);
            // What is not a number is not close.
            let is_close = (area.value - expected).abs() <= most + area.error;
            if !is_close {
                return Err(format!("({column}, {row}): {area:?}, not {expected}"));
            }
            mixed |= area.edges > 0;
        }
    }
    Ok(mixed.into())
}

/// The mean of `x` limited to 0..=1 where it grows evenly from `a` to `b`, or falls.
fn mean_within_pixel(a: f64, b: f64) -> f64 {
    let (a, b) = (a.min(b), a.max(b));
    if a >= 0.0 && b <= 1.0 || a == b {
        return f64::midpoint(a, b).clamp(0.0, 1.0);
    }
    let (from, to) = (a.clamp(0.0, 1.0), b.clamp(0.0, 1.0));
    let above = (b - 1.0).max(0.0).min(b - a);
    ((to - from) * f64::midpoint(from, to) + above) / (b - a)
}

/// The integral of the winding number over a pixel, edge by edge: each adds what lies to its right.
fn winding_integral(contours: &[Vec<Vertex>], column: i32, row: i32) -> f64 {
    let (left, top) = (256 * i64::from(column), 256 * i64::from(row));
    let of_edge = |(a, b): (At, At)| {
        let (upper, lower, sign) = if a.y < b.y { (a, b, 1.0) } else { (b, a, -1.0) };
        let (from, to) = (upper.y.max(top), lower.y.min(top + 256));
        if from >= to {
            return 0.0;
        }
        let dy = i128::from(lower.y - upper.y);
        let at = |y: i64| {
            let run = i128::from(y - upper.y) * i128::from(lower.x - upper.x) + i128::from(upper.x - left) * dy;
            run as f64 / (256 * dy) as f64
        };
        sign * (1.0 - mean_within_pixel(at(from), at(to))) * (to - from) as f64 / 256.0
    };
    contours.iter().flat_map(|contour| edges(contour)).map(of_edge).sum()
}

#[test]
fn winding_integrals_are_the_sums_over_their_edges() {
    let count = cases(2_000);
    let mixed = for_each_case(200, count, |rng| {
        let (outline, window) = random::outline(rng);
        compare(
            &window,
            |row| weighted_areas(&outline.contours, row, &window.columns, |winding| winding),
            |column, row| winding_integral(&outline.contours, column, row),
            1e-11,
        )
        .map_err(|message| format!("{message}: {outline:?}"))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count}");
}

#[test]
fn triangles_in_slabs_are_the_pixel_cut_by_three_half_planes() {
    let count = cases(3_000);
    let mixed = for_each_case(201, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        let outline = Outline::of(&triangle.vertices, random::fill_rule(rng));
        let cut: Vec<Vec<Area>> = window.rows.clone().map(|row| triangle.areas_in_row(row, &window.columns)).collect();
        let at = |column: i32, row: i32| {
            cut[(row - window.rows.start) as usize][(column - window.columns.start) as usize].value
        };
        compare(&window, |row| outline.areas_in_row(row, &window.columns), at, 1e-12)
            .map_err(|message| format!("{message}: {outline:?}"))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count}");
}

#[test]
fn areas_of_outlines_do_not_depend_on_which_axis_is_cut() {
    let count = cases(1_200);
    let mixed = for_each_case(202, count, |rng| {
        let (outline, window) = random::outline(rng);
        let mut turned = outline.clone();
        for vertex in turned.contours.iter_mut().flatten() {
            *vertex = Vertex { x: vertex.y, y: vertex.x };
        }
        let at = |column: i32, row: i32| turned.areas_in_row(column, &(row..row + 1))[0].value;
        compare(&window, |row| outline.areas_in_row(row, &window.columns), at, 1e-12)
            .map_err(|message| format!("{message}: {outline:?}"))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count}");
}

/// The least and the greatest area that a pixel can have: it is cut into 32 x 32 squares, of which those that no edge
/// meets belong or do not, as their centres do.
fn bounds_of_area(outline: &Outline, column: i32, row: i32) -> (f64, f64) {
    const SIDE: i64 = 8;
    let (mut sure, mut unsure) = (0, 0);
    let edges: Vec<(At, At)> = outline.contours.iter().flat_map(|contour| edges(contour)).collect();
    for top in (0..256).step_by(SIDE as usize).map(|y| 256 * i64::from(row) + y) {
        for left in (0..256).step_by(SIDE as usize).map(|x| 256 * i64::from(column) + x) {
            let (right, bottom) = (left + SIDE, top + SIDE);
            let corners = [
                At { x: left, y: top },
                At { x: right, y: top },
                At { x: right, y: bottom },
                At { x: left, y: bottom },
            ];
            let meets = |(a, b): &(At, At)| {
                let apart = a.x.max(b.x) < left || right < a.x.min(b.x) || a.y.max(b.y) < top || bottom < a.y.min(b.y);
                let sides = corners.map(|corner| cross(*a, *b, corner).signum());
                !apart && sides != [1; 4] && sides != [-1; 4]
            };
            if edges.iter().any(meets) {
                unsure += 1;
                continue;
            }
            let around = winding(&outline.contours, At { x: left + SIDE / 2, y: top + SIDE / 2 });
            sure += i32::from(match outline.fill_rule {
                FillRule::NonZero => around != 0,
                FillRule::EvenOdd => around & 1 == 1,
            });
        }
    }
    let share = |squares: i32| f64::from(squares) / f64::from(32 * 32);
    (share(sure), share(sure + unsure))
}

#[test]
fn areas_of_outlines_lie_between_those_of_small_squares() {
    let mixed = for_each_case(203, cases(60), |rng| {
        let (outline, window) = random::outline(rng);
        let row = rng.int(window.rows.start.into()..=i64::from(window.rows.end) - 1) as i32;
        let mut mixed = 0;
        for (column, area) in window.columns.clone().zip(outline.areas_in_row(row, &window.columns)) {
            let (least, most) = bounds_of_area(&outline, column, row);
            if !(least - area.error <= area.value && area.value <= most + area.error) {
                return Err(format!("({column}, {row}): {area:?}, not in {least}..={most}: {outline:?}"));
            }
            // What has edges through it and is bounded closely.
            mixed += u64::from(area.edges > 0 && most - least < 0.2);
        }
        Ok(mixed)
    });
    assert!(mixed > cases(60), "only {mixed} pixels");
}

/// A contour within pixel (0, 0), coordinates in sub-pixels.
fn contour(vertices: &[(i32, i32)]) -> Vec<Vertex> {
    vertices.iter().map(|(x, y)| Vertex::from_bits(*x, *y)).collect()
}

fn area_at(shape: &impl HasArea, column: i32, row: i32) -> f64 {
    shape.areas_in_row(row, &(column..column + 1))[0].value
}

#[test]
fn areas_that_can_be_worked_out_by_hand() {
    let both = [FillRule::NonZero, FillRule::EvenOdd];
    let areas = |contours: &[Vec<Vertex>]| both.map(|rule| area_at(&Outline::new(contours.to_vec(), rule), 0, 0));
    let square = contour(&[(0, 0), (256, 0), (256, 256), (0, 256)]);
    assert_eq!(areas(std::slice::from_ref(&square)), [1.0, 1.0]);
    assert_eq!(areas(&[square.clone(), square.clone()]), [1.0, 0.0]);
    let back = square.iter().rev().copied().collect();
    assert_eq!(areas(&[square.clone(), back]), [0.0, 0.0]);
    let middle = contour(&[(64, 64), (192, 64), (192, 192), (64, 192)]);
    assert_eq!(areas(&[square.clone(), middle.clone()]), [1.0, 0.75]);
    let hole = middle.into_iter().rev().collect();
    assert_eq!(areas(&[square, hole]), [0.75, 0.75]);
    // A bow tie is two triangles of a quarter each.
    assert_eq!(areas(&[contour(&[(0, 0), (256, 256), (256, 0), (0, 256)])]), [0.5, 0.5]);
    // The two squares of a figure eight, one of them around again.
    let twice = [(0, 0), (128, 0), (128, 128), (0, 128), (0, 0), (256, 0), (256, 256), (0, 256)];
    assert_eq!(areas(&[contour(&twice)]), [1.0, 0.75]);
    // One 1/256 wide and 1/256 high, the least there is.
    assert_eq!(areas(&[contour(&[(7, 7), (8, 7), (7, 8)])]), [0.5 / 65536.0; 2]);
    // Edges that cross at a third of the row: triangles of 1/3 * 256/3 / 2 and twice that, squared.
    let thirds = contour(&[(0, 0), (192, 256), (192, 0), (96, 0), (0, 128)]);
    let sum = area_at(&Outline::of(&thirds, FillRule::EvenOdd), 0, 0);
    let turned: Vec<Vertex> = thirds.iter().map(|vertex| Vertex { x: vertex.y, y: vertex.x }).collect();
    assert!((sum - area_at(&Outline::of(&turned, FillRule::EvenOdd), 0, 0)).abs() < 1e-12);
}

/// Sixteen-point Gauss-Legendre quadrature over a..b.
fn integral(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    const NODES: [(f64, f64); 8] = [
        (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
        (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
        (0.458_016_777_657_227_4, 0.169_156_519_395_002_5),
        (0.617_876_244_402_643_7, 0.149_595_988_816_576_7),
        (0.755_404_408_355_003, 0.124_628_971_255_533_9),
        (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
        (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
        (0.989_400_934_991_649_9, 0.027_152_459_411_754_1),
    ];
    let (middle, half) = (f64::midpoint(a, b), (b - a) / 2.0);
    NODES.iter().map(|(node, weight)| weight * (f(middle - half * node) + f(middle + half * node))).sum::<f64>() * half
}

/// The disc's area within a pixel: its columns added up, cut to the pixel. Exact integers place the pixel.
fn disc_by_quadrature(circle: Circle, column: i32, row: i32) -> f64 {
    let radius = i128::from(circle.radius.to_bits());
    if radius <= 0 {
        return 0.0;
    }
    let corner = |pixel: i32, center: i32| 256 * i128::from(pixel) - i128::from(center);
    let (mut left, mut top) = (corner(column, circle.center.x.to_bits()), corner(row, circle.center.y.to_bits()));
    if left.abs() > top.abs() {
        // Across the diagonal, where the circle is steep.
        (left, top) = (top, left);
    }
    // The column's height above the pixel's top and below, at `x` pixels from its left side, in pixels.
    let root = |x: i128| ((radius * radius - x * x).max(0) as f64).sqrt();
    let exact_root = |x: i128| ((radius * radius - x * x).max(0) << 60).isqrt();
    let arc = |x: f64| {
        let x = x * 256.0;
        // From the exact height at the left side, or in the middle of the disc where that side is outside.
        if left * left < radius * radius {
            let base = exact_root(left);
            let square = (radius * radius - left * left) as f64;
            let fall = ((2.0 * left as f64 + x) * x).min(square);
            let height = (square - fall).sqrt();
            let rise = -fall / (height + root(left));
            let upper = ((-base - (top << 30)) as f64 / f64::from(1 << 30) - rise) / 256.0;
            let lower = ((base - (top << 30)) as f64 / f64::from(1 << 30) + rise) / 256.0;
            (upper, lower)
        } else {
            let across = left as f64 + x;
            let height = ((radius * radius) as f64 - across * across).max(0.0).sqrt();
            ((-height - top as f64) / 256.0, (height - top as f64) / 256.0)
        }
    };
    // The pieces end where the circle crosses the lines of the pixel's sides.
    let mut ends = vec![0.0, 1.0];
    for y in [top, top + 256] {
        if y * y < radius * radius {
            let root = exact_root(y);
            ends.extend([root, -root].map(|x| ((x - (left << 30)) as f64) / f64::from(1 << 30) / 256.0));
        }
    }
    ends.extend([radius, -radius].map(|x| (x - left) as f64 / 256.0));
    ends.push(-left as f64 / 256.0);
    ends.retain(|end| (0.0..=1.0).contains(end));
    ends.sort_by(f64::total_cmp);
    let piece = |pair: &[f64]| {
        let (from, to) = (pair[0], pair[1]);
        // x = from + (to - from) (1 - cos u) / 2: no root is left at the ends.
        let height = |u: f64| {
            let (upper, lower) = arc(from + (to - from) * (1.0 - u.cos()) / 2.0);
            (lower.clamp(0.0, 1.0) - upper.clamp(0.0, 1.0)) * (to - from) * u.sin() / 2.0
        };
        // In parts, as the circle can be at its steepest just outside.
        (0..8).map(|part| integral(PI * f64::from(part) / 8.0, PI * f64::from(part + 1) / 8.0, height)).sum::<f64>()
    };
    ends.windows(2).map(piece).sum()
}

#[test]
fn areas_of_discs_are_those_of_quadrature() {
    let count = cases(150);
    let mixed = for_each_case(204, count, |rng| {
        let (circle, window) = random::circle(rng);
        compare(
            &window,
            |row| circle.areas_in_row(row, &window.columns),
            |column, row| disc_by_quadrature(circle, column, row),
            2e-9,
        )
        .map_err(|message| format!("{message}: {circle:?}"))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count}");
}

/// What is left of the disc in the pixel is nothing, all, or a corner some of which is smaller than a sub-pixel.
#[test]
fn areas_of_discs_that_only_just_reach_a_corner() {
    let corners = for_each_case(209, cases(100), |rng| {
        let (dx, dy) = (rng.magnitude(16), rng.magnitude(16));
        let corner = (256 * rng.int(-20..=20), 256 * rng.int(-20..=20));
        let radius = product(dx, dx) + product(dy, dy);
        let radius = radius.isqrt() as i32 + rng.int(-1..=2) as i32;
        let circle = Circle::from_bits(random::vertex(corner.0 + dx, corner.1 + dy), radius);
        let (column, row) = ((corner.0 >> 8) as i32, (corner.1 >> 8) as i32);
        let window = rect(column - 1..column + 1, row - 1..row + 1);
        compare(
            &window,
            |row| circle.areas_in_row(row, &window.columns),
            |column, row| disc_by_quadrature(circle, column, row),
            2e-9,
        )
        .map_err(|message| format!("{message}: {circle:?}"))
    });
    assert!(corners > 0);
}

/// The area of all pixels from `first` to `end`, in both directions.
fn total(shape: &impl HasArea, first: i32, end: i32) -> f64 {
    (first..end).flat_map(|row| shape.areas_in_row(row, &(first..end))).map(|area| area.value).sum()
}

#[test]
fn pixels_of_a_disc_and_of_a_line_add_up() {
    for_each_case(205, cases(2_000), |rng| {
        let bits = |rng: &mut Rng| rng.int(0..=16 * 256) as i32;
        let radius = rng.magnitude(12).abs();
        let circle = Circle::from_bits(Vertex::from_bits(bits(rng), bits(rng)), radius as i32);
        let expected = PI * (radius * radius) as f64 / 65536.0;
        let sum = total(&circle, -18, 34);
        if (sum - expected).abs() > 1e-9 {
            return Err(format!("{sum}, not {expected}: {circle:?}"));
        }
        let mut vertex = || Vertex::from_bits(bits(rng), bits(rng));
        let line = Line::new(vertex(), vertex());
        let run = f64::from(line.end.x.to_bits() - line.start.x.to_bits());
        let rise = f64::from(line.end.y.to_bits() - line.start.y.to_bits());
        let (sum, expected) = (total(&line, -2, 20), run.hypot(rise) / 256.0);
        if (sum - expected).abs() > 1e-9 {
            return Err(format!("{sum}, not {expected}: {line:?}"));
        }
        Ok(0)
    });
}

#[test]
fn lines_along_the_axes_are_rectangles() {
    for_each_case(206, cases(2_000), |rng| {
        let (x, y) = random::place(rng);
        // Half a pixel to either side of the line stays within the range.
        let (x, y) = (x.clamp(-(1 << 30), 1 << 30), y.clamp(-(1 << 30), 1 << 30));
        let length = rng.magnitude(30);
        let window = random::window_at(rng, (x, y));
        let turn = |(x, y): (i64, i64), swap: bool| if swap { random::vertex(y, x) } else { random::vertex(x, y) };
        let swap = rng.one_in(2);
        let line = Line::new(turn((x, y), swap), turn((x + length, y), swap));
        let around = [(x, y - 128), (x + length, y - 128), (x + length, y + 128), (x, y + 128)];
        let outline = Outline::of(&around.map(|at| turn(at, swap)), FillRule::NonZero);
        let window = if swap { rect(window.rows, window.columns) } else { window };
        let at = |column: i32, row: i32| area_at(&outline, column, row);
        compare(&window, |row| line.areas_in_row(row, &window.columns), at, 1e-12)
            .map_err(|message| format!("{message}: {line:?}"))
    });
}

/// The line's rectangle and the polygon of its corners, rounded to sub-pixels: close, for lines of every direction.
#[test]
fn lines_are_close_to_the_polygons_of_their_corners() {
    for_each_case(207, cases(1_500), |rng| {
        let bits = |rng: &mut Rng| rng.int(-3000..=3000);
        let [(ax, ay), (bx, by)] = [(bits(rng), bits(rng)), (bits(rng), bits(rng))];
        let line = Line::new(random::vertex(ax, ay), random::vertex(bx, by));
        let length = ((bx - ax) as f64).hypot((by - ay) as f64);
        if length == 0.0 {
            return Ok(0);
        }
        let aside = |run: i64| (128.0 * run as f64 / length).round() as i64;
        let (dx, dy) = (aside(ay - by), aside(bx - ax));
        let corners = [(ax + dx, ay + dy), (bx + dx, by + dy), (bx - dx, by - dy), (ax - dx, ay - dy)];
        let outline = Outline::of(&corners.map(|(x, y)| random::vertex(x, y)), FillRule::NonZero);
        let window = random::window_at(rng, (ax, ay));
        // Half a sub-pixel either way along at most four sides of at most a pixel's diagonal.
        let most = 4.0 * 2_f64.sqrt() / 2.0 / 256.0;
        let at = |column: i32, row: i32| area_at(&outline, column, row);
        compare(&window, |row| line.areas_in_row(row, &window.columns), at, most)
            .map_err(|message| format!("{message}: {line:?}"))
    });
}

/// Narrower than 2^-40, for whatever there is to compare.
#[test]
fn areas_are_bounded_closely_at_any_distance() {
    let checked = for_each_case(208, cases(3_000), |rng| {
        let (outline, window) = random::outline(rng);
        for row in window.rows.clone() {
            for area in outline.areas_in_row(row, &window.columns) {
                if area.error > 9e-13 || !(-1e-12..=1.0 + 1e-12).contains(&area.value) {
                    return Err(format!("{area:?}: {outline:?}"));
                }
            }
        }
        Ok(1)
    });
    assert!(checked > 0);
}
