//! Edge walking: down the left and the right edge at once, filling in between, until a break point or the bottom.
//!
//! Source: the lecture notes "6.837 Lecture 6: Scan Converting Triangles" (MIT) and "CISC 440/640 Lecture 13"
//! (Delaware); fractional offsets as in Hecker, *Perspective texture mapping*, Game Developer 1995-96.
//!
//! ```text
//! top .             rows whose centre lies between the vertices; on the first, an edge starts not at its vertex but
//!     |\            a fraction of a row below, x0 + (Y - y0) dx/dy: the fractional offset
//!     | \
//!     |  . middle   the break point, on the left or on the right; there a side changes its edge
//!     | /
//!     .             bottom
//! ```
//!
//! "We can use *ceiling* to find the leftmost pixel in span and *floor* to find the rightmost": a closed span, which has
//! the pixels whose centres lie exactly on either edge, so that neighbours both draw those of their common edge. A
//! half-open span ends before the ceiling of the right edge, and rows before the ceiling of the bottom: the top-left
//! rule.

use core::{cmp::Ordering, fmt::Debug, ops::Range};

use crate::{Fragment, FragmentSink, PixelRect};

/// An edge on its way down, at the centre of a row.
pub trait Side: Copy + Debug {
    /// What vertices are given in.
    type Coordinate: Copy + PartialOrd;

    /// The edge from `top` to `bottom`, which is further down, on a row.
    fn on_row(top: [Self::Coordinate; 2], bottom: [Self::Coordinate; 2], row: i32) -> Self;

    /// To the next row.
    fn step(&mut self);

    /// The first pixel whose centre is on the edge or to the right of it.
    fn ceil(&self) -> i32;

    /// The last pixel whose centre is on the edge or to the left of it.
    fn floor(&self) -> i32;

    /// The first row whose centre is at y or below.
    fn ceil_row(y: Self::Coordinate) -> i32;

    /// The last row whose centre is at y or above.
    fn floor_row(y: Self::Coordinate) -> i32;

    /// Whether the break point lies to the right of the edge from top to bottom.
    fn breaks_right(vertices: &[[Self::Coordinate; 2]; 3]) -> bool;
}

/// Which pixels on the outline belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Spans {
    /// By ceiling and floor.
    Closed,
    /// From ceiling to before ceiling.
    HalfOpen,
}

/// The vertices from top to bottom.
#[inline(always)]
pub fn sorted<C: Copy + PartialOrd>(v: &[[C; 2]; 3]) -> [[C; 2]; 3] {
    let by_height = |a: [C; 2], b: [C; 2]| if b[1] < a[1] { (b, a) } else { (a, b) };
    let [a, b, c] = *v;
    let (a, b) = by_height(a, b);
    let (b, c) = by_height(b, c);
    let (a, b) = by_height(a, b);
    [a, b, c]
}

/// The rows above and below the break point, in the clip.
#[inline(always)]
pub fn halves<E: Side>(
    [top, middle, bottom]: &[[E::Coordinate; 2]; 3],
    spans: Spans,
    clip: &PixelRect,
) -> [Range<i32>; 2] {
    let end_at = |y: E::Coordinate| match spans {
        Spans::HalfOpen => E::ceil_row(y),
        Spans::Closed => E::floor_row(y).saturating_add(1),
    };
    let end = end_at(bottom[1]);
    // A flat bottom has no edge below the break point: the row that it may lie on belongs above.
    let turn = if middle[1] < bottom[1] { E::ceil_row(middle[1]) } else { end };
    let clamp = |row: i32| row.min(clip.rows.end).max(clip.rows.start);
    let (first, turn, end) = (clamp(E::ceil_row(top[1])), clamp(turn), clamp(end));
    // A flat top has no edge above it.
    let first_half = if top[1] < middle[1] { first } else { turn };
    [first_half..turn, turn..end]
}

/// Fills the triangle.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn edge_walk<E: Side, S: FragmentSink>(
    v: &[[E::Coordinate; 2]; 3],
    spans: Spans,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let vertices = sorted(v);
    let [top, middle, bottom] = vertices;
    if top[1].partial_cmp(&bottom[1]) != Some(Ordering::Less) {
        return Ok(());
    }
    let breaks_right = E::breaks_right(&vertices);
    let [above, below] = halves::<E>(&vertices, spans, clip);
    let mut long = E::on_row(top, bottom, if above.is_empty() { below.start } else { above.start });
    for (from, to, rows) in [(top, middle, above), (middle, bottom, below)] {
        if rows.is_empty() {
            continue;
        }
        let mut short = E::on_row(from, to, rows.start);
        for y in rows {
            let (left, right) = if breaks_right { (&long, &short) } else { (&short, &long) };
            let end = match spans {
                Spans::HalfOpen => right.ceil(),
                Spans::Closed => right.floor().saturating_add(1),
            };
            for x in left.ceil().max(clip.columns.start)..end.min(clip.columns.end) {
                sink.visit(x, y);
                sink.fragment(Fragment::pixel(x, y))?;
            }
            long.step();
            short.step();
        }
    }
    Ok(())
}
