//! Perspective in affine pieces: right at every 16th pixel of a span, linear in between.
//!
//! Source: Hecker, *Perspective texture mapping*, Game Developer 1995-96; Heckbert and Moreton, *Interpolation for
//! polygon texture mapping and shading*, 1991.
//!
//! A division a piece in place of one a pixel. Over a piece whose ends have 1/w in the ratio r, linear interpolation is
//! off by at most `|s1 - s0| |sqrt(r) - 1| / (sqrt(r) + 1)`. The last piece ends at the last pixel of its span, not
//! beyond, where 1/w may be 0.

use crate::{Fragment, FragmentSink, PixelRect};

use super::{
    super::number::Real,
    Corner, channels,
    plane::{Plane, Setup, step},
};

/// How many pixels a piece has.
const PIECE: i32 = 16;

/// Fills the triangle; values are rounded to the nearest.
///
/// # Errors
///
/// The sink's.
#[inline(always)]
pub fn affine_pieces<R: Real, const N: usize, S: FragmentSink<N>>(
    corners: &[Corner<R, N>; 3],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let Some(setup) = Setup::new(corners) else { return Ok(()) };
    let [w0, w1, w2] = corners.map(|corner| R::ONE / corner.w);
    let over_w = channels(corners).map(|[s0, s1, s2]| setup.plane([s0 * w0, s1 * w1, s2 * w2]));
    let one_over_w = setup.plane([w0, w1, w2]);
    let PixelRect { rows, columns } = setup.bounds(clip);
    for y in rows {
        let mut e = setup.edges.map(|edge| edge.at(columns.start, y));
        // The span: the first pixel inside, and the last.
        let mut span = None;
        for x in columns.clone() {
            sink.visit(x, y);
            if e.iter().all(|value| *value >= R::ZERO) {
                span = Some((span.map_or(x, |(first, _)| first), x));
            } else if span.is_some() {
                break;
            }
            step(&mut e, &setup.edges, |plane| plane.a);
        }
        let Some((first, last)) = span else { continue };
        pieces(first, last, y, &over_w, &one_over_w, sink)?;
    }
    Ok(())
}

#[inline(always)]
fn pieces<R: Real, const N: usize, S: FragmentSink<N>>(
    first: i32,
    last: i32,
    y: i32,
    over_w: &[Plane<R>; N],
    one_over_w: &Plane<R>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let exact = |x: i32| {
        let w = R::ONE / one_over_w.at(x, y);
        over_w.map(|plane| plane.at(x, y) * w)
    };
    let (mut start, mut values) = (first, exact(first));
    loop {
        let end = start.saturating_add(PIECE).min(last);
        let at_end = exact(end);
        // 1 for the piece of one pixel, whose step is not taken.
        let length = R::from_integer(end.saturating_sub(start).max(1));
        let mut steps = at_end;
        steps.iter_mut().zip(values).for_each(|(step, value)| *step = (*step - value) / length);
        // The last piece has its end as well.
        for x in start..if end == last { end.saturating_add(1) } else { end } {
            sink.fragment(Fragment { x, y, coverage: 255, depth: 0, attributes: values.map(Real::round) })?;
            values.iter_mut().zip(steps).for_each(|(value, step)| *value = *value + step);
        }
        if end == last {
            return Ok(());
        }
        (start, values) = (end, at_end);
    }
}
