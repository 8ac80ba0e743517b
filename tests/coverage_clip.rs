//! Coverage in pieces: any split of a clip into bands, columns and tiles gives the whole, bit for bit, and so does any
//! amount of scratch; too little is an error that says how much there has to be.

mod oracle;

use std::ops::Range;

use embedded_graphics::{Drawable as _, mock_display::MockDisplay, pixelcolor::Gray8, prelude::GrayColor as _};
use oracle::{
    Belongs, CoverageGrid, Outline, Rng, cases, check_same_coverage, coverage, coverage_within, for_each_case, random,
    rect,
    rule::{At, edges},
};
use spanfill::{
    AntiAlias as _, Circle, Cover, CoverageEdge, CoverageSink, Line, Over, PixelRect, Polygon, Span, TooLittleScratch,
    TooManyEdges, Triangle, Vertex,
};

/// Cuts a range anywhere, into pieces some of which may be empty.
fn cuts(rng: &mut Rng, range: &Range<i32>) -> Vec<Range<i32>> {
    let mut at: Vec<i32> = (0..rng.index(5))
        .map(|_| rng.int(range.start.into()..=range.end.into()) as i32)
        .chain([range.start, range.end])
        .collect();
    at.sort_unstable();
    at.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

/// Draws a shape in one piece and in many. One if the window shows an outline.
fn check_split(rng: &mut Rng, shape: &(impl Cover + Belongs), window: &PixelRect) -> u64 {
    let whole = coverage(shape, window);
    let mut pieces = CoverageGrid::new(window.clone());
    for rows in cuts(rng, &window.rows) {
        for columns in cuts(rng, &window.columns) {
            pieces.add(&coverage(shape, &rect(columns, rows.clone())));
        }
    }
    check_same_coverage(&pieces, &whole, || format!("pieces of {}", shape.code()));
    // Row by row, and column by column.
    let mut slices = CoverageGrid::new(window.clone());
    if rng.one_in(2) {
        for row in window.rows.clone() {
            slices.add(&coverage(shape, &rect(window.columns.clone(), row..row + 1)));
        }
    } else {
        for column in window.columns.clone() {
            slices.add(&coverage(shape, &rect(column..column + 1, window.rows.clone())));
        }
    }
    check_same_coverage(&slices, &whole, || format!("slices of {}", shape.code()));
    whole.is_mixed().into()
}

#[test]
fn triangles_in_pieces() {
    let count = cases(10_000);
    let mixed = for_each_case(400, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        Ok(check_split(rng, &triangle, &window))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

#[test]
fn lines_in_pieces() {
    let count = cases(10_000);
    let mixed = for_each_case(401, count, |rng| {
        let (line, window) = random::line(rng);
        Ok(check_split(rng, &line, &window))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

#[test]
fn circles_in_pieces() {
    let count = cases(10_000);
    let mixed = for_each_case(402, count, |rng| {
        let (circle, window) = random::circle(rng);
        Ok(check_split(rng, &circle, &window))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

#[test]
fn polygons_in_pieces() {
    let count = cases(2_500);
    let mixed = for_each_case(403, count, |rng| {
        let (outline, window) = random::outline(rng);
        Ok(check_split(rng, &outline, &window))
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

/// A window of thousands of columns and one of thousands of rows: what is stepped or added up goes a long way.
#[test]
fn large_shapes_in_pieces() {
    let mixed = for_each_case(404, cases(60), |rng| {
        let window = if rng.one_in(2) { rect(0..4_000, 20..24) } else { rect(20..24, 0..4_000) };
        let mut far = || random::vertex(rng.int(-600_000..=1_900_000), rng.int(-600_000..=1_900_000));
        let vertices = [far(), far(), far(), far(), far()];
        let line = Line::new(vertices[0], vertices[1]);
        let circle = Circle::from_bits(vertices[2], rng.int(1..=2_000_000) as i32);
        let outline = Outline::of(&vertices, random::fill_rule(rng));
        let triangle = Triangle::from_vertices([vertices[2], vertices[3], vertices[4]]);
        let outlines = check_split(rng, &outline, &window) + check_split(rng, &triangle, &window);
        Ok(outlines + check_split(rng, &line, &window) + check_split(rng, &circle, &window))
    });
    assert!(mixed > cases(60), "only {mixed} showed an outline");
}

const ALL: PixelRect = PixelRect { rows: i32::MIN..i32::MAX, columns: i32::MIN..i32::MAX };

/// Draws in clips far larger than the shape, up to all the rows and columns there are.
fn check_large_clips(draw: impl Fn(&PixelRect) -> CoverageGrid, window: &PixelRect, code: &str) {
    let whole = draw(window);
    let PixelRect { rows, columns } = window.clone();
    for clip in [ALL, rect(columns, ALL.rows), rect(ALL.columns, rows)] {
        check_same_coverage(&draw(&clip), &whole, || format!("{code} in {clip:?}"));
    }
}

/// Vertices within a few pixels of each other, and a window around all of a shape between them.
fn four_vertices(rng: &mut Rng) -> ([Vertex; 4], PixelRect) {
    let (x, y) = random::place(rng);
    let within = |at: i64| at.clamp(random::LOWEST + 8192, random::HIGHEST - 8192);
    let (x, y) = (within(x), within(y));
    let mut vertex = || random::vertex(x + rng.int(-1500..=1500), y + rng.int(-1500..=1500));
    let vertices = [vertex(), vertex(), vertex(), vertex()];
    let (column, row) = ((x >> 8) as i32, (y >> 8) as i32);
    (vertices, rect(column - 12..column + 13, row - 12..row + 13))
}

#[test]
fn triangles_lines_and_circles_in_clips_that_are_far_larger() {
    for_each_case(405, cases(3_000), |rng| {
        let ([a, b, c, d], window) = four_vertices(rng);
        let triangle = Triangle::from_vertices([a, b, c]);
        check_large_clips(|clip| coverage_within(&triangle, clip, &window), &window, &triangle.code());
        let line = Line::new(a, d);
        check_large_clips(|clip| coverage_within(&line, clip, &window), &window, &line.code());
        let circle = Circle::from_bits(d, rng.int(1..=1500) as i32);
        check_large_clips(|clip| coverage_within(&circle, clip, &window), &window, &circle.code());
        Ok(0)
    });
}

#[test]
fn spikes_in_pieces() {
    let count = cases(1_500);
    let mixed = for_each_case(413, count, |rng| {
        let (outline, window) = random::spikes(rng);
        Ok(check_split(rng, &outline, &window))
    });
    assert!(mixed * 2 >= count, "only {mixed} of {count} windows showed an outline");
}

/// Many edges cross where one row of pixels ends and the next begins, and areas are ties.
#[test]
fn edges_on_half_pixels_in_pieces() {
    let count = cases(3_000);
    let mixed = for_each_case(414, count, |rng| {
        let vertex = |rng: &mut Rng| Vertex::from_bits(128 * rng.int(-16..=16) as i32, 128 * rng.int(-16..=16) as i32);
        let contours = (0..1 + rng.index(3)).map(|_| (0..4 + rng.index(12)).map(|_| vertex(rng)).collect()).collect();
        let outline = Outline::new(contours, random::fill_rule(rng));
        Ok(check_split(rng, &outline, &rect(-9..9, -9..9)))
    });
    assert!(mixed * 2 >= count, "only {mixed} of {count} windows showed an outline");
}

/// There are rows, and tiles, only where the polygon is.
#[test]
fn polygons_in_clips_that_are_far_larger() {
    for_each_case(406, cases(300), |rng| {
        let (vertices, window) = four_vertices(rng);
        let outline = Outline::of(&vertices, random::fill_rule(rng));
        check_large_clips(|clip| coverage_within(&outline, clip, &window), &window, &outline.code());
        Ok(0)
    });
}

/// With few slots, tops are dropped and found again; with many, they all wait.
#[test]
fn any_amount_of_scratch_draws_the_same() {
    let count = cases(1_500);
    let mixed = for_each_case(410, count, |rng| {
        let (outline, window) = random::outline(rng);
        let whole = coverage(&outline, &window);
        outline.with_polygon(|polygon| {
            let (least, most) = (polygon.coverage_edges(), polygon.coverage_edges_at_most());
            // All of them used before.
            let mut edges = vec![CoverageEdge::EMPTY; most + 5];
            for count in
                [least, least + 1, least + rng.index(5), usize::midpoint(least, most).max(least), most, most + 5]
            {
                let polygon = polygon.coverage_in(&mut edges[..count]).unwrap();
                let code = || format!("with {count} edges: {}", outline.code());
                check_same_coverage(&coverage(&polygon, &window), &whole, code);
            }
            let code = || format!("on the stack: {}", outline.code());
            if let Ok(polygon) = polygon.coverage_with::<12>() {
                check_same_coverage(&coverage(&polygon, &window), &whole, code);
            }
        });
        Ok(whole.is_mixed().into())
    });
    assert!(mixed * 2 > count, "only {mixed} of {count} showed an outline");
}

/// The most chains, edges that go on downwards or upwards, that have a part in a row of pixels. There can only be more
/// where one starts.
fn most_chains_in_a_row(outline: &Outline) -> usize {
    let mut chains: Vec<(i64, i64)> = Vec::new();
    for contour in &outline.contours {
        let steps: Vec<(At, At)> = edges(contour).filter(|(a, b)| a.y != b.y).collect();
        let turns = |index: usize| {
            let (before, here) = (steps[(index + steps.len() - 1) % steps.len()], steps[index]);
            (before.0.y < before.1.y) != (here.0.y < here.1.y)
        };
        for start in (0..steps.len()).filter(|&index| turns(index)) {
            let length = (1..steps.len()).find(|next| turns((start + next) % steps.len())).unwrap_or(steps.len());
            let (first, last) = (steps[start].0.y, steps[(start + length - 1) % steps.len()].1.y);
            chains.push((first.min(last), first.max(last)));
        }
    }
    let met = |row: i64| chains.iter().filter(|(top, bottom)| *top < 256 * (row + 1) && *bottom > 256 * row).count();
    chains.iter().map(|(top, _)| met(top.div_euclid(256))).max().unwrap_or(0)
}

#[test]
fn one_edge_too_few_is_an_error_that_names_both_numbers() {
    let refused = for_each_case(411, cases(20_000), |rng| {
        let (outline, _) = random::outline(rng);
        let expected = most_chains_in_a_row(&outline);
        outline.with_polygon(|polygon| {
            let needed = polygon.coverage_edges();
            if needed != expected || polygon.coverage_edges_at_most() < needed {
                let at_most = polygon.coverage_edges_at_most();
                return Err(format!("{needed}, not {expected}, at most {at_most}: {}", outline.code()));
            }
            let mut edges = vec![CoverageEdge::EMPTY; needed];
            assert!(polygon.coverage_in(&mut edges).is_ok(), "{}", outline.code());
            match polygon.coverage_with::<4>() {
                Ok(_) => assert!(needed <= 4, "{}", outline.code()),
                Err(error) => assert_eq!(error, TooManyEdges { needed, available: 4 }, "{}", outline.code()),
            }
            if needed == 0 {
                return Ok(0);
            }
            for available in [needed - 1, rng.index(needed)] {
                let error = polygon.coverage_in(&mut edges[..available]).map(|_| ()).unwrap_err();
                assert_eq!(error, TooManyEdges { needed, available }, "{}", outline.code());
            }
            Ok(1)
        })
    });
    assert!(refused > 0);
}

const ARROW: [Vertex; 4] = [Vertex::pixel(4, 0), Vertex::pixel(8, 7), Vertex::pixel(4, 4), Vertex::pixel(0, 7)];
const ARROW_EDGES: usize = Polygon::new(&ARROW).coverage_edges();

#[test]
fn nothing_to_draw_needs_no_edges() {
    assert!(Polygon::new(&[]).coverage_in(&mut []).is_ok());
    assert!(Polygon::new(&ARROW[..1]).coverage_in(&mut []).is_ok());
}

#[test]
fn a_refused_polygon_leaves_the_display_untouched() {
    let mut display = MockDisplay::<Gray8>::new();
    let mut edges = [CoverageEdge::EMPTY; ARROW_EDGES - 1];
    let mut draw = || -> Result<(), TooManyEdges> {
        let arrow = Polygon::new(&ARROW).coverage_in(&mut edges)?;
        let Ok(()) = arrow.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).draw(&mut display);
        Ok(())
    };
    assert_eq!(draw(), Err(TooManyEdges { needed: 4, available: 3 }));
    assert_eq!(display.affected_area().size.width, 0);
    let error = TooLittleScratch::from(TooManyEdges { needed: 12, available: 8 }).to_string();
    assert!(error.contains("12") && error.contains('8'), "{error}");
}

/// Takes `left` calls and refuses the next.
struct Failing {
    left: usize,
    taken: Vec<(i32, i32, Vec<u8>)>,
    has_failed: bool,
}

impl Failing {
    fn after(left: usize) -> Self {
        Self { left, taken: Vec::new(), has_failed: false }
    }

    fn take(&mut self, row: i32, column: i32, coverage: Vec<u8>) -> Result<(), usize> {
        assert!(!self.has_failed, "called again after it failed");
        if self.taken.len() == self.left {
            self.has_failed = true;
            return Err(self.left);
        }
        self.taken.push((row, column, coverage));
        Ok(())
    }
}

impl CoverageSink for Failing {
    type Error = usize;

    fn span(&mut self, Span { row, columns }: Span, coverage: u8) -> Result<(), usize> {
        self.take(row, columns.start, vec![coverage; columns.len()])
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), usize> {
        self.take(row, column, coverage.to_vec())
    }
}

/// A shape that is cut off by its sink stops there with the sink's error, and is whole again the next time.
fn check_failing(rng: &mut Rng, shape: &impl Cover, window: &PixelRect) -> u64 {
    let mut whole = Failing::after(usize::MAX);
    shape.coverage(window, &mut whole).unwrap();
    let calls = whole.taken.len();
    if calls == 0 {
        return 0;
    }
    let left = rng.index(calls);
    let mut part = Failing::after(left);
    assert_eq!(shape.coverage(window, &mut part), Err(left));
    assert_eq!(part.taken, whole.taken[..left]);
    let mut again = Failing::after(usize::MAX);
    shape.coverage(window, &mut again).unwrap();
    assert_eq!(again.taken, whole.taken);
    1
}

#[test]
fn a_sink_that_fails_ends_the_walk_and_leaves_the_scratch_in_order() {
    let count = cases(2_000);
    let failed = for_each_case(412, count, |rng| {
        let (outline, window) = random::outline(rng);
        let failed = outline.with_polygon(|polygon| {
            let mut edges = vec![CoverageEdge::EMPTY; polygon.coverage_edges()];
            check_failing(rng, &polygon.coverage_in(&mut edges).unwrap(), &window)
        });
        let (triangle, window) = random::triangle(rng);
        let failed = failed + check_failing(rng, &triangle, &window);
        let (line, window) = random::line(rng);
        let failed = failed + check_failing(rng, &line, &window);
        let (circle, window) = random::circle(rng);
        Ok(failed + check_failing(rng, &circle, &window))
    });
    assert!(failed > count * 2, "only {failed} of {} drew anything", 4 * count);
}
