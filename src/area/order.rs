//! Chains whose extents overlap, from left to right: compared along the heights that they share.
//!
//! The order is not transitive where two share no height, so every pair that overlaps is compared. Those that cross, and
//! what lies between them, are joined, to be swept together. What is not joined lies on one side of the other at every
//! height.

use crate::area::{
    chain::{CoverageEdge, State},
    line::Line,
    lines::Row,
    table::Table,
};

/// What rounding may make of two columns that are equal, in 2^-32 pixel: 2^-18 pixel.
const TOLERANCE: i64 = 1 << 14;

/// Where one chain lies, seen from another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
    /// Nowhere apart, or at no height together.
    Same,
    /// On both sides.
    Across,
}

/// Puts the chains of a group in order, and joins those that cross.
#[inline(never)]
pub(super) fn put_in_order(table: &mut Table<'_, '_>, place: usize, end: usize, (top, kept): (i32, &[Line])) {
    if let Some(first) = table.chain_mut(place) {
        (first.state, first.next) = (State::Active, first.high.cast_unsigned());
    }
    for new in place + 1..end {
        let low = table.place(new).low;
        let Some(&chain) = table.chain(new) else { return };
        // Where it has to go at the latest, and at the earliest; what has to be joined.
        let (mut to, mut behind) = (new, place);
        let (mut first_crossed, mut behind_crossed) = (new, place);
        for other in (place..new).rev() {
            let Some(left) = table.chain(other) else { return };
            // No chain up to there reaches this one.
            if left.next.cast_signed() <= low {
                break;
            }
            if left.top >= chain.bottom || chain.top >= left.bottom {
                continue;
            }
            let side = if left.high <= low {
                Side::Left
            } else {
                side(left, &chain, &Row { source: table.source, top, kept })
            };
            match side {
                Side::Left => behind = behind.max(other + 1),
                Side::Right => to = other,
                Side::Same => {}
                Side::Across => {
                    first_crossed = other;
                    behind_crossed = behind_crossed.max(other + 1);
                }
            }
        }
        // It goes to `at`, joined with all from `first` on: with what it crosses, or what contradicts the order.
        let crosses = first_crossed < new;
        let at = if crosses { behind.max(behind_crossed) } else { to.max(behind) };
        insert(table, place, new, at, to.min(first_crossed).min(at));
    }
}

/// Moves the chain at `new` to `at`, and joins it with all from `first` on.
fn insert(table: &mut Table<'_, '_>, place_of_group: usize, new: usize, at: usize, first: usize) {
    let place = table.place(new);
    for left in (at..new).rev() {
        let moved = table.place(left);
        table.set_place(left + 1, moved);
    }
    table.set_place(at, place);
    // How far those up to each place reach.
    let mut reach =
        (at > place_of_group).then(|| table.chain(at - 1)).flatten().map_or(i32::MIN, |left| left.next.cast_signed());
    for moved in at..=new {
        if let Some(chain) = table.chain_mut(moved) {
            reach = reach.max(chain.high);
            chain.next = reach.cast_unsigned();
        }
    }
    // Within what is joined it has to be joined, too.
    let splits = at < new && table.chain(at + 1).is_some_and(|chain| chain.state == State::Joined);
    if let Some(chain) = table.chain_mut(at) {
        chain.state = if splits { State::Joined } else { State::Active };
    }
    for joined in first + 1..=at {
        if let Some(chain) = table.chain_mut(joined) {
            chain.state = State::Joined;
        }
    }
}

/// Where `a` lies, seen from `b`.
fn side(a: &CoverageEdge, b: &CoverageEdge, row: &Row<'_>) -> Side {
    if let (Some(a), Some(b)) = (a.ends_if_single(), b.ends_if_single()) {
        return Side::Same.and(Side::of(a.0 - b.0)).and(Side::of(a.1 - b.1));
    }
    let (mut a_lines, mut b_lines) = (a.lines(row), b.lines(row));
    let (mut a, mut b) = (a_lines.next(), b_lines.next());
    let mut side = Side::Same;
    while let (Some(one), Some(other)) = (a, b) {
        let (top, bottom) = (one.y0.max(other.y0), one.y1.min(other.y1));
        if top < bottom {
            side = match clearly_apart(&one, &other) {
                Some(apart) => side.and(apart),
                None => side.and(side_at(&one, &other, top)).and(side_at(&one, &other, bottom)),
            };
            if side == Side::Across {
                return side;
            }
        }
        if one.y1 <= other.y1 {
            a = a_lines.next();
        } else {
            b = b_lines.next();
        }
    }
    side
}

/// Of two lines that share no column.
#[inline]
fn clearly_apart(a: &Line, b: &Line) -> Option<Side> {
    if a.x0.max(a.x1) - b.x0.min(b.x1) < -TOLERANCE {
        Some(Side::Left)
    } else {
        (a.x0.min(a.x1) - b.x0.max(b.x1) > TOLERANCE).then_some(Side::Right)
    }
}

/// At a height at which one of them begins or ends.
///
/// At `y` the other is at `x0 + floor(dx (y - y0) / dy)`, and `floor(n / d) < k` means `n < k d`: so there is no division. The
/// products have 62 bits, as lines reach 2^46.
#[inline]
fn side_at(a: &Line, b: &Line, y: i32) -> Side {
    let end = |line: &Line| {
        if y == line.y0 { Some(line.x0) } else { (y == line.y1).then_some(line.x1) }
    };
    let (x, line, is_reversed) = match end(a) {
        Some(x) => (x, b, false),
        None => (end(b).unwrap_or(b.x1), a, true),
    };
    let (moved, height) = ((line.x1 - line.x0) * i64::from(y - line.y0), i64::from(line.y1 - line.y0));
    let distance = x - line.x0;
    let side = if moved >= (distance + TOLERANCE + 1) * height {
        Side::Left
    } else if moved < (distance - TOLERANCE) * height {
        Side::Right
    } else {
        Side::Same
    };
    match side {
        Side::Left if is_reversed => Side::Right,
        Side::Right if is_reversed => Side::Left,
        side => side,
    }
}

impl Side {
    /// At a height at which one is so far from the other.
    #[inline]
    fn of(apart: i64) -> Self {
        if apart < -TOLERANCE {
            Self::Left
        } else if apart > TOLERANCE {
            Self::Right
        } else {
            Self::Same
        }
    }

    /// With what is known of one more height.
    #[inline]
    fn and(self, here: Self) -> Self {
        match (self, here) {
            (side, Self::Same) | (Self::Same, side) => side,
            (one, other) if one == other => one,
            _ => Self::Across,
        }
    }
}
