//! Walks of many rows: an error of a step would add up until it moves a pixel.
//!
//! Ordinary shapes are compared on the whole of a display of 320 x 240. For tall and broad ones there are too many pixels
//! to ask the rule about; of each span the first and the last pixel must belong, and the pixels before and after must not.

mod oracle;

use std::{convert::Infallible, ops::Range};

use oracle::{
    Belongs, Outline, Rng, cases, check_exact, for_each_case,
    random::{self, HIGHEST, LOWEST},
    rect,
};
use spanfill::{Circle, Line, PixelRect, Shape, Span, SpanSink, Triangle, Vertex};

const SCREEN: PixelRect = PixelRect { rows: 0..240, columns: 0..320 };

/// A vertex within `reach` of a point, on the screen or near it.
fn around(rng: &mut Rng, (x, y): (i64, i64), reach: i64) -> Vertex {
    random::vertex(x + rng.int(-reach..=reach), y + rng.int(-reach..=reach))
}

fn on_screen(rng: &mut Rng) -> (i64, i64) {
    (rng.int(0..=320 * 256), rng.int(0..=240 * 256))
}

#[test]
fn ordinary_shapes_on_a_whole_screen() {
    let count = cases(1500);
    let mixed = for_each_case(90, count, |rng| {
        let reach = rng.pick(&[5, 25, 100, 400]) * 256;
        let place = on_screen(rng);
        let corners = [(); 3].map(|()| around(rng, place, reach));
        let mut mixed = u64::from(check_exact(&Triangle::from_vertices(corners), &SCREEN)?);
        mixed += u64::from(check_exact(&Line::new(corners[0], corners[1]), &SCREEN)?);
        let circle = Circle::from_bits(corners[2], rng.int(0..=reach) as i32);
        mixed += u64::from(check_exact(&circle, &SCREEN)?);
        let contour: Vec<Vertex> = (0..3 + rng.index(64)).map(|_| around(rng, place, reach)).collect();
        mixed += u64::from(check_exact(&Outline::of(&contour, random::fill_rule(rng)), &SCREEN)?);
        Ok(mixed)
    });
    assert!(mixed > 3 * count, "only {mixed} of {} screens showed an outline", 4 * count);
}

/// Holds the ends of every span against the rule.
struct Ends<'a, S> {
    shape: &'a S,
    clip: &'a PixelRect,
    last: Option<Span>,
    spans: u64,
}

impl<S: Belongs> SpanSink for Ends<'_, S> {
    type Error = Infallible;

    fn span(&mut self, span: Span) -> Result<(), Infallible> {
        let Span { row, columns: Range { start, end } } = span.clone();
        if let Some(last) = &self.last {
            assert!(row > last.row || row == last.row && start > last.columns.end, "{span:?} after {last:?}");
        }
        assert!(self.clip.rows.contains(&row) && self.clip.columns.start <= start && end <= self.clip.columns.end);
        let has = |column| self.shape.has(column, row);
        assert!(has(start) && has(end - 1), "{span:?} holds too much: {}", self.shape.code());
        let cut_before = start == self.clip.columns.start || !has(start - 1);
        let cut_after = end == self.clip.columns.end || !has(end);
        assert!(cut_before && cut_after, "{span:?} holds too little: {}", self.shape.code());
        self.last = Some(span);
        self.spans += 1;
        Ok(())
    }
}

/// Walks a shape for up to a few thousand rows from a row of its own, with no sides to the clip; how many spans it sent.
fn walk<S: Shape + Belongs>(rng: &mut Rng, shape: &S, tops: Range<i32>) -> u64 {
    let rows = 3000;
    let top = rng.int((i64::from(tops.start) - 10)..=i64::from(tops.end)) as i32;
    let top = if rng.one_in(3) { tops.start } else { top };
    let clip = rect(i32::MIN..i32::MAX, top..top + rows);
    let mut ends = Ends { shape, clip: &clip, last: None, spans: 0 };
    let Ok(()) = shape.spans(&clip, &mut ends);
    ends.spans
}

/// Draws all of a shape; how many spans it sent.
fn whole<S: Shape + Belongs>(shape: &S) -> u64 {
    let clip = rect(i32::MIN..i32::MAX, i32::MIN..i32::MAX);
    let mut ends = Ends { shape, clip: &clip, last: None, spans: 0 };
    let Ok(()) = shape.spans(&clip, &mut ends);
    ends.spans
}

/// Up to ten thousand pixels from the origin, where shapes need no more than 32 bits or just more than that.
fn thousands_away(rng: &mut Rng) -> i64 {
    let reach = 1 << 21;
    match rng.int(0..=5) {
        0 => rng.pick(&[reach, -reach]) + rng.magnitude(9),
        1 => rng.pick(&[reach, -reach]),
        2 => 128 * rng.int(-(reach >> 7)..=reach >> 7),
        3 => rng.magnitude(21),
        4 => rng.int(-reach - (1 << 19)..=reach + (1 << 19)),
        _ => rng.int(-reach..=reach),
    }
}

#[test]
fn shapes_of_thousands_of_pixels_whole() {
    let count = cases(400);
    let spans = for_each_case(95, count, |rng| {
        let mut vertex = || random::vertex(thousands_away(rng), thousands_away(rng));
        let corners = [vertex(), vertex(), vertex(), vertex(), vertex()];
        let mut spans = whole(&Triangle::from_vertices([corners[0], corners[1], corners[2]]));
        spans += whole(&Line::new(corners[3], corners[4]));
        spans += whole(&Outline::of(&corners, random::fill_rule(rng)));
        let radius = match rng.int(0..=2) {
            0 => (1 << 19) - rng.magnitude(8),
            1 => rng.int(1..=1 << 19),
            _ => 64 * rng.int(1..=1 << 14),
        };
        spans += whole(&Circle::from_bits(corners[3], radius as i32));
        Ok(spans)
    });
    assert!(spans > 10_000 * count, "{spans}");
}

/// The rows between vertices.
fn rows_between(vertices: &[Vertex]) -> Range<i32> {
    let rows = || vertices.iter().map(|vertex| vertex.y.to_bits() >> 8);
    rows().min().unwrap()..rows().max().unwrap() + 1
}

/// Tall, broad or both, by up to the whole range.
fn far_apart(rng: &mut Rng, count: usize) -> Vec<Vertex> {
    let (width, height) = (rng.int(8..=32), rng.int(18..=32));
    let (x, y) = (rng.int(LOWEST..=HIGHEST), rng.int(LOWEST..=HIGHEST));
    (0..count).map(|_| random::vertex(x + rng.magnitude(width), y + rng.int(-(1 << height)..=1 << height))).collect()
}

#[test]
fn tall_triangles_row_by_row() {
    let spans = for_each_case(91, cases(6000), |rng| {
        let corners = far_apart(rng, 3);
        let triangle = Triangle::from_vertices([corners[0], corners[1], corners[2]]);
        Ok(walk(rng, &triangle, rows_between(&corners)))
    });
    assert!(spans > 1000 * cases(6000), "{spans}");
}

#[test]
fn tall_lines_row_by_row() {
    let spans = for_each_case(92, cases(6000), |rng| {
        let ends = far_apart(rng, 2);
        Ok(walk(rng, &Line::new(ends[0], ends[1]), rows_between(&ends)))
    });
    assert!(spans > 1000 * cases(6000), "{spans}");
}

#[test]
fn large_circles_row_by_row() {
    let spans = for_each_case(93, cases(6000), |rng| {
        let bits = rng.int(16..=31);
        let radius = rng.int(0..=1 << bits).min(HIGHEST) as i32;
        let center = around(rng, (0, 0), 1 << 30);
        let (middle, reach) = (center.y.to_bits() >> 8, radius >> 8);
        Ok(walk(rng, &Circle::from_bits(center, radius), middle - reach - 1..middle + reach + 1))
    });
    assert!(spans > 1000 * cases(6000), "{spans}");
}

#[test]
fn tall_polygons_row_by_row() {
    let spans = for_each_case(94, cases(2000), |rng| {
        let count = 3 + rng.index(8);
        let contour = far_apart(rng, count);
        let outline = Outline::of(&contour, random::fill_rule(rng));
        Ok(walk(rng, &outline, rows_between(&contour)))
    });
    assert!(spans > 1000 * cases(2000), "{spans}");
}
