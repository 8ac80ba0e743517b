//! Chains whose extents overlap, from left to right: compared along the heights that they share.
//!
//! The order is not transitive where two share no height, so every pair that overlaps is compared. Those that cross, and
//! what lies between them, are joined, to be swept together. What is not joined lies on one side of the other at every
//! height.

use crate::area::{
    chain::{CoverageEdge, Line, State},
    source::Source,
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
pub(super) fn put_in_order(table: &mut Table<'_, '_>, place: usize, end: usize, row_top: i32) {
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
            let side = if left.high <= low { Side::Left } else { side(left, &chain, &table.source, row_top) };
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
fn side(a: &CoverageEdge, b: &CoverageEdge, source: &Source<'_>, row_top: i32) -> Side {
    if let (Some(a), Some(b)) = (a.ends_if_single(), b.ends_if_single()) {
        return Side::Same.and(a.0 - b.0).and(a.1 - b.1);
    }
    let (mut a_lines, mut b_lines) = (a.lines(source, row_top), b.lines(source, row_top));
    let (mut a, mut b) = (a_lines.next(), b_lines.next());
    let mut side = Side::Same;
    while let (Some(one), Some(other)) = (a, b) {
        let (top, bottom) = (one.y0.max(other.y0), one.y1.min(other.y1));
        if top < bottom {
            side = side.and(apart(&one, &other, top)).and(apart(&one, &other, bottom));
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

/// How far apart two lines are at a height, up to a rounding.
fn apart(a: &Line, b: &Line, y: i32) -> i64 {
    a.x_at(y) - b.x_at(y)
}

impl Side {
    /// With what is known of one more height.
    #[inline]
    fn and(self, apart: i64) -> Self {
        let here = if apart < -TOLERANCE {
            Self::Left
        } else if apart > TOLERANCE {
            Self::Right
        } else {
            Self::Same
        };
        match (self, here) {
            (side, Self::Same) => side,
            (Self::Same, side) => side,
            (one, other) if one == other => one,
            _ => Self::Across,
        }
    }
}
