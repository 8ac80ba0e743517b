//! The bounding box, as each note rounds it.
//!
//! Sources: "6.837 Lecture 6" and "CISC 440/640 Lecture 13" for `(int) min` to `(int) (max + 1)` and for the table of
//! six entries; "Triangle Rasterization" (Purdue), slide 21, for `(int) (min + .5)` to `(int) (max - .5)`.
//!
//! `(int)` goes towards zero, so that left of and above the origin a box starts a pixel late and ends a pixel late. On
//! a screen that starts at 0 nothing comes of it; in a clip that starts elsewhere it loses column or row -1 and the
//! like. `(int) (max + 1)` is up to two pixels beyond the last centre inside: only time. `(int) (min + .5)` leaves out
//! a column or row whose centres lie exactly on the box, while `(int) (max - .5)` takes it in: on such lines the box
//! decides what the comparison with 0 was to decide.
//!
//! # The table
//!
//! The sign of A = y0 - y1 tells which of two vertices is higher, that of B = x1 - x0 which is further right. Three
//! signs each sort the vertices; the table has the first and the last of them:
//!
//! ```text
//! x1 >= x0  x2 >= x1  x0 >= x2     index   min, max
//!    1         0         0           0       0, 1
//!    0         1         0           1       1, 2
//!    1         1         0           2       0, 2
//!    0         0         1           3       2, 0
//!    1         0         1           4       2, 1
//!    0         1         1           5       1, 0
//! ```
//!
//! Three negative signs cannot be, as the differences add up to 0. Three signs `>= 0` come where all three x, or all
//! three y, are equal, or differ by less than what truncation to F fraction bits leaves of a difference: index 6, past
//! the table's end. The notes trust that such a triangle has no area and is gone before. It is not: the area is the
//! sum of three truncated C's, which need not cancel, and the published Java throws
//! `ArrayIndexOutOfBoundsException`: for 404 of 1000 triangles with one x, all in 1/256 px and within 100 px. In doubles
//! the sum is right for those, but for 515 of 1000 with coordinates in tenths it is not. Here that is
//! [`Failure::NoEntry`].

use core::ops::Range;

use crate::PixelRect;

use super::{
    super::number::{Number, Real},
    Failure,
    equation::EdgeEqn,
};

/// How a bounding box comes about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Bounds {
    /// The centres within: `ceil(min - 1/2)` to `floor(max - 1/2)`.
    Centres,
    /// `(int) min` to `(int) (max + 1)`.
    Outwards,
    /// `(int) (min + .5)` to `(int) (max - .5)`.
    Inwards,
    /// `(int) min` to `(int) (max + 1)`, the vertices found by the signs of the coefficients.
    Table,
}

/// The first pixel and the last.
type Extent = (i32, i32);

const SORT: [[usize; 2]; 6] = [[0, 1], [1, 2], [0, 2], [2, 0], [2, 1], [1, 0]];

impl Bounds {
    /// The part of the box that lies in the clip.
    ///
    /// # Errors
    ///
    /// [`Failure::NoEntry`] where the table has none.
    #[inline(always)]
    pub fn of<N: Number, E>(
        self,
        v: &[[N::Setup; 2]; 3],
        edges: &[EdgeEqn<N>; 3],
        clip: &PixelRect,
    ) -> Result<PixelRect, Failure<E>> {
        let [[x0, y0], [x1, y1], [x2, y2]] = *v;
        let (columns, rows) = if self == Self::Table {
            let [first, second, third] = edges;
            let xflag = first.flag + 2 * second.flag + 4 * third.flag;
            let (left, right) = entry(xflag & 7, [x0, x1, x2])?;
            let (bottom, top) = entry(xflag >> 3, [y0, y1, y2])?;
            (outwards(left, right), outwards(top, bottom))
        } else {
            (self.extent([x0, x1, x2]), self.extent([y0, y1, y2]))
        };
        Ok(PixelRect { rows: clipped(rows, &clip.rows), columns: clipped(columns, &clip.columns) })
    }

    #[inline(always)]
    fn extent<R: Real>(self, [a, b, c]: [R; 3]) -> Extent {
        let (min, max) = (a.at_most(b).at_most(c), a.at_least(b).at_least(c));
        match self {
            Self::Centres => centres(min, max),
            Self::Outwards | Self::Table => outwards(min, max),
            Self::Inwards => ((min + R::HALF).truncate(), (max - R::HALF).truncate()),
        }
    }
}

/// The pixels whose centres lie from `min` to `max`.
#[inline(always)]
pub fn centres<R: Real>(min: R, max: R) -> Extent {
    ((min - R::HALF).ceil(), (max - R::HALF).floor())
}

#[inline(always)]
fn outwards<R: Real>(min: R, max: R) -> Extent {
    (min.truncate(), (max + R::ONE).truncate())
}

/// The two vertices that an entry names, its index being one less than the flags.
#[inline(always)]
fn entry<R: Real, E>(flags: u8, [a, b, c]: [R; 3]) -> Result<(R, R), Failure<E>> {
    let index = i32::from(flags) - 1;
    let entry = usize::try_from(index).ok().and_then(|index| SORT.get(index));
    let Some(&[first, second]) = entry else { return Err(Failure::NoEntry { index }) };
    let vertex = |number: usize| match number {
        0 => a,
        1 => b,
        _ => c,
    };
    Ok((vertex(first), vertex(second)))
}

/// From the first to the last, in the clip.
#[inline(always)]
pub fn clipped((first, last): Extent, clip: &Range<i32>) -> Range<i32> {
    first.max(clip.start)..last.saturating_add(1).min(clip.end)
}
