//! The edges of a side, from their upper ends down.

use crate::coverage::{
    ramp::{Extent, Ramp, Steep, height_in},
    slope::directed,
    steepness::{Steepness, high_word},
};

/// An edge that goes down; heights in 2^-`BITS` pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Straight<const BITS: u32> {
    /// Where it is at `y`.
    pub(super) position: i64,
    /// To the next row.
    pub(super) step: i64,
    pub(super) y: i32,
    /// Its lower end.
    until: i32,
    end: i64,
    pub(super) rise: Rise,
}

/// How steep an edge is, to be multiplied by words where registers have 32 bits: see [`Steepness::shifts`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Rise {
    mantissa: u32,
    up: u32,
    down: u32,
    steepness: Steepness,
}

const HAS_WIDE_REGISTERS: bool = cfg!(target_pointer_width = "64");

impl Rise {
    #[inline(always)]
    fn new(steepness: Steepness) -> Self {
        let (mantissa, up, down) = steepness.shifts();
        Self { mantissa, up, down, steepness }
    }

    #[inline(always)]
    fn down_in_words(self, across: u32) -> u32 {
        high_word(across << self.up, self.mantissa) >> self.down
    }

    #[inline(always)]
    fn down_a_pixel_in_words(self) -> u32 {
        self.mantissa >> self.down
    }
}

impl Steep for Rise {
    #[inline(always)]
    fn down(self, across: u32) -> u32 {
        if HAS_WIDE_REGISTERS { self.steepness.down(across) } else { self.down_in_words(across) }
    }

    #[inline(always)]
    fn down_a_pixel(self) -> u32 {
        if HAS_WIDE_REGISTERS { self.steepness.down_a_pixel() } else { self.down_a_pixel_in_words() }
    }

    #[inline(always)]
    fn steepness(self) -> Steepness {
        self.steepness
    }
}

impl<const BITS: u32> Straight<BITS> {
    /// From one position and height to another, in the direction (dx, dy), both at most 2^22.
    #[inline(always)]
    pub(crate) fn new(from: (i64, i32), to: (i64, i32), dx: i32, dy: u32) -> Self {
        let (step, steepness) = directed(dx, dy);
        Self { position: from.0, step, y: from.1, until: to.1, end: to.0, rise: Rise::new(steepness) }
    }

    /// From here to a position below.
    #[inline(always)]
    pub(super) fn ramp(&self, to: i64, height: u32) -> Ramp {
        // Compared, as corners of lines are rounded, and may be on the other side of a steep one.
        let from = self.position;
        let (from, to) = if from <= to { (from, to) } else { (to, from) };
        let extent = Extent { first: upper(from), last: upper(to), left: lower(from), right: lower(to) };
        Ramp::new(extent, height, self.rise)
    }

    #[inline(always)]
    pub(super) fn at(&self, y: i32) -> i64 {
        if y == self.until {
            self.end
        } else {
            self.position + ((self.step * i64::from((y - self.y).cast_unsigned())) >> BITS)
        }
    }

    /// Takes it to a height on its way that is the top of a row.
    #[inline(always)]
    pub(super) fn skip_to(&mut self, y: i32) {
        let boundary = (self.y + (1 << BITS) - 1) >> BITS << BITS;
        let rows = (y - boundary) >> BITS;
        self.position = self.at(boundary) + self.step * i64::from(rows);
        self.y = y;
    }
}

/// One side: an edge, and perhaps another below.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side<const BITS: u32> {
    pub(crate) edge: Straight<BITS>,
    pub(crate) next: Option<Straight<BITS>>,
}

impl<const BITS: u32> Side<BITS> {
    /// Takes it to the top of a row, unless it starts farther down.
    #[inline(always)]
    pub(super) fn skip_to(&mut self, row: i32) {
        let y = row << BITS;
        if y >= self.edge.until {
            self.turn();
        }
        if y > self.edge.y && y < self.edge.until {
            self.edge.skip_to(y);
        }
    }

    #[inline(always)]
    pub(super) fn turn(&mut self) {
        if let Some(next) = self.next.take() {
            self.edge = next;
        }
    }

    /// How many rows from `row` on its edge crosses from top to bottom.
    #[inline(always)]
    pub(super) fn whole_rows(&self, row: i32) -> i32 {
        if self.edge.y == row << BITS { (self.edge.until >> BITS) - row } else { 0 }
    }

    /// What it has of `row`, one or two pieces, and where it leaves the row.
    #[inline(always)]
    pub(super) fn pieces(&self, row: i32, mut piece: impl FnMut(&Ramp)) -> Foot {
        let bottom = (row + 1) << BITS;
        let mut edge = &self.edge;
        let mut next = self.next.as_ref();
        loop {
            let y = bottom.min(edge.until);
            let mut foot = Foot { position: edge.position, y: edge.y, has_turned: next.is_none() };
            if y > edge.y {
                foot.position = edge.at(y);
                foot.y = y;
                piece(&edge.ramp(foot.position, height_in::<BITS>(y - edge.y)));
            }
            match next.take() {
                Some(lower) if y >= edge.until => edge = lower,
                _ => return foot,
            }
        }
    }

    /// Takes it to where it leaves a row.
    #[inline(always)]
    pub(super) fn go_to(&mut self, foot: Foot) {
        if foot.has_turned {
            self.turn();
        }
        (self.edge.position, self.edge.y) = (foot.position, foot.y);
    }
}

/// Where a side leaves a row, and whether on the last of its edges.
#[derive(Debug, Clone, Copy)]
pub(super) struct Foot {
    position: i64,
    y: i32,
    has_turned: bool,
}

#[inline(always)]
pub(super) fn upper(position: i64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    let upper = (position >> 32) as i32;
    upper
}

#[inline(always)]
pub(super) fn lower(position: i64) -> u32 {
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    #[allow(clippy::cast_sign_loss, reason = "bits")]
    let lower = position as u32;
    lower
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boards multiply words where hosts multiply all at once: both find the same heights, for every width that an edge can
    /// have in a row.
    #[test]
    fn words_are_multiplied_to_the_same_heights() {
        let lengths = || (1..=22).flat_map(|bits| [(1_u32 << bits) - 1, 1 << bits, (1 << bits) / 3 * 2 + 1]);
        for (dx, dy) in lengths().flat_map(|dx| lengths().map(move |dy| (dx, dy))) {
            let (_, steepness) = directed(dx.cast_signed(), dy);
            let rise = Rise::new(steepness);
            // In 2^-32 pixel: what it crosses in a row, if that is less than a pixel.
            let widest = u32::try_from((u64::from(dx) << 32) / u64::from(dy)).unwrap_or(u32::MAX);
            for across in (0..32).map(|bits| widest >> bits).chain((1..100).map(|part| widest / 100 * part)) {
                assert_eq!(rise.down_in_words(across), steepness.down(across), "{dx} / {dy}: {across}");
            }
            if dx >= dy {
                assert_eq!(rise.down_a_pixel_in_words(), steepness.down_a_pixel(), "{dx} / {dy}");
            }
        }
    }
}
