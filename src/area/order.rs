//! Chains whose extents overlap, from left to right: compared along the heights that they share.

use crate::area::{
    chain::{CoverageEdge, Line},
    source::Source,
    table::Table,
};

/// What rounding may make of two columns that are equal, in 2^-32 pixel: 2^-18 pixel.
pub(super) const TOLERANCE: i64 = 1 << 14;

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

/// Puts the chains of a group in order; `false` where some of them cross.
///
/// The order is not transitive where two share no height, so every pair that overlaps is compared.
pub(super) fn put_in_order(table: &mut Table<'_, '_>, place: usize, end: usize, row_top: i32) -> bool {
    for new in place + 1..end {
        let Some(&chain) = table.chain_ref(new) else { return true };
        // Where it has to go, and behind what.
        let (mut to, mut behind) = (new, place);
        for other in (place..new).rev() {
            let Some(left) = table.chain_ref(other) else { return true };
            if left.top >= chain.bottom || chain.top >= left.bottom {
                continue;
            }
            let side = if left.high <= chain.low { Side::Left } else { side(left, &chain, &table.source, row_top) };
            match side {
                Side::Left => behind = behind.max(other + 1),
                Side::Right => to = other,
                Side::Same => {}
                Side::Across => return false,
            }
        }
        if to < behind {
            return false;
        }
        let slot = table.slot_of(new);
        for at in (to..new).rev() {
            let left = table.slot_of(at);
            table.set_order(at + 1, left);
        }
        table.set_order(to, slot);
    }
    true
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
    #[inline(always)]
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
