//! An edge for areas: where it is on every scan line, and how steep it is.
//!
//! A position is a coordinate in 1/256 pixel with 32 bits behind it. In the narrow zone (see `limits`) it is
//! `x0 + (y - y0) slope` with `slope = dx / dy` to 2^-32, whichever way it was come by: adding is exact, so no clip
//! changes a bit. As `dy <= 2^22`, it is within 2^-18 pixel of the true line at the lower end, and within 2^-24 where an
//! edge is no taller than 256 pixels. Outside of the zone it is divided out anew for every scan line, to 2^-40 pixel.

use crate::{
    Vertex,
    coverage::ramp::Steep,
    edge::{Descent, divide_product},
    limits::SUBPIXEL_BITS,
};

/// An edge on its current scan line.
#[derive(Debug, Clone, Copy, Default)]
pub struct Slope {
    /// Halves, the lower first, so that scratch has no padding.
    position: (u32, i32),
    /// How far on it is in the next row of pixels; of a wide edge, at the end of the band that it was made for.
    row_step: (u32, i32),
    pub(crate) steepness: Steepness,
    /// What is above has been sent, or added up: a row of pixels in trapezoids, a scan line in bands.
    pub(crate) sent_to: i32,
}

#[inline(always)]
fn joined((low, high): (u32, i32)) -> i64 {
    (i64::from(high) << 32) | i64::from(low)
}

#[inline(always)]
fn halves(value: i64) -> (u32, i32) {
    #[allow(clippy::cast_possible_truncation, reason = "the lower and the upper half")]
    #[allow(clippy::cast_sign_loss, reason = "bits")]
    let halves = (value as u32, (value >> 32) as i32);
    halves
}

/// The position of a coordinate in 1/256 pixel.
#[inline(always)]
pub(crate) fn position_of(coordinate: i32) -> i64 {
    i64::from(coordinate) << 32
}

impl Slope {
    pub(crate) const EMPTY: Self = Self { position: (0, 0), row_step: (0, 0), steepness: Steepness::NONE, sent_to: 0 };

    /// The edge on scan line `y`, which is not below its end. One outside of the narrow zone cannot be stepped, see
    /// [`widen`](Self::widen).
    #[inline(always)]
    pub(crate) fn on_line(top: Vertex, bottom: Vertex, y: i32) -> Self {
        let descent = Descent::between(top, bottom);
        let below = y.wrapping_sub(top.y.to_bits()).cast_unsigned();
        let (position, step, steepness) = if descent.is_narrow() {
            let (step, steepness) = directed(descent.x1.wrapping_sub(descent.x0), descent.dy);
            (position_of(descent.x0) + i64::from(below) * step, step, steepness)
        } else {
            (wide_position(descent, below), 0, Steepness::WIDE)
        };
        Self { position: halves(position), row_step: halves(step << SUBPIXEL_BITS), steepness, sent_to: 0 }
    }

    /// Outside of the narrow zone: what it steps by is all the way to the end of the band that it was made for last.
    #[inline(always)]
    pub(crate) fn is_wide(&self) -> bool {
        self.steepness.marked(0) == Steepness::WIDE
    }

    /// Makes a wide edge for the band from scan line `y` to `bottom`.
    #[inline(never)]
    pub(crate) fn widen(&mut self, upper: Vertex, lower: Vertex, y: i32, bottom: i32) {
        let below = |y: i32| y.wrapping_sub(upper.y.to_bits()).cast_unsigned();
        let at = |y: i32| wide_position(Descent::between(upper, lower), below(y));
        self.position = halves(at(y));
        self.row_step = halves(at(bottom).wrapping_sub(at(y)));
    }

    #[inline(always)]
    pub(crate) fn position(&self) -> i64 {
        joined(self.position)
    }

    #[inline(always)]
    pub(crate) fn move_to(&mut self, position: i64) {
        self.position = halves(position);
    }

    /// How far on it is on the next scan line.
    #[inline(always)]
    pub(crate) fn step(&self) -> i64 {
        self.row_step() >> SUBPIXEL_BITS
    }

    /// How far on it is in the next row of pixels.
    #[inline(always)]
    pub(crate) fn row_step(&self) -> i64 {
        joined(self.row_step)
    }

    /// How far on a wide edge is at the end of its band.
    #[inline(always)]
    pub(crate) fn band_step(&self) -> i64 {
        joined(self.row_step)
    }
}

/// How far on an edge in the direction (dx, dy), both at most 2^22, is on the next of `dy` scan lines.
#[inline(always)]
pub(crate) fn directed(dx: i32, dy: u32) -> (i64, Steepness) {
    let width = dx.unsigned_abs();
    let slope = divided::<HAS_WIDE_DIVISION>(width, dy);
    (if dx < 0 { -slope } else { slope }, Steepness::of(dy, width))
}

/// A position on an edge of any size.
#[inline(never)]
pub(crate) fn wide_position(descent: Descent, below: u32) -> i64 {
    let Descent { x0, x1, dy } = descent;
    let (whole, part) = divide_product(u64::from(below), x1.abs_diff(x0), dy);
    let distance = (whole << 32) | ((u64::from(part) << 32) / u64::from(dy.max(1)));
    if x1 >= x0 {
        position_of(x0).wrapping_add_unsigned(distance)
    } else {
        position_of(x0).wrapping_sub_unsigned(distance)
    }
}

/// Where words of 64 bits are divided as fast as two of 32.
const HAS_WIDE_DIVISION: bool = cfg!(target_pointer_width = "64");

/// `width / dy` to 2^-32; both at most 2^22, `dy` not 0.
#[inline(always)]
fn divided<const WIDE: bool>(width: u32, dy: u32) -> i64 {
    let dy = dy.max(1);
    if WIDE {
        return ((u64::from(width) << 32) / u64::from(dy)).cast_signed();
    }
    let (whole, rest) = (width / dy, width % dy);
    let part = if dy < 1 << 16 {
        let (high, rest) = ((rest << 16) / dy, (rest << 16) % dy);
        u64::from((high << 16) | ((rest << 16) / dy))
    } else {
        (u64::from(rest) << 32) / u64::from(dy)
    };
    (u64::from(whole) << 32 | part).cast_signed()
}

/// How far down a line goes for a pixel to the right, in units of height (see `ramp`): `mantissa 2^(32 - shift)`, with a
/// mantissa of 32 bits, of which the six lowest bits are given up for the shift, and two more for a mark.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Steepness(u32);

const SHIFT_MASK: u32 = 63;
const MARK_SHIFT: u32 = 6;
const MARK_MASK: u32 = 3 << MARK_SHIFT;
const MANTISSA_MASK: u32 = !(SHIFT_MASK | MARK_MASK);

impl Steepness {
    /// Vertical.
    pub(crate) const NONE: Self = Self(0);

    /// Not known.
    pub(crate) const WIDE: Self = Self(1);

    /// `down / across`, both below 2^31.
    #[inline(always)]
    pub(crate) fn of(down: u32, across: u32) -> Self {
        let Self(bits) = Self::ratio::<HAS_WIDE_DIVISION>(down, across);
        // A pixel's height has 255 / 256 of 2^30 units.
        let mantissa = bits & MANTISSA_MASK;
        Self(((mantissa - (mantissa >> 8)) & MANTISSA_MASK) | (bits & SHIFT_MASK))
    }

    /// The same for `down` in units of height.
    #[inline(always)]
    fn ratio<const WIDE: bool>(down: u32, across: u32) -> Self {
        if across == 0 || down == 0 {
            return Self::NONE;
        }
        // `down 2^left = quotient across + rest`; then as many bits more as the quotient has zeros in front.
        let left = down.leading_zeros();
        let down = down << left;
        if WIDE {
            let quotient = (u64::from(down) << 32) / u64::from(across);
            let more = quotient.leading_zeros();
            let mantissa = upper(quotient << more);
            return Self((mantissa & MANTISSA_MASK) | (2 + left + more).min(SHIFT_MASK));
        }
        let (quotient, rest) = (down / across, down % across);
        let more = quotient.leading_zeros() & 31;
        let mantissa = if more <= across.leading_zeros() {
            (quotient << more) | ((rest << more) / across)
        } else {
            #[allow(clippy::cast_possible_truncation, reason = "the quotient has `more` zeros in front")]
            let mantissa = ((u64::from(down) << more) / u64::from(across)) as u32;
            mantissa
        };
        // The ratio is `mantissa 2^-(left + more)`.
        Self((mantissa & MANTISSA_MASK) | (2 + left + more).min(SHIFT_MASK))
    }

    /// `down`, a height (see `ramp`), for a difference of positions.
    pub(crate) fn of_positions(down: u32, across: u64) -> Self {
        let excess = 33_u32.saturating_sub(across.leading_zeros());
        #[allow(clippy::cast_possible_truncation, reason = "31 bits are left")]
        let Self(bits) = Self::ratio::<HAS_WIDE_DIVISION>(down, (across >> excess) as u32);
        if bits == 0 {
            return Self::NONE;
        }
        // Below what the shift can say, the mantissa loses bits: at most two or three, and the rest is as fine.
        let shift = ((bits & SHIFT_MASK) + excess).saturating_sub(10).max(2);
        let mantissa = (bits & MANTISSA_MASK) >> shift.saturating_sub(SHIFT_MASK).min(31);
        Self((mantissa & MANTISSA_MASK) | shift.min(SHIFT_MASK))
    }

    /// Whether it crosses at most a pixel in a row: almost none that do are left out.
    #[inline(always)]
    pub(crate) fn is_steep(self) -> bool {
        self.0 & SHIFT_MASK <= 33
    }

    /// Two bits that whoever holds the slope may use.
    #[inline(always)]
    pub(crate) fn mark(self) -> i32 {
        ((self.0 & MARK_MASK) >> MARK_SHIFT).cast_signed()
    }

    #[inline(always)]
    pub(crate) fn marked(self, mark: i32) -> Self {
        Self((self.0 & !MARK_MASK) | (mark.cast_unsigned() << MARK_SHIFT))
    }

    /// The mantissa, and by how much to shift a width to the left and what is multiplied out to the right, to have heights
    /// in 2^-30.
    #[inline(always)]
    pub(crate) fn shifts(self) -> (u32, u32, u32) {
        // One bit less than it takes to have a width that is a pixel high in 32 bits: widths are rounded.
        let shift = self.0 & SHIFT_MASK;
        (self.0 & MANTISSA_MASK, 32_u32.saturating_sub(shift) & 31, shift.saturating_sub(32).min(31))
    }

    /// How far down for so many pixels, below 2^24.
    pub(crate) fn down_pixels(self, pixels: u32) -> u32 {
        let down = (u64::from(pixels) * u64::from(self.0 & MANTISSA_MASK)) >> (self.0 & SHIFT_MASK).saturating_sub(32);
        u32::try_from(down).unwrap_or(u32::MAX)
    }
}

impl Steep for Steepness {
    #[inline(always)]
    fn down(self, across: u32) -> u32 {
        #[allow(clippy::cast_possible_truncation, reason = "about 2^30, or less")]
        let down = ((u64::from(across) * u64::from(self.0 & MANTISSA_MASK)) >> (self.0 & SHIFT_MASK)) as u32;
        down
    }

    #[inline(always)]
    fn down_a_pixel(self) -> u32 {
        #[allow(clippy::cast_possible_truncation, reason = "about 2^30, or less")]
        let down = ((u64::from(self.0 & MANTISSA_MASK) << 32) >> (self.0 & SHIFT_MASK)) as u32;
        down
    }

    #[inline(always)]
    fn steepness(self) -> Steepness {
        self
    }
}

/// The upper half of a product.
#[inline(always)]
pub(crate) fn high_word(a: u32, b: u32) -> u32 {
    upper(u64::from(a) * u64::from(b))
}

#[inline(always)]
fn upper(value: u64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let upper = (value >> 32) as u32;
    upper
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boards divide words where hosts divide all at once: both find the same, for every width and height that an edge can have.
    #[test]
    fn words_are_divided_to_the_same_slopes() {
        let near_powers = |bits: u32| (0..=bits).flat_map(|bit| [(1_u32 << bit) - 1, 1 << bit, (1 << bit) / 3 * 2 + 1]);
        for (width, dy) in near_powers(22).flat_map(|width| near_powers(22).map(move |dy| (width, dy))) {
            assert_eq!(divided::<false>(width, dy), divided::<true>(width, dy), "{width} / {dy}");
        }
        for (down, across) in near_powers(30).flat_map(|down| near_powers(30).map(move |across| (down, across))) {
            assert_eq!(
                Steepness::ratio::<false>(down, across),
                Steepness::ratio::<true>(down, across),
                "{down} / {across}"
            );
        }
    }
}
