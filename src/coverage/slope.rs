//! An edge for areas: where it is on every scan line, and how steep it is.
//!
//! A position is a coordinate in 1/256 pixel with 32 bits behind it. In the narrow zone (see `limits`) it is
//! `x0 + (y - y0) slope` with `slope = dx / dy` to 2^-32, whichever way it was come by: adding is exact, so no clip
//! changes a bit. As `dy <= 2^22`, it is within 2^-18 pixel of the true line at the lower end, and within 2^-24 where an
//! edge is no taller than 256 pixels. Outside of the zone it is divided out anew for every scan line, to 2^-40 pixel.

use crate::{
    coverage::steepness::{HAS_WIDE_DIVISION, Steepness},
    edge::{Descent, divide_product},
};

/// The position of a coordinate in 1/256 pixel.
#[inline(always)]
pub(crate) fn position_of(coordinate: i32) -> i64 {
    i64::from(coordinate) << 32
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Boards divide words where hosts divide all at once: both find the same, for every width and height that an edge can have.
    #[test]
    fn words_are_divided_to_the_same_slopes() {
        let near_powers = || (0..=22).flat_map(|bit| [(1_u32 << bit) - 1, 1 << bit, (1 << bit) / 3 * 2 + 1]);
        for (width, dy) in near_powers().flat_map(|width| near_powers().map(move |dy| (width, dy))) {
            assert_eq!(divided::<false>(width, dy), divided::<true>(width, dy), "{width} / {dy}");
        }
    }
}
