//! The transfer curve of sRGB (IEC 61966-2-1), in integers, as tables made by the compiler.

/// The light that each step of a channel stands for, in 65535ths of the brightest.
///
/// There is one for each depth: 2 steps take 4 bytes, 256 take 512. Only those in use are part of a program.
pub(crate) const fn light<const STEPS: usize>() -> [u16; STEPS] {
    let mut table = [0; STEPS];
    let mut step = 0;
    while step < STEPS {
        #[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
        {
            table[step] = linear(step as u128, STEPS as u128 - 1);
        }
        step += 1;
    }
    table
}

/// The light of `step` out of `last` (at most 255), to the nearest 65535th; ties are not met.
///
/// With `c = step / last`, that is `c / 12.92` up to `c = 0.04045` and `((c + 0.055) / 1.055)^2.4` above. There, with
/// `x = a / b` for what is raised, `x^2.4 = x^2 * (x^2)^(1/5)`, and the root is taken down to a 2^24th: `x <= 1`, so
/// the light is at most 65535 / 2^24 < 0.004 units too small before it is rounded. `tests::table_is_the_curve` finds
/// none that this moves.
const fn linear(step: u128, last: u128) -> u16 {
    const ONE: u128 = 65535;
    let (numerator, denominator) = if 100_000 * step <= 4045 * last {
        (ONE * 100 * step, 1292 * last)
    } else {
        // At most 211 * 255, squared below 2^32.
        let (a, b) = (200 * step + 11 * last, 211 * last);
        let square_q120 = (((a * a) << 96) / (b * b)) << 24;
        (ONE * a * a * fifth_root(square_q120), (b * b) << 24)
    };
    #[allow(clippy::cast_possible_truncation, reason = "step <= last, so at most 65535")]
    let rounded = ((2 * numerator + denominator) / (2 * denominator)) as u16;
    rounded
}

/// The integer part of the fifth root of a number up to 2^120, bit by bit.
const fn fifth_root(number: u128) -> u128 {
    let mut root = 0;
    let mut bit = 1 << 24;
    while bit > 0 {
        let candidate: u128 = root | bit;
        // Below 2^25, but for a second bit beside the 25th: then below 2^125, and too large.
        if candidate.pow(5) <= number {
            root = candidate;
        }
        bit >>= 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const STEPS: usize>() {
        for (step, &light) in light::<STEPS>().iter().enumerate() {
            let c = step as f64 / (STEPS - 1) as f64;
            let exact = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            assert_eq!(f64::from(light), (65535.0 * exact).round(), "step {step} of {STEPS}");
        }
    }

    #[test]
    fn table_is_the_curve() {
        check::<2>();
        check::<4>();
        check::<16>();
        check::<32>();
        check::<64>();
        check::<256>();
    }
}
