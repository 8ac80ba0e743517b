//! Arcs around a corner: round joins, round caps, and what opens between the chords of a curve.

use crate::{
    outline::{FinePoint, OutlineSink, Vector},
    stroke::normal::{UNIT, UNIT_BITS, Unit},
};

/// How far a chord may be from the arc, in 1/4096 pixel.
const TOLERANCE: i64 = 4;

/// An arc is halved so often at most: 2048 chords are enough for half a turn at a radius of 60,000 pixels.
const MOST_HALVINGS: u32 = 11;

/// The points of the arc around `center` between two directions, both left out: anticlockwise (as y grows downwards),
/// by at most half a turn.
///
/// By halving: the direction between two is that of their sum, or, where they are more than a quarter apart, across
/// their difference. Points are moved out by 11/16 of the sagitta, so that chords keep the arc's area (see
/// `outline::Curve`).
///
/// The square of the chord of the unit circle, `d`, becomes `d / (2 + 2 sqrt(1 - d/4))` when its arc is halved, and the
/// sagitta is `r d / 8`, to less than a tenth once `d < 1`.
pub(super) fn fan<S: OutlineSink>(sink: &mut S, center: FinePoint, radius: i64, from: Unit, to: Unit) {
    let between = to.0.minus(from.0);
    // Parts of at most 2^31.
    let mut square = (between.x * between.x).saturating_add(between.y * between.y) >> UNIT_BITS;
    let mut halvings = 0;
    while (radius * square) >> (UNIT_BITS + 3) >= TOLERANCE && halvings < MOST_HALVINGS {
        let cosine_square = (UNIT - square / 4).max(0);
        let cosine = (cosine_square << UNIT_BITS).cast_unsigned().isqrt().cast_signed();
        square = (square << UNIT_BITS) / (2 * (UNIT + cosine)).max(1);
        halvings += 1;
    }
    if halvings > 0 {
        let moved_out = (radius * square * 11) >> (UNIT_BITS + 7);
        halve(sink, center, radius + moved_out, from, to, halvings);
    }
}

fn halve<S: OutlineSink>(sink: &mut S, center: FinePoint, radius: i64, from: Unit, to: Unit, halvings: u32) {
    let Some(middle) = middle(from, to) else { return };
    if halvings > 1 {
        halve(sink, center, radius, from, middle, halvings - 1);
    }
    let FinePoint { x, y } = middle.from(center, radius);
    sink.point(x.into(), y.into());
    if halvings > 1 {
        halve(sink, center, radius, middle, to, halvings - 1);
    }
}

/// The direction between two, anticlockwise from the first.
fn middle(from: Unit, to: Unit) -> Option<Unit> {
    let Vector { x, y } = if from.dot(to) >= 0 { from.0.plus(to.0) } else { to.0.minus(from.0).turned() };
    Unit::along(Vector::new(x, y))
}
