//! All eight octants by transformation: into the first octant, a line there, and its pixels back.
//!
//! ```text
//!   0 > m > -1   flip about the x axis    x' = x,  y' = -y
//!   m > 1        flip about y = x         x' = y,  y' = x
//!   x1 > x2      flip about the y axis    x' = -x, y' = y
//! ```
//!
//! A flip turns "exactly between two rows" around, too: which of them is drawn depends on the direction.

use core::ops::Range;

use crate::{Fragment, FragmentSink, PixelRect};

/// What leads from the first octant back to where the line is: first the transposition, then the flips.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Octant {
    /// x and y change places.
    pub transpose: bool,
    /// x' = -x.
    pub flip_x: bool,
    /// y' = -y.
    pub flip_y: bool,
}

impl Octant {
    /// Nothing has to be done.
    pub const FIRST: Self = Self { transpose: false, flip_x: false, flip_y: false };

    /// Of the direction (dx, dy).
    pub const fn of(dx: i32, dy: i32) -> Self {
        Self { transpose: dy.unsigned_abs() > dx.unsigned_abs(), flip_x: dx < 0, flip_y: dy < 0 }
    }

    /// Into the first octant.
    #[inline(always)]
    pub(in crate::methods) const fn into_first(self, [x, y]: [i32; 2]) -> [i32; 2] {
        let x = if self.flip_x { x.wrapping_neg() } else { x };
        let y = if self.flip_y { y.wrapping_neg() } else { y };
        if self.transpose { [y, x] } else { [x, y] }
    }

    /// And back.
    #[inline(always)]
    const fn back(self, [x, y]: [i32; 2]) -> [i32; 2] {
        let [x, y] = if self.transpose { [y, x] } else { [x, y] };
        [if self.flip_x { x.wrapping_neg() } else { x }, if self.flip_y { y.wrapping_neg() } else { y }]
    }

    /// The clip in the first octant.
    pub(in crate::methods) fn clip(self, clip: &PixelRect) -> PixelRect {
        let flipped = |range: &Range<i32>, flip: bool| {
            if flip { 1_i32.saturating_sub(range.end)..1_i32.saturating_sub(range.start) } else { range.clone() }
        };
        let (columns, rows) = (flipped(&clip.columns, self.flip_x), flipped(&clip.rows, self.flip_y));
        if self.transpose { PixelRect { rows: columns, columns: rows } } else { PixelRect { rows, columns } }
    }
}

/// Takes fragments of the first octant back to where they belong.
#[derive(Debug)]
pub struct Transformed<'s, S> {
    octant: Octant,
    sink: &'s mut S,
}

impl<'s, S> Transformed<'s, S> {
    /// Hands everything to `sink`.
    pub fn new(octant: Octant, sink: &'s mut S) -> Self {
        Self { octant, sink }
    }
}

impl<const N: usize, S: FragmentSink<N>> FragmentSink<N> for Transformed<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), S::Error> {
        let [x, y] = self.octant.back([fragment.x, fragment.y]);
        self.sink.fragment(Fragment { x, y, ..fragment })
    }

    #[inline(always)]
    fn visit(&mut self, x: i32, y: i32) {
        let [x, y] = self.octant.back([x, y]);
        self.sink.visit(x, y);
    }
}

/// Draws a line in whatever direction by a method for the first octant, which gets the line, the clip and the sink there.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [start, end]: [[i32; 2]; 2],
    clip: &PixelRect,
    sink: &mut S,
    first_octant: impl FnOnce([[i32; 2]; 2], &PixelRect, &mut Transformed<'_, S>) -> Result<(), S::Error>,
) -> Result<(), S::Error> {
    let octant = Octant::of(end[0].wrapping_sub(start[0]), end[1].wrapping_sub(start[1]));
    let line = [octant.into_first(start), octant.into_first(end)];
    first_octant(line, &octant.clip(clip), &mut Transformed::new(octant, sink))
}
