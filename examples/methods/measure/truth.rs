//! What the exact oracle says of a shape, pixel by pixel, and how a method's picture differs from it.

use std::ops::AddAssign;

use crate::variants::{HEIGHT, Picture, WIDTH};

/// What a shape's pixels are held against: the whole screen.
#[derive(Debug, Clone)]
pub(crate) struct Truth {
    pub(crate) wanted: Vec<Wanted>,
    /// How much of each pixel is covered, 0 to 1; empty where pixels are covered or not.
    pub(crate) coverage: Vec<f64>,
    /// What each pixel's attributes are; empty where there are none.
    pub(crate) attributes: Vec<[f64; 4]>,
    /// How many attributes count.
    pub(crate) channels: usize,
    /// Whether the one attribute is the depth.
    pub(crate) is_depth: bool,
}

/// What the rule makes of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Wanted {
    /// How many shapes own it.
    pub(crate) count: u16,
    /// Whether its centre lies on an outline, so that another rule for ties may decide otherwise.
    pub(crate) is_tie: bool,
}

impl Truth {
    /// Nothing is wanted yet.
    pub(crate) fn new() -> Self {
        let pixels = (WIDTH * HEIGHT) as usize;
        Self {
            wanted: vec![Wanted::default(); pixels],
            coverage: vec![],
            attributes: vec![],
            channels: 0,
            is_depth: false,
        }
    }

    /// How many pixels the oracle's picture has.
    pub(crate) fn pixels(&self) -> u64 {
        self.wanted.iter().filter(|wanted| wanted.count > 0).count() as u64
    }
}

/// How a pixel of a picture differs from the oracle's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// Rightly not there.
    Empty,
    /// Rightly there.
    Right,
    /// Its centre is covered, but it is not there.
    Missing,
    /// It is there, but its centre is not covered.
    Extra,
    /// It came more often than it should.
    Doubled,
    /// Its centre lies on the outline, and the method decides otherwise than the top-left rule.
    Moved,
}

/// What became of the pixel in this place.
pub(crate) fn verdict(picture: &Picture, truth: &Truth, at: usize) -> Verdict {
    let (count, wanted) = (picture.count[at], truth.wanted[at]);
    if count == wanted.count {
        return if count == 0 { Verdict::Empty } else { Verdict::Right };
    }
    if wanted.is_tie && (count == 0) != (wanted.count == 0) {
        return Verdict::Moved;
    }
    match (count, wanted.count) {
        (0, _) => Verdict::Missing,
        (_, 0) => Verdict::Extra,
        (more, less) if more > less => Verdict::Doubled,
        _ => Verdict::Missing,
    }
}

/// How far a pixel's coverage (in 255ths) or its worst attribute is off, beyond what rounding it once takes; nothing where
/// neither counts.
pub(crate) fn levels_off(picture: &Picture, truth: &Truth, at: usize) -> f64 {
    if let Some(coverage) = truth.coverage.get(at) {
        let drawn = if picture.count[at] == 0 { 0.0 } else { f64::from(picture.coverage[at]) };
        return beyond_rounding(drawn - 255.0 * coverage);
    }
    let Some(attributes) = truth.attributes.get(at) else { return 0.0 };
    if picture.count[at] == 0 || truth.wanted[at].count == 0 {
        return 0.0;
    }
    let off = |channel: usize| {
        let drawn =
            if truth.is_depth { f64::from(picture.depth[at]) } else { f64::from(picture.attributes[at][channel]) };
        beyond_rounding(drawn - attributes[channel])
    };
    (0..truth.channels).map(off).fold(0.0, f64::max)
}

fn beyond_rounding(off: f64) -> f64 {
    let beyond = off.abs() - 0.5;
    // The oracle's values are quotients in `f64`.
    if beyond < 1e-6 { 0.0 } else { beyond }
}

/// How a method's pictures differ from the oracle's, added up over shapes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Tally {
    /// Pixels of the oracle's pictures.
    pub(crate) pixels: u64,
    pub(crate) missing: u64,
    pub(crate) extra: u64,
    pub(crate) doubled: u64,
    /// Pixels that only another rule for ties moves.
    pub(crate) moved: u64,
    /// Pixels that the method looked at.
    pub(crate) visited: u64,
    /// Pixels that it wanted to draw outside of the screen.
    pub(crate) outside: u64,
    /// Shapes that it could not draw.
    pub(crate) refused: u64,
    /// Levels off: the sum over pixels, and the most.
    pub(crate) levels: f64,
    pub(crate) worst: f64,
}

impl Tally {
    pub(crate) fn of(picture: &Picture, truth: &Truth) -> Self {
        let mut tally = Self { visited: picture.visited, outside: picture.outside, ..Self::default() };
        for (at, (count, wanted)) in picture.count.iter().zip(&truth.wanted).enumerate() {
            if *count == 0 && wanted.count == 0 && truth.coverage.is_empty() {
                continue;
            }
            tally.pixels += u64::from(wanted.count > 0);
            match verdict(picture, truth, at) {
                Verdict::Empty | Verdict::Right => {}
                Verdict::Missing => tally.missing += 1,
                Verdict::Extra => tally.extra += 1,
                Verdict::Doubled => tally.doubled += 1,
                Verdict::Moved => tally.moved += 1,
            }
            let off = levels_off(picture, truth, at);
            tally.levels += off;
            tally.worst = tally.worst.max(off);
        }
        tally
    }

    /// Pixels that no rule for ties excuses.
    pub(crate) fn wrong(&self) -> u64 {
        self.missing + self.extra + self.doubled
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.missing += other.missing;
        self.extra += other.extra;
        self.doubled += other.doubled;
        self.moved += other.moved;
        self.visited += other.visited;
        self.outside += other.outside;
        self.refused += other.refused;
        self.levels += other.levels;
        self.worst = self.worst.max(other.worst);
    }
}
