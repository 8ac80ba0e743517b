//! From the ends of an arc to its centre (SVG 2, appendix B.2.4), in integers.
//!
//! All in the frame in which the ellipse is the unit circle: the half chord `(a, b)` has length `h`; the centre is
//! `sqrt(1 - h^2)` from the chord's middle, across it; with `h >= 1` it is the middle, and the radii grow by `h`.

use crate::{
    Angle,
    outline::{FinePoint, clamp_fine},
    path::element::{ArcTo, Element},
};

/// An arc by its ends: coordinates in pixels with 32 fraction bits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    pub(super) from: [i64; 2],
    pub(super) to: [i64; 2],
    pub(super) radii: [i64; 2],
    pub(super) rotation: Angle,
    pub(super) is_large: bool,
    pub(super) is_clockwise: bool,
}

/// Fraction bits of the unit circle's frame.
const UNIT_BITS: u32 = 56;

/// What fits the arithmetic: 2^19 pixels.
const FAR: i64 = (1 << 51) - 1;

const fn near(value: i64) -> i128 {
    let value = if value > FAR {
        FAR
    } else if value < -FAR {
        -FAR
    } else {
        value
    };
    value as i128
}

/// From 32 fraction bits to a coordinate.
const fn fine(value: i128) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "sums of a few values below 2^53")]
    let value = ((value + (1 << 19)) >> 20) as i64;
    clamp_fine(value)
}

impl Ends {
    pub(super) const fn element(self) -> Element {
        let [x0, y0] = [near(self.from[0]), near(self.from[1])];
        let [x1, y1] = [near(self.to[0]), near(self.to[1])];
        let [rx, ry] = [near(self.radii[0]).abs(), near(self.radii[1]).abs()];
        let to = FinePoint::from_bits(fine(x1), fine(y1));
        // Radii below 2^-20 pixel are none.
        if (x0 == x1 && y0 == y1) || rx < 1 << 12 || ry < 1 << 12 {
            return Element::Line(to);
        }
        let (sin, cos) = self.rotation.sin_cos();
        let (sin, cos) = (sin as i128, cos as i128);
        // Twice the half chord, turned back.
        let (dx, dy) = (x0 - x1, y0 - y1);
        let (along, across) = ((cos * dx + sin * dy) >> 30, (cos * dy - sin * dx) >> 30);
        // |along| < 2^53, so with at least 2^12 below, less than 2^97.
        let (mut a, mut b) = ((along << (UNIT_BITS - 1)) / rx, (across << (UNIT_BITS - 1)) / ry);
        let mut lost = 0;
        while a.abs() >= 1 << 60 || b.abs() >= 1 << 60 {
            (a, b, lost) = (a >> 1, b >> 1, lost + 1);
        }
        let square = a * a + b * b;
        let one = 1_i128 << (2 * UNIT_BITS);
        let h = square.cast_unsigned().isqrt().cast_signed();
        let is_short = lost == 0 && square < one;
        let (rx, ry, cu, cv) = if is_short && h > 0 {
            let away = (one - square).cast_unsigned().isqrt().cast_signed();
            let sign = if self.is_large == self.is_clockwise { -1 } else { 1 };
            (rx, ry, sign * b * away / h, -sign * a * away / h)
        } else {
            // (a, b) becomes a unit vector by the growth of the radii.
            let grown = [((rx * h) >> UNIT_BITS) << lost, ((ry * h) >> UNIT_BITS) << lost];
            let h = if h <= 0 { 1 } else { h };
            (a, b) = ((a << UNIT_BITS) / h, (b << UNIT_BITS) / h);
            (grown[0], grown[1], 0, 0)
        };
        let (ru, rv) = ((rx * cu) >> UNIT_BITS, (ry * cv) >> UNIT_BITS);
        let center = FinePoint::from_bits(
            fine((x0 + x1) / 2 + ((cos * ru - sin * rv) >> 30)),
            fine((y0 + y1) / 2 + ((sin * ru + cos * rv) >> 30)),
        );
        let start = direction(a - cu, b - cv);
        let end = direction(-a - cu, -b - cv);
        let sweep = end.to_bits().wrapping_sub(start.to_bits());
        let sweep = if self.is_clockwise { sweep } else { sweep.wrapping_neg() };
        Element::Arc(ArcTo {
            center,
            radii: FinePoint::from_bits(fine(rx), fine(ry)),
            rotation: self.rotation,
            start,
            sweep: Angle::from_bits(sweep),
            is_clockwise: self.is_clockwise,
            to,
        })
    }
}

const fn direction(x: i128, y: i128) -> Angle {
    #[allow(clippy::cast_possible_truncation, reason = "at most 2 in length: below 2^58")]
    let angle = Angle::of(x as i64, y as i64);
    angle
}
