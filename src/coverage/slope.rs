//! An edge for areas: where it is on every scan line, and how steep it is.
//!
//! A position is a coordinate in 1/256 pixel with 32 bits behind it. In the narrow zone (see `limits`) it is
//! `x0 + (y - y0) slope` with `slope = dx / dy` to 2^-32, whichever way it was come by: adding is exact, so no clip
//! changes a bit. As `dy <= 2^22`, it is within 2^-18 pixel of the true line at the lower end, and within 2^-24 where an
//! edge is no taller than 256 pixels. Outside of the zone it is divided out anew for every scan line, to 2^-40 pixel.

use crate::{
    Vertex,
    coverage::steepness::{HAS_WIDE_DIVISION, Steepness},
    edge::{Descent, divide_product},
    limits::SUBPIXEL_BITS,
};

/// An edge on its current scan line.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Slope {
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
