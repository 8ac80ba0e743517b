//! Seed fill without memory: a walk along the boundary that fills only what it can spare.
//!
//! What is open and connected stays connected when a pixel is filled that is not a cut vertex, so that one place in it
//! is all there is to remember. The idea is D. Henrich's, "Space-efficient region filling in raster graphics", The
//! Visual Computer 1994, who marks loops; here, whether a pixel can be spared is decided exactly and without marks.
//!
//! ```text
//!     # # # # # # #       the walk keeps the boundary to its left;
//!     # > . . . . #       a pixel whose open neighbours touch each other around it (*) can be spared:
//!     # . # # # . #       its neighbours reach each other without it;
//!     # . . . # * #       of a loop around an island (#), none looks like that, and yet any one can be
//!     # # # # # # #
//! ```
//!
//! **Exactly.** Say p were filled. It would then be part of some piece W of what is not open, and all neighbours of p
//! would lie at W's edge. A connected set has one boundary curve with each piece of what is around it (Jordan's
//! theorem, in the grid: the set 4-connected and its surroundings 8-connected, or the other way round). So p can be
//! spared if and only if the boundary curve that starts at one of its neighbours, with p to the left, comes past all
//! of them.
//!
//! **It ends.** The outer boundary always has a pixel that can be spared. Take a leaf of the graph that the outer
//! walk goes along: the end of a dead end can be spared. A loop has a topmost and a lowest corner, of which one is
//! not where the loop hangs on the rest; both of its neighbours lie on the loop, and nothing else can hang on it that
//! the outer walk would not come past. From the boundary of an island, on which there may be none, the way up from
//! its topmost pixel leads to a boundary that reaches higher.

use super::region::{Connectivity, FillRegion, Open, SeedFillError};

/// To the right, down, left and up.
const STEPS: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

const UP: Heading = Heading(3);

/// One of the four [`STEPS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Heading(u8);

impl Heading {
    fn left(self) -> Self {
        Self(self.0.wrapping_add(3) & 3)
    }

    fn right(self) -> Self {
        Self(self.0.wrapping_add(1) & 3)
    }

    fn from(self, (x, y): Pixel) -> Pixel {
        let (dx, dy) = STEPS.get(usize::from(self.0)).copied().unwrap_or_default();
        (x.wrapping_add(dx), y.wrapping_add(dy))
    }
}

type Pixel = (i32, i32);

/// A place on a boundary: an open pixel, and one that is not open to the left of where it heads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    at: Pixel,
    heading: Heading,
}

/// Fills all open pixels that are connected to an open one.
pub(super) fn walk<R: FillRegion>(
    open: &mut Open<'_, R>,
    x: i32,
    y: i32,
    connectivity: Connectivity,
) -> Result<(), SeedFillError<R::Error>> {
    let walk = Walk { open, eight: connectivity == Connectivity::Eight };
    let mut place = walk.ceiling((x, y));
    while let Some(spare) = walk.find_spare(place)? {
        walk.open.fill(spare.1, spare.0..spare.0.wrapping_add(1))?;
        let Some(next) = walk.first_neighbour(spare) else { break };
        place = next;
    }
    Ok(())
}

struct Walk<'o, 'r, R> {
    open: &'o mut Open<'r, R>,
    eight: bool,
}

impl<R: FillRegion> Walk<'_, '_, R> {
    fn has(&self, (x, y): Pixel) -> bool {
        self.open.has(x, y)
    }

    /// Straight up to where the way is barred.
    fn ceiling(&self, mut at: Pixel) -> Place {
        while self.has(UP.from(at)) {
            at = UP.from(at);
        }
        Place { at, heading: UP.right() }
    }

    /// A pixel that can be spared; none only if the region changes by itself.
    fn find_spare(&self, mut start: Place) -> Result<Option<Pixel>, SeedFillError<R::Error>> {
        let mut highest = i32::MAX;
        loop {
            // One that is seen to be spare, once around the boundary; then one that is found out to be.
            if let Some(spare) = self.around(start, |at| self.is_spare_here(at)) {
                return Ok(Some(spare));
            }
            let mut topmost = start.at;
            let spare = self.around(start, |at| {
                topmost = if at.1 < topmost.1 { at } else { topmost };
                self.is_spare(at)
            });
            if spare.is_some() {
                return Ok(spare);
            }
            if topmost.1 >= highest {
                return Err(SeedFillError::Unreadable { x: topmost.0, y: topmost.1 });
            }
            highest = topmost.1;
            start = self.ceiling(topmost);
        }
    }

    /// The first pixel of a boundary that is looked for, once around.
    fn around(&self, start: Place, mut is_wanted: impl FnMut(Pixel) -> bool) -> Option<Pixel> {
        let mut place = start;
        if is_wanted(place.at) {
            return Some(place.at);
        }
        loop {
            let next = self.next(place, |at| self.has(at));
            if next == start {
                return None;
            }
            if next.at != place.at && is_wanted(next.at) {
                return Some(next.at);
            }
            place = next;
        }
    }

    /// The next place on a boundary. This is a permutation of the places: it leads back to where it began.
    fn next(&self, Place { at, heading }: Place, has: impl Fn(Pixel) -> bool) -> Place {
        let ahead = heading.from(at);
        let ahead_left = heading.left().from(ahead);
        let (has_ahead, has_ahead_left) = (has(ahead), has(ahead_left));
        if has_ahead_left && (has_ahead || self.eight) {
            Place { at: ahead_left, heading: heading.left() }
        } else if has_ahead {
            Place { at: ahead, heading }
        } else {
            Place { at, heading: heading.right() }
        }
    }

    /// Which of the eight pixels around one are open, a bit each, clockwise from the right.
    fn ring(&self, at: Pixel) -> u8 {
        let mut bits = 0;
        let mut heading = Heading(0);
        for side in 0..4 {
            let neighbour = heading.from(at);
            bits |= u8::from(self.has(neighbour)) << (2 * side);
            bits |= u8::from(self.has(heading.right().from(neighbour))) << (2 * side + 1);
            heading = heading.right();
        }
        bits
    }

    /// Whether the open neighbours reach each other around the pixel: Yokoi's number of connectivity is at most 1.
    fn is_spare_here(&self, at: Pixel) -> bool {
        // For 8-connectivity, the pieces of what is not open are counted, which are as many.
        let ring = if self.eight { !self.ring(at) } else { self.ring(at) };
        let (next, after_next) = (ring.rotate_right(1), ring.rotate_right(2));
        (ring & !(next & after_next) & SIDES).count_ones() <= 1
    }

    /// Whether the open neighbours reach each other without the pixel, by whatever way.
    fn is_spare(&self, at: Pixel) -> bool {
        let ring = self.ring(at);
        let sides = ring & SIDES;
        // A corner next to an open side is connected to that.
        let corners = ring & !SIDES & !(sides.rotate_left(1) | sides.rotate_right(1));
        let mut missing = if self.eight { sides | corners } else { sides };
        let Some(start) = self.first_neighbour(at) else { return true };
        let mut place = start;
        loop {
            missing &= !bit_around(at, place.at);
            if missing == 0 {
                return true;
            }
            place = self.next(place, |pixel| pixel != at && self.has(pixel));
            if place == start {
                return false;
            }
        }
    }

    /// A neighbour of a pixel, with that pixel to the left, or one of the same piece of what is not open.
    fn first_neighbour(&self, at: Pixel) -> Option<Place> {
        let mut heading = Heading(0);
        for _ in 0..4 {
            let neighbour = heading.from(at);
            if self.has(neighbour) {
                return Some(Place { at: neighbour, heading: heading.left() });
            }
            heading = heading.right();
        }
        if !self.eight {
            return None;
        }
        for _ in 0..4 {
            // None of the sides is open: the one that was passed on the way to the corner is to the left of there.
            let corner = heading.right().from(heading.from(at));
            if self.has(corner) {
                return Some(Place { at: corner, heading });
            }
            heading = heading.right();
        }
        None
    }
}

/// The neighbours by sides.
const SIDES: u8 = 0b0101_0101;

/// The bit of [`Walk::ring`] that `other` has around `at`; none if it is not next to it.
fn bit_around(at: Pixel, other: Pixel) -> u8 {
    match (other.0.wrapping_sub(at.0), other.1.wrapping_sub(at.1)) {
        (1, 0) => 1,
        (1, 1) => 1 << 1,
        (0, 1) => 1 << 2,
        (-1, 1) => 1 << 3,
        (-1, 0) => 1 << 4,
        (-1, -1) => 1 << 5,
        (0, -1) => 1 << 6,
        (1, -1) => 1 << 7,
        _ => 0,
    }
}
