//! Where a side of a stroke turns: from the end of one chord to the start of the next.
//!
//! `n` is the normal, the direction turned clockwise; a side lies on `+n` as it is gone along:
//!
//! ```text
//!     -------- direction ----> b                 outer: +n, the join, +n'; of a miter the tip alone
//!                              |                 inner: where both sides cross; +n, b, +n' where a chord is too
//!     ------------------------ b+n                      short for that
//! ```

use crate::{
    outline::{FinePoint, Vector},
    stroke::{
        Cap, Join,
        fan::{Fan, halved, halved_bend},
        normal::{UNIT_BITS, Unit},
    },
};

/// The vertices of one corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    at: FinePoint,
    radius: i64,
    from: Unit,
    to: Unit,
    /// Whether the vertex on `from` is one of its own, not the last of the corner before.
    has_from: bool,
    between: Between,
    pub(super) count: u32,
}

/// What lies between both normals.
#[derive(Debug, Clone, Copy)]
enum Between {
    Nothing,
    /// Where both sides cross: the only vertex.
    Crossing(FinePoint),
    Pivot,
    Tip(FinePoint),
    Square,
    /// An arc that is halved so often, with its points so far out.
    Fan {
        halvings: u32,
        reach: i64,
    },
}

/// What may be at a corner.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    Cap(Cap),
    Join(Join),
    /// Between the chords of a curve.
    Bend,
}

/// The points of a fan that are worked out together are so many at most.
const MOST_TOGETHER: u32 = 5;

impl Corner {
    pub(super) const NOTHING: Self = Self {
        at: FinePoint::from_bits(0, 0),
        radius: 0,
        from: Unit::RIGHT,
        to: Unit::RIGHT,
        has_from: false,
        between: Between::Nothing,
        count: 0,
    };

    /// `shorter` is the square of the length of the shorter of both chords.
    pub(super) fn new(
        at: FinePoint,
        radius: i64,
        [from, to]: [Unit; 2],
        kind: Kind,
        has_from: bool,
        shorter: u128,
        most_halvings: u32,
    ) -> Self {
        let fan = |halved: fn(i64, Unit, Unit, u32) -> (u32, i64)| match halved(radius, from, to, most_halvings) {
            (0, _) => Between::Nothing,
            (halvings, reach) => Between::Fan { halvings, reach },
        };
        let cross = from.cross(to);
        let is_same = from == to || radius == 0;
        let between = match kind {
            _ if is_same => Between::Nothing,
            Kind::Cap(Cap::Butt) => Between::Nothing,
            Kind::Cap(Cap::Square) => Between::Square,
            Kind::Cap(Cap::Round) => fan(halved),
            // Clockwise. Both sides cross at r tan(phi / 2) before the corner, which is |n' - n| / |n' + n|: within half
            // of each chord, so that no two crossings change their order.
            Kind::Join(_) | Kind::Bend if cross > 0 || (cross == 0 && from.dot(to) > 0) => {
                let square = |vector: Vector| vector.dot(vector).unsigned_abs();
                // At most 2^59 and 2^63; 2^66 and 2^63.
                let overlap = square(Vector::new(2 * radius, 0)).saturating_mul(square(to.0.minus(from.0)));
                let is_short = overlap > shorter.saturating_mul(square(to.0.plus(from.0)));
                match tip(at, radius, from, to) {
                    _ if is_short => Between::Pivot,
                    Some(crossing) if has_from => Between::Crossing(crossing),
                    _ => Between::Nothing,
                }
            }
            Kind::Join(Join::Bevel) => Between::Nothing,
            Kind::Join(Join::Miter { limit }) => match tip(at, radius, from, to) {
                // Both sides lead there.
                Some(tip) if is_within(from, to, limit) => {
                    if has_from {
                        Between::Crossing(tip)
                    } else {
                        Between::Tip(tip)
                    }
                }
                _ => Between::Nothing,
            },
            Kind::Bend => fan(halved_bend),
            Kind::Join(Join::Round) => match (fan(halved), tip(at, radius, from, to)) {
                // Of an arc that is as good as straight, the tip of r^2 phi^3 / 24 is too much, the chord of r^2 phi^3 / 12
                // too little.
                (Between::Nothing, Some(tip)) if has_from => Between::Crossing(tip),
                (fan, _) => fan,
            },
        };
        let middle = match between {
            Between::Nothing | Between::Crossing(_) => 0,
            Between::Pivot | Between::Tip(_) => 1,
            Between::Square => 2,
            Between::Fan { halvings, .. } => (1_u32 << halvings) - 1,
        };
        let has_to = !is_same && !matches!(between, Between::Crossing(_));
        let count = u32::from(has_from) + middle + u32::from(has_to);
        Self { at, radius, from, to, has_from, between, count }
    }

    /// The vertices that are of an arc, each with its number, where they are not too many.
    pub(super) fn fan(&self, found: &mut dyn FnMut(u32, FinePoint)) {
        let Self { at, from, to, has_from, between, .. } = *self;
        if let Between::Fan { halvings, reach } = between
            && halvings <= MOST_TOGETHER
        {
            let first = u32::from(has_from);
            let fan = Fan { center: at, reach, from, to, halvings };
            fan.points(&mut |index, point| found(first + index - 1, point));
        }
    }

    /// One of its vertices.
    #[inline]
    pub(super) fn vertex(&self, index: u32) -> FinePoint {
        let Self { at, radius, from, to, .. } = *self;
        if let Between::Crossing(crossing) = self.between {
            return crossing;
        }
        if index == 0 && self.has_from {
            return from.from(at, radius);
        }
        if index + 1 == self.count {
            return to.from(at, radius);
        }
        let index = index - u32::from(self.has_from);
        match self.between {
            Between::Nothing | Between::Pivot | Between::Crossing(_) => at,
            Between::Tip(tip) => tip,
            Between::Square => {
                let (across, ahead) = (from.times(radius), from.turned_back().times(radius));
                if index == 0 { across.plus(ahead).from(at) } else { ahead.minus(across).from(at) }
            }
            Between::Fan { halvings, reach } => Fan { center: at, reach, from, to, halvings }.point(index + 1),
        }
    }
}

/// Whether a miter is within its limit: `|n + n'|` is `2 cos(phi / 2)`, and the tip is `1 / cos(phi / 2)` away, so where
/// `4 <= limit^2 |n + n'|^2`.
fn is_within(from: Unit, to: Unit, limit: u32) -> bool {
    let sum = from.0.plus(to.0);
    let square = (sum.x * sum.x + sum.y * sum.y).unsigned_abs();
    4 << (2 * UNIT_BITS + 16) <= u128::from(limit) * u128::from(limit) * u128::from(square)
}

/// Where both sides meet: `p + 2 r (n + n') / |n + n'|^2`.
fn tip(at: FinePoint, radius: i64, from: Unit, to: Unit) -> Option<FinePoint> {
    let sum = from.0.plus(to.0);
    let square = sum.x * sum.x + sum.y * sum.y;
    if square == 0 {
        return None;
    }
    // Of a radius of 2^29 at most. The sum is no longer than the root of its square.
    const BITS: u32 = 62;
    let scale = (i128::from(2 * radius) << (UNIT_BITS + BITS)).checked_div(square.into())?;
    let part = |part: i64| {
        let tip = crate::outline::shift_half_even_wide(i128::from(part) * scale, BITS);
        i64::try_from(tip).unwrap_or(if tip < 0 { i64::MIN / 4 } else { i64::MAX / 4 })
    };
    Some(Vector::new(part(sum.x), part(sum.y)).from(at))
}
