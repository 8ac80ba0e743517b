//! A polygon's scratch: exactly what `active_edges` says suffices, one less is an error that names both numbers and
//! draws nothing, and a constant outline sizes its own scratch at compile time.

mod oracle;

use std::error::Error;

use embedded_graphics::{Drawable as _, mock_display::MockDisplay, pixelcolor::BinaryColor};
use oracle::{Outline, block_pixels, cases, check_same, for_each_case, random, rect, span_pixels};
use spanfill::{ActiveEdge, Fill as _, FillRule, Polygon, TooManyEdges, Vertex};

/// An arrow head: four edges, two of them on most rows and four between the barbs.
const ARROW: [Vertex; 4] = [Vertex::pixel(4, 0), Vertex::pixel(8, 7), Vertex::pixel(4, 4), Vertex::pixel(0, 7)];
const ARROW_EDGES: usize = Polygon::new(&ARROW).active_edges();
const ARROW_PICTURE: [&str; 8] =
    ["         ", "    #    ", "   ###   ", "   ###   ", "  #####  ", "  #   #  ", " #     # ", "         "];

#[test]
fn a_constant_outline_sizes_its_own_scratch() {
    assert_eq!(ARROW_EDGES, 4);
    let mut display = MockDisplay::new();
    let arrow = Polygon::new(&ARROW).with_capacity::<ARROW_EDGES>().unwrap();
    arrow.filled(BinaryColor::On).draw(&mut display).unwrap();
    display.assert_pattern(&ARROW_PICTURE);
}

#[test]
fn the_number_of_active_edges_is_the_most_that_cross_a_row_of_centres() {
    let count = cases(200_000);
    let crossed = for_each_case(70, count, |rng| {
        let (outline, _) = random::outline(rng);
        let expected = outline.most_edges_on_a_row();
        let needed = outline.with_polygon(|polygon| polygon.active_edges());
        if needed == expected {
            Ok(u64::from(expected > 2))
        } else {
            Err(format!("{needed}, not {expected}: {outline:?}"))
        }
    });
    assert!(crossed * 4 > count, "only {crossed} of {count} needed more than two");
}

#[test]
fn the_number_of_active_edges_of_small_outlines_is_that_of_their_busiest_row() {
    let crossed = for_each_case(71, cases(50_000), |rng| {
        let length = 3 + rng.index(12);
        let contour: Vec<Vertex> =
            (0..length).map(|_| random::vertex(rng.int(-4000..=4000), 32 * rng.int(-128..=128))).collect();
        let crossings = |row: i64| {
            let y = 256 * row + 128;
            let starts = contour.iter().map(|vertex| i64::from(vertex.y.to_bits()));
            let ends = contour.iter().cycle().skip(1).map(|vertex| i64::from(vertex.y.to_bits()));
            starts.zip(ends).filter(|(start, end)| (*start <= y) != (*end <= y)).count()
        };
        let expected = (-17..=17).map(crossings).max().unwrap();
        let needed = Polygon::new(&contour).active_edges();
        if needed == expected { Ok(needed as u64) } else { Err(format!("{needed}, not {expected}: {contour:?}")) }
    });
    assert!(crossed > 0);
}

/// Sorted, in as much room as is asked for or more, and counted, in less.
#[test]
fn the_number_found_by_sorting_is_the_one_that_is_counted() {
    let needed_more = for_each_case(74, cases(100_000), |rng| {
        let outline = match rng.index(4) {
            0 => random::spikes(rng).0,
            1 => {
                let length = 3 + rng.index(60);
                let step = rng.pick(&[1, 64, 128, 256, 300]);
                let vertex = |rng: &mut oracle::Rng| random::vertex(rng.int(-999..=999), step * rng.int(-30..=30));
                Outline::of(&(0..length).map(|_| vertex(rng)).collect::<Vec<_>>(), FillRule::EvenOdd)
            }
            _ => random::outline(rng).0,
        };
        outline.with_polygon(|polygon| {
            let (active, at_most) = (polygon.active_edges(), polygon.active_edges_at_most());
            for length in [at_most, at_most + rng.index(3), at_most.saturating_sub(1)] {
                let found = polygon.active_edges_in(&mut vec![i32::MIN; length]);
                assert_eq!(found, active, "active edges in {length} of {at_most}: {outline:?}");
            }
            let (covered, at_most) = (polygon.coverage_edges(), polygon.coverage_edges_at_most());
            for length in [at_most, at_most + rng.index(3), at_most.saturating_sub(1)] {
                let found = polygon.coverage_edges_in(&mut vec![i32::MIN; length]);
                assert_eq!(found, covered, "coverage edges in {length} of {at_most}: {outline:?}");
            }
            Ok(u64::from(covered != active && covered < at_most))
        })
    });
    assert!(needed_more > 100, "{needed_more}");
}

#[test]
fn outlines_without_height_need_no_scratch() {
    assert_eq!(Polygon::new(&[]).active_edges(), 0);
    assert_eq!(Polygon::new(&[Vertex::pixel(1, 1)]).active_edges(), 0);
    assert_eq!(Polygon::new(&[Vertex::pixel(1, 1), Vertex::pixel(9, 1)]).active_edges(), 0);
    // Between two rows of centres.
    let flat = [Vertex::from_bits(0, 129), Vertex::from_bits(900, 200), Vertex::from_bits(0, 384)];
    assert_eq!(Polygon::new(&flat).active_edges(), 0);
    let window = rect(0..8, 0..8);
    let polygon = Polygon::new(&flat);
    assert_eq!(span_pixels(&polygon.in_scratch(&mut []).unwrap(), &window).covered(), 0);
    assert_eq!(span_pixels(&polygon.with_capacity::<0>().unwrap(), &window).covered(), 0);
}

#[test]
fn one_edge_too_few_is_an_error_that_names_both_numbers() {
    let refused = for_each_case(72, cases(50_000), |rng| {
        let (outline, window) = random::outline(rng);
        outline.with_polygon(|polygon| {
            let needed = polygon.active_edges();
            let mut scratch = vec![ActiveEdge::EMPTY; needed];
            let pixels = span_pixels(&polygon.in_scratch(&mut scratch).unwrap(), &window);
            // More than enough is as good: one slot for each vertex is the most that could be of use.
            let more = rng.index(2 + outline.contours.concat().len());
            let mut larger = vec![ActiveEdge::EMPTY; needed + more];
            let in_larger = polygon.in_scratch(&mut larger).unwrap();
            check_same(&span_pixels(&in_larger, &window), &pixels, || format!("{outline:?}"));
            if needed == 0 {
                return Ok(0);
            }
            let available = rng.index(needed);
            for available in [available, needed - 1] {
                let refusal = polygon.in_scratch(&mut scratch[..available]).map(|_| ()).unwrap_err();
                if refusal != (TooManyEdges { needed, available }) {
                    return Err(format!("{refusal:?}, needed {needed}, available {available}: {outline:?}"));
                }
            }
            Ok(1)
        })
    });
    assert!(refused > 0);
}

#[test]
fn a_capacity_in_the_type_draws_the_same_and_refuses_the_same() {
    let refused = for_each_case(73, cases(50_000), |rng| {
        let (outline, window) = random::outline(rng);
        outline.with_polygon(|polygon| {
            let needed = polygon.active_edges();
            match polygon.with_capacity::<4>() {
                Ok(with_capacity) => {
                    assert!(needed <= 4, "{needed} edges in a scratch of 4: {outline:?}");
                    let pixels = span_pixels(&outline, &window);
                    check_same(&span_pixels(&with_capacity, &window), &pixels, || format!("{outline:?}"));
                    check_same(&block_pixels(&with_capacity, &window), &pixels, || format!("{outline:?}"));
                    Ok(0)
                }
                Err(refusal) => {
                    assert_eq!(refusal, TooManyEdges { needed, available: 4 }, "{outline:?}");
                    Ok(1)
                }
            }
        })
    });
    assert!(refused > 0);
}

#[test]
fn a_refused_polygon_leaves_the_display_untouched() {
    let mut display = MockDisplay::<BinaryColor>::new();
    let mut draw = || -> Result<(), TooManyEdges> {
        let Ok(()) =
            Polygon::new(&ARROW).with_capacity::<{ ARROW_EDGES - 1 }>()?.filled(BinaryColor::On).draw(&mut display);
        Ok(())
    };
    assert_eq!(draw(), Err(TooManyEdges { needed: 4, available: 3 }));
    assert_eq!(display.affected_area().size.width, 0);
}

#[test]
fn the_error_says_what_was_needed_and_what_there_was() {
    let error: Box<dyn Error> = Box::new(TooManyEdges { needed: 12, available: 8 });
    let text = error.to_string();
    assert!(text.contains("12 edges, not 8") && text.contains("coverage_with::<12>"), "{text}");
}
