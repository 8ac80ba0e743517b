//! Curves into lines: quadratic and cubic by forward differences, arcs of ellipses by the table of sines.
//!
//! A chord over a step `h` of the parameter is `h^2 / 8 |B''|` away from the curve, all over on the same side (Wang
//! 1984: `d (d - 1) / 8` times the greatest second difference of the control points, over `n^2`, for degree `d`). The
//! steps are chosen to leave at most 1/1024 pixel. A polygon with its vertices *on* the curve has too little area, by
//! two thirds of that along each chord; here they are moved out by as much,
//!
//! ```text
//!     Q(t) = B(t) - B''(t) h^2 / 12,
//! ```
//!
//! so each chord gains what it loses, and what remains is what a pixel cuts off of a chord.
//!
//! An edge that is moved by `d` changes a pixel's coverage by at most `361 d` 255ths. Between the chords' ends the
//! deviation runs from 2/3 of the sagitta `s` outside to 1/3 inside; what a pixel cuts out of that adds up to at most
//! `0.13 s l` for chords of length `l`, and to `s l / 3` where a curve begins or ends, on its exact end: below 0.1 of
//! 255 for `s` of 1/1024 and radii up to 200 pixels. Rounding to 1/4096 pixel is 0.03 at most of that. The constant is
//! 11/16 in place of 2/3, so that all is exact in binary.

use crate::{
    Angle,
    outline::{FinePoint, FineRect, Vector, clamp_fine, shift_half_even},
};

/// How far a chord may be from the curve, in 1/4096 pixel.
const TOLERANCE: u64 = 4;

/// Fraction bits of the axes of an ellipse beyond the 12 of a point.
const AXIS_BITS: u32 = 8;

/// At most so many chords in an arc.
const MOST_CHORDS: u32 = 1 << 14;

/// A curve from one point to another, and into how many chords it is cut.
///
/// It can be walked as often as wanted, from either end, to the same points: the vertices of a chain of lines that is
/// within 1/1024 pixel of the curve and has its area. Curves that stretch over more than 4096 pixels get coarser.
///
/// # Cost
///
/// Polynomials: three additions, a shift and a rounding a point and axis. Arcs: a sine and cosine, four
/// multiplications and a division a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Curve {
    from: FinePoint,
    to: FinePoint,
    kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    /// `from + c1 t + c2 t^2 + c3 t^3` in `2^log_chords` chords.
    Polynomial { c1: Vector, c2: Vector, c3: Vector, log_chords: u32 },
    /// `center + u cos + v sin` over a sweep that starts somewhere, in 2^-32 turns; walked from its end, perhaps.
    Ellipse { center: FinePoint, u: Vector, v: Vector, start: Angle, sweep: i64, chords: u32, is_reversed: bool },
}

// What `outline` says of it.
const _: () = assert!(size_of::<Curve>() < 100);

/// The least `k` for which `4^k` chords squared are enough: `deviation / 4^k` is within the tolerance.
const fn log_chords(deviation: u64) -> u32 {
    let mut log = 0;
    while deviation >> (2 * log) > TOLERANCE {
        log += 1;
    }
    log
}

/// 0 where there is none.
const fn quotient(value: i128, divisor: i128) -> i128 {
    match value.checked_div(divisor) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// At least the longer half axis of an ellipse, in the unit of its axes.
const fn longest_axis(u: Vector, v: Vector) -> u64 {
    // Half the sum and the difference of these are the half axes.
    let (turning, mirroring) = (Vector::new(u.x + v.y, u.y - v.x), Vector::new(u.x - v.y, u.y + v.x));
    (turning.length_at_most() + mirroring.length_at_most()) >> 1
}

impl Curve {
    /// A quadratic Bézier curve.
    pub const fn quadratic(from: FinePoint, control: FinePoint, to: FinePoint) -> Self {
        let (first, last) = (Vector::between(from, control), Vector::between(control, to));
        let second = last.minus(first);
        let coefficients = [first.times(2), second, Vector::new(0, 0)];
        Self::polynomial(from, to, coefficients, second.length_at_most().div_ceil(4))
    }

    /// A cubic Bézier curve.
    pub const fn cubic(from: FinePoint, control1: FinePoint, control2: FinePoint, to: FinePoint) -> Self {
        let a = Vector::between(from, control1);
        let b = Vector::between(control1, control2);
        let c = Vector::between(control2, to);
        let (second, second_last) = (b.minus(a), c.minus(b));
        let (greatest, other) = (second.length_at_most(), second_last.length_at_most());
        let greatest = if greatest > other { greatest } else { other };
        let coefficients = [a.times(3), second.times(3), second_last.minus(second)];
        Self::polynomial(from, to, coefficients, (3 * greatest).div_ceil(4))
    }

    const fn polynomial(from: FinePoint, to: FinePoint, [c1, c2, c3]: [Vector; 3], deviation: u64) -> Self {
        // Values at the points, times 2^(3 log), and six bits more for moving them out, fit 63 bits. No point is
        // further from the start than this.
        let size = c1.length_at_most() + c2.length_at_most() + c3.length_at_most() + 1;
        let bits = u64::BITS - size.leading_zeros();
        let (wanted, most) = (log_chords(deviation), 62_u32.saturating_sub(6 + bits) / 3);
        let log_chords = if wanted < most { wanted } else { most };
        Self { from, to, kind: Kind::Polynomial { c1, c2, c3, log_chords } }
    }

    /// An arc of the ellipse `center + u cos + v sin`, over `sweep` 2^-32 turns from `start`; `u` and `v` have
    /// `AXIS_BITS` more fraction bits than points. The ends are points that have been made elsewhere.
    pub(crate) const fn arc(
        from: FinePoint,
        to: FinePoint,
        center: FinePoint,
        [u, v]: [Vector; 2],
        start: Angle,
        sweep: i64,
    ) -> Self {
        // Chords of the angle a with r a^2 / 8 <= tolerance: a turn of 2 pi over sqrt(8 tolerance / r). 1609 is 256 *
        // 2 pi.
        let longest = (longest_axis(u, v) >> AXIS_BITS) << 11;
        let root = (if longest < 1 << 60 { longest } else { 1 << 60 }).isqrt() + 1;
        let sweep = if sweep > 1 << 32 {
            1 << 32
        } else if sweep < -(1 << 32) {
            -(1 << 32)
        } else {
            sweep
        };
        let chords = ((sweep.unsigned_abs() as u128 * root as u128 * 1609) >> 48) + 1;
        #[allow(clippy::cast_possible_truncation, reason = "compared")]
        let chords = if chords < MOST_CHORDS as u128 { chords as u32 } else { MOST_CHORDS };
        let chords = if sweep.unsigned_abs() >= 1 << 30 { chords.next_multiple_of(4) } else { chords };
        // 1 + a^2 / 8 * 11 / 16, in 2^-32: (2 pi)^2 * 11 / 128 is 3.392672, the square in 2^-64 turns.
        const fn grow(axis: i64, step: u64) -> i64 {
            let square = (step as i128 * step as i128) >> 32;
            let more = (axis as i128 * square * 13_896) >> (32 + 12);
            #[allow(clippy::cast_possible_truncation, reason = "less than four times an axis, of at most 2^41")]
            let grown = axis + more as i64;
            grown
        }
        let step = match sweep.unsigned_abs().checked_div(chords as u64) {
            Some(step) => step,
            None => 0,
        };
        let u = Vector::new(grow(u.x, step), grow(u.y, step));
        let v = Vector::new(grow(v.x, step), grow(v.y, step));
        Self { from, to, kind: Kind::Ellipse { center, u, v, start, sweep, chords, is_reversed: false } }
    }

    /// Its first point.
    #[inline]
    pub const fn from(&self) -> FinePoint {
        self.from
    }

    /// Its last point.
    #[inline]
    pub const fn to(&self) -> FinePoint {
        self.to
    }

    /// How many chords it has, and so how many points besides the first.
    #[inline]
    pub const fn chords(&self) -> u32 {
        match self.kind {
            Kind::Polynomial { log_chords, .. } => 1 << log_chords,
            Kind::Ellipse { chords, .. } => chords,
        }
    }

    /// The same from its other end.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let Self { from, to, kind } = *self;
        let kind = match kind {
            Kind::Polynomial { c1, c2, c3, log_chords } => Kind::Polynomial {
                c1: Vector::default().minus(c1).minus(c2.times(2)).minus(c3.times(3)),
                c2: c2.plus(c3.times(3)),
                c3: Vector::default().minus(c3),
                log_chords,
            },
            Kind::Ellipse { center, u, v, start, sweep, chords, is_reversed } => {
                Kind::Ellipse { center, u, v, start, sweep, chords, is_reversed: !is_reversed }
            }
        };
        Self { from: to, to: from, kind }
    }

    /// Every point but the first, in order.
    #[inline]
    pub fn points(&self) -> CurvePoints {
        self.points_after(0)
    }

    /// Every point after so many chords, in order.
    #[inline]
    pub(crate) fn points_after(&self, index: u32) -> CurvePoints {
        let walk = match self.kind {
            Kind::Polynomial { c1, c2, c3, log_chords } => {
                let axis = |c1: i64, c2: i64, c3: i64| Differences::new([c1, c2, c3], log_chords, index);
                Walk::Polynomial { x: axis(c1.x, c2.x, c3.x), y: axis(c1.y, c2.y, c3.y), bits: 3 * log_chords + 6 }
            }
            Kind::Ellipse { .. } => Walk::Ellipse { index },
        };
        CurvePoints { curve: *self, walk, left: self.chords().saturating_sub(index) }
    }

    /// The point after so many chords.
    #[inline]
    pub(crate) fn point(&self, index: u32) -> FinePoint {
        match index.checked_sub(1) {
            None => self.from,
            Some(before) => self.points_after(before).next().unwrap_or(self.to),
        }
    }

    /// The same in about four times as many chords, as far as numbers allow.
    #[must_use]
    pub(crate) fn refined(&self) -> Self {
        let mut refined = *self;
        match &mut refined.kind {
            Kind::Polynomial { c1, c2, c3, log_chords } => {
                let size = c1.length_at_most() + c2.length_at_most() + c3.length_at_most() + 1;
                let most = size.leading_zeros().saturating_sub(8) / 3;
                *log_chords = (*log_chords + 2).min(most.max(*log_chords));
            }
            // Points were moved out for fewer chords: by less than 1/1400 pixel, all to the same side.
            Kind::Ellipse { chords, .. } => *chords *= 4,
        }
        refined
    }

    /// A rectangle that none of its points is outside of.
    pub const fn hull(&self) -> FineRect {
        let Self { from, to, kind } = *self;
        let mut hull = FineRect::EMPTY;
        hull.add(from);
        hull.add(to);
        match kind {
            // Control points, and what points are moved out by: less than the tolerance, but where curves are huge.
            Kind::Polynomial { c1, c2, c3, log_chords } => {
                let moved = c2.plus(c3.times(3));
                let moved =
                    Vector::new((moved.x.abs() >> (2 * log_chords)) + 2, (moved.y.abs() >> (2 * log_chords)) + 2);
                let (first, second) =
                    if c3.is_zero() { (c1.over(2), c1.over(2)) } else { (c1.over(3), c1.times(2).plus(c2).over(3)) };
                hull.add(first.minus(moved).from(from));
                hull.add(first.plus(moved).from(from));
                hull.add(second.minus(moved).from(from));
                hull.add(second.plus(moved).from(from));
            }
            Kind::Ellipse { center, u, v, .. } => {
                let x = (Vector::new(u.x, v.x).length_at_most() >> AXIS_BITS).cast_signed() + 2;
                let y = (Vector::new(u.y, v.y).length_at_most() >> AXIS_BITS).cast_signed() + 2;
                hull.add(Vector::new(x, y).from(center));
                hull.add(Vector::new(-x, -y).from(center));
            }
        }
        hull
    }

    /// No less than its length, in 1/4096 pixel: that of the lines between its control points, or of the circle around it.
    pub(crate) const fn length_at_most(&self) -> u64 {
        match self.kind {
            Kind::Polynomial { c1, c2, c3, .. } => {
                c1.length_at_most() + 2 * c2.length_at_most() + 3 * c3.length_at_most()
            }
            Kind::Ellipse { u, v, .. } => 7 * ((longest_axis(u, v) >> AXIS_BITS) + 1),
        }
    }

    /// Into how many parts that go up or down it falls at most.
    pub(crate) const fn parts(&self) -> u32 {
        match self.kind {
            Kind::Polynomial { c3, .. } if c3.is_zero() => 2,
            Kind::Polynomial { .. } | Kind::Ellipse { .. } => 3,
        }
    }

    /// A radius that it is nowhere tighter than, in 1/4096 pixel: `|B'|^3 / |B' x B''|` is at least `|B'|^2 / |B''|`, and
    /// `B'` along the chord at least the least of its control points.
    pub(crate) const fn tightest(&self) -> i64 {
        match self.kind {
            Kind::Polynomial { c1, c2, c3, .. } => {
                let chord = Vector::between(self.from, self.to);
                let middle = c1.plus(c2);
                let last = c1.plus(c2.times(2)).plus(c3.times(3));
                let (first, middle, last) = (c1.dot(chord), middle.dot(chord), last.dot(chord));
                let least = if first < middle { first } else { middle };
                let least = if least < last { least } else { last };
                let length = chord.dot(chord).unsigned_abs().isqrt().cast_signed() + 1;
                let speed = if least > 0 { quotient(least, length) } else { 0 };
                let (start, end) = (c2.length_at_most(), c2.plus(c3.times(3)).length_at_most());
                let turn = 2 * (if start > end { start } else { end }) as i128 + 1;
                #[allow(
                    clippy::cast_possible_truncation,
                    reason = "a square of 2^37 at most, over one or more; cut off"
                )]
                let radius = quotient(speed * speed, turn) as i64;
                radius
            }
            Kind::Ellipse { u, v, .. } => {
                let longer = (longest_axis(u, v) as i128) + 1;
                let product = u.x as i128 * v.y as i128 - u.y as i128 * v.x as i128;
                let shorter = quotient(product.abs(), longer);
                #[allow(clippy::cast_possible_truncation, reason = "less than an axis")]
                let radius = quotient(shorter * shorter, longer) as i64;
                radius >> AXIS_BITS
            }
        }
    }

    /// The direction that it starts in; none where all its control points are the same.
    pub(crate) fn start_direction(&self) -> Option<Vector> {
        let candidates = match self.kind {
            Kind::Polynomial { c1, c2, c3, .. } => [c1, c2, c3],
            Kind::Ellipse { .. } => [self.direction(0, 0), Vector::between(self.from, self.to), Vector::default()],
        };
        candidates.into_iter().find(|candidate| !candidate.is_zero())
    }

    /// The direction in which it goes after `index` chords and a part of the next, in 1/65536; or none at all, in a
    /// cusp.
    pub(crate) fn direction(&self, index: u32, part: u32) -> Vector {
        let position = (i64::from(index) << 16) + i64::from(part);
        match self.kind {
            Kind::Polynomial { c1, c2, c3, log_chords } => {
                // 2^16 n times the parameter, of at most 2^26; coefficients below 2^36.
                let whole = 16 + log_chords;
                let axis = |c1: i64, c2: i64, c3: i64| {
                    let (c1, c2, c3, t) = (i128::from(c1), i128::from(c2), i128::from(c3), i128::from(position));
                    (c1 << (2 * whole)) + ((2 * c2 * t) << whole) + 3 * c3 * t * t
                };
                shortened(axis(c1.x, c2.x, c3.x), axis(c1.y, c2.y, c3.y))
            }
            Kind::Ellipse { u, v, start, sweep, chords, is_reversed, .. } => {
                let position = if is_reversed { (i64::from(chords) << 16) - position } else { position };
                let swept = (i128::from(sweep) * i128::from(position) / i128::from(chords.max(1))) >> 16;
                #[allow(clippy::cast_possible_truncation, reason = "at most the sweep")]
                let (sin, cos) = (start + Angle::from_bits(low_word(swept as i64))).sin_cos();
                let (sin, cos) = (i64::from(sin), i64::from(cos));
                let along = |u: i64, v: i64| {
                    let along = i128::from(v) * i128::from(cos) - i128::from(u) * i128::from(sin);
                    if is_reversed == (sweep < 0) { along } else { -along }
                };
                let (x, y) = (along(u.x, v.x), along(u.y, v.y));
                shortened(x, y)
            }
        }
    }

    /// The point after `index` chords of an arc.
    fn on_ellipse(&self, index: u32) -> FinePoint {
        let Kind::Ellipse { center, u, v, start, sweep, chords, is_reversed } = self.kind else { return self.to };
        let index = if is_reversed { chords.saturating_sub(index) } else { index };
        let part = sweep * i64::from(index) / i64::from(chords.max(1));
        let (sin, cos) = (start + Angle::from_bits(low_word(part))).sin_cos();
        let at = |center: i32, u: i64, v: i64| {
            let sum = i128::from(u) * i128::from(cos) + i128::from(v) * i128::from(sin);
            #[allow(clippy::cast_possible_truncation, reason = "at most twice an axis, of at most 2^42")]
            let sum = (sum >> 20) as i64;
            clamp_fine(i64::from(center).saturating_add(shift_half_even(sum, AXIS_BITS + 10)))
        };
        FinePoint::from_bits(at(center.x, u.x, v.x), at(center.y, u.y, v.y))
    }
}

/// As long as 30 bits can tell.
fn shortened(x: i128, y: i128) -> Vector {
    let bits = (u128::BITS - (x.unsigned_abs() | y.unsigned_abs()).leading_zeros()).saturating_sub(30);
    #[allow(clippy::cast_possible_truncation, reason = "shifted to 30 bits")]
    let vector = Vector::new((x >> bits) as i64, (y >> bits) as i64);
    vector
}

#[inline]
const fn low_word(value: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole turns are of no interest")]
    let low = value as u32;
    low
}

/// The points of a [`Curve`] but the first.
#[derive(Debug, Clone)]
pub struct CurvePoints {
    curve: Curve,
    walk: Walk,
    /// Points still to come.
    left: u32,
}

#[derive(Debug, Clone)]
enum Walk {
    /// Values have so many more fraction bits than points.
    Polynomial {
        x: Differences,
        y: Differences,
        bits: u32,
    },
    Ellipse {
        index: u32,
    },
}

/// A cubic along one axis at equal steps: what it is, and its three differences, modulo 2^64.
#[derive(Debug, Clone)]
struct Differences {
    value: i64,
    first: i64,
    second: i64,
    third: i64,
}

impl Differences {
    /// `64 n^3 (c1 t + c2 t^2 + c3 t^3 - 11/64 (c2 + 3 c3 t) / n^2)` at `t = i / n`: the last part is 11/16 of `h^2
    /// B'' / 8`.
    fn new([c1, c2, c3]: [i64; 3], log: u32, index: u32) -> Self {
        let shifted = |value: i64, bits: u32| value.wrapping_shl(bits);
        // As a i^3 + b i^2 + c i + d.
        let a = shifted(c3, 6);
        let b = shifted(c2, 6 + log);
        let c = shifted(c1, 6 + 2 * log).wrapping_sub(c3.wrapping_mul(33));
        let d = shifted(c2.wrapping_mul(11), log).wrapping_neg();
        let i = i64::from(index);
        // Horner's rule, and the differences to the next: a (3 i^2 + 3 i + 1) + b (2 i + 1) + c, and so on.
        let value = a.wrapping_mul(i).wrapping_add(b).wrapping_mul(i).wrapping_add(c).wrapping_mul(i).wrapping_add(d);
        let first = a.wrapping_mul(3 * i * (i + 1) + 1).wrapping_add(b.wrapping_mul(2 * i + 1)).wrapping_add(c);
        let second = a.wrapping_mul(6 * (i + 1)).wrapping_add(b.wrapping_mul(2));
        Self { value, first, second, third: a.wrapping_mul(6) }
    }

    #[inline(always)]
    fn step(&mut self) -> i64 {
        self.value = self.value.wrapping_add(self.first);
        self.first = self.first.wrapping_add(self.second);
        self.second = self.second.wrapping_add(self.third);
        self.value
    }
}

impl Iterator for CurvePoints {
    type Item = FinePoint;

    #[inline]
    fn next(&mut self) -> Option<FinePoint> {
        self.left = self.left.checked_sub(1)?;
        if self.left == 0 {
            return Some(self.curve.to);
        }
        let from = self.curve.from;
        Some(match &mut self.walk {
            Walk::Polynomial { x, y, bits } => {
                let [x, y] = [x, y].map(|axis| shift_half_even(axis.step(), *bits));
                Vector::new(x, y).from(from)
            }
            Walk::Ellipse { index } => {
                *index += 1;
                self.curve.on_ellipse(*index)
            }
        })
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = usize::try_from(self.left).unwrap_or(usize::MAX);
        (left, Some(left))
    }
}

impl ExactSizeIterator for CurvePoints {}
