//! The two divisions that an edge takes, in words of 32 bits where the processor has no wider ones.

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
                let (dy, divisor) = (numerator & 0x1_FFFF, divisor | 1 << 31);
                if dy <= 1 << 16 {
                    assert_eq!(share_in::<false>(dy, divisor), share_in::<true>(dy, divisor), "{dy}, {divisor}");
                }
            }
        }
    }
}
