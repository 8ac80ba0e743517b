//! The bands of an anti-aliased polygon: between two rows of 1/256 pixel on which no edge starts or ends, inside of a row of
//! pixels.
//!
//! Edges are straight in a band. If they leave it in the order they entered it in, none cross, and the winding number between
//! each and the next is the same all the way down: only edges with the inside on one side of them bound it, and the
//! area to their right is added to the cells or taken off. That is exact where contours overlap, too.
//!
//! Where edges cross in a band, those that do are a block of neighbours, which enters and leaves it in the same places of the
//! order. Only the block is cut at the crossings, from top to bottom, each time at the next crossing of two neighbours:
//!
//! ```text
//!        \   /      |
//!    - - -\-/- - -  |      the block's two edges change places;
//!          X        |      the edge to its right is in one piece
//!         / \       |
//! ```
//!
//! A crossing is off by up to 2^-31 of the band's height. In between, two edges are in the wrong order over a strip of that height.

use core::ops::Range;

use crate::{
    coverage::{Cells, CoverageSink, FULL, Ramp, Runs, Steepness, column_of, height_of, send_between},
    limits::ONE,
    shape::{active::CoverageEdge, outline::FillRule},
};

impl CoverageEdge {
    /// The edge's position `height` rows of 1/256 pixel farther down.
    #[inline(always)]
    pub(super) fn below_by(&self, height: i32) -> i64 {
        if self.edge.is_wide() {
            self.edge.position().wrapping_add(self.edge.step())
        } else {
            self.edge.position() + self.edge.step() * i64::from(height)
        }
    }

    /// The edge between two positions.
    #[inline(always)]
    pub(super) fn ramp(&self, from: i64, to: i64, height: u32) -> Ramp {
        let steepness =
            if self.edge.is_wide() { Steepness::of_positions(height, to.abs_diff(from)) } else { self.edge.steepness };
        Ramp::between(from, to, height, steepness)
    }
}

/// Adds up windings from left to right.
#[derive(Debug, Clone, Copy)]
pub(super) struct Winding {
    pub(super) number: i32,
    /// What is left of it decides: any of it, or whether it is odd.
    mask: i32,
}

impl Winding {
    pub(super) fn new(fill_rule: FillRule) -> Self {
        Self { number: 0, mask: fill_rule.mask() }
    }

    /// 1 where the next edge leads inside, -1 where it leads outside, 0 where it does neither.
    #[inline(always)]
    pub(super) fn cross(&mut self, winding: i32) -> i32 {
        let before = self.number & self.mask != 0;
        self.number += winding;
        i32::from(self.number & self.mask != 0) - i32::from(before)
    }
}

/// Adds a band, `height` rows of 1/256 pixel high, and takes the edges to its lower end.
///
/// They are in order at its upper end.
pub(super) fn add_band(edges: &mut [CoverageEdge], height: i32, fill_rule: FillRule, cells: &mut Cells<'_>) {
    let mut winding = Winding::new(fill_rule);
    if keep_their_order(edges, height) {
        for edge in edges {
            let sign = winding.cross(edge.winding());
            let (from, to) = (edge.edge.position(), edge.below_by(height));
            edge.edge.move_to(to);
            if sign != 0 {
                cells.add_ramp(&edge.ramp(from, to, height_of(height)), sign);
            }
        }
        return;
    }
    let mut start = 0;
    while start < edges.len() {
        let end = block_end(edges.get(start..).unwrap_or_default(), height) + start;
        match edges.get_mut(start..end) {
            Some([edge]) => {
                let sign = winding.cross(edge.winding());
                let (from, to) = (edge.edge.position(), edge.below_by(height));
                if sign != 0 {
                    cells.add_ramp(&edge.ramp(from, to, height_of(height)), sign);
                }
            }
            Some(block) => add_crossing(block, height, &mut winding, cells),
            None => return,
        }
        start = end;
    }
    for edge in edges {
        let below = edge.below_by(height);
        edge.edge.move_to(below);
    }
}

/// Whether edges leave the band in the order they entered it in.
#[inline(always)]
fn keep_their_order(edges: &[CoverageEdge], height: i32) -> bool {
    let mut before = i64::MIN;
    edges.iter().all(|edge| {
        let below = edge.below_by(height);
        core::mem::replace(&mut before, below) <= below
    })
}

/// Sends a whole row of pixels without cells, and takes the edges to its lower end, if no edges cross in it, and no two parts
/// of the inside share a pixel.
#[inline(always)]
pub(super) fn send_row<S: CoverageSink>(
    edges: &mut [CoverageEdge],
    fill_rule: FillRule,
    columns: &Range<i32>,
    runs: &mut Runs<'_, S>,
) -> Result<bool, S::Error> {
    let mut winding = Winding::new(fill_rule);
    let mut before = i64::MIN;
    let mut inside_until = i32::MIN;
    for edge in &*edges {
        let (from, to) = (edge.edge.position(), edge.below_by(ONE));
        if to < before {
            return Ok(false);
        }
        before = to;
        match winding.cross(edge.winding()) {
            1 if column_of(from.min(to)) <= inside_until => return Ok(false),
            -1 => inside_until = column_of(from.max(to)),
            _ => {}
        }
    }
    let mut left = Ramp::NONE;
    for edge in edges {
        let sign = winding.cross(edge.winding());
        let (from, to) = (edge.edge.position(), edge.below_by(ONE));
        edge.edge.move_to(to);
        if sign > 0 {
            left = edge.ramp(from, to, FULL);
        } else if sign < 0 {
            send_between(&left, &edge.ramp(from, to, FULL), columns, runs)?;
        }
    }
    runs.finish()?;
    Ok(true)
}

/// How many of the edges, from the first on, leave the band among themselves.
fn block_end(edges: &[CoverageEdge], height: i32) -> usize {
    let [first, others @ ..] = edges else { return 0 };
    let mut rightmost = first.below_by(height);
    let mut of_block = rightmost;
    let mut end = 1;
    for (index, edge) in others.iter().enumerate() {
        let below = edge.below_by(height);
        rightmost = rightmost.max(below);
        if below < of_block {
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
    let low = u64::from(distance as u32) * u64::from(part) >> 30;
    let moved = ((distance >> 32) * u64::from(part) << 2).wrapping_add(low);
    if to >= from { from.wrapping_add_unsigned(moved) } else { from.wrapping_sub_unsigned(moved) }
}

/// Where two neighbours cross that leave the band in the other order, as a part of its height.
fn crossing_of(left: &CoverageEdge, right: &CoverageEdge, height: i32) -> Option<u32> {
    let apart = right.below_by(height).wrapping_sub(left.below_by(height));
    if apart >= 0 {
        return None;
    }
    let at_top = u64::try_from(right.edge.position().wrapping_sub(left.edge.position())).unwrap_or(0);
    let sum = at_top.saturating_add(apart.unsigned_abs());
    // 31 bits of each are enough.
    let excess = 33_u32.saturating_sub(sum.leading_zeros());
    let part = ((at_top >> excess) << 30) / (sum >> excess).max(1);
    Some(u32::try_from(part).unwrap_or(WHOLE).min(WHOLE))
}

/// Adds a block of edges that cross, and leaves them in the order of the band's lower end.
#[inline(never)]
fn add_crossing(block: &mut [CoverageEdge], height: i32, winding: &mut Winding, cells: &mut Cells<'_>) {
    let mut upper = 0;
    loop {
        let next = block
            .windows(2)
            .enumerate()
            .filter_map(|(index, pair)| match pair {
                [left, right] => Some((crossing_of(left, right, height)?.max(upper), index)),
                _ => None,
            })
            .min();
        let lower = next.map_or(WHOLE, |(part, _)| part);
        let mut across = *winding;
        for edge in &*block {
            let sign = across.cross(edge.winding());
            if sign != 0 && upper < lower {
                let (from, to) = (edge.edge.position(), edge.below_by(height));
                let part = (u64::from(lower - upper) * u64::from(height_of(height))) >> 30;
                let part = u32::try_from(part).unwrap_or(FULL);
                cells.add_ramp(&edge.ramp(between(from, to, upper), between(from, to, lower), part), sign);
            }
        }
        let Some((_, index)) = next else {
            *winding = across;
            return;
        };
        block.swap(index, index + 1);
        upper = lower;
    }
}
