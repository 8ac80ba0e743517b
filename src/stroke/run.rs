//! One line, or a part of a curve, of what is stroked.

use crate::{
    outline::{Curve, FinePoint, Step, Vector},
    stroke::normal::Unit,
};

/// A line, or a part of a curve, with its normals at both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) from: FinePoint,
    pub(super) to: FinePoint,
    pub(super) normals: [Unit; 2],
    /// The curve, and its vertices between the ends: after so many chords to after so many, or fewer.
    pub(super) curve: Option<(Curve, u32, u32)>,
}

impl Run {
    /// None where it has no length.
    pub(super) fn of(step: &Step) -> Option<Self> {
        match *step {
            Step::Move(_) => None,
            Step::Line(from, to) | Step::Close(from, to) => {
                let normal = Unit::along(Vector::between(from, to))?.turned();
                Some(Self { from, to, normals: [normal, normal], curve: None })
            }
            Step::Curve(curve) => {
                let start = Unit::along(curve.start_direction()?)?.turned();
                let end = Unit::along(curve.reversed().start_direction()?)?.turned_back();
                let (from, to, last) = (curve.from(), curve.to(), curve.chords().saturating_sub(1));
                Some(Self { from, to, normals: [start, end], curve: Some((curve, 1, last)) })
            }
        }
    }

    #[inline]
    pub(super) fn chords(&self) -> u32 {
        self.curve.map_or(1, |(_, first, last)| (last + 2).saturating_sub(first))
    }

    /// The point after so many chords, or before so many.
    #[inline]
    pub(super) fn point(&self, index: u32, is_back: bool) -> FinePoint {
        let chords = self.chords();
        let index = if is_back { chords.saturating_sub(index) } else { index };
        match self.curve {
            _ if index == 0 => self.from,
            Some((curve, first, _)) if index < chords => curve.point(first + index - 1),
            _ => self.to,
        }
    }

    /// The normals at its ends, as it is gone along.
    #[inline]
    pub(super) fn ends(&self, is_back: bool) -> [Unit; 2] {
        let [start, end] = self.normals;
        if is_back { [end.opposite(), start.opposite()] } else { [start, end] }
    }

    /// The normal of a chord, and the square of its length. One of no length has that of the curve there.
    pub(super) fn chord(&self, index: u32, is_back: bool) -> (Unit, u128) {
        let [start, _] = self.ends(is_back);
        let Some((curve, first, _)) = self.curve else {
            let vector = Vector::between(self.from, self.to);
            return (start, vector.dot(vector).unsigned_abs());
        };
        let vector = Vector::between(self.point(index, is_back), self.point(index + 1, is_back));
        if let Some(direction) = Unit::along(vector) {
            return (direction.turned(), vector.dot(vector).unsigned_abs());
        }
        let forward = if is_back { self.chords().saturating_sub(index + 1) } else { index };
        let direction = Unit::along(curve.direction((first + forward).saturating_sub(1), 1 << 15));
        let normal = direction.map(|direction| if is_back { direction.turned_back() } else { direction.turned() });
        (normal.unwrap_or(start), 0)
    }
}
