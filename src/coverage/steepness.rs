//! How steep an edge is.

use crate::coverage::ramp::Steep;

/// Where words of 64 bits are divided as fast as two of 32.
pub(super) const HAS_WIDE_DIVISION: bool = cfg!(target_pointer_width = "64");

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

    /// As in `slope`.
    #[test]
    fn words_are_divided_to_the_same_steepness() {
        let near_powers = || (0..=30).flat_map(|bit| [(1_u32 << bit) - 1, 1 << bit, (1 << bit) / 3 * 2 + 1]);
        for (down, across) in near_powers().flat_map(|down| near_powers().map(move |across| (down, across))) {
            let [by_words, at_once] = [Steepness::ratio::<false>(down, across), Steepness::ratio::<true>(down, across)];
            assert_eq!(by_words, at_once, "{down} / {across}");
        }
    }
}
