//! Square roots of integers, to 2^-30 of them: of words by two steps of Newton's and a tangent.

/// The square root of a product, to 2^-30 of it.
#[inline]
pub(super) fn root(a: u64, b: u64) -> u64 {
    if let (Ok(a), Ok(b)) = (u32::try_from(a), u32::try_from(b)) {
        root_of_word(u64::from(a) * u64::from(b)).into()
    } else {
        root_of_wide(u128::from(a) * u128::from(b))
    }
}

/// The square root, to 2^-30 of it.
#[inline]
pub(crate) fn root_of_word(square: u64) -> u32 {
    let more = square.leading_zeros() & !1;
    if more >= 64 {
        return 0;
    }
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let top = ((square << more) >> 32) as u32;
    // 16 bits, and 16 more by the tangent there, which is at most 2^-16 of the last of the first too high.
    let root = root_of_normal(top);
    let rest = (top - root * root).min(2 * root - 1);
    // Never 0, but the compiler does not know, and would check.
    ((root << 16) + (rest << 15) / root.max(1)) >> (more / 2)
}

/// The square root of at least 2^30, rounded down, in half the instructions of `isqrt`, which takes any number.
///
/// A line is off by at most 3 % of it; two steps of Newton's make that 0.0005, then 10^-7, or less than 0.01. Both are means, of a
/// number and of what the square is of it, and so not below the root.
#[inline]
fn root_of_normal(square: u32) -> u32 {
    // `0.34315 x + 0.6863`, for `x` from 1 to 4.
    let guess = (((square >> 16) * 44_977) >> 16) + 22_489;
    let nearer = |root: u32| (root + square / root.max(1)) / 2;
    let root = nearer(nearer(guess)).min(0xFFFF);
    root - u32::from(root * root > square)
}

/// Bit by bit, for circles of more than 32768 pixels.
#[cold]
#[inline(never)]
fn root_of_wide(square: u128) -> u64 {
    let mut root = 0_u64;
    for bit in (0..48).rev() {
        let more = root | 1 << bit;
        if u128::from(more) * u128::from(more) <= square {
            root = more;
        }
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Around every square of 16 bits, where the root changes.
    #[test]
    fn roots_of_normal_numbers_are_rounded_down() {
        for root in 1 << 15..1_u32 << 16 {
            for square in [root * root, root * root + root, root * root + 2 * root] {
                assert_eq!(root_of_normal(square), root, "{square}");
            }
        }
    }
}
