//! Divisions, in words of 32 bits where the processor has no wider ones: no division of 64 bits is linked then.

use core::hint::black_box;

/// Whether a division of 64 bits is an instruction.
const HAS_WIDE_DIVISION: bool = cfg!(target_pointer_width = "64");

/// `(numerator << 32) / divisor`, rounded down; 0 by 0.
#[inline]
pub(crate) fn ratio(numerator: u32, divisor: u32) -> u64 {
    ratio_in::<HAS_WIDE_DIVISION>(numerator, divisor)
}

/// `(dy << 47) / divisor`, rounded down and at most 2^32 - 1, for `dy` of at most 2^16 and a divisor of at least 2^31.
#[inline]
pub(super) fn share(dy: u32, divisor: u32) -> u32 {
    share_in::<HAS_WIDE_DIVISION>(dy, divisor)
}

#[inline]
fn ratio_in<const WIDE: bool>(numerator: u32, divisor: u32) -> u64 {
    if WIDE {
        return (u64::from(numerator) << 32).checked_div(divisor.into()).unwrap_or(0);
    }
    let whole = numerator.checked_div(divisor).unwrap_or(0);
    let rest = numerator.wrapping_sub(whole.wrapping_mul(divisor));
    let zeros = divisor.leading_zeros() & 31;
    u64::from(whole) << 32 | u64::from(divide(rest << zeros, 0, divisor << zeros))
}

#[inline]
fn share_in<const WIDE: bool>(dy: u32, divisor: u32) -> u32 {
    if WIDE {
        let quotient = (u64::from(dy) << 47).checked_div(divisor.into()).unwrap_or(0);
        return u32::try_from(quotient).unwrap_or(u32::MAX);
    }
    let high = dy << 15;
    if high >= divisor { u32::MAX } else { divide(high, 0, divisor) }
}

/// `product / divisor`, rounded down, for a divisor of at most 2^16; 0 by 0.
#[inline]
pub(super) fn floor_ratio(product: i64, divisor: u32) -> i64 {
    floor_ratio_in::<HAS_WIDE_DIVISION>(product, divisor)
}

/// `distance * across / length`, rounded down, for a distance of at most the length, which is below 2^47, and `across` of at
/// most 2^16; 0 where there is no length.
#[inline]
pub(super) fn part_of(distance: u64, across: u32, length: u64) -> u32 {
    part_of_in::<HAS_WIDE_DIVISION>(distance, across, length)
}

/// By digits of 16 bits. What is negative is one less than the negative of what it is from -1 down.
#[cfg_attr(target_pointer_width = "64", inline)]
fn floor_ratio_in<const WIDE: bool>(product: i64, divisor: u32) -> i64 {
    if WIDE {
        return product.checked_div_euclid(divisor.into()).unwrap_or(0);
    }
    let sign = product >> 63;
    let magnitude = (product ^ sign).cast_unsigned();
    let (mut quotient, mut rest) = (0_u64, 0_u32);
    for digit in [48, 32, 16, 0] {
        #[allow(clippy::cast_possible_truncation, reason = "16 bits")]
        let digits = rest << 16 | (magnitude >> digit) as u32 & 0xFFFF;
        let here = digits.checked_div(divisor).unwrap_or(0);
        rest = digits.wrapping_sub(here.wrapping_mul(divisor));
        quotient = quotient << 16 | u64::from(here);
    }
    if divisor == 0 { 0 } else { quotient.cast_signed() ^ sign }
}

/// Bit by bit: the quotient has 17.
#[cfg_attr(target_pointer_width = "64", inline)]
fn part_of_in<const WIDE: bool>(distance: u64, across: u32, length: u64) -> u32 {
    let mut rest = distance * u64::from(across);
    if WIDE {
        return u32::try_from(rest.checked_div(length).unwrap_or(0)).unwrap_or(u32::MAX);
    }
    let mut quotient = 0;
    for bit in (0..=16).rev() {
        if length != 0 && rest >> bit >= length {
            rest -= length << bit;
            quotient |= 1 << bit;
        }
    }
    quotient
}

/// `(high << 32 | low) / divisor`, for `high < divisor` and a divisor whose highest bit is set: two digits of 16 bits, each
/// guessed by the divisor's upper half and too great by two at the most (D. E. Knuth, "The art of computer programming",
/// volume 2, 4.3.1, algorithm D, 1969; H. S. Warren, "Hacker's delight", 2002).
#[inline]
fn divide(high: u32, low: u32, divisor: u32) -> u32 {
    let (upper, lower) = (divisor >> 16, divisor & 0xFFFF);
    let digit = |rest: u32, next: u32| {
        let mut digit = rest.checked_div(upper).unwrap_or(0);
        let mut left = rest.wrapping_sub(digit.wrapping_mul(upper));
        while digit > 0xFFFF || digit.wrapping_mul(lower) > (left << 16 | next) {
            // Not unrolled: mostly there is nothing to make up for.
            black_box(());
            digit -= 1;
            left += upper;
            if left > 0xFFFF {
                break;
            }
        }
        (digit, (rest << 16 | next).wrapping_sub(digit.wrapping_mul(divisor)))
    };
    let (first, rest) = digit(high, low >> 16);
    let (second, _) = digit(rest, low & 0xFFFF);
    first << 16 | second
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> impl Iterator<Item = u32> {
        (0..32).flat_map(|bit| {
            let power = 1_u32 << bit;
            [power - 1, power, power + 1, power / 3 * 2 + 1, power ^ 0x5A5A_5A5A, power.wrapping_mul(0x9E37_79B9)]
        })
    }

    /// Boards divide words where hosts divide all at once.
    #[test]
    fn words_are_divided_to_the_same_quotients() {
        for divisor in numbers() {
            for numerator in numbers() {
                let context = || std::format!("{numerator} / {divisor}");
                assert_eq!(
                    ratio_in::<false>(numerator, divisor),
                    ratio_in::<true>(numerator, divisor),
                    "{}",
                    context()
                );
                let (across, product) = (numerator & 0xFFFF, i64::from(divisor >> 2) * i64::from(numerator));
                for product in [product, -product, !product] {
                    let (narrow, wide) =
                        (floor_ratio_in::<false>(product, across), floor_ratio_in::<true>(product, across));
                    assert_eq!(narrow, wide, "{product} / {across}");
                }
                let (distance, length) = (u64::from(divisor) << 14, (u64::from(divisor) << 14) + u64::from(numerator));
                for (distance, length) in [(distance, length), (distance.min(numerator.into()), numerator.into())] {
                    let (narrow, wide) =
                        (part_of_in::<false>(distance, across, length), part_of_in::<true>(distance, across, length));
                    assert_eq!(narrow, wide, "{distance} {across} / {length}");
                }
                let (dy, divisor) = (numerator & 0x1_FFFF, divisor | 1 << 31);
                if dy <= 1 << 16 {
                    assert_eq!(share_in::<false>(dy, divisor), share_in::<true>(dy, divisor), "{dy}, {divisor}");
                }
            }
        }
    }
}
