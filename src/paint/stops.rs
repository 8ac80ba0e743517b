//! The colours of a gradient, and what lies between them.

use core::fmt;

use crate::{attribute::Channels, paint::dither::rounding};

/// A colour at a place of a gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Stop<C> {
    /// Where, in 1/65536 of the gradient: 0 at its start, 65536 at its end.
    pub offset: u32,
    /// Which colour it has there.
    pub colour: C,
}

impl<C> Stop<C> {
    /// A colour at a place in 1/65536.
    #[inline]
    pub const fn new(offset: u32, colour: C) -> Self {
        Self { offset, colour }
    }
}

/// What lies before the start and after the end of a gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Spread {
    /// The colours of the ends.
    #[default]
    Pad,
    /// The gradient again.
    Repeat,
    /// The gradient again, every second one backwards.
    Reflect,
}

/// Stops that make no gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BadStops {
    /// There is no colour at all.
    None,
    /// A stop lies before the one that precedes it.
    Unsorted {
        /// Which one.
        index: usize,
    },
    /// A stop lies after the end.
    TooFar {
        /// Which one.
        index: usize,
    },
}

impl fmt::Display for BadStops {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("a gradient needs at least one stop"),
            Self::Unsorted { index } => write!(f, "stop {index} lies before the one that precedes it"),
            Self::TooFar { index } => write!(f, "stop {index} lies beyond 65536"),
        }
    }
}

impl core::error::Error for BadStops {}

/// The stops of a gradient: colours in order, each channel in a line between two of them.
///
/// The colour is the exact one's nearest step in each channel, or the next to it. Two stops at one place make a hard
/// edge: before it the first one's colour, from there on the second one's. Before the first stop is the first one's
/// colour, after the last the last one's.
///
/// ```text
///   0       16384              65536         offsets
///   a . . . b | c . . . . . . . d            two stops, b and c, at 16384
/// ```
///
/// # Errors
///
/// No stops, or an offset that is less than the one before or more than 65536: see [`BadStops`].
///
/// # Cost
///
/// A division for each pair of stops that a row comes into, a multiplication for each channel and pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Stops<'a, C, const N: usize> {
    stops: &'a [Stop<C>],
    spread: Spread,
    dithered: bool,
}

/// A whole gradient, in the unit of places within it.
pub(super) const WHOLE: i64 = 1 << 32;

/// Before the start: not the same as there, where two stops may be.
const BEFORE: i64 = -1;

impl<'a, C: Channels<N>, const N: usize> Stops<'a, C, N> {
    /// Stops in order.
    ///
    /// # Errors
    ///
    /// See [`BadStops`].
    pub fn new(stops: &'a [Stop<C>], spread: Spread) -> Result<Self, BadStops> {
        if stops.is_empty() {
            return Err(BadStops::None);
        }
        let mut before = 0;
        for (index, stop) in stops.iter().enumerate() {
            if stop.offset > 1 << 16 {
                return Err(BadStops::TooFar { index });
            }
            if stop.offset < before {
                return Err(BadStops::Unsorted { index });
            }
            before = stop.offset;
        }
        Ok(Self { stops, spread, dithered: false })
    }

    /// The same, with an ordered dither in place of rounding: for colours of few steps.
    #[inline]
    pub const fn dithered(self) -> Self {
        Self { dithered: true, ..self }
    }

    /// The same for gradients that have no length: everything is beyond the end.
    pub(super) fn padded(&self) -> Self {
        Self { spread: Spread::Pad, ..*self }
    }

    /// Colours at places, which are those of pixels.
    #[inline]
    pub(super) fn colours<I: Iterator<Item = i64>>(
        self,
        row: i32,
        column: i32,
        places: I,
    ) -> impl Iterator<Item = C> + use<'a, C, N, I> {
        let mut column = column;
        let mut between: Option<Between<N>> = None;
        places.map(move |place| {
            let place = self.spread.place(place);
            let between = match &between {
                Some(known) if known.has(place) => known,
                _ => between.insert(self.between(place)),
            };
            let colour = between.at(place, rounding(self.dithered, row, column));
            column = column.wrapping_add(1);
            colour
        })
    }

    /// The stops around a place.
    fn between(&self, place: i64) -> Between<N> {
        let after = self.stops.partition_point(|stop| i64::from(stop.offset) << 16 <= place);
        let (before, after) = (after.checked_sub(1).and_then(|at| self.stops.get(at)), self.stops.get(after));
        let Some((first, second)) = before.or(after).zip(after.or(before)) else { return Between::EMPTY };
        let (start, end) = (
            before.map_or(BEFORE, |stop| i64::from(stop.offset) << 16),
            after.map_or(WHOLE + 1, |stop| i64::from(stop.offset) << 16),
        );
        let from = first.colour.channels();
        let mut change = second.colour.channels();
        for (change, from) in change.iter_mut().zip(from) {
            *change -= from;
        }
        // 2^32 over the width, in 2^-16: times a distance, the share of it in 2^-16 after 32 bits are cut off.
        Between { start, end, inverse: (1 << 48) / (end - start).max(1), from, change }
    }
}

/// Two stops around a place, from the first one's on and before the second one's.
struct Between<const N: usize> {
    start: i64,
    end: i64,
    inverse: i64,
    from: [i32; N],
    change: [i32; N],
}

impl<const N: usize> Between<N> {
    const EMPTY: Self = Self { start: BEFORE, end: WHOLE + 1, inverse: 0, from: [0; N], change: [0; N] };

    #[inline]
    fn has(&self, place: i64) -> bool {
        self.start <= place && place < self.end
    }

    #[inline]
    fn at<C: Channels<N>>(&self, place: i64, rounding: i32) -> C {
        // The inverse has 16 bits at least where widths are greatest, and then a distance has 32: 2^48 at most.
        let share = (place - self.start).wrapping_mul(self.inverse) >> 32;
        let share = i32::try_from(share).unwrap_or(0);
        let mut channels = self.from;
        for ((channel, change), last) in channels.iter_mut().zip(&self.change).zip(C::LAST) {
            *channel = (((*channel << 16) + change * share + rounding) >> 16).clamp(0, last);
        }
        C::from_channels(channels)
    }
}

impl Spread {
    /// A place anywhere to one in `BEFORE..=WHOLE`.
    #[inline]
    fn place(self, place: i64) -> i64 {
        match self {
            Self::Pad => place.clamp(BEFORE, WHOLE),
            Self::Repeat => place & (WHOLE - 1),
            Self::Reflect => {
                let twice = place & (2 * WHOLE - 1);
                if twice > WHOLE { 2 * WHOLE - twice } else { twice }
            }
        }
    }
}
