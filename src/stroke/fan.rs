//! Arcs around a corner: round joins, round caps, and what opens between the chords of a curve.

use crate::{
    outline::{FinePoint, Vector},
    stroke::normal::{UNIT, UNIT_BITS, Unit},
};

/// How far a chord may be from the arc, in 1/4096 pixel: `s`. What a pixel cuts out of chords of a length `l` adds up to
/// `0.13 s l` for each (see `outline::Curve`), and `l` is `sqrt(8 r s)`: the smaller the arc, the more may it be.
const fn tolerance(radius: i64) -> i64 {
    const PIXEL: i64 = 4096;
    if radius < PIXEL / 2 {
        24
    } else if radius < 2 * PIXEL {
        16
    } else if radius < 8 * PIXEL {
        8
    } else {
        4
    }
}

/// An arc is halved so often at most: 2048 chords are enough for half a turn at a radius of 60,000 pixels.
pub(super) const MOST_HALVINGS: u32 = 11;

/// How often the arc between two directions is halved, `most` at most, and how far out its points are.
///
/// The square of the chord of the unit circle, `d`, becomes `d / (2 + 2 sqrt(1 - d/4))` when its arc is halved, and the
/// sagitta is `r d / 8`, to less than a tenth once `d < 1`.
pub(super) fn halved(radius: i64, from: Unit, to: Unit, most: u32) -> (u32, i64) {
    let (halvings, square) = chords(radius, from, to, tolerance(radius), most);
    let chords = 1_i64 << halvings;
    let moved_out = ((radius * square) >> UNIT_BITS) * chords;
    (halvings, radius + (moved_out + 6 * (chords - 1)) / (12 * (chords - 1)).max(1))
}

/// The same between the chords of a curve, which have moved out by themselves: points by 11/16 of the sagitta.
pub(super) fn halved_bend(radius: i64, from: Unit, to: Unit, most: u32) -> (u32, i64) {
    let (halvings, square) = chords(radius, from, to, 4, most);
    (halvings, radius + ((radius * square * 11) >> (UNIT_BITS + 7)))
}

/// How often it is halved, and the square of the chords that result.
fn chords(radius: i64, from: Unit, to: Unit, tolerance: i64, most: u32) -> (u32, i64) {
    let between = to.0.minus(from.0);
    // Parts of at most 2^31.
    let mut square = (between.x * between.x).saturating_add(between.y * between.y) >> UNIT_BITS;
    let mut halvings = 0;
    while (radius * square) >> (UNIT_BITS + 3) >= tolerance && halvings < most {
        let cosine_square = (UNIT - square / 4).max(0);
        let cosine = (cosine_square << UNIT_BITS).cast_unsigned().isqrt().cast_signed();
        square = (square << UNIT_BITS) / (2 * (UNIT + cosine)).max(1);
        halvings += 1;
    }
    (halvings, square)
}

/// The arc around `center` between two directions: anticlockwise (as y grows downwards), by at most half a turn.
///
/// By halving: the direction between two is that of their sum, or, where they are more than a quarter apart, across
/// their difference. Its points, but not its ends, are moved out so that `n` chords of an angle `a` keep the area of the
/// arc: by `r a^2 / 12 * n / (n - 1)`, as `r (r + m) sin a + (n - 2) / 2 (r + m)^2 sin a` is to be `r^2 n a / 2`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fan {
    pub(super) center: FinePoint,
    /// How far out the points are.
    pub(super) reach: i64,
    pub(super) from: Unit,
    pub(super) to: Unit,
    pub(super) halvings: u32,
}

impl Fan {
    /// All of its points, with their numbers.
    pub(super) fn points(&self, found: &mut dyn FnMut(u32, FinePoint)) {
        self.halve(self.from, self.to, 0, 1 << self.halvings.min(MOST_HALVINGS), found);
    }

    fn halve(&self, from: Unit, to: Unit, first: u32, last: u32, found: &mut dyn FnMut(u32, FinePoint)) {
        if last - first < 2 {
            return;
        }
        let Some(middle) = between(from, to) else { return };
        let half = first.midpoint(last);
        found(half, middle.from(self.center, self.reach));
        self.halve(from, middle, first, half, found);
        self.halve(middle, to, half, last, found);
    }

    /// One of its points, from 1 to `2^halvings - 1`.
    pub(super) fn point(&self, index: u32) -> FinePoint {
        let (mut from, mut to) = (self.from, self.to);
        let mut half = 1_u32 << self.halvings.min(MOST_HALVINGS) >> 1;
        let mut rest = index;
        let mut middle = from;
        while half > 0 {
            middle = between(from, to).unwrap_or(middle);
            if rest == half {
                break;
            }
            if rest > half {
                (from, rest) = (middle, rest - half);
            } else {
                to = middle;
            }
            half >>= 1;
        }
        middle.from(self.center, self.reach)
    }
}

/// The direction between two, anticlockwise from the first.
fn between(from: Unit, to: Unit) -> Option<Unit> {
    let Vector { x, y } = if from.dot(to) >= 0 { from.0.plus(to.0) } else { to.0.minus(from.0).turned() };
    Unit::along(Vector::new(x, y))
}
