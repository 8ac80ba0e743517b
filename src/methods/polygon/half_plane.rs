//! Triangles by half-planes, and what else cutting a polygon into triangles asks of its numbers.

use crate::{
    fragment::{Fragment, FragmentSink},
    geometry::{PixelRect, Vertex},
    shape::{Shape, Triangle},
    span::{Span, SpanSink},
};

/// Numbers that polygons can be cut into triangles with.
pub trait Plane: Copy + PartialEq {
    /// Zero.
    const ORIGIN: Self;

    /// The side of the line a -> b that c lies on: 1 to its right (y grows downwards), -1 to its left, 0 on it.
    fn turn(a: [Self; 2], b: [Self; 2], c: [Self; 2]) -> i8;

    /// Where the line through a and b meets the one through c and d; none where they are parallel.
    fn crossing(a: [Self; 2], b: [Self; 2], c: [Self; 2], d: [Self; 2]) -> Option<[Self; 2]>;

    /// The middle between two vertices, twice as far from the origin: their sum, in numbers that hold it.
    fn middle(a: [Self; 2], b: [Self; 2]) -> [f64; 2];

    /// The vertex in the same numbers, which are exact.
    fn wide(a: [Self; 2]) -> [f64; 2];

    /// Fills a triangle, by the top-left rule.
    ///
    /// # Errors
    ///
    /// The sink's.
    fn fill<S: FragmentSink>(triangle: [[Self; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error>;
}

/// 1/256 pixel: turns are exact, crossings are rounded to the nearest.
impl Plane for i32 {
    const ORIGIN: Self = 0;

    fn turn(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i8 {
        let sign =
            (difference(b[0], a[0]) * difference(c[1], a[1])).cmp(&(difference(b[1], a[1]) * difference(c[0], a[0])));
        sign as i8
    }

    fn crossing(a: [i32; 2], b: [i32; 2], c: [i32; 2], d: [i32; 2]) -> Option<[i32; 2]> {
        let (ab, cd) = (b.map_with(a, difference), d.map_with(c, difference));
        let ac = c.map_with(a, difference);
        let (numerator, denominator) = (ac[0] * cd[1] - ac[1] * cd[0], ab[0] * cd[1] - ab[1] * cd[0]);
        let (numerator, denominator) = (numerator * denominator.signum(), denominator.abs());
        let along = |start: i32, run: i128| {
            let offset = (2 * numerator * run + denominator).checked_div_euclid(2 * denominator)?;
            i32::try_from(i128::from(start) + offset).ok()
        };
        Some([along(a[0], ab[0])?, along(a[1], ab[1])?])
    }

    fn middle(a: [i32; 2], b: [i32; 2]) -> [f64; 2] {
        [f64::from(a[0]) + f64::from(b[0]), f64::from(a[1]) + f64::from(b[1])]
    }

    fn wide(a: [i32; 2]) -> [f64; 2] {
        [2.0 * f64::from(a[0]), 2.0 * f64::from(a[1])]
    }

    fn fill<S: FragmentSink>(triangle: [[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        Triangle::from_vertices(triangle.map(|[x, y]| Vertex::from_bits(x, y))).spans(clip, &mut Pixels(sink))
    }
}

/// Pixels, every step rounded to 24 bits.
impl Plane for f32 {
    const ORIGIN: Self = 0.0;

    fn turn(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> i8 {
        let e = edge(a, b, c);
        i8::from(e > 0.0) - i8::from(e < 0.0)
    }

    fn crossing(a: [f32; 2], b: [f32; 2], c: [f32; 2], d: [f32; 2]) -> Option<[f32; 2]> {
        let (ab, cd, ac) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]], [c[0] - a[0], c[1] - a[1]]);
        let t = (ac[0] * cd[1] - ac[1] * cd[0]) / (ab[0] * cd[1] - ab[1] * cd[0]);
        t.is_finite().then(|| [a[0] + t * ab[0], a[1] + t * ab[1]])
    }

    fn middle(a: [f32; 2], b: [f32; 2]) -> [f64; 2] {
        [f64::from(a[0]) + f64::from(b[0]), f64::from(a[1]) + f64::from(b[1])]
    }

    fn wide(a: [f32; 2]) -> [f64; 2] {
        [2.0 * f64::from(a[0]), 2.0 * f64::from(a[1])]
    }

    #[allow(clippy::cast_precision_loss, reason = "pixels in single precision")]
    fn fill<S: FragmentSink>([a, b, c]: [[f32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let (b, c) = if edge(a, b, c) < 0.0 { (c, b) } else { (b, c) };
        let low = |i: usize| [a, b, c].iter().filter_map(|v| v.get(i).copied()).fold(f32::INFINITY, f32::min);
        let high = |i: usize| [a, b, c].iter().filter_map(|v| v.get(i).copied()).fold(f32::NEG_INFINITY, f32::max);
        // Clockwise as y grows downwards: an upper edge leads to the right, a left one upwards.
        let covers = |from: [f32; 2], to: [f32; 2], p: [f32; 2]| {
            let e = edge(from, to, p);
            e > 0.0 || e == 0.0 && (from[1] > to[1] || from[1] == to[1] && from[0] < to[0])
        };
        for y in ceil(low(1) - 0.5).max(clip.rows.start)..ceil(high(1) + 0.5).min(clip.rows.end) {
            for x in ceil(low(0) - 0.5).max(clip.columns.start)..ceil(high(0) + 0.5).min(clip.columns.end) {
                sink.visit(x, y);
                let p = [x as f32 + 0.5, y as f32 + 0.5];
                if covers(a, b, p) && covers(b, c, p) && covers(c, a, p) {
                    sink.fragment(Fragment::pixel(x, y))?;
                }
            }
        }
        Ok(())
    }
}

/// The edge equation of a -> b: positive to its right.
fn edge(a: [f32; 2], b: [f32; 2], p: [f32; 2]) -> f32 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

fn difference(to: i32, from: i32) -> i128 {
    i128::from(to) - i128::from(from)
}

/// Two vertices' coordinates, one by one.
trait MapWith<T> {
    fn map_with<R>(self, other: Self, f: impl Fn(T, T) -> R) -> [R; 2];
}

impl<T> MapWith<T> for [T; 2] {
    fn map_with<R>(self, other: Self, f: impl Fn(T, T) -> R) -> [R; 2] {
        let ([x, y], [other_x, other_y]) = (self, other);
        [f(x, other_x), f(y, other_y)]
    }
}

/// The least integer that is not less; saturating, 0 for what is not a number.
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "saturating, and compared afterwards")]
pub(super) fn ceil(value: f32) -> i32 {
    let towards_zero = value as i32;
    towards_zero.saturating_add(i32::from((towards_zero as f32) < value))
}

/// Spans to fragments.
pub(super) struct Pixels<'s, S>(pub(super) &'s mut S);

impl<S: FragmentSink> SpanSink for Pixels<'_, S> {
    type Error = S::Error;

    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        for x in span.columns {
            self.0.visit(x, span.row);
            self.0.fragment(Fragment::pixel(x, span.row))?;
        }
        Ok(())
    }
}
