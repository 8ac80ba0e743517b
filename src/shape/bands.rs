//! The bands of an anti-aliased polygon: between two rows of 1/256 pixel on which no edge starts or ends, inside of a row of
//! pixels.
//!
//! Edges are straight in a band. If they leave it in the order they entered it in, none cross, and the winding number between
//! each and the next is the same all the way down: only edges with the inside on one side of them bound it, and the
//! area to their right is added to the cells or taken off. That is exact where contours overlap, too. What an edge leaves is put
//! off, from band to band, until it ends, leaves the row, or has the inside on another side: then it is added as one ramp.
//!
//! Where edges cross in a band, see `crossing`.

use crate::{
    coverage::{Cells, Extent, Ramp, Steepness, height_of},
    limits::ONE,
    shape::{active::CoverageEdge, outline::FillRule, table::sort},
};

impl CoverageEdge {
    /// The edge's position `height` rows of 1/256 pixel farther down; for a wide one, at the end of the band.
    #[inline(always)]
    pub(super) fn below_by<const WIDE: bool>(&self, height: i32) -> i64 {
        if WIDE && self.edge.is_wide() {
            self.edge.position().wrapping_add(self.edge.band_step())
        } else {
            self.edge.position() + self.edge.step() * i64::from(height)
        }
    }

    /// The edge between two positions.
    #[inline(always)]
    pub(super) fn ramp<const WIDE: bool>(&self, from: i64, to: i64, height: u32) -> Ramp {
        let steepness = if WIDE && self.edge.is_wide() {
            Steepness::of_positions(height, to.abs_diff(from))
        } else {
            self.edge.steepness
        };
        Ramp::new(Extent::between(from, to), height, steepness)
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

/// A band of a row of pixels: `height` rows of 1/256 pixel, from the one at `y` on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Band {
    pub(super) y: i32,
    pub(super) height: i32,
}

/// The sign that an edge has had so far, plus this, is marked: while it keeps it, what it leaves is not added, but once, in the end,
/// in place of once a band.
const SIGN_MARK: i32 = 2;

impl Band {
    /// The scan line in its row that it begins with, and the one after its last.
    #[inline(always)]
    pub(super) fn offsets(self) -> (i32, i32) {
        let offset = self.y & (ONE - 1);
        (offset, offset + self.height)
    }

    /// Adds the band, and takes the edges to its lower end; they are in order at its upper end, but for some that meet there.
    ///
    /// `WIDE`: some are not in the narrow zone.
    pub(super) fn add<const WIDE: bool>(self, edges: &mut [CoverageEdge], fill_rule: FillRule, cells: &mut Cells<'_>) {
        if !keep_their_order::<WIDE>(edges, self.height) {
            // Those that cross where the band begins are in the order of the band above.
            sort(edges);
            if !keep_their_order::<WIDE>(edges, self.height) {
                return self.add_crossing::<WIDE>(edges, fill_rule, cells);
            }
        }
        let mut winding = Winding::new(fill_rule);
        for edge in edges {
            self.add_edge::<WIDE>(edge, winding.cross(edge.winding()), cells);
        }
    }

    /// Adds or puts off what an edge that crosses none leaves, and takes it to the band's lower end.
    #[inline(always)]
    pub(super) fn add_edge<const WIDE: bool>(self, edge: &mut CoverageEdge, sign: i32, cells: &mut Cells<'_>) {
        let (offset, end_offset) = self.offsets();
        let (from, to) = (edge.edge.position(), edge.below_by::<WIDE>(self.height));
        edge.edge.move_to(to);
        let mark = edge.edge.steepness.mark();
        let is_over = WIDE || end_offset == ONE || edge.until == self.y + self.height;
        if mark == 0 && is_over {
            if sign != 0 {
                cells.add_ramp(&edge.ramp::<WIDE>(from, to, height_of(self.height)), sign);
            }
            return;
        }
        if mark != sign + SIGN_MARK {
            edge.add_put_off(from, offset, cells);
            edge.edge.sent_to = offset;
            edge.edge.steepness = edge.edge.steepness.marked(sign + SIGN_MARK);
        }
        if is_over {
            edge.add_put_off(to, end_offset, cells);
        }
    }
}

/// In `sent_to`, beside the scan line in the row.
const LEAST: i32 = ONE;

impl CoverageEdge {
    /// Adds what was put off of it, down to a scan line of the row, where it is at `to`.
    #[inline(always)]
    pub(super) fn add_put_off(&mut self, to: i64, offset: i32, cells: &mut Cells<'_>) {
        let sign = self.edge.steepness.mark() - SIGN_MARK;
        self.edge.steepness = self.edge.steepness.marked(0);
        if sign == 1 || sign == -1 {
            let height = offset - (self.edge.sent_to & (LEAST - 1));
            let from = to - self.edge.step() * i64::from(height);
            cells.add_ramp(&self.ramp::<false>(from, to, height_of(height)), sign);
        }
    }

    /// Whether none to its right leaves the band farther to the left.
    pub(super) fn is_least(&self) -> bool {
        self.edge.sent_to & LEAST != 0
    }

    pub(super) fn set_least(&mut self, is_least: bool) {
        self.edge.sent_to = (self.edge.sent_to & (LEAST - 1)) | if is_least { LEAST } else { 0 };
    }
}

/// Edges that end in one vertex are not quite there, as slopes are rounded: 2^-24 pixel in the other order is no crossing.
pub(super) const SLACK: i64 = 1 << 16;

/// Whether edges leave the band in the order they entered it in.
#[inline(always)]
fn keep_their_order<const WIDE: bool>(edges: &[CoverageEdge], height: i32) -> bool {
    let mut before = i64::MIN;
    edges.iter().all(|edge| {
        let below = edge.below_by::<WIDE>(height);
        core::mem::replace(&mut before, below) <= below.saturating_add(SLACK)
    })
}
