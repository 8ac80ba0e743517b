//! Dashes: a path in pieces of given lengths.
//!
//! Lengths are in 1/65536 pixel; that of a line is a root, off by less than one, so after `k` lines a dash is off by
//! `k` of them. The place in the pattern is an integer in those units, never a quotient. Curves are cut into four
//! times as many chords as otherwise, whose lengths are within 2^-18 of the arcs'; caps lie across the curve itself,
//! not its chord.

use crate::{
    outline::{Curve, CurveSink, FinePoint, OutlineSink, Vector},
    stroke::{
        StrokeStyle,
        normal::{Unit, length_q16},
        pieces::{Pieces, Run},
    },
};

/// The dashes of a style, and where in them a subpath starts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pattern<'d> {
    dashes: &'d [u32],
    /// Which of them; even ones are dashes, odd ones gaps, the second time around as well when they are odd in number.
    index: usize,
    /// What is left of it.
    left: u64,
}

impl<'d> Pattern<'d> {
    /// None where there are no gaps.
    pub(super) fn new(style: &StrokeStyle<'d>) -> Option<Self> {
        let dashes = style.dashes;
        let sum: u64 = dashes.iter().map(|length| u64::from(*length)).sum();
        let cycle = if dashes.len() % 2 == 1 { 2 * sum } else { sum };
        let cycle = i64::try_from(cycle).ok().filter(|cycle| *cycle > 0)?;
        let mut phase = i64::from(style.phase).rem_euclid(cycle).unsigned_abs();
        let mut pattern = Self { dashes, index: 0, left: 0 };
        loop {
            let length = pattern.length();
            if phase < length || phase == 0 {
                pattern.left = (length - phase) << 8;
                return Some(pattern);
            }
            phase -= length;
            pattern.index += 1;
        }
    }

    fn length(&self) -> u64 {
        let index = self.index.checked_rem(self.dashes.len()).unwrap_or(0);
        self.dashes.get(index).copied().unwrap_or(0).into()
    }

    const fn is_dash(&self) -> bool {
        self.index.is_multiple_of(2)
    }

    fn advance(&mut self) {
        // Both are even where the pattern starts again.
        self.index = (self.index + 1) % (2 * self.dashes.len()).max(1);
        self.left = self.length() << 8;
    }
}

/// Cuts what it is told into dashes.
#[derive(Debug)]
pub(super) struct Dasher<'p, 'd, 's, S> {
    start_pattern: Pattern<'d>,
    pattern: Pattern<'d>,
    pieces: &'p mut Pieces<'s, S>,
    start: FinePoint,
    at: FinePoint,
    /// Something of the subpath has had a length.
    has_length: bool,
    /// A dash has begun, and has or has not got any length yet.
    is_drawing: bool,
    is_empty: bool,
}

impl<'p, 'd, 's, S: OutlineSink> Dasher<'p, 'd, 's, S> {
    pub(super) fn new(pattern: Pattern<'d>, pieces: &'p mut Pieces<'s, S>) -> Self {
        let at = FinePoint::default();
        Self {
            start_pattern: pattern,
            pattern,
            pieces,
            start: at,
            at,
            has_length: false,
            is_drawing: false,
            is_empty: true,
        }
    }

    fn begin_dash(&mut self, at: FinePoint) {
        self.pieces.begin(at);
        (self.is_drawing, self.is_empty) = (true, true);
    }

    fn end_dash(&mut self, at: FinePoint, normal: Unit) {
        if self.is_drawing {
            if self.is_empty {
                self.pieces.dot(at, normal);
            } else {
                self.pieces.finish();
            }
            self.is_drawing = false;
        }
    }

    fn push(&mut self, run: Run) {
        self.pieces.push(run);
        self.is_empty = false;
    }

    /// Along something of a length: `part` makes the run between two places on it, `place` the point and normal.
    fn along(&mut self, length: u64, part: impl Fn(u64, u64) -> Option<Run>, place: impl Fn(u64) -> (FinePoint, Unit)) {
        let mut done = 0;
        loop {
            if self.pattern.is_dash() && !self.is_drawing {
                self.begin_dash(place(done).0);
            }
            let rest = length - done;
            let is_over = self.pattern.left > rest;
            let step = self.pattern.left.min(rest);
            if self.is_drawing
                && step > 0
                && let Some(run) = part(done, done + step)
            {
                self.push(run);
            }
            done += step;
            self.pattern.left -= step;
            if is_over {
                return;
            }
            let (at, normal) = place(done);
            self.end_dash(at, normal);
            self.pattern.advance();
        }
    }
}

/// The point at a part of the way.
fn between(from: FinePoint, to: FinePoint, part: u64, length: u64) -> FinePoint {
    let vector = Vector::between(from, to);
    let length = i128::from(length.max(1));
    let axis = |whole: i64| {
        let moved = crate::outline::divide_half_even(i128::from(whole) * i128::from(part), length);
        // Less than the whole.
        i64::try_from(moved).unwrap_or(whole)
    };
    Vector::new(axis(vector.x), axis(vector.y)).from(from)
}

impl<S: OutlineSink> CurveSink for Dasher<'_, '_, '_, S> {
    fn start(&mut self, at: FinePoint) {
        self.pattern = self.start_pattern;
        (self.start, self.at, self.has_length, self.is_drawing) = (at, at, false, false);
    }

    fn line(&mut self, to: FinePoint) {
        let from = self.at;
        let Some(whole) = Run::line(from, to) else { return };
        let length = length_q16(Vector::between(from, to));
        (self.has_length, self.at) = (true, to);
        let [normal, _] = whole.normals;
        let place = |part: u64| (between(from, to, part, length), normal);
        let part = |start: u64, end: u64| Some(Run { from: place(start).0, to: place(end).0, ..whole });
        self.along(length, part, place);
    }

    fn curve(&mut self, curve: &Curve) {
        let Some(whole) = Run::curve(curve) else { return };
        let curve = curve.refined();
        (self.has_length, self.at) = (true, curve.to());
        // Chord after chord, but a dash is one run from where it begins to where it ends, if that is on this curve.
        let mut from = curve.from();
        let (mut open_from, mut open_index, mut open_normal) = (from, 1, whole.normals[0]);
        if self.pattern.is_dash() && !self.is_drawing {
            self.begin_dash(from);
        }
        for (index, to) in (0..).zip(curve.points()) {
            let length = length_q16(Vector::between(from, to));
            let mut done = 0;
            while self.pattern.left <= length - done {
                done += self.pattern.left;
                let at = between(from, to, done, length);
                let part = u32::try_from((done << 16) / length.max(1)).unwrap_or(0);
                let normal = Unit::along(curve.direction(index, part))
                    .or_else(|| Unit::along(Vector::between(from, to)))
                    .unwrap_or(Unit::RIGHT)
                    .turned();
                if self.is_drawing {
                    if open_index <= index || at != open_from {
                        let normals = [open_normal, normal];
                        self.push(Run { from: open_from, to: at, normals, curve: Some((curve, open_index, index)) });
                    }
                    self.end_dash(at, normal);
                }
                self.pattern.advance();
                if self.pattern.is_dash() {
                    self.begin_dash(at);
                    (open_from, open_index, open_normal) = (at, index + 1, normal);
                }
            }
            self.pattern.left -= length - done;
            from = to;
        }
        let last = curve.chords().saturating_sub(1);
        if self.is_drawing && (open_index <= last || from != open_from) {
            let normals = [open_normal, whole.normals[1]];
            self.push(Run { from: open_from, to: from, normals, curve: Some((curve, open_index, last)) });
        }
    }

    fn end(&mut self, is_closed: bool) {
        if is_closed {
            self.line(self.start);
        }
        if !self.has_length {
            if self.pattern.is_dash() {
                self.pieces.dot(self.at, Unit::RIGHT.turned());
            }
        } else if self.is_drawing && !self.is_empty {
            self.pieces.finish();
        }
    }
}
