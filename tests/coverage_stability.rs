//! What must not change a bit of the coverage: the order of vertices, the direction of a contour, where it starts, a move
//! by whole pixels; what may change it by its rounding: a mirror. And what draws nothing, and what must not overflow.

mod oracle;

use std::ops::Range;

use oracle::{
    Belongs, CoverageGrid, HasArea, Outline, Rng, Tolerance, Worst, cases, check_coverage, check_same_coverage,
    coverage, for_each_case, random, rect,
};
use spanfill::{Circle, Cover, FillRule, Line, PixelRect, Triangle, Vertex};

const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

#[test]
fn triangles_do_not_depend_on_the_order_of_their_vertices() {
    let count = cases(15_000);
    let mixed = for_each_case(430, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        let [a, b, c] = triangle.vertices;
        let drawn = coverage(&triangle, &window);
        for order in [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            check_same_coverage(&coverage(&Triangle::from_vertices(order), &window), &drawn, || triangle.code());
        }
        Ok(drawn.is_mixed().into())
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

#[test]
fn lines_do_not_depend_on_their_direction() {
    let count = cases(25_000);
    let mixed = for_each_case(431, count, |rng| {
        let (line, window) = random::line(rng);
        let drawn = coverage(&line, &window);
        let back = Line::new(line.end, line.start);
        check_same_coverage(&coverage(&back, &window), &drawn, || line.code());
        Ok(drawn.is_mixed().into())
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

/// Whether all coordinates lie within 8192 pixels of the origin. Farther away, pixels that are exactly half way between
/// two 255ths may become the one or the other.
fn is_near(outline: &Outline) -> bool {
    let coordinates = outline.contours.iter().flatten().flat_map(|vertex| [vertex.x, vertex.y]);
    coordinates.into_iter().all(|at| at.to_bits().unsigned_abs() <= 1 << 21)
}

/// Holds an outline against another way to say the same.
fn check_alike(outline: &Outline, other: &Outline, drawn: &CoverageGrid) -> Result<(), String> {
    let drawn_other = coverage(other, drawn.window());
    if is_near(outline) {
        check_same_coverage(&drawn_other, drawn, || outline.code());
    }
    check_close(&drawn_other, drawn, |pixel| pixel, || format!("{} and {}", other.code(), outline.code()))
}

#[test]
fn polygons_do_not_depend_on_where_contours_start_or_go_nor_on_their_order() {
    let count = cases(12_000);
    let mixed = for_each_case(432, count, |rng| {
        let (outline, window) = if rng.one_in(2) {
            random::outline(rng)
        } else {
            let shapes = shapes(rng);
            (shapes.outline, shapes.window)
        };
        let drawn = coverage(&outline, &window);
        let mut other = outline.clone();
        rng.shuffle(&mut other.contours);
        let all_backward = rng.one_in(2);
        for contour in &mut other.contours {
            if !contour.is_empty() {
                let start = rng.index(contour.len());
                contour.rotate_left(start);
            }
            // Directions are for windings, not for parities.
            if all_backward || outline.fill_rule == FillRule::EvenOdd && rng.one_in(2) {
                contour.reverse();
            }
        }
        check_alike(&outline, &other, &drawn)?;
        Ok(u64::from(drawn.is_mixed() && is_near(&outline)))
    });
    assert!(mixed * 4 > count, "only {mixed} of {count} showed an outline");
}

#[test]
fn repeated_vertices_change_nothing() {
    for_each_case(433, cases(5_000), |rng| {
        let (outline, window) = random::outline(rng);
        let mut repeated = outline.clone();
        for contour in &mut repeated.contours {
            *contour = contour.iter().flat_map(|vertex| [*vertex, *vertex]).collect();
        }
        check_alike(&outline, &repeated, &coverage(&outline, &window))?;
        Ok(0)
    });
}

#[test]
fn three_vertices_are_a_triangle_by_both_rules() {
    let count = cases(15_000);
    let mixed = for_each_case(434, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        let drawn = coverage(&triangle, &window);
        for fill_rule in RULES {
            let outline = Outline::of(&triangle.vertices, fill_rule);
            check_close(&coverage(&outline, &window), &drawn, |pixel| pixel, || outline.code())?;
        }
        Ok(drawn.is_mixed().into())
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

/// Each pixel of one grid is at most one off from the other's.
fn check_close(
    one: &CoverageGrid,
    other: &CoverageGrid,
    pixel: impl Fn((i32, i32)) -> (i32, i32),
    code: impl FnOnce() -> String,
) -> Result<(), String> {
    for row in one.window().rows.clone() {
        for column in one.window().columns.clone() {
            let there = pixel((column, row));
            let (here, there) = (one.at(column, row), other.at(there.0, there.1));
            if here.abs_diff(there) > 1 {
                return Err(format!("({column}, {row}) has {here} and {there}: {}", code()));
            }
        }
    }
    Ok(())
}

/// A shape that can be moved and mirrored.
trait Moved: Cover + Belongs {
    fn moved(&self, to: &dyn Fn(Vertex) -> Vertex) -> Self;
}

impl Moved for Triangle {
    fn moved(&self, to: &dyn Fn(Vertex) -> Vertex) -> Self {
        Self::from_vertices(self.vertices.map(to))
    }
}

impl Moved for Line {
    fn moved(&self, to: &dyn Fn(Vertex) -> Vertex) -> Self {
        Self::new(to(self.start), to(self.end))
    }
}

impl Moved for Circle {
    fn moved(&self, to: &dyn Fn(Vertex) -> Vertex) -> Self {
        Self { center: to(self.center), ..*self }
    }
}

impl Moved for Outline {
    fn moved(&self, to: &dyn Fn(Vertex) -> Vertex) -> Self {
        let contours = self.contours.iter().map(|contour| contour.iter().map(|vertex| to(*vertex)).collect()).collect();
        Self::new(contours, self.fill_rule)
    }
}

/// A window near the origin, and one of each kind of shape there.
struct Shapes {
    window: PixelRect,
    triangle: Triangle,
    line: Line,
    circle: Circle,
    outline: Outline,
}

fn shapes(rng: &mut Rng) -> Shapes {
    let reach = rng.pick(&[300, 3_000, 3_000, 100_000]);
    let step = rng.pick(&[1, 1, 64]);
    let mut vertex = || {
        let mut coordinate = || step * rng.int(-reach / step..=reach / step);
        random::vertex(coordinate(), coordinate())
    };
    let (triangle, line) = (Triangle::from_vertices([vertex(), vertex(), vertex()]), Line::new(vertex(), vertex()));
    let contours = vec![vec![vertex(), vertex(), vertex(), vertex(), vertex()], vec![vertex(), vertex(), vertex()]];
    let circle = Circle::from_bits(vertex(), rng.int(1..=reach) as i32);
    let outline = Outline::new(contours, random::fill_rule(rng));
    Shapes { window: rect(-12..12, -8..8), triangle, line, circle, outline }
}

fn check_moved(shape: &impl Moved, window: &PixelRect, (right, down): (i32, i32)) -> u64 {
    let drawn = coverage(shape, window);
    let moved = shape.moved(&|Vertex { x, y }| Vertex::from_bits(x.to_bits() + 256 * right, y.to_bits() + 256 * down));
    let shifted = |range: &Range<i32>, by: i32| range.start + by..range.end + by;
    let there = rect(shifted(&window.columns, right), shifted(&window.rows, down));
    let mut back = CoverageGrid::new(window.clone());
    let drawn_there = coverage(&moved, &there);
    for (column, row) in drawn_there.covered() {
        back.set(column - right, row - down, drawn_there.at(column, row));
    }
    check_same_coverage(&back, &drawn, || format!("moved by ({right}, {down}): {}", shape.code()));
    drawn.is_mixed().into()
}

#[test]
fn moves_by_whole_pixels_change_nothing() {
    let count = cases(8_000);
    let mixed = for_each_case(435, count, |rng| {
        let Shapes { window, triangle, line, circle, outline } = shapes(rng);
        let mut by = || rng.pick(&[0, 1, -7, 1000, -5000, 7000]);
        let by = (by(), by());
        let mixed = check_moved(&triangle, &window, by) + check_moved(&line, &window, by);
        Ok(mixed + check_moved(&circle, &window, by) + check_moved(&outline, &window, by))
    });
    assert!(mixed > count, "only {mixed} of {} showed an outline", 4 * count);
}

#[derive(Debug, Clone, Copy)]
enum Mirror {
    LeftRight,
    UpDown,
    Diagonal,
}

impl Mirror {
    fn vertex(self, Vertex { x, y }: Vertex) -> Vertex {
        match self {
            Self::LeftRight => Vertex { x: -x, y },
            Self::UpDown => Vertex { x, y: -y },
            Self::Diagonal => Vertex { x: y, y: x },
        }
    }

    fn pixel(self, (column, row): (i32, i32)) -> (i32, i32) {
        match self {
            Self::LeftRight => (-1 - column, row),
            Self::UpDown => (column, -1 - row),
            Self::Diagonal => (row, column),
        }
    }
}

fn check_mirrored(shape: &impl Moved) -> Result<(), String> {
    let window = rect(-10..10, -10..10);
    let drawn = coverage(shape, &window);
    for mirror in [Mirror::LeftRight, Mirror::UpDown, Mirror::Diagonal] {
        let mirrored = coverage(&shape.moved(&|vertex| mirror.vertex(vertex)), &window);
        check_close(&drawn, &mirrored, |pixel| mirror.pixel(pixel), || format!("{mirror:?} {}", shape.code()))?;
    }
    Ok(())
}

#[test]
fn mirrors_change_no_more_than_the_rounding() {
    for_each_case(436, cases(3_000), |rng| {
        let Shapes { triangle, line, outline, .. } = shapes(rng);
        check_mirrored(&triangle)?;
        check_mirrored(&line)?;
        check_mirrored(&outline)?;
        Ok(0)
    });
}

#[test]
fn mirrors_of_circles_change_no_more_than_the_rounding() {
    for_each_case(437, cases(3_000), |rng| {
        check_mirrored(&shapes(rng).circle)?;
        Ok(0)
    });
}

fn check_empty(shape: &(impl Cover + Belongs), window: &PixelRect) {
    assert!(coverage(shape, window).is_empty(), "{}\n{:?}", shape.code(), coverage(shape, window));
}

#[test]
fn degenerate_shapes_draw_nothing() {
    for_each_case(438, cases(4_000), |rng| {
        let (line, window) = random::line(rng);
        let (a, b) = (line.start, line.end);
        let ((x, y), share) = ((a.x.to_bits(), a.y.to_bits()), rng.int(-3..=3));
        // In line with a and b, unless that is out of range.
        let beyond = |a: i32, b: i32| i64::from(b) + share * (i64::from(b) - i64::from(a));
        let (cx, cy) = (beyond(x, b.x.to_bits()), beyond(y, b.y.to_bits()));
        let c = random::vertex(cx, cy);
        let is_in_line = i64::from(c.x.to_bits()) == cx && i64::from(c.y.to_bits()) == cy;
        let c = if is_in_line { c } else { b };
        check_empty(&Triangle::from_vertices([a, b, c]), &window);
        check_empty(&Triangle::from_vertices([a, a, b]), &window);
        check_empty(&Line::new(a, a), &window);
        check_empty(&Circle::from_bits(a, 0), &window);
        check_empty(&Circle::from_bits(a, -(rng.magnitude(31).abs() as i32).max(1)), &window);
        check_empty(&Circle::from_bits(a, i32::MIN), &window);
        let contours: [&[Vertex]; 7] = [&[], &[a], &[a, b], &[a, b, a], &[a, a, b], &[a, b, c], &[a, b, c, a, c, b]];
        for contour in contours {
            RULES.into_iter().for_each(|fill_rule| check_empty(&Outline::of(contour, fill_rule), &window));
        }
        // There and back.
        let (outline, window) = random::outline(rng);
        let mut contour = outline.contours[0].clone();
        contour.extend(outline.contours[0].iter().rev());
        RULES.into_iter().for_each(|fill_rule| check_empty(&Outline::of(&contour, fill_rule), &window));
        let back: Vec<Vertex> = outline.contours[0].iter().rev().copied().collect();
        let both = vec![back, outline.contours[0].clone()];
        RULES.into_iter().for_each(|fill_rule| check_empty(&Outline::new(both.clone(), fill_rule), &window));
        Ok(0)
    });
}

/// All pixels that are covered lie in the rectangle. One if the window shows all of it.
fn check_touched(shape: &(impl Cover + Belongs), window: &PixelRect) -> u64 {
    let PixelRect { rows, columns } = shape.touched();
    for (column, row) in coverage(shape, window).covered() {
        let is_in = columns.contains(&column) && rows.contains(&row);
        assert!(is_in, "({column}, {row}) is in neither of {columns:?}, {rows:?}: {}", shape.code());
    }
    let is_within =
        |part: &Range<i32>, all: &Range<i32>| !part.is_empty() && all.start <= part.start && part.end <= all.end;
    u64::from(is_within(&rows, &window.rows) && is_within(&columns, &window.columns))
}

#[test]
fn touched_pixels_are_all_there_are() {
    let count = cases(10_000);
    let whole = for_each_case(439, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        let whole = check_touched(&triangle, &window);
        let (outline, window) = random::outline(rng);
        let whole = whole + check_touched(&outline, &window);
        let (line, window) = random::line(rng);
        let whole = whole + check_touched(&line, &window);
        let (circle, window) = random::circle(rng);
        Ok(whole + check_touched(&circle, &window))
    });
    assert!(whole * 8 > count, "only {whole} of {} were all to be seen", 4 * count);
}

/// The ends of the range, and the middle.
const ENDS: [i32; 7] = [i32::MIN, i32::MIN + 1, i32::MIN + 300, 0, i32::MAX - 300, i32::MAX - 1, i32::MAX];

/// Two pixels at each end of those that have coordinates, with one beyond, and around the origin.
fn windows_at_the_ends() -> Vec<PixelRect> {
    let ranges = [-8_388_609..-8_388_606, -1..2, 8_388_606..8_388_609];
    ranges.iter().flat_map(|rows| ranges.iter().map(|columns| rect(columns.clone(), rows.clone()))).collect()
}

/// Where no shape can be: the ends of what a clip can be.
fn windows_beyond() -> Vec<PixelRect> {
    let ranges = [i32::MIN..i32::MIN + 2, -1..2, i32::MAX - 2..i32::MAX];
    let windows = ranges.iter().flat_map(|rows| ranges.iter().map(|columns| rect(columns.clone(), rows.clone())));
    windows.filter(|window| *window != rect(-1..2, -1..2)).collect()
}

fn check_at_the_ends(shape: &(impl Cover + HasArea + Belongs), tolerance: Tolerance) -> Result<(), String> {
    for window in windows_at_the_ends() {
        check_coverage(shape, &window, tolerance, &Worst::new())?;
    }
    for window in windows_beyond() {
        check_empty(shape, &window);
    }
    Ok(())
}

fn at_an_end(rng: &mut Rng) -> Vertex {
    Vertex::from_bits(rng.pick(&ENDS), rng.pick(&ENDS))
}

#[test]
fn triangles_and_polygons_at_the_ends_of_the_range() {
    for_each_case(440, cases(3_000), |rng| {
        let vertices = [at_an_end(rng), at_an_end(rng), at_an_end(rng)];
        check_at_the_ends(&Triangle::from_vertices(vertices), Tolerance::EXACT)?;
        let contour: Vec<Vertex> = (0..rng.int(3..=6)).map(|_| at_an_end(rng)).collect();
        check_at_the_ends(&Outline::of(&contour, random::fill_rule(rng)), Tolerance::EXACT)?;
        Ok(0)
    });
}

#[test]
fn lines_at_the_ends_of_the_range() {
    for_each_case(441, cases(2_401), |rng| {
        check_at_the_ends(&Line::new(at_an_end(rng), at_an_end(rng)), Tolerance::EXACT)?;
        Ok(0)
    });
}

#[test]
fn circles_at_the_ends_of_the_range() {
    for_each_case(442, cases(1_000), |rng| {
        let radius = rng.pick(&[1, 300, i32::MAX / 2, i32::MAX - 1, i32::MAX]);
        check_at_the_ends(&Circle::from_bits(at_an_end(rng), radius), Tolerance { few: 0.6, many: 0.6 })?;
        Ok(0)
    });
}

/// Clips that hold nothing, some of them the wrong way around.
#[test]
fn empty_clips_get_nothing() {
    for_each_case(443, cases(1_000), |rng| {
        let Shapes { triangle, line, circle, outline, .. } = shapes(rng);
        let empty = [(0, 0), (5, 5), (3, -3), (i32::MAX, i32::MIN), (i32::MAX, i32::MAX), (i32::MIN, i32::MIN)];
        let empty = empty.map(|(start, end)| start..end);
        let (empty, other) = (empty[rng.index(empty.len())].clone(), rng.pick(&[-4, 1, i32::MIN])..rng.pick(&[2, 9]));
        for clip in [rect(empty.clone(), other.clone()), rect(other.clone(), empty.clone()), rect(empty.clone(), empty)]
        {
            check_empty(&triangle, &clip);
            check_empty(&line, &clip);
            check_empty(&circle, &clip);
            check_empty(&outline, &clip);
        }
        Ok(0)
    });
}
