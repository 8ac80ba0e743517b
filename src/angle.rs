//! Angles as fractions of a turn, with sine and cosine from a table, in integers.

use core::ops::{Add, Neg, Sub};

/// An angle: a 2^32nd part of a turn, or many. Clockwise, as y grows downwards; 0 points right, a quarter down.
///
/// Sums wrap around with the turn. The sine and cosine are within 2^-29 of the true ones, so points on a circle of
/// radius 2^16 pixels are within 1/4096 pixel of where they should be, before they are rounded.
///
/// ```text
///               3/4
///                |
///        1/2 ----+---- 0        sine and cosine from 65 entries for a quarter, and
///                |              sin(a + d) = sin a cos d + cos a sin d with d < 0.0123:
///               1/4             cos d = 1 - d^2/2 (+ 1e-9), sin d = d - d^3/6 (+ 3e-12)
/// ```
///
/// # Cost
///
/// A sine and cosine take eight multiplications, no division and no floating point; the table has 260 bytes.
///
/// # Examples
///
/// ```
/// use spanfill::Angle;
///
/// let tick = Angle::fraction(1, 60);
/// assert_eq!(Angle::degrees(6), tick);
/// assert_eq!(tick.sin_cos().0, 112_236_582); // 0.10452846 * 2^30
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Angle {
    bits: u32,
}

/// Bits behind the binary point of a sine.
pub(crate) const SINE_BITS: u32 = 30;

/// From one entry of the table to the next: 2^24 is a 64th of a quarter.
const STEP_BITS: u32 = 24;
const STEPS: usize = 64;

/// pi, with 60 bits behind the binary point.
const PI_Q60: i128 = 3_622_009_729_038_561_421;

/// The sine of an angle of at most a quarter, in 2^60ths of a radian: its Taylor series. For the table only.
const fn taylor_sine(radians: i128) -> i128 {
    let square = (radians * radians) >> 60;
    let (mut term, mut sum, mut n) = (radians, radians, 1);
    while n < 26 {
        term = -((term * square) >> 60) / ((n + 1) * (n + 2));
        sum += term;
        n += 2;
    }
    sum
}

#[allow(clippy::indexing_slicing, clippy::cast_possible_truncation, reason = "evaluated by the compiler alone")]
const SINES: [i32; STEPS + 1] = {
    let mut sines = [0; STEPS + 1];
    let mut index = 0;
    while index <= STEPS {
        let sine = taylor_sine(PI_Q60 / 2 * index as i128 / STEPS as i128);
        sines[index] = ((sine + (1 << (59 - SINE_BITS))) >> (60 - SINE_BITS)) as i32;
        index += 1;
    }
    sines
};

/// The arc tangents of 2^0, 2^-1 and so on, in 2^40ths of a turn.
#[allow(clippy::indexing_slicing, clippy::cast_possible_truncation, reason = "evaluated by the compiler alone")]
const ARC_TANGENTS: [i64; 34] = {
    let mut table = [1 << 37; 34];
    let mut index = 1;
    while index < 34 {
        let tangent = 1_i128 << (60 - index);
        let square = (tangent * tangent) >> 60;
        let (mut power, mut sum, mut n) = (tangent, 0, 1);
        while n < 64 {
            sum += power / n;
            power = -((power * square) >> 60);
            n += 2;
        }
        table[index] = (((sum << 40) + PI_Q60) / (2 * PI_Q60)) as i64;
        index += 1;
    }
    table
};

/// An entry of the table; the index is that of one.
#[inline(always)]
const fn sine_at(index: usize) -> i64 {
    if index <= STEPS {
        #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
        let sine = SINES[index] as i64;
        sine
    } else {
        0
    }
}

impl Angle {
    /// Right.
    pub const ZERO: Self = Self::from_bits(0);
    /// A quarter of a turn: down.
    pub const QUARTER: Self = Self::from_bits(1 << 30);
    /// Half a turn: left.
    pub const HALF: Self = Self::from_bits(1 << 31);

    /// An angle in 2^32nds of a turn.
    #[inline]
    pub const fn from_bits(bits: u32) -> Self {
        Self { bits }
    }

    /// In 2^32nds of a turn.
    #[inline]
    pub const fn to_bits(self) -> u32 {
        self.bits
    }

    /// So many of the equal parts of a turn, to the nearest 2^32nd; of no parts it is 0.
    pub const fn fraction(numerator: i32, denominator: u32) -> Self {
        if denominator == 0 {
            return Self::ZERO;
        }
        let parts = (numerator as i64).rem_euclid(denominator as i64).cast_unsigned();
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^32, which is a whole turn")]
        let bits = (((parts << 32) + denominator as u64 / 2) / denominator as u64) as u32;
        Self::from_bits(bits)
    }

    /// Whole degrees, to the nearest 2^32nd of a turn.
    #[inline]
    pub const fn degrees(degrees: i32) -> Self {
        Self::fraction(degrees, 360)
    }

    /// Degrees, to the nearest 2^32nd of a turn. What is not finite is 0.
    pub const fn from_degrees(degrees: f32) -> Self {
        let Some((mantissa, exponent, is_negative)) = parts(degrees) else { return Self::ZERO };
        // mantissa 2^exponent / 360 turns: what is whole of it is of no interest.
        let turn = if exponent >= 0 {
            let mut part = mantissa as u64 % 360;
            let mut doubled = 0;
            while doubled < exponent {
                part = part * 2 % 360;
                doubled += 1;
            }
            ((part << 32) + 180) / 360
        } else if exponent > -64 {
            let scaled = ((mantissa as u128) << 96) / 360;
            low_word_64((scaled >> (63 - exponent)) + 1) >> 1
        } else {
            0
        };
        Self::from_bits(low_word(turn)).signed(is_negative)
    }

    /// Radians, to the nearest 2^32nd of a turn for angles below 2^20. What is not finite is 0.
    pub const fn from_radians(radians: f32) -> Self {
        let Some((mantissa, exponent, is_negative)) = parts(radians) else { return Self::ZERO };
        // 2^100 / 2 pi; mantissa < 2^24.
        const PER_TURN: u128 = (((1_u128 << 127) / PI_Q60.cast_unsigned()) << 32)
            + (((1_u128 << 127) % PI_Q60.cast_unsigned()) << 32) / PI_Q60.cast_unsigned();
        // 1/(2 pi) = 2^127 / PI_Q60 / 2^68, and 32 bits more.
        let turns = mantissa as u128 * PER_TURN;
        let shift = 100 - 33 - exponent;
        let turn = if shift >= 128 || shift <= 0 { 0 } else { low_word_64((turns >> shift) + 1) >> 1 };
        Self::from_bits(low_word(turn)).signed(is_negative)
    }

    const fn signed(self, is_negative: bool) -> Self {
        if is_negative { Self::from_bits(self.bits.wrapping_neg()) } else { self }
    }

    /// The direction from the origin to (x, y); 0 for the origin itself. Within 2^-31 of a turn.
    ///
    /// By rotating onto the axis, a bit of the angle at a time (J. E. Volder, "The CORDIC trigonometric computing
    /// technique", 1959).
    pub const fn of(x: i64, y: i64) -> Self {
        // At most 2^60 after scaling; rotations lengthen by 1.65.
        let size = x.unsigned_abs() | y.unsigned_abs();
        if size == 0 {
            return Self::ZERO;
        }
        let zeros = size.leading_zeros();
        let (x, y) = if zeros >= 4 { (x << (zeros - 4), y << (zeros - 4)) } else { (x >> 4, y >> 4) };
        let (mut x, mut y, mut turned) = if x < 0 { (-x, -y, 1_i64 << 39) } else { (x, y, 0) };
        let mut index = 0;
        while index < ARC_TANGENTS.len() {
            #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
            let part = ARC_TANGENTS[index];
            let (along, across) = (x >> index, y >> index);
            if y > 0 {
                (x, y, turned) = (x + across, y - along, turned + part);
            } else {
                (x, y, turned) = (x - across, y + along, turned - part);
            }
            index += 1;
        }
        Self::from_bits(low_word(((turned + 128) >> 8).cast_unsigned()))
    }

    /// The sine and the cosine, in 2^-30: within 2^-29.
    pub const fn sin_cos(self) -> (i32, i32) {
        let within = (self.bits & ((1 << 30) - 1)) as i64;
        let nearest = (within + (1 << (STEP_BITS - 1))) >> STEP_BITS;
        let offset = within - (nearest << STEP_BITS);
        // In 2^-35 radians, below 2^29; divisions that cut towards zero keep both directions alike.
        #[allow(clippy::cast_possible_truncation, reason = "2^31.7")]
        const RADIANS_Q30: i64 = (PI_Q60 >> 30) as i64;
        let d = offset * RADIANS_Q30 / (1 << 26);
        let square = d * d / (1 << 35);
        // In 2^-32: times an entry of the table below 2^63.
        let sine = (d - d * square / (6 << 35)) / (1 << 3);
        let cosine = (1 << 32) - square / (1 << 4);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 ..= 64")]
        let index = nearest as usize;
        let (s, c) = (sine_at(index), sine_at(STEPS - index));
        let s0 = (s * cosine + c * sine + (1 << 31)) >> 32;
        let c0 = (c * cosine - s * sine + (1 << 31)) >> 32;
        let (s, c) = match self.bits >> 30 {
            0 => (s0, c0),
            1 => (c0, -s0),
            2 => (-s0, -c0),
            _ => (-c0, s0),
        };
        #[allow(clippy::cast_possible_truncation, reason = "at most 2^30 + 2")]
        let pair = (s as i32, c as i32);
        pair
    }

    /// The same turn the other way round.
    #[inline]
    pub const fn opposite_way(self) -> Self {
        self.signed(true)
    }
}

/// Mantissa, exponent and sign of what is finite.
const fn parts(value: f32) -> Option<(u32, i32, bool)> {
    if !value.is_finite() {
        return None;
    }
    let bits = value.to_bits();
    let exponent = ((bits >> 23) & 255).cast_signed();
    let fraction = bits & ((1 << 23) - 1);
    let (mantissa, exponent) = if exponent == 0 { (fraction, -149) } else { (fraction | 1 << 23, exponent - 150) };
    Some((mantissa, exponent, bits >> 31 != 0))
}

#[allow(clippy::cast_possible_truncation, reason = "whole turns are of no interest")]
const fn low_word(value: u64) -> u32 {
    value as u32
}

#[allow(clippy::cast_possible_truncation, reason = "whole turns are of no interest")]
const fn low_word_64(value: u128) -> u64 {
    value as u64
}

impl Add for Angle {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::from_bits(self.bits.wrapping_add(other.bits))
    }
}

impl Sub for Angle {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::from_bits(self.bits.wrapping_sub(other.bits))
    }
}

impl Neg for Angle {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.opposite_way()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ULP: f64 = 1.0 / (1 << 30) as f64;

    fn radians(angle: Angle) -> f64 {
        f64::from(angle.to_bits()) / 2f64.powi(32) * core::f64::consts::TAU
    }

    /// Densely, and around every entry of the table and every half way between two.
    fn angles() -> impl Iterator<Item = Angle> {
        let dense = (0..1 << 22).map(|step: u32| step.wrapping_mul(1021).wrapping_add(step << 10));
        let special =
            (0..512_u32).flat_map(|half| (0..9_u32).map(move |near| (half << 23).wrapping_add(near).wrapping_sub(4)));
        dense.chain(special).map(Angle::from_bits)
    }

    #[test]
    fn sines_are_within_a_2_29th() {
        let mut worst: f64 = 0.0;
        for angle in angles() {
            let (sin, cos) = angle.sin_cos();
            let (true_sin, true_cos) = radians(angle).sin_cos();
            worst = worst.max((f64::from(sin) * ULP - true_sin).abs()).max((f64::from(cos) * ULP - true_cos).abs());
        }
        assert!(worst < 2.0 * ULP, "{}", worst / ULP);
    }

    #[test]
    fn quarters_are_exact_and_mirrored() {
        let one = 1 << 30;
        let quarters = [0, 1, 2, 3].map(|quarter| Angle::fraction(quarter, 4).sin_cos());
        assert_eq!(quarters, [(0, one), (one, 0), (0, -one), (-one, 0)]);
        for angle in angles().step_by(17) {
            let (sin, cos) = angle.sin_cos();
            assert_eq!((Angle::QUARTER + angle).sin_cos(), (cos, -sin));
            assert_eq!((Angle::HALF + angle).sin_cos(), (-sin, -cos));
            let (mirrored_sin, mirrored_cos) = (-angle).sin_cos();
            assert!((mirrored_sin + sin).abs() <= 1 && (mirrored_cos - cos).abs() <= 1, "{angle:?}");
        }
    }

    #[test]
    fn the_direction_of_a_point_is_its_angle() {
        assert_eq!(Angle::of(0, 0), Angle::ZERO);
        let mut worst = 0;
        for angle in angles().step_by(37) {
            let (sin, cos) = angle.sin_cos();
            for scale in [1_i64, 1 << 20, 1 << 32] {
                let found = Angle::of(i64::from(cos) * scale, i64::from(sin) * scale);
                worst = worst.max((found - angle).to_bits().cast_signed().unsigned_abs());
            }
        }
        // The point itself is known to 2^-30 radian only: 1.4 units.
        assert!(worst <= 4, "{worst}");
        for (x, y, eighths) in
            [(1, 0, 0), (1, 1, 1), (0, 1, 2), (-1, 1, 3), (-1, 0, 4), (-3, -3, 5), (0, -9, 6), (i64::MAX, i64::MIN, 7)]
        {
            let error = (Angle::of(x, y) - Angle::fraction(eighths, 8)).to_bits().cast_signed();
            assert!(error.abs() <= 2, "{x} {y} {error}");
        }
    }

    #[test]
    fn fractions_and_degrees_are_the_nearest() {
        assert_eq!(Angle::fraction(1, 0), Angle::ZERO);
        assert_eq!(Angle::fraction(-1, 4), Angle::fraction(3, 4));
        assert_eq!(Angle::degrees(450), Angle::QUARTER);
        for tenths in -32_000..32_000_i16 {
            let degrees = f32::from(tenths) / 10.0;
            let exact = (f64::from(degrees) / 360.0).rem_euclid(1.0) * 2f64.powi(32);
            let error = f64::from(Angle::from_degrees(degrees).to_bits()) - exact;
            assert!(error.abs() <= 0.500_001 || error.abs() > 4e9, "{degrees}: {error}");
            let radians = f32::from(tenths) / 100.0;
            let exact = (f64::from(radians) / core::f64::consts::TAU).rem_euclid(1.0) * 2f64.powi(32);
            let error = f64::from(Angle::from_radians(radians).to_bits()) - exact;
            assert!(error.abs() <= 0.501 || error.abs() > 4e9, "{radians}: {error}");
        }
    }

    #[test]
    fn floats_at_the_ends_of_their_range_are_angles() {
        for value in [f32::NAN, f32::INFINITY, 0.0, f32::MIN_POSITIVE, 1e-40] {
            assert_eq!(Angle::from_degrees(value), Angle::ZERO);
            assert_eq!(Angle::from_radians(value), Angle::ZERO);
        }
        let exact = (f64::from(1e20_f32) % 360.0 / 360.0 * 2f64.powi(32)).round();
        assert_eq!(f64::from(Angle::from_degrees(1e20).to_bits()), exact);
        assert_eq!(Angle::from_degrees(-1e20), -Angle::from_degrees(1e20));
        Angle::from_degrees(f32::MAX);
        Angle::from_radians(f32::MAX);
    }

    #[test]
    fn sixty_ticks_are_even_to_a_256th_up_to_256_pixels() {
        let radius = 256 * 256;
        let tick = |index: i32| {
            let (sin, cos) = Angle::fraction(index, 60).sin_cos();
            let round = |sine: i32| ((i64::from(sine) * radius + (1 << 29)) >> 30) as f64 / 256.0;
            (round(cos), round(sin))
        };
        for index in 0..60 {
            let (x, y) = tick(index);
            let (sin, cos) = (f64::from(index) * core::f64::consts::TAU / 60.0).sin_cos();
            // Half a unit of rounding, and nothing that could be seen besides.
            assert!((x - 256.0 * cos).abs() < 0.5001 / 256.0 && (y - 256.0 * sin).abs() < 0.5001 / 256.0, "{index}");
        }
    }
}
