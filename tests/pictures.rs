//! The rule for pixels, in pictures drawn by hand: the oracle of the other tests must agree with them, and so must
//! the crate.

mod oracle;

use oracle::{Belongs, Grid, Outline, block_pixels, rect, span_pixels};
use spanfill::{Circle, FillRule, Line, Shape, Triangle, Vertex};

/// A vertex in quarter pixels: small whole numbers, centres at 2, 6, 10, 14.
fn quarters(x: i32, y: i32) -> Vertex {
    Vertex::from_bits(64 * x, 64 * y)
}

/// Holds the rule, the spans and the blocks against a picture whose top-left pixel is (0, 0).
fn assert_picture(shape: &(impl Shape + Belongs), picture: &[&str]) {
    let window = rect(0..picture[0].len() as i32, 0..picture.len() as i32);
    let picture = picture.join("\n") + "\n";
    assert_eq!(Grid::of_rule(shape, &window).to_string(), picture, "the rule, {}", shape.code());
    assert_eq!(span_pixels(shape, &window).to_string(), picture, "spans, {}", shape.code());
    assert_eq!(block_pixels(shape, &window).to_string(), picture, "blocks, {}", shape.code());
}

#[test]
fn a_triangle_covers_the_centres_inside() {
    // The long side leaves row 0 at column 3.5 and moves left by one column a row: x + y = 4, through the centres.
    let triangle = Triangle::new(quarters(0, 0), quarters(16, 0), quarters(0, 16));
    assert_picture(&triangle, &["###..", "##...", "#....", ".....", "....."]);
    // A sub-pixel further out, they are inside.
    let triangle = Triangle::new(quarters(0, 0), Vertex::from_bits(1025, 0), Vertex::from_bits(0, 1025));
    assert_picture(&triangle, &["####.", "###..", "##...", "#....", "....."]);
}

#[test]
fn centres_on_left_and_top_edges_belong_and_on_right_and_bottom_edges_do_not() {
    // A rectangle from centre (0, 0) to centre (3, 2), as two triangles and as a polygon.
    let (a, b, c, d) = (Vertex::pixel(0, 0), Vertex::pixel(3, 0), Vertex::pixel(3, 2), Vertex::pixel(0, 2));
    assert_picture(&Outline::of(&[a, b, c, d], FillRule::NonZero), &["###.", "###.", "....", "...."]);
    // The diagonal crosses row 1 half way between two centres.
    assert_picture(&Triangle::new(a, b, c), &["###.", "..#.", "....", "...."]);
    assert_picture(&Triangle::new(a, c, d), &["....", "##..", "....", "...."]);
}

#[test]
fn a_diagonal_through_centres_gives_them_to_the_side_on_its_right() {
    // The step (+e, +e^2) from a centre on the diagonal y = x leads above the diagonal.
    let (a, b, c, d) = (Vertex::pixel(0, 0), Vertex::pixel(3, 0), Vertex::pixel(3, 3), Vertex::pixel(0, 3));
    assert_picture(&Triangle::new(a, b, c), &["###.", ".##.", "..#.", "...."]);
    assert_picture(&Triangle::new(a, c, d), &["....", "#...", "##..", "...."]);
    // On the other diagonal, y = 3 - x, it leads below.
    assert_picture(&Triangle::new(a, b, d), &["###.", "##..", "#...", "...."]);
    assert_picture(&Triangle::new(b, c, d), &["....", "..#.", ".##.", "...."]);
}

#[test]
fn a_triangle_without_area_covers_nothing() {
    let nothing = ["....", "....", "....", "...."];
    let (a, b) = (Vertex::pixel(0, 0), Vertex::pixel(3, 3));
    assert_picture(&Triangle::new(a, b, Vertex::pixel(1, 1)), &nothing);
    assert_picture(&Triangle::new(a, b, b), &nothing);
    assert_picture(&Triangle::new(b, b, b), &nothing);
    assert_picture(&Triangle::new(a, Vertex::pixel(3, 0), Vertex::pixel(1, 0)), &nothing);
}

#[test]
fn a_circle_covers_the_centres_nearer_than_its_radius() {
    let center = Vertex::pixel(2, 2);
    let small = [".....", ".###.", ".###.", ".###.", "....."];
    // (2, 0) is exactly two pixels from the centre: outside, until the radius grows by a sub-pixel.
    assert_picture(&Circle::from_bits(center, 512), &small);
    assert_picture(&Circle::from_bits(center, 513), &["..#..", ".###.", "#####", ".###.", "..#.."]);
    // Around a corner of pixels: the nearest centres are 181.02 sub-pixels away.
    let corner = Vertex::from_bits(512, 512);
    assert_picture(&Circle::from_bits(corner, 181), &["....", "....", "....", "...."]);
    assert_picture(&Circle::from_bits(corner, 182), &["....", ".##.", ".##.", "...."]);
}

#[test]
fn a_circle_of_no_radius_or_less_covers_nothing() {
    for radius in [0, -1, -512, i32::MIN] {
        assert_picture(&Circle::from_bits(Vertex::pixel(1, 1), radius), &["...", "...", "..."]);
    }
    assert_picture(&Circle::from_bits(Vertex::pixel(1, 1), 1), &["...", ".#.", "..."]);
}

/// A line's picture, in both directions, and transposed with the line.
fn assert_line(start: Vertex, end: Vertex, picture: &[&str]) {
    assert_picture(&Line::new(start, end), picture);
    assert_picture(&Line::new(end, start), picture);
    let transposed: Vec<String> = (0..picture[0].len())
        .map(|column| picture.iter().map(|row| char::from(row.as_bytes()[column])).collect())
        .collect();
    let transposed: Vec<&str> = transposed.iter().map(String::as_str).collect();
    let swap = |vertex: Vertex| Vertex { x: vertex.y, y: vertex.x };
    // On the diagonal both lines are x-major, and their pictures are not each other's transposes where they tie.
    let (run, rise) = (end.x.abs_diff(start.x), end.y.abs_diff(start.y));
    assert_ne!(run, rise, "has no transpose");
    assert_picture(&Line::new(swap(start), swap(end)), &transposed);
    assert_picture(&Line::new(swap(end), swap(start)), &transposed);
}

#[test]
fn a_line_between_centres_takes_the_nearest_pixel_of_each_column_and_the_lower_of_two() {
    assert_line(Vertex::pixel(0, 0), Vertex::pixel(4, 2), &["#....", ".##..", "...##"]);
    assert_line(Vertex::pixel(0, 2), Vertex::pixel(4, 0), &["....#", "..##.", "##..."]);
    assert_line(Vertex::pixel(0, 1), Vertex::pixel(6, 2), &[".......", "###....", "...####"]);
    assert_line(Vertex::pixel(1, 1), Vertex::pixel(3, 1), &[".....", ".###.", "....."]);
}

#[test]
fn a_line_starts_and_ends_in_the_columns_that_hold_its_ends() {
    let y = 384;
    assert_line(Vertex::from_bits(255, y), Vertex::from_bits(1023, y), &[".....", "####.", "....."]);
    assert_line(Vertex::from_bits(256, y), Vertex::from_bits(1024, y), &[".....", ".####", "....."]);
}

#[test]
fn a_line_within_a_pixel_is_that_pixel() {
    assert_picture(&Line::new(Vertex::from_bits(256, 511), Vertex::from_bits(256, 511)), &["...", ".#.", "..."]);
    assert_line(Vertex::from_bits(300, 500), Vertex::from_bits(500, 490), &["...", ".#.", "..."]);
}

#[test]
fn a_diagonal_line_is_stepped_by_columns() {
    let diagonal = Line::new(Vertex::pixel(0, 0), Vertex::pixel(3, 3));
    assert_picture(&diagonal, &["#...", ".#..", "..#.", "...#"]);
    // The centre of column 0 lies before the start: the line is continued to it, into the row above.
    let short = Line::new(Vertex::from_bits(230, 282), Vertex::from_bits(282, 334));
    assert_picture(&short, &["#...", ".#..", "....", "...."]);
}

/// A square in whole pixels, clockwise as one looks at the screen.
fn square(from: i32, to: i32) -> Vec<Vertex> {
    let (from, to) = (4 * from, 4 * to);
    vec![quarters(from, from), quarters(to, from), quarters(to, to), quarters(from, to)]
}

#[test]
fn overlapping_contours_unite_or_cancel_by_the_fill_rule() {
    let union = ["###..", "####.", "####.", ".###.", "....."];
    let difference = ["###..", "#..#.", "#..#.", ".###.", "....."];
    let same_way = vec![square(0, 3), square(1, 4)];
    assert_picture(&Outline::new(same_way.clone(), FillRule::NonZero), &union);
    assert_picture(&Outline::new(same_way, FillRule::EvenOdd), &difference);
    let reversed = square(1, 4).into_iter().rev().collect();
    let against_each_other = vec![square(0, 3), reversed];
    assert_picture(&Outline::new(against_each_other.clone(), FillRule::NonZero), &difference);
    assert_picture(&Outline::new(against_each_other, FillRule::EvenOdd), &difference);
}

#[test]
fn a_contour_that_crosses_itself_fills_both_of_its_parts() {
    // An hourglass on its side; both of its diagonals run through centres and give them to what is on their right.
    let bow_tie = [quarters(0, 0), quarters(16, 16), quarters(16, 0), quarters(0, 16)];
    for fill_rule in [FillRule::NonZero, FillRule::EvenOdd] {
        assert_picture(&Outline::of(&bow_tie, fill_rule), &["...#.", "#.##.", "#.##.", "...#.", "....."]);
    }
}

#[test]
fn contours_of_two_vertices_or_less_cover_nothing() {
    let nothing = ["...", "...", "..."];
    let contours = vec![vec![], vec![quarters(1, 1)], vec![quarters(0, 0), quarters(12, 12)]];
    assert_picture(&Outline::new(contours, FillRule::NonZero), &nothing);
    assert_picture(&Outline::new(vec![], FillRule::EvenOdd), &nothing);
}

#[test]
fn horizontal_edges_and_notches_follow_the_same_rule() {
    // A comb: teeth up, its back on row 3; the inner horizontal edges run through the centres of row 1.
    let comb = [(0, 0), (4, 0), (4, 6), (8, 6), (8, 0), (12, 0), (12, 6), (16, 6), (16, 0), (20, 0), (20, 16), (0, 16)];
    let comb: Vec<Vertex> = comb.into_iter().map(|(x, y)| quarters(x, y)).collect();
    let picture = ["#.#.#.", "#####.", "#####.", "#####.", "......"];
    assert_picture(&Outline::of(&comb, FillRule::NonZero), &picture);
    assert_picture(&Outline::of(&comb, FillRule::EvenOdd), &picture);
}

#[test]
fn the_oracle_finds_the_same_winding_along_two_rays() {
    let both = |contours: &[Vec<Vertex>], column, row| {
        let p = oracle::rule::centre(column, row);
        (oracle::rule::winding(contours, p), oracle::rule::winding_by_vertical_ray(contours, p))
    };
    let wound = oracle::for_each_case(1, oracle::cases(20_000), |rng| {
        let (outline, window) = oracle::random::outline(rng);
        let mut wound = 0;
        for row in window.rows {
            for column in window.columns.clone() {
                let (across, down) = both(&outline.contours, column, row);
                if across != down {
                    return Err(format!("{} at ({column}, {row}): {across} and {down}", outline.code()));
                }
                wound += u64::from(across != 0);
            }
        }
        Ok(wound)
    });
    assert!(wound > 0, "no pixel was inside");
}

#[test]
fn the_oracle_finds_a_triangle_where_it_finds_its_contour() {
    let mixed = oracle::for_each_case(2, oracle::cases(50_000), |rng| {
        let (triangle, window) = oracle::random::triangle(rng);
        let outline = Outline::of(&triangle.vertices, FillRule::NonZero);
        let grid = Grid::of_rule(&triangle, &window);
        if grid == Grid::of_rule(&outline, &window) { Ok(grid.is_mixed().into()) } else { Err(triangle.code()) }
    });
    assert!(mixed > 0, "no window showed an outline");
}
