//! What one pixel has of a line, in words of 32 bits.

use crate::area::{
    accumulator::Accumulator,
    cell::{CELL_BITS, WHOLE},
    division::floor_ratio,
    line::Line,
};

/// Bits behind the point of a column within the pixel.
pub(super) const PIECE_BITS: u32 = 29;

/// A line within the pixel, in 32 bytes: columns in 2^-29 pixel from its left side, heights in 2^-16 from the top of the row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    x0: i32,
    x1: i32,
    /// Per 2^-16 pixel downwards, in 2^-45 pixel.
    slope: i64,
    /// Where it is at the top and the bottom of the band.
    pub(super) above: i32,
    pub(super) below: i32,
    y0: u16,
    /// The last height that it is at.
    last: u16,
    /// Where what has not been added yet begins.
    from: u16,
    pub(super) weight: i8,
    pub(super) direction: i8,
}

const _: () = assert!(size_of::<Piece>() == 32);

impl Piece {
    pub(super) const NONE: Self =
        Self { x0: 0, x1: 0, slope: 0, above: 0, below: 0, y0: 0, last: 0, from: 0, weight: 0, direction: 0 };

    /// Of a line between the two sides of a column, the left one in 2^-32 pixel.
    #[inline]
    pub(super) fn new(line: &Line, direction: i8, left: i64) -> Self {
        #[allow(clippy::cast_possible_truncation, reason = "from 0 to 2^29")]
        let within = |x: i64| ((x - left) >> (32 - PIECE_BITS)) as i32;
        let (x0, x1) = (within(line.x0), within(line.x1));
        let slope = floor_ratio(i64::from(x1 - x0) << 16, (line.y1 - line.y0).unsigned_abs());
        let (y0, last) = (height(line.y0), height(line.y1 - 1));
        Self { x0, x1, slope, above: x0, y0, last, from: y0, direction, ..Self::NONE }
    }

    /// Where it begins.
    #[inline]
    pub(super) fn start(&self) -> i32 {
        self.y0.into()
    }

    /// Where it ends.
    #[inline]
    pub(super) fn end(&self) -> i32 {
        i32::from(self.last) + 1
    }

    #[inline]
    pub(super) fn x_at(&self, y: i32) -> i32 {
        if y == self.end() {
            return self.x1;
        }
        #[allow(clippy::cast_possible_truncation, reason = "between both ends")]
        let moved = ((self.slope * i64::from(y - self.start())) >> 16) as i32;
        self.x0 + moved
    }

    /// Adds what is left of it, down to a height, and goes on with another weight.
    #[inline]
    pub(super) fn add(&mut self, y: i32, weight: i8, column: i32, accumulator: &mut Accumulator) {
        let from = self.from.into();
        if self.weight != 0 && y > from {
            let columns = (in_cell(self.x_at(from)), in_cell(self.x_at(y)));
            accumulator.add_to_column(column, columns, y - from, self.weight.into());
        }
        (self.from, self.weight) = (height(y), weight);
    }
}

/// From 2^-29 pixel to 2^-24; what lies on the right side is still within.
#[inline]
fn in_cell(x: i32) -> u32 {
    (x.unsigned_abs() >> (PIECE_BITS - CELL_BITS)).min(WHOLE - 1)
}

/// Below a pixel's, which no piece begins at.
#[inline]
fn height(y: i32) -> u16 {
    u16::try_from(y).unwrap_or(u16::MAX)
}
