//! The part of the plane that a sweep of an angle covers, cut off by two half planes.
//!
//! The directions are embedded-graphics' own: sine and cosine by micromath in single precision, cut to 1/1024. They are
//! within 0.2 degrees of the angle. From there on everything is in integers.

use core::ops::Range;

use embedded_graphics::geometry::Angle;
use micromath::F32Ext;

/// The length of a direction.
pub(super) const DIRECTION: i64 = 1024;

/// Farther than any column.
const FAR: i64 = i64::MAX / 4;

/// How the two half planes make up the wedge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sweep {
    /// Less than half a turn: what lies in both.
    Narrow,
    /// Half a turn or more: what lies in one of them.
    Wide,
    /// A whole turn or more.
    Whole,
}

impl Sweep {
    pub(super) fn of(sweep: Angle) -> Self {
        let turned = sweep.abs();
        if turned >= Angle::from_radians(2.0 * core::f32::consts::PI) {
            Self::Whole
        } else if turned >= Angle::from_radians(core::f32::consts::PI) {
            Self::Wide
        } else {
            Self::Narrow
        }
    }
}

/// From one direction clockwise to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    start: (i64, i64),
    end: (i64, i64),
    sweep: Sweep,
}

impl Wedge {
    pub(super) fn new(start: Angle, sweep: Angle) -> Self {
        let end = start + sweep;
        let (start, end) = if sweep < Angle::zero() { (end, start) } else { (start, end) };
        Self { start: direction(start), end: direction(end), sweep: Sweep::of(sweep) }
    }

    /// Whether something lies in the wedge that lies on these sides of its start and its end.
    pub(super) fn holds(&self, after_start: bool, before_end: bool) -> bool {
        match self.sweep {
            Sweep::Narrow => after_start && before_end,
            Sweep::Wide => after_start || before_end,
            Sweep::Whole => true,
        }
    }

    /// The columns on a row that lie to the right of the start, or at most `behind` to the left of it; and the same,
    /// mirrored, for the end.
    pub(super) fn sides(&self, row: i64, center_2x: (i64, i64), behind: i64) -> [Range<i64>; 2] {
        let ((cos, sin), (end_cos, end_sin)) = (self.start, self.end);
        [
            HalfPlane { normal: (-sin, cos), at_least: -behind }.columns(row, center_2x),
            HalfPlane { normal: (end_sin, -end_cos), at_least: -behind }.columns(row, center_2x),
        ]
    }
}

/// Where an angle points to.
pub(super) fn direction(angle: Angle) -> (i64, i64) {
    // Half a turn is not exact in single precision, and would be off by 1/1024.
    if angle == Angle::from_degrees(180.0) {
        return (-DIRECTION, 0);
    }
    let scaled = |value: f32| {
        // Of angles far beyond a turn micromath makes more than a sine.
        #[allow(clippy::cast_possible_truncation, reason = "clamped; cut off as embedded-graphics does")]
        let scaled = (value * 1024.0).clamp(-1100.0, 1100.0) as i32;
        i64::from(scaled)
    };
    let radians = angle.to_radians();
    (scaled(F32Ext::cos(radians)), scaled(F32Ext::sin(radians)))
}

/// The points whose product with `normal` is at least that, in doubled coordinates around a middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfPlane {
    pub(super) normal: (i64, i64),
    pub(super) at_least: i64,
}

impl HalfPlane {
    /// The columns of a row, around twice the middle.
    pub(super) fn columns(&self, row: i64, (center_2x, y): (i64, i64)) -> Range<i64> {
        let (x, rest) = (self.normal.0, self.at_least - self.normal.1 * (2 * row - y));
        // x (2 column - center_2x) >= rest
        match x {
            0 if rest <= 0 => -FAR..FAR,
            0 => 0..0,
            1.. => {
                // The least integer that is at least rest / x, and then half of it.
                let least = -(-rest).div_euclid(x);
                -(-(least + center_2x)).div_euclid(2)..FAR
            }
            _ => {
                let most = (-rest).div_euclid((-x).max(1));
                -FAR..(most + center_2x).div_euclid(2) + 1
            }
        }
    }
}
