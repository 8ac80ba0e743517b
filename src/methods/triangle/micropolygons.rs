//! Recursive subdivision of the primitive into micropolygons.
//!
//! Source: Cook, Carpenter and Catmull, *The Reyes image rendering architecture*, SIGGRAPH 1987: bound, split, dice,
//! sample; named in the lecture notes "6.837 Lecture 6" and "CISC 440/640 Lecture 13".
//!
//! ```text
//!        a                     A triangle off the screen is dropped (bound). One longer than half a pixel is cut at
//!       / \                    the middles of its edges into four (split). What is left has at most one pixel centre
//!     ab---ca                  in it, and draws that (sample).
//!     / \ / \
//!    b---bc--c
//! ```
//!
//! Cutting at the middles halves every edge, so the depth is `ceil(log2(longest / 128))`, 10 for a screen of 320 px, and
//! there are `4^depth` micropolygons whatever the area: those of a sliver lie on top of each other. Of a triangle of
//! 2^24 px, thousands of millions would meet the screen; so one longer than 2^13 px is refused.
//!
//! Middles that are rounded to 1/256 px move the pieces' edges; as `(a + b) >> 1` does not depend on the direction,
//! neighbours move alike and no crack opens, but the outline is off by up to 1/256 px. Middles in coordinates with
//! as many more bits as there are levels are exact.

use core::ops::Range;

use crate::{Fragment, FragmentSink, PixelRect};

use super::{Failure, exact::PIXEL};

/// Half a pixel, in 1/256: Reyes' micropolygons are about that long.
const LONGEST: i64 = 128;

/// 2^13 px, in 1/256: what is longer is refused.
const LIMIT: i64 = PIXEL << 13;

/// What middles are rounded to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Middles {
    /// 1/256 px.
    Rounded,
    /// As many more bits as there are levels.
    Exact,
}

/// The clip, and the coordinates' unit.
#[derive(Debug, Clone, Copy)]
struct Frame<'c> {
    clip: &'c PixelRect,
    /// Bits beyond 1/256 px.
    bits: u32,
}

type Piece = [[i64; 2]; 3];

/// Fills the triangle. A micropolygon that is sampled counts as one pixel looked at.
///
/// # Errors
///
/// The sink's; [`Failure::TooLong`], before anything is drawn.
pub fn micropolygons<S: FragmentSink>(
    v: &[[i32; 2]; 3],
    middles: Middles,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    let piece = v.map(|vertex| vertex.map(i64::from));
    if longest(&piece) > LIMIT {
        return Err(Failure::TooLong);
    }
    let mut bits = 0;
    // 14 at most, so that all values fit.
    while middles == Middles::Exact && longest(&piece) > LONGEST << bits {
        bits += 1;
    }
    Ok(split(piece.map(|vertex| vertex.map(|value| value << bits)), Frame { clip, bits }, sink)?)
}

#[inline(always)]
fn longest([[x0, y0], [x1, y1], [x2, y2]]: &Piece) -> i64 {
    let dx = (x1 - x0).abs().max((x2 - x1).abs()).max((x0 - x2).abs());
    let dy = (y1 - y0).abs().max((y2 - y1).abs()).max((y0 - y2).abs());
    dx.max(dy)
}

/// The pixels that the least and the largest of three coordinates lie in, once all are moved up by `offset`.
#[inline(always)]
fn pixels([a, b, c]: [i64; 3], offset: i64, bits: u32) -> (i64, i64) {
    let pixel = |value: i64| (value + (offset << bits)) >> (8 + bits);
    (pixel(a.min(b).min(c)), pixel(a.max(b).max(c)))
}

fn split<S: FragmentSink>(piece: Piece, frame: Frame<'_>, sink: &mut S) -> Result<(), S::Error> {
    let [a, b, c] = piece;
    let (xs, ys) = ([a[0], b[0], c[0]], [a[1], b[1], c[1]]);
    let meets = |(first, last): (i64, i64), clip: &Range<i32>| {
        !clip.is_empty() && first < i64::from(clip.end) && last >= i64::from(clip.start)
    };
    let PixelRect { rows, columns } = frame.clip;
    if !meets(pixels(xs, 0, frame.bits), columns) || !meets(pixels(ys, 0, frame.bits), rows) {
        return Ok(());
    }
    if longest(&piece) <= LONGEST << frame.bits {
        // No longer than half a pixel, so that no centre but the first at or after its left and top can be in it.
        let ((x, _), (y, _)) = (pixels(xs, PIXEL / 2 - 1, frame.bits), pixels(ys, PIXEL / 2 - 1, frame.bits));
        if !meets((x, x), columns) || !meets((y, y), rows) {
            return Ok(());
        }
        sink.visit(narrow(x), narrow(y));
        return if has_centre(&piece, x, y, frame.bits) {
            sink.fragment(Fragment::pixel(narrow(x), narrow(y)))
        } else {
            Ok(())
        };
    }
    let middle = |from: [i64; 2], to: [i64; 2]| [(from[0] + to[0]) >> 1, (from[1] + to[1]) >> 1];
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    for piece in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        split(piece, frame, sink)?;
    }
    Ok(())
}

/// The inside test with the top-left rule.
#[inline(always)]
fn has_centre(piece: &Piece, x: i64, y: i64, bits: u32) -> bool {
    let centre = |pixel: i64| (PIXEL * pixel + PIXEL / 2) << bits;
    let (px, py) = (centre(x), centre(y));
    let [v0, v1, v2] = *piece;
    let value = |[x0, y0]: [i64; 2], [x1, y1]: [i64; 2]| {
        let (a, b) = (y0 - y1, x1 - x0);
        let value = b * (py - y0) + a * (px - x0);
        (value, a > 0 || a == 0 && b > 0)
    };
    let edges = [value(v0, v1), value(v1, v2), value(v2, v0)];
    let area = edges.iter().map(|(value, _)| value).sum::<i64>();
    area != 0
        && edges.iter().all(|(value, is_left_or_top)| match value.signum() * area.signum() {
            0 => *is_left_or_top == (area > 0),
            sign => sign > 0,
        })
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "in the clip, which is of i32")]
fn narrow(pixel: i64) -> i32 {
    pixel as i32
}
