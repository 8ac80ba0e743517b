//! What is off the screen costs nothing: neither in spans sent nor in time.
//!
//! The time bounds are very generous for a walk of the visible rows, and far too short for one of all rows: a hundred
//! thousand shapes of a million rows each would be a hundred thousand million steps.

mod oracle;

use std::{
    convert::Infallible,
    hint::black_box,
    time::{Duration, Instant},
};

use oracle::{Outline, Rng, rect};
use spanfill::{Circle, FillRule, Line, PixelRect, Shape, Span, SpanSink, Triangle, Vertex};

/// Counts what is sent; the pixels are other tests' business.
#[derive(Default)]
struct Counter {
    calls: usize,
}

impl SpanSink for Counter {
    type Error = Infallible;

    fn span(&mut self, span: Span) -> Result<(), Infallible> {
        black_box(span);
        self.calls += 1;
        Ok(())
    }
}

fn calls(shape: &impl Shape, clip: &PixelRect) -> usize {
    let mut counter = Counter::default();
    let Ok(()) = shape.spans(clip, &mut counter);
    counter.calls
}

const MANY: usize = 100_000;
const GENEROUS: Duration = Duration::from_secs(20);

fn assert_quick(what: &str, mut draw: impl FnMut(&mut Rng)) {
    let mut rng = Rng::new(60, 0);
    let start = Instant::now();
    for _ in 0..MANY {
        draw(&mut rng);
        assert!(start.elapsed() < GENEROUS, "{what} cost time for what is off the screen");
    }
}

/// A coordinate about a million pixels (or eight) to one side.
fn far(rng: &mut Rng, sign: i64) -> i32 {
    (sign * rng.pick(&[256_000_000, (1 << 31) - 1]) + rng.int(-1000..=0) * sign) as i32
}

#[test]
fn a_triangle_a_million_pixels_high_costs_its_visible_rows() {
    let clip = rect(0..16, 0..8);
    assert_quick("triangles", |rng| {
        let mut x = || rng.int(-20_000..=20_000) as i32;
        let (a, b, c) = (x(), x(), x());
        let (top, bottom) = (far(rng, -1), far(rng, 1));
        let triangle =
            Triangle::new(Vertex::from_bits(a, top), Vertex::from_bits(b, bottom), Vertex::from_bits(c, bottom));
        assert!(calls(&triangle, &clip) <= 8);
    });
    let (left, right) = (Vertex::from_bits(0, i32::MIN), Vertex::from_bits(2000, i32::MIN));
    assert_eq!(calls(&Triangle::new(left, right, Vertex::from_bits(1000, i32::MAX)), &clip), 8);
}

#[test]
fn shapes_beside_the_screen_send_nothing_and_cost_nothing() {
    let clip = rect(0..320, 0..240);
    assert_quick("shapes beside the screen", |rng| {
        // Beyond the left or the right side, from far above to far below.
        let side = rng.pick(&[-1, 1]);
        let mut beside = |below| Vertex::from_bits(far(rng, side), far(rng, below));
        let (a, b, c) = (beside(-1), beside(1), beside(1));
        assert_eq!(calls(&Triangle::new(a, b, c), &clip), 0);
        assert_eq!(calls(&Line::new(a, c), &clip), 0);
        assert_eq!(calls(&Circle::from_bits(a, 200_000_000), &clip), 0);
        assert_eq!(calls(&Outline::of(&[a, b, c, b], FillRule::NonZero), &clip), 0);
    });
}

#[test]
fn a_line_across_the_whole_range_costs_its_visible_pixels() {
    let clip = rect(-8..8, -8..8);
    assert_quick("lines", |rng| {
        let shift = rng.int(-1000..=1000) as i32;
        let line = Line::new(
            Vertex::from_bits(i32::MIN, far(rng, -1)),
            Vertex::from_bits(i32::MAX, far(rng, 1) - shift.abs()),
        );
        assert!(calls(&line, &clip) <= 16);
        let steep = Line::new(Vertex::from_bits(shift, far(rng, -1)), Vertex::from_bits(-shift, far(rng, 1)));
        assert_eq!(calls(&steep, &clip), 16);
    });
}

#[test]
fn a_circle_as_large_as_the_range_costs_its_visible_rows() {
    let clip = rect(0..16, -4..4);
    assert_quick("circles", |rng| {
        let radius = i32::MAX - rng.int(0..=1000) as i32;
        // Its leftmost or rightmost point is on the screen.
        let center = Vertex::from_bits(rng.pick(&[radius - 2000, 2000 - radius]), 0);
        assert_eq!(calls(&Circle::from_bits(center, radius), &clip), 8);
    });
}

#[test]
fn a_polygon_of_many_tall_edges_costs_its_visible_rows() {
    let clip = rect(0..64, 0..4);
    assert_quick("polygons", |rng| {
        // A zigzag from the upper end of the range to the lower one, some of its teeth on the screen.
        let zigzag: Vec<Vertex> = (0..16)
            .map(|index| {
                Vertex::from_bits(2000 * index - 8000, if index % 2 == 0 { far(rng, -1) } else { far(rng, 1) })
            })
            .collect();
        // Sixteen edges cross the screen, and at most every other gap between them is inside.
        assert!((1..=4 * 8).contains(&calls(&Outline::of(&zigzag, FillRule::EvenOdd), &clip)));
    });
}

#[test]
fn a_clip_of_every_pixel_there_is_costs_only_the_rows_of_the_shape() {
    let clip = rect(i32::MIN..i32::MAX, i32::MIN..i32::MAX);
    let (a, b, c) = (Vertex::pixel(0, 0), Vertex::pixel(9, 0), Vertex::pixel(0, 9));
    assert_quick("a large clip", |_| {
        assert_eq!(calls(&Triangle::new(a, b, c), &clip), 9);
        assert_eq!(calls(&Line::new(a, c), &clip), 10);
        assert_eq!(calls(&Circle::from_bits(a, 257), &clip), 3);
        assert_eq!(calls(&Outline::of(&[a, b, c], FillRule::NonZero), &clip), 9);
    });
}
