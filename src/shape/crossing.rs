//! Bands in which edges cross.
//!
//! Edges that cross are a block of neighbours, which enters and leaves the band in the same places of the order. Only the
//! block is cut at the crossings, from top to bottom, each time at the next crossing of two neighbours:
//!
//! ```text
//!        \   /      |
//!    - - -\-/- - -  |      the block's two edges change places;
//!          X        |      the edge to its right is in one piece
//!         / \       |
//! ```
//!
//! A crossing is off by up to 2^-30 of the band's height: two edges are in the wrong order in a strip so high.

use crate::{
    coverage::{Cells, FULL, height_of},
    shape::{
        active::CoverageEdge,
        bands::{Band, SLACK, Winding},
        outline::FillRule,
    },
};

impl Band {
    /// Adds a band in which some edges cross, and takes all of them to its lower end; they are in order at its upper end.
    #[inline(never)]
    pub(super) fn add_crossing<const WIDE: bool>(
        self,
        edges: &mut [CoverageEdge],
        fill_rule: FillRule,
        cells: &mut Cells<'_>,
    ) {
        let mut least = i64::MAX;
        for edge in edges.iter_mut().rev() {
            let below = edge.below_by::<WIDE>(self.height);
            edge.set_least(below <= least);
            least = least.min(below);
        }
        let mut winding = Winding::new(fill_rule);
        let mut rest = edges;
        while !rest.is_empty() {
            let end = block_end::<WIDE>(rest, self.height);
            let Some((block, others)) = rest.split_at_mut_checked(end) else { return };
            rest = others;
            if let [edge] = block {
                self.add_edge::<WIDE>(edge, winding.cross(edge.winding()), cells);
                continue;
            }
            for edge in &mut *block {
                edge.add_put_off(edge.edge.position(), self.offsets().0, cells);
            }
            add_block::<WIDE>(block, self.height, &mut winding, cells);
            for edge in block {
                let below = edge.below_by::<WIDE>(self.height);
                edge.edge.move_to(below);
            }
        }
    }
}

/// How many of the edges, from the first on, leave the band among themselves.
///
/// Those to the right of a place leave it no farther left than the first of them that is marked, so it is enough to compare
/// that one with what is to the left.
fn block_end<const WIDE: bool>(edges: &[CoverageEdge], height: i32) -> usize {
    let [first, others @ ..] = edges else { return 0 };
    let mut rightmost = first.below_by::<WIDE>(height);
    let mut of_block = rightmost;
    let mut end = 1;
    for (index, edge) in others.iter().enumerate() {
        let below = edge.below_by::<WIDE>(height);
        rightmost = rightmost.max(below);
        if edge.is_least() {
            if of_block <= below.saturating_add(SLACK) {
                break;
            }
            end = index + 2;
            of_block = rightmost;
        }
    }
    end
}

/// All of a band's height.
const WHOLE: u32 = 1 << 30;

/// The position, `part` of the way down.
#[inline]
fn between(from: i64, to: i64, part: u32) -> i64 {
    let distance = to.abs_diff(from);
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    let low = (u64::from(distance as u32) * u64::from(part)) >> 30;
    // At most the distance: what wraps on the way comes back.
    let moved = ((distance >> 32) * u64::from(part)).wrapping_shl(2).wrapping_add(low);
    if to >= from { from.wrapping_add_unsigned(moved) } else { from.wrapping_sub_unsigned(moved) }
}

/// Where two neighbours cross that leave the band in the other order, as a part of its height.
fn crossing_of<const WIDE: bool>(left: &CoverageEdge, right: &CoverageEdge, height: i32) -> Option<u32> {
    let (left_end, right_end) = (left.below_by::<WIDE>(height), right.below_by::<WIDE>(height));
    if left_end <= right_end {
        return None;
    }
    let (left_start, right_start) = (left.edge.position(), right.edge.position());
    let before = if left_start < right_start { left_start.abs_diff(right_start) } else { 0 };
    let after = left_end.abs_diff(right_end);
    // So that neither their sum nor the product overflows; 32 bits of the greater are enough.
    let excess = 34_u32.saturating_sub((before | after).leading_zeros());
    let (before, after) = (before >> excess, after >> excess);
    let part = (before << 30) / (before + after).max(1);
    Some(u32::try_from(part).unwrap_or(WHOLE).min(WHOLE))
}

/// Adds a block of edges that cross, and leaves them in the order of the band's lower end.
#[inline(never)]
fn add_block<const WIDE: bool>(block: &mut [CoverageEdge], height: i32, winding: &mut Winding, cells: &mut Cells<'_>) {
    let mut upper = 0;
    loop {
        let next = block
            .windows(2)
            .enumerate()
            .filter_map(|(index, pair)| match pair {
                [left, right] => Some((crossing_of::<WIDE>(left, right, height)?.max(upper), index)),
                _ => None,
            })
            .min();
        let lower = next.map_or(WHOLE, |(part, _)| part);
        let mut across = *winding;
        for edge in &*block {
            let sign = across.cross(edge.winding());
            if sign != 0 && upper < lower {
                let (from, to) = (edge.edge.position(), edge.below_by::<WIDE>(height));
                let part = (u64::from(lower - upper) * u64::from(height_of(height))) >> 30;
                let part = u32::try_from(part).unwrap_or(FULL);
                cells.add_ramp(&edge.ramp::<WIDE>(between(from, to, upper), between(from, to, lower), part), sign);
            }
        }
        let Some((_, index)) = next else {
            *winding = across;
            return;
        };
        if let Some([left, right]) = block.get_mut(index..=index + 1) {
            core::mem::swap(left, right);
        }
        upper = lower;
    }
}
