//! Numbers of SVG path data, without floating point.

/// The factor that numbers are multiplied by before they are rounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub(super) numerator: u32,
    pub(super) denominator: u32,
}

impl Scale {
    pub(super) const ONE: Self = Self { numerator: 1, denominator: 1 };
}

/// Fraction bits of what is parsed.
pub(super) const PARSED_BITS: u32 = 32;

/// As far as numbers reach: their sums do not overflow.
const MOST: i64 = 1 << 60;

/// A number at the start of `text`, to the nearest 2^-32 after scaling, and what follows it. None where there is none.
///
/// `[+-]? (digits [. digits?] | . digits) ([eE] [+-]? digits)?`, as SVG 1.1 and CSS have it. `1.` is taken as well, as
/// viewers do.
pub(super) const fn number(text: &[u8], scale: Scale) -> Option<(i64, &[u8])> {
    let (is_negative, mut rest) = sign(text);
    let (mut mantissa, mut exponent) = (0_u64, 0_i32);
    let (mut has_digits, mut is_fraction) = (false, false);
    while let Some((&byte, next)) = rest.split_first() {
        match byte {
            b'0'..=b'9' => {
                has_digits = true;
                // Sixteen digits are more than can be told apart.
                if mantissa < 1_000_000_000_000_000 {
                    mantissa = mantissa * 10 + (byte - b'0') as u64;
                    if is_fraction {
                        exponent = exponent.saturating_sub(1);
                    }
                } else if !is_fraction {
                    exponent = exponent.saturating_add(1);
                }
            }
            b'.' if !is_fraction => is_fraction = true,
            _ => break,
        }
        rest = next;
    }
    if !has_digits {
        return None;
    }
    if let Some((power, after)) = power_of_ten(rest) {
        exponent = exponent.saturating_add(power);
        rest = after;
    }
    let magnitude = scaled(mantissa, exponent, scale);
    Some((if is_negative { -magnitude } else { magnitude }, rest))
}

const fn sign(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    }
}

/// What follows a number after `e`. An `e` without digits is not its own.
const fn power_of_ten(text: &[u8]) -> Option<(i32, &[u8])> {
    let ([b'e', rest @ ..] | [b'E', rest @ ..]) = text else { return None };
    let (is_negative, mut rest) = sign(rest);
    let (mut power, mut has_digits) = (0_i32, false);
    while let Some((&byte @ b'0'..=b'9', next)) = rest.split_first() {
        power = power.saturating_mul(10).saturating_add((byte - b'0') as i32);
        has_digits = true;
        rest = next;
    }
    if has_digits { Some((if is_negative { -power } else { power }, rest)) } else { None }
}

/// `mantissa 10^exponent scale`, to the nearest 2^-32, at most `MOST`.
const fn scaled(mantissa: u64, exponent: i32, scale: Scale) -> i64 {
    // Below 2^54 2^32 2^32.
    let mut value = ((mantissa as u128) << PARSED_BITS) * scale.numerator as u128;
    let mut divisor = if scale.denominator == 0 { 1 } else { scale.denominator as u128 };
    let mut exponent = exponent;
    while exponent > 0 && value != 0 {
        if quotient(value, divisor) >= MOST.cast_unsigned() as u128 {
            return MOST;
        }
        // Below 2^60 divisor, which is below 2^32: 2^92.
        value *= 10;
        exponent -= 1;
    }
    while exponent < 0 {
        // Less than half a unit, and ever less. (Neither side reaches 2^122.)
        if divisor > value * 2 {
            return 0;
        }
        divisor *= 10;
        exponent += 1;
    }
    let nearest = quotient(value + divisor / 2, divisor);
    #[allow(clippy::cast_possible_truncation, reason = "compared with MOST")]
    let nearest = if nearest > MOST.cast_unsigned() as u128 { MOST } else { nearest as i64 };
    nearest
}

/// There is always a divisor.
const fn quotient(value: u128, divisor: u128) -> u128 {
    match value.checked_div(divisor) {
        Some(quotient) => quotient,
        None => 0,
    }
}
