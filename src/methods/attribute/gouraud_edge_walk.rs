//! Gouraud shading by edge walking: along the edges, then along each span.
//!
//! Source: Gouraud, *Continuous shading of curved surfaces*, 1971; the lecture notes "6.837 Lecture 6" (MIT),
//! "Fractional Offsets": "The trick comes when interpolating color values. It is straightforward to interpolate along
//! the edges, but you must be careful when offsetting from the edge to the pixel's center."
//!
//! ```text
//!    xl       first centre                  on an edge's first row:  c = c0 + (Y - y0) dc/dy
//! ----|----------.----------.---- row       in a span:               c = cl + (X - xl) dc/dx
//!     |<-offset->|
//! ```
//!
//! Without the two offsets, colours start up to a pixel too late: a step of up to a pixel's worth of slope to and fro
//! between rows, which shows as a ragged shade along the edges. A division a channel and row.

use core::cmp::Ordering;

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    super::{
        number::Real,
        triangle::{
            dda_float::FloatDda,
            edge_walk::{Side, Spans, halves},
        },
    },
    Corner,
};

/// An edge on its way down with its colour.
#[derive(Debug, Clone, Copy)]
struct ShadedSide<R, const N: usize> {
    dda: FloatDda<R>,
    colour: [R; N],
    step: [R; N],
}

impl<R: Real, const N: usize> ShadedSide<R, N> {
    #[inline(always)]
    fn on_row(from: &Corner<R, N>, to: &Corner<R, N>, row: i32, with_offset: bool) -> Self {
        let height = to.y - from.y;
        let below = R::from_integer(row) + R::HALF - from.y;
        // Without an offset, the edge's first row has the vertex' own colour.
        let below = if with_offset { below } else { R::from_integer(below.floor()) };
        let mut colour = from.attributes.map(R::from_integer);
        let mut step = to.attributes.map(R::from_integer);
        for (colour, step) in colour.iter_mut().zip(&mut step) {
            *step = (*step - *colour) / height;
            *colour = *colour + below * *step;
        }
        Self { dda: FloatDda::on_row([from.x, from.y], [to.x, to.y], row), colour, step }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.dda.step();
        self.colour.iter_mut().zip(self.step).for_each(|(colour, step)| *colour = *colour + step);
    }
}

/// Fills the triangle in half-open spans; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn gouraud_edge_walk<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    with_offset: bool,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let by_height = |a: Corner<R, N>, b: Corner<R, N>| if b.y < a.y { (b, a) } else { (a, b) };
    let [a, b, c] = *corners;
    let (a, b) = by_height(a, b);
    let (b, bottom) = by_height(b, c);
    let (top, middle) = by_height(a, b);
    let vertices = [[top.x, top.y], [middle.x, middle.y], [bottom.x, bottom.y]];
    // NaN, too.
    if top.y.partial_cmp(&bottom.y) != Some(Ordering::Less) {
        return Ok(());
    }
    let [above, below] = halves::<FloatDda<R>>(&vertices, Spans::HalfOpen, clip);
    let breaks_right = FloatDda::breaks_right(&vertices);
    let first = if above.is_empty() { below.start } else { above.start };
    let mut long = ShadedSide::on_row(&top, &bottom, first, with_offset);
    for (from, to, rows) in [(top, middle, above), (middle, bottom, below)] {
        if rows.is_empty() {
            continue;
        }
        let mut short = ShadedSide::on_row(&from, &to, rows.start, with_offset);
        for y in rows {
            let (left, right) = if breaks_right { (&long, &short) } else { (&short, &long) };
            span(left, right, y, with_offset, clip, sink)?;
            long.step();
            short.step();
        }
    }
    Ok(())
}

#[inline(always)]
fn span<R: Real, const N: usize, S: FragmentSink<N>>(
    left: &ShadedSide<R, N>,
    right: &ShadedSide<R, N>,
    y: i32,
    with_offset: bool,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let columns = left.dda.ceil().max(clip.columns.start)..right.dda.ceil().min(clip.columns.end);
    let width = right.dda.x() - left.dda.x();
    let offset = R::from_integer(columns.start) + R::HALF - left.dda.x();
    let offset = if with_offset { offset } else { R::from_integer(offset.floor()) };
    let (mut colour, mut step) = (left.colour, right.colour);
    for (colour, step) in colour.iter_mut().zip(&mut step) {
        *step = (*step - *colour) / width;
        *colour = *colour + offset * *step;
    }
    for x in columns {
        sink.visit(x, y);
        sink.fragment(Fragment { x, y, coverage: 255, depth: 0, attributes: colour.map(Real::round) })?;
        colour.iter_mut().zip(step).for_each(|(colour, step)| *colour = *colour + step);
    }
    Ok(())
}
