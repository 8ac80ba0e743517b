//! One scratch for all shapes: what is drawn within it is what is drawn in a slice of just the size, and what it is too small for
//! is refused by an error that says what to write.

mod oracle;

use std::sync::Mutex;

use embedded_graphics::{Drawable as _, mock_display::MockDisplay, pixelcolor::Gray4, prelude::GrayColor as _};
use oracle::{
    Outline, block_pixels, cases, check_same, check_same_coverage, coverage, for_each_case, random, span_pixels,
};
use spanfill::{
    Cap, Element, Over, Path, Polygon, Scratch, ScratchSize, ScratchTooSmall, Stroke, StrokeStyle, SvgElements, Vertex,
    collect, edges_for, path, prelude::*,
};

/// Whether it could be drawn in a scratch of so many edges; then it is what it has to be.
fn is_drawn_within<const EDGES: usize>(outline: &Outline, window: &spanfill::PixelRect) -> bool {
    let mut scratch = Scratch::<EDGES>::new();
    outline.with_polygon(|polygon| {
        let needed = polygon.coverage_edges();
        match polygon.within(&mut scratch) {
            Ok(within) => {
                assert!(needed <= EDGES, "{needed} edges in {EDGES}: {outline:?}");
                let filled = span_pixels(outline, window);
                // Twice, in what the first has left behind, and anti-aliased in between.
                check_same(&span_pixels(&within, window), &filled, || format!("{outline:?}"));
                check_same_coverage(&coverage(&within, window), &coverage(outline, window), || format!("{outline:?}"));
                check_same(&block_pixels(&within, window), &filled, || format!("{outline:?}"));
                true
            }
            Err(error) => {
                let [needed, available] = [needed, EDGES].map(|edges| ScratchSize { edges, vertices: 0 });
                assert_eq!(error, ScratchTooSmall { needed, available }, "{outline:?}");
                assert!(needed.edges > EDGES, "{needed} edges in {EDGES}: {outline:?}");
                false
            }
        }
    })
}

#[test]
fn polygons_within_any_scratch_that_is_enough_are_the_same() {
    let count = cases(1_000);
    let drawn = for_each_case(80, count, |rng| {
        let (outline, window) = if rng.one_in(4) { random::spikes(rng) } else { random::outline(rng) };
        // Just enough and one too few are among these for most outlines.
        let drawn = [
            is_drawn_within::<0>(&outline, &window),
            is_drawn_within::<1>(&outline, &window),
            is_drawn_within::<2>(&outline, &window),
            is_drawn_within::<3>(&outline, &window),
            is_drawn_within::<4>(&outline, &window),
            is_drawn_within::<6>(&outline, &window),
            is_drawn_within::<8>(&outline, &window),
            is_drawn_within::<12>(&outline, &window),
        ];
        Ok(u64::from(drawn[7] && !drawn[3]))
    });
    assert!(drawn * 3 > count, "only {drawn} of {count} needed more than a few edges, and not too many");
}

/// Filled polygons are not asked for: there are never more of their edges.
#[test]
fn no_outline_has_more_active_edges_than_coverage_edges() {
    let fewer = for_each_case(81, cases(100_000), |rng| {
        let outline = if rng.one_in(4) { random::spikes(rng).0 } else { random::outline(rng).0 };
        let (active, covered) = outline.with_polygon(|polygon| (polygon.active_edges(), polygon.coverage_edges()));
        if active <= covered {
            Ok(u64::from(active < covered))
        } else {
            Err(format!("{active}, {covered}: {outline:?}"))
        }
    });
    assert!(fewer > 0);
}

/// Without room for a vertex, the error still says how many edges are enough: as many as the polygon that it would become has
/// at most.
#[test]
fn an_outline_that_does_not_fit_says_how_much_does() {
    let found = for_each_case(82, cases(20_000), |rng| {
        let mut data = "M0 0".to_owned();
        for _ in 0..rng.index(20) {
            let letter = rng.pick(&["M", "L", "L", "L", "L", "Z M"]);
            data += &format!("{letter}{} {}", rng.int(-9..=40), rng.int(-9..=40));
        }
        let elements: Vec<Element> = SvgElements::new(&data, 1, 1).map(Result::unwrap).collect();
        let path = Path::new(&elements);
        let mut vertices = vec![Vertex::default(); 200];
        let polygon = collect(&path, &mut vertices).map_err(|error| error.to_string())?;
        let Err(error) = path.within(&mut Scratch::<0>::new()) else {
            return Ok(0);
        };
        let expected = ScratchSize { edges: polygon.coverage_edges_at_most(), vertices: path.count_vertices() };
        if error.needed == expected { Ok(1) } else { Err(format!("{error:?}, not {expected}: {data}")) }
    });
    assert!(found > 0);
}

/// As many as `collect` needs.
trait CountVertices {
    fn count_vertices(&self) -> usize;
}

impl<O: spanfill::Outline> CountVertices for O {
    fn count_vertices(&self) -> usize {
        collect(self, &mut []).map_or_else(|error| error.needed, |_| 0)
    }
}

const ARROW: Polygon = Polygon::new(&[Vertex::pixel(0, 0), Vertex::pixel(4, 2), Vertex::pixel(0, 4)]);
const ROOF: Polygon =
    Polygon::new(&[Vertex::pixel(6, 4), Vertex::pixel(8, 0), Vertex::pixel(10, 4), Vertex::pixel(8, 2)]);

const EDGES: usize = edges_for(&[ARROW, ROOF]);
static SHARED: Mutex<Scratch<EDGES, 300>> = Mutex::new(Scratch::new());

#[test]
fn a_static_serves_polygons_paths_and_strokes() {
    assert_eq!((EDGES, edges_for(&[]), edges_for(&[ARROW])), (4, 0, 2));
    let mut scratch = SHARED.lock().unwrap();
    let corner = Stroke::new(path!("M2 8V2h5"), StrokeStyle::pixels(2).cap(Cap::Square));
    let leaf = path!("M1 1C1 9 9 9 9 9C9 1 1 1 1 1Z");
    let mut expected = MockDisplay::new();
    let mut shared = MockDisplay::new();
    for display in [&mut expected, &mut shared] {
        display.set_allow_overdraw(true);
    }
    macro_rules! draw {
        ($shape:ident) => {{
            $shape.within(&mut *scratch).unwrap().filled(Gray4::WHITE).draw(&mut shared).unwrap();
            let blend = Over(Gray4::BLACK);
            $shape.within(&mut *scratch).unwrap().antialiased(Gray4::new(9), blend).draw(&mut shared).unwrap();
        }};
    }
    draw!(ARROW);
    draw!(ROOF);
    draw!(corner);
    draw!(leaf);
    let mut vertices = [[Vertex::default(); 300]; 2];
    let [first, second] = &mut vertices;
    for polygon in [ARROW, ROOF, collect(&corner, first).unwrap(), collect(&leaf, second).unwrap()] {
        polygon.with_capacity::<16>().unwrap().filled(Gray4::WHITE).draw(&mut expected).unwrap();
        let blend = Over(Gray4::BLACK);
        polygon.coverage_with::<16>().unwrap().antialiased(Gray4::new(9), blend).draw(&mut expected).unwrap();
    }
    expected.assert_eq(&shared);
}

#[test]
fn a_refusal_says_what_to_write_and_leaves_the_display_untouched() {
    let mut display = MockDisplay::<Gray4>::new();
    let mut scratch = Scratch::<3, 5>::new();
    let mut draw = || -> Result<(), ScratchTooSmall> {
        let Ok(()) = ROOF.within(&mut scratch)?.filled(Gray4::WHITE).draw(&mut display);
        Ok(())
    };
    assert_eq!(draw().unwrap_err().to_string(), "the outline needs a Scratch<4, 5>, not a Scratch<3, 5>");
    let roof = path!("M6 4L8 0L10 4L8 2Z");
    let error = roof.within(&mut scratch).unwrap_err();
    assert_eq!(error.to_string(), "the outline needs a Scratch<4, 6>, not a Scratch<3, 5>");
    assert_eq!(roof.within(&mut Scratch::<3, 6>::new()).unwrap_err().needed, ScratchSize { edges: 4, vertices: 6 });
    assert!(roof.within(&mut Scratch::<4, 6>::new()).is_ok());
    assert_eq!(display.affected_area().size.width, 0);
}
