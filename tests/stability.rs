//! What must not change the pixels: the order of the vertices, the direction of an outline, a move by whole pixels, a
//! clip that is larger than the shape; and what must change them only as a mirror does.

mod oracle;

use oracle::{
    Belongs, Grid, Outline, Rng, block_pixels, cases, check_same, for_each_case,
    grid::{block_pixels_within, span_pixels_within},
    random::{self, HIGHEST, LOWEST},
    rect,
    rule::{At, centre, cross, edges},
    span_pixels,
};
use spanfill::{Circle, FillRule, Line, PixelRect, Shape, Triangle, Vertex};

const EVERY_ROW_AND_COLUMN: PixelRect = PixelRect { rows: i32::MIN..i32::MAX, columns: i32::MIN..i32::MAX };

#[test]
fn triangles_do_not_depend_on_the_order_of_their_vertices() {
    let mixed = for_each_case(30, cases(300_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let [a, b, c] = triangle.vertices;
        let pixels = span_pixels(&triangle, &window);
        for order in [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            check_same(&span_pixels(&Triangle::from_vertices(order), &window), &pixels, || triangle.code());
        }
        Ok(pixels.is_mixed().into())
    });
    assert!(mixed > 0);
}

#[test]
fn three_vertices_are_a_triangle_under_both_fill_rules() {
    let mixed = for_each_case(31, cases(300_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let pixels = span_pixels(&triangle, &window);
        for fill_rule in [FillRule::NonZero, FillRule::EvenOdd] {
            let polygon = Outline::of(&triangle.vertices, fill_rule);
            check_same(&span_pixels(&polygon, &window), &pixels, || polygon.code());
        }
        Ok(pixels.is_mixed().into())
    });
    assert!(mixed > 0);
}

#[test]
fn polygons_do_not_depend_on_where_a_contour_starts_nor_which_way_it_goes() {
    let mixed = for_each_case(32, cases(100_000), |rng| {
        let (outline, window) = random::outline(rng);
        let pixels = span_pixels(&outline, &window);
        let mut turned = outline.clone();
        for contour in &mut turned.contours {
            if !contour.is_empty() {
                let start = rng.index(contour.len());
                contour.rotate_left(start);
            }
            if outline.fill_rule == FillRule::EvenOdd && rng.one_in(2) {
                contour.reverse();
            }
        }
        // Non-zero depends on how the contours go around each other, not on how all of them go around.
        if outline.fill_rule == FillRule::NonZero && rng.one_in(2) {
            turned.contours.iter_mut().for_each(|contour| contour.reverse());
        }
        rng.shuffle(&mut turned.contours);
        check_same(&span_pixels(&turned, &window), &pixels, || format!("{} and {}", turned.code(), outline.code()));
        Ok(pixels.is_mixed().into())
    });
    assert!(mixed > 0);
}

#[test]
fn vertices_given_twice_or_on_an_edge_change_nothing() {
    let mixed = for_each_case(33, cases(100_000), |rng| {
        let (outline, window) = random::outline(rng);
        let pixels = span_pixels(&outline, &window);
        let mut more = outline.clone();
        for contour in more.contours.iter_mut().filter(|contour| !contour.is_empty()) {
            let index = rng.index(contour.len());
            let vertex = contour[index];
            contour.insert(index, vertex);
            // There and back again: a spike without area.
            let spike = rng.index(contour.len());
            let (vertex, far) = (contour[spike], contour[rng.index(contour.len())]);
            contour.splice(spike..spike, [vertex, far]);
        }
        check_same(&span_pixels(&more, &window), &pixels, || format!("{} and {}", more.code(), outline.code()));
        Ok(pixels.is_mixed().into())
    });
    assert!(mixed > 0);
}

#[test]
fn lines_are_the_same_in_both_directions() {
    let mixed = for_each_case(34, cases(300_000), |rng| {
        let (line, window) = random::line(rng);
        let pixels = span_pixels(&line, &window);
        let back = Line::new(line.end, line.start);
        check_same(&span_pixels(&back, &window), &pixels, || line.code());
        Ok(pixels.is_mixed().into())
    });
    assert!(mixed > 0);
}

/// The whole pixels by which `vertices` can be moved and stay within the range, as far as possible one time in three.
fn whole_pixel_move(rng: &mut Rng, vertices: &[Vertex]) -> (i64, i64) {
    let mut along = |coordinate: fn(&Vertex) -> i32| {
        let bits = || vertices.iter().map(coordinate).map(i64::from);
        let (back, forth) = (LOWEST - bits().min().unwrap_or(0), HIGHEST - bits().max().unwrap_or(0));
        // Towards 0 on both sides: what is left is a part of a pixel.
        let (back, forth) = (back / 256, forth / 256);
        if rng.one_in(3) { rng.pick(&[back, forth]) } else { rng.int(back..=forth) }
    };
    (along(|vertex| vertex.x.to_bits()), along(|vertex| vertex.y.to_bits()))
}

fn moved(vertex: Vertex, (columns, rows): (i64, i64)) -> Vertex {
    let bits = |bits: i32, pixels: i64| i32::try_from(i64::from(bits) + 256 * pixels).unwrap();
    Vertex::from_bits(bits(vertex.x.to_bits(), columns), bits(vertex.y.to_bits(), rows))
}

fn moved_window(window: &PixelRect, (columns, rows): (i64, i64)) -> PixelRect {
    let range = |range: &std::ops::Range<i32>, by: i64| {
        let [start, end] = [range.start, range.end].map(|pixel| i32::try_from(i64::from(pixel) + by).unwrap());
        start..end
    };
    rect(range(&window.columns, columns), range(&window.rows, rows))
}

/// Draws a shape and the same shape moved; the pictures must be the same.
fn check_moved<S: Shape + Belongs>(shape: &S, there: &S, window: &PixelRect, by: (i64, i64)) -> u64 {
    let here = span_pixels(shape, window);
    let there_pixels = span_pixels(there, &moved_window(window, by));
    assert_eq!(here.to_string(), there_pixels.to_string(), "{} and {}", shape.code(), there.code());
    here.is_mixed().into()
}

#[test]
fn a_move_by_whole_pixels_moves_the_pixels() {
    let mixed = for_each_case(35, cases(200_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let by = whole_pixel_move(rng, &triangle.vertices);
        let there = Triangle::from_vertices(triangle.vertices.map(|vertex| moved(vertex, by)));
        let mut mixed = check_moved(&triangle, &there, &window, by);

        let (line, window) = random::line(rng);
        let by = whole_pixel_move(rng, &[line.start, line.end]);
        mixed += check_moved(&line, &Line::new(moved(line.start, by), moved(line.end, by)), &window, by);

        let (circle, window) = random::circle(rng);
        let by = whole_pixel_move(rng, &[circle.center]);
        let there = Circle::from_bits(moved(circle.center, by), circle.radius.to_bits());
        mixed += check_moved(&circle, &there, &window, by);

        let (outline, window) = random::outline(rng);
        let by = whole_pixel_move(rng, &outline.contours.concat());
        let mut there = outline.clone();
        there.contours.iter_mut().flatten().for_each(|vertex| *vertex = moved(*vertex, by));
        mixed += check_moved(&outline, &there, &window, by);
        Ok(mixed)
    });
    assert!(mixed > 0);
}

/// The mirrors of the sub-pixel plane that keep the centres of pixels: left and right, up and down, across the diagonal.
#[derive(Debug, Clone, Copy)]
enum Mirror {
    LeftRight,
    UpDown,
    Diagonal,
}

const MIRRORS: [Mirror; 3] = [Mirror::LeftRight, Mirror::UpDown, Mirror::Diagonal];

impl Mirror {
    /// `i32::MIN` has no mirror image and is moved by a sub-pixel first, on both sides of the comparison.
    fn vertex(self, vertex: Vertex) -> Vertex {
        let (x, y) = (vertex.x.to_bits(), vertex.y.to_bits());
        match self {
            Self::LeftRight => Vertex::from_bits(-x, y),
            Self::UpDown => Vertex::from_bits(x, -y),
            Self::Diagonal => Vertex::from_bits(y, x),
        }
    }

    fn pixel(self, column: i32, row: i32) -> (i32, i32) {
        match self {
            Self::LeftRight => (-1 - column, row),
            Self::UpDown => (column, -1 - row),
            Self::Diagonal => (row, column),
        }
    }

    fn window(self, window: &PixelRect) -> PixelRect {
        let PixelRect { rows, columns } = window.clone();
        match self {
            Self::LeftRight => rect(-columns.end..-columns.start, rows),
            Self::UpDown => rect(columns, -rows.end..-rows.start),
            Self::Diagonal => rect(rows, columns),
        }
    }
}

fn off_the_lower_end(vertex: Vertex) -> Vertex {
    Vertex::from_bits(vertex.x.to_bits().max(-i32::MAX), vertex.y.to_bits().max(-i32::MAX))
}

/// Compares a shape with its mirror image, except for the pixels that `skip` names.
fn check_mirrored<S: Shape + Belongs>(
    shape: &S,
    image: &S,
    mirror: Mirror,
    window: &PixelRect,
    skip: impl Fn(i32, i32) -> bool,
) -> u64 {
    let pixels = span_pixels(shape, window);
    let image_pixels = span_pixels(image, &mirror.window(window));
    for row in window.rows.clone() {
        for column in window.columns.clone() {
            let (image_column, image_row) = mirror.pixel(column, row);
            assert!(
                pixels.count(column, row) == image_pixels.count(image_column, image_row) || skip(column, row),
                "{mirror:?}: {} and {} at ({column}, {row})",
                shape.code(),
                image.code()
            );
        }
    }
    pixels.is_mixed().into()
}

#[test]
fn mirror_images_differ_only_where_a_centre_lies_on_the_outline() {
    let mixed = for_each_case(36, cases(100_000), |rng| {
        let (mut outline, window) = random::outline(rng);
        outline.contours.iter_mut().flatten().for_each(|vertex| *vertex = off_the_lower_end(*vertex));
        let on_outline = |column, row| {
            let p = centre(column, row);
            let on_edge = |(a, b): (At, At)| cross(a, b, p) == 0;
            outline.contours.iter().flat_map(|contour| edges(contour)).any(on_edge)
        };
        let mut mixed = 0;
        for mirror in MIRRORS {
            let mut image = outline.clone();
            image.contours.iter_mut().flatten().for_each(|vertex| *vertex = mirror.vertex(*vertex));
            mixed += check_mirrored(&outline, &image, mirror, &window, on_outline);
        }

        let (triangle, window) = random::triangle(rng);
        let triangle = Triangle::from_vertices(triangle.vertices.map(off_the_lower_end));
        let on_outline = |column, row| {
            let p = centre(column, row);
            edges(&triangle.vertices).any(|(a, b)| cross(a, b, p) == 0)
        };
        for mirror in MIRRORS {
            let image = Triangle::from_vertices(triangle.vertices.map(|vertex| mirror.vertex(vertex)));
            mixed += check_mirrored(&triangle, &image, mirror, &window, on_outline);
        }
        Ok(mixed)
    });
    assert!(mixed > 0);
}

#[test]
fn circles_are_their_own_mirror_images_and_lines_are_on_the_diagonal() {
    let mixed = for_each_case(37, cases(300_000), |rng| {
        let (circle, window) = random::circle(rng);
        let center = off_the_lower_end(circle.center);
        let radius = circle.radius.to_bits();
        let circle = Circle::from_bits(center, radius);
        let mut mixed = 0;
        for mirror in MIRRORS {
            let image = Circle::from_bits(mirror.vertex(center), radius);
            mixed += check_mirrored(&circle, &image, mirror, &window, |_, _| false);
        }

        let (line, window) = random::line(rng);
        let image = Line::new(Mirror::Diagonal.vertex(line.start), Mirror::Diagonal.vertex(line.end));
        let (run, rise) = (line.end.x.abs_diff(line.start.x), line.end.y.abs_diff(line.start.y));
        // At exactly 45 degrees both are stepped by columns: another set of ends.
        if run != rise {
            mixed += check_mirrored(&line, &image, Mirror::Diagonal, &window, |_, _| false);
        }
        Ok(mixed)
    });
    assert!(mixed > 0);
}

/// `bounds` must hold every pixel of the window, and what they leave out must not be missed.
fn check_bounds<S: Shape + Belongs>(shape: &S, window: &PixelRect) -> u64 {
    let bounds = shape.bounds();
    let pixels = Grid::of_rule(shape, window);
    for row in window.rows.clone() {
        for column in window.columns.clone() {
            assert!(
                pixels.count(column, row) == 0 || bounds.rows.contains(&row) && bounds.columns.contains(&column),
                "({column}, {row}) is outside {bounds:?}: {}",
                shape.code()
            );
        }
    }
    pixels.is_mixed().into()
}

/// `bounds` may be larger than the shape, but not by more than a pixel on each side of what holds its vertices.
fn check_bounds_are_close(bounds: &PixelRect, vertices: &[Vertex], reach: i32) {
    let held = |coordinate: fn(&Vertex) -> i32| {
        let pixels = || vertices.iter().map(coordinate).map(|bits| bits >> 8);
        pixels().min().unwrap() - reach - 1..pixels().max().unwrap() + reach + 2
    };
    let (columns, rows) = (held(|vertex| vertex.x.to_bits()), held(|vertex| vertex.y.to_bits()));
    let within = |inner: &std::ops::Range<i32>, outer: &std::ops::Range<i32>| {
        inner.is_empty() || outer.start <= inner.start && inner.end <= outer.end
    };
    let close = within(&bounds.columns, &columns) && within(&bounds.rows, &rows);
    assert!(close, "{bounds:?}, the vertices need {rows:?} x {columns:?}");
}

#[test]
fn bounds_are_close_around_the_vertices() {
    for_each_case(41, cases(200_000), |rng| {
        let (triangle, _) = random::triangle(rng);
        check_bounds_are_close(&triangle.bounds(), &triangle.vertices, 0);
        let (line, _) = random::line(rng);
        check_bounds_are_close(&line.bounds(), &[line.start, line.end], 0);
        let (circle, _) = random::circle(rng);
        check_bounds_are_close(&circle.bounds(), &[circle.center], (circle.radius.to_bits().max(0) >> 8) + 1);
        let (outline, _) = random::outline(rng);
        let vertices = outline.contours.concat();
        if !vertices.is_empty() {
            check_bounds_are_close(&outline.bounds(), &vertices, 0);
        }
        Ok(0)
    });
}

#[test]
fn bounds_hold_every_pixel() {
    let mixed = for_each_case(38, cases(200_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let mut mixed = check_bounds(&triangle, &window);
        let (line, window) = random::line(rng);
        mixed += check_bounds(&line, &window);
        let (circle, window) = random::circle(rng);
        mixed += check_bounds(&circle, &window);
        let (outline, window) = random::outline(rng);
        mixed += check_bounds(&outline, &window);
        Ok(mixed)
    });
    assert!(mixed > 0);
}

/// A window with a margin around vertices, if it is not too large to count in.
fn window_around(vertices: &[Vertex], reach: i32) -> Option<PixelRect> {
    let range = |coordinate: fn(&Vertex) -> i32| {
        let pixels = || vertices.iter().map(coordinate).map(|bits| bits >> 8);
        Some(pixels().min()? - reach - 2..pixels().max()? + reach + 3)
    };
    let window = rect(range(|vertex| vertex.x.to_bits())?, range(|vertex| vertex.y.to_bits())?);
    (window.columns.len() < 64 && window.rows.len() < 64).then_some(window)
}

/// With every pixel there is for a clip, a shape sends its own and no others.
fn check_without_clip<S: Shape + Belongs>(shape: &S, window: Option<PixelRect>) -> u64 {
    let Some(window) = window else { return 0 };
    let pixels = Grid::of_rule(shape, &window);
    check_same(&span_pixels_within(shape, &EVERY_ROW_AND_COLUMN, &window), &pixels, || shape.code());
    check_same(&block_pixels_within(shape, &EVERY_ROW_AND_COLUMN, &window), &pixels, || shape.code());
    u64::from(pixels.covered() > 0)
}

#[test]
fn a_clip_of_every_pixel_there_is_clips_nothing() {
    let count = cases(200_000);
    let compared = for_each_case(39, count, |rng| {
        let (triangle, _) = random::triangle(rng);
        let mut compared = check_without_clip(&triangle, window_around(&triangle.vertices, 0));
        let (line, _) = random::line(rng);
        compared += check_without_clip(&line, window_around(&[line.start, line.end], 1));
        let (circle, _) = random::circle(rng);
        let reach = circle.radius.to_bits().max(0) >> 8;
        if reach < 24 {
            compared += check_without_clip(&circle, window_around(&[circle.center], reach));
        }
        let (outline, _) = random::outline(rng);
        compared += check_without_clip(&outline, window_around(&outline.contours.concat(), 0));
        Ok(compared)
    });
    assert!(compared * 4 > count, "only {compared} of {count}");
}

#[test]
fn an_empty_clip_takes_nothing() {
    // From and to: a range that ends where it starts is as empty as one that ends before.
    let ends = [(0, 0), (3, 3), (9, 0), (i32::MAX, i32::MIN), (i32::MIN, i32::MIN), (i32::MAX, i32::MAX)];
    let nowhere = ends.iter().flat_map(|(from, to)| [rect(*from..*to, 0..9), rect(0..9, *from..*to)]);
    let square = [Vertex::pixel(0, 0), Vertex::pixel(8, 0), Vertex::pixel(8, 8), Vertex::pixel(0, 8)];
    let window = rect(0..9, 0..9);
    for clip in nowhere {
        let triangle = Triangle::new(square[0], square[1], square[2]);
        let line = Line::new(square[0], square[2]);
        let circle = Circle::from_bits(square[0], 2000);
        let outline = Outline::of(&square, FillRule::NonZero);
        for pixels in [
            span_pixels_within(&triangle, &clip, &window),
            block_pixels_within(&triangle, &clip, &window),
            span_pixels_within(&line, &clip, &window),
            block_pixels_within(&line, &clip, &window),
            span_pixels_within(&circle, &clip, &window),
            block_pixels_within(&circle, &clip, &window),
            span_pixels_within(&outline, &clip, &window),
            block_pixels_within(&outline, &clip, &window),
        ] {
            assert_eq!(pixels.covered(), 0, "{clip:?}");
        }
    }
}

/// A mask that is wider and taller than any of the numbers the crate could be tempted to use for a length.
#[test]
fn a_triangle_over_the_whole_range_sends_every_row() {
    struct Rows {
        triangle: Triangle,
        next: i32,
        sampled: u64,
    }

    impl spanfill::SpanSink for Rows {
        type Error = std::convert::Infallible;

        fn span(&mut self, span: spanfill::Span) -> Result<(), Self::Error> {
            assert_eq!(span.row, self.next);
            self.next += 1;
            if span.row.rem_euclid(101) == 0 || span.row < -8_388_000 || span.row > 8_388_000 {
                let has = |column| self.triangle.has(column, span.row);
                let (first, end) = (span.columns.start, span.columns.end);
                assert!(has(first) && has(end - 1) && !has(first - 1) && !has(end), "{span:?}");
                self.sampled += 1;
            }
            Ok(())
        }
    }

    // Its left edge goes from one corner of the range to the opposite one, the right edge down the last sub-pixel.
    let (low, high) = (i32::MIN, i32::MAX);
    let corners = [Vertex::from_bits(low, low), Vertex::from_bits(high, low), Vertex::from_bits(high, high)];
    let triangle = Triangle::from_vertices(corners);
    let mut rows = Rows { triangle, next: -(1 << 23), sampled: 0 };
    let Ok(()) = triangle.spans(&EVERY_ROW_AND_COLUMN, &mut rows);
    assert_eq!(rows.next, 1 << 23, "the last row");
    assert!(rows.sampled > 166_000);
}

#[test]
fn drawing_again_draws_the_same() {
    let mixed = for_each_case(40, cases(50_000), |rng| {
        let (outline, window) = random::outline(rng);
        let (other, other_window) = random::outline(rng);
        let expected = span_pixels(&outline, &window);
        outline.with_polygon(|polygon| {
            other.with_polygon(|other_polygon| {
                let needed = polygon.active_edges().max(other_polygon.active_edges());
                let mut scratch = vec![spanfill::ActiveEdge::EMPTY; needed + rng.index(3)];
                // What another outline left in the scratch does not matter, nor does what this one did.
                span_pixels(&other_polygon.in_scratch(&mut scratch).unwrap(), &other_window);
                let in_scratch = polygon.in_scratch(&mut scratch).unwrap();
                for _ in 0..2 {
                    check_same(&span_pixels(&in_scratch, &window), &expected, || outline.code());
                    check_same(&block_pixels(&in_scratch, &window), &expected, || outline.code());
                }
            });
        });
        Ok(expected.is_mixed().into())
    });
    assert!(mixed > 0);
}
