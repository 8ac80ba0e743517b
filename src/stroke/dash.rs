//! Dashes: a path in pieces of given lengths.
//!
//! Lengths are in 1/65536 pixel; that of a line is a root, off by less than one, so after `k` lines a dash is off by
//! `k` of them. The place in the pattern is an integer in those units, never a quotient. Curves are cut into four
//! times as many chords as otherwise, whose lengths are within 2^-18 of the arcs'; caps lie across the curve itself,
//! not its chord.

use core::cell::Cell;

use crate::{
    outline::{Curves, FinePoint, Step, Vector},
    stroke::{
        Cap, StrokeStyle,
        normal::{Unit, length_q16},
        piece::Piece,
        run::Run,
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

/// A place on what is dashed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    step: u32,
    chord: u32,
    at: FinePoint,
    normal: Unit,
}

/// From one place to another: a dot where both are the same.
#[derive(Debug, Clone, Copy)]
struct Dash {
    from: Place,
    to: Place,
}

/// Where the walk along a path has got to.
#[derive(Debug, Clone, Copy)]
struct Pen<'d> {
    step: u32,
    chord: u32,
    /// Along the chord.
    done: u64,
    pattern: Pattern<'d>,
    /// Where the dash began that is being drawn.
    open: Option<Place>,
    /// The last step of the subpath that has a length; 0 for none.
    last: u32,
    is_in_subpath: bool,
}

/// How many places along the path are remembered.
const STOPS: usize = 16;

/// Every dash, by number: found from the nearest of a few that are remembered.
pub(super) struct Dashes<'d> {
    curves: &'d dyn Curves,
    start: Pattern<'d>,
    cap: Cap,
    count: u32,
    /// Before every `2^log_every`th dash.
    stops: [Option<Pen<'d>>; STOPS],
    log_every: u32,
    /// The dash that was asked for last, and where it was left.
    latest: Cell<Option<(u32, Dash, Pen<'d>)>>,
}

impl<'d> Dashes<'d> {
    /// None where there are no gaps.
    pub(super) fn new(curves: &'d dyn Curves, style: &StrokeStyle<'d>) -> Option<Self> {
        let start = Pattern::new(style)?;
        let mut dashes = Self {
            curves,
            start,
            cap: style.cap,
            count: 0,
            stops: [None; STOPS],
            log_every: 0,
            latest: Cell::new(None),
        };
        let mut pen = dashes.pen();
        loop {
            if (dashes.count >> dashes.log_every) as usize >= STOPS {
                let mut kept = [None; STOPS];
                for (kept, stop) in kept.iter_mut().zip(dashes.stops.iter().step_by(2)) {
                    *kept = *stop;
                }
                (dashes.stops, dashes.log_every) = (kept, dashes.log_every + 1);
            }
            if dashes.count & ((1 << dashes.log_every) - 1) == 0
                && let Some(stop) = dashes.stops.get_mut((dashes.count >> dashes.log_every) as usize)
            {
                *stop = Some(pen);
            }
            if dashes.advance(&mut pen).is_none() {
                return Some(dashes);
            }
            dashes.count += 1;
        }
    }

    const fn pen(&self) -> Pen<'d> {
        Pen { step: 0, chord: 0, done: 0, pattern: self.start, open: None, last: 0, is_in_subpath: false }
    }

    pub(super) const fn count(&self) -> u32 {
        self.count
    }

    fn dash(&self, number: u32) -> Option<Dash> {
        let latest = self.latest.get();
        if let Some((kept, dash, _)) = latest
            && kept == number
        {
            return Some(dash);
        }
        let stop = number >> self.log_every;
        let (mut next, mut pen) = match latest {
            Some((kept, _, pen)) if kept < number && kept >> self.log_every == stop => (kept + 1, pen),
            _ => (stop << self.log_every, (*self.stops.get(stop as usize)?)?),
        };
        loop {
            let dash = self.advance(&mut pen)?;
            if next == number {
                self.latest.set(Some((number, dash, pen)));
                return Some(dash);
            }
            next += 1;
        }
    }

    pub(super) fn is_dot(&self, number: u32) -> bool {
        self.dash(number).is_some_and(|dash| dash.from.at == dash.to.at && dash.from.step == dash.to.step)
    }

    pub(super) fn dot(&self, number: u32) -> (FinePoint, Unit) {
        self.dash(number).map_or((FinePoint::default(), Unit::RIGHT), |dash| (dash.from.at, dash.from.normal))
    }

    /// A step of a dash, numbered from 1.
    pub(super) fn piece(&self, number: u32, step: u32) -> Piece {
        let Some(Dash { from, to }) = self.dash(number) else { return Piece::NOTHING };
        let index = (from.step + step).wrapping_sub(1);
        if index < from.step || index > to.step {
            return Piece::NOTHING;
        }
        let run = self.run(index).map(|mut run| {
            if index == from.step {
                (run.from, run.normals[0]) = (from.at, from.normal);
                run.curve = run.curve.map(|(curve, _, last)| (curve, from.chord + 1, last));
            }
            if index == to.step {
                (run.to, run.normals[1]) = (to.at, to.normal);
                run.curve = run.curve.map(|(curve, first, _)| (curve, first, to.chord));
            }
            run
        });
        let has_length = |run: &Run| run.from != run.to || run.chords() > 1;
        Piece { is_over: false, is_last: index == to.step, run: run.filter(has_length) }
    }

    /// A whole step, of a curve in more chords.
    fn run(&self, step: u32) -> Option<Run> {
        let mut run = Run::of(&self.curves.step(step))?;
        if let Some((curve, ..)) = run.curve {
            let curve = curve.refined();
            run.curve = Some((curve, 1, curve.chords().saturating_sub(1)));
        }
        Some(run)
    }

    /// To the end of the next dash.
    fn advance(&self, pen: &mut Pen<'d>) -> Option<Dash> {
        loop {
            let step = (pen.step < self.curves.steps()).then(|| self.curves.step(pen.step));
            let Some(step) = step.filter(|step| !matches!(step, Step::Move(_))) else {
                let dash = self.end_subpath(pen, pen.step);
                if step.is_some() {
                    pen.step += 1;
                    self.begin_subpath(pen);
                }
                match dash {
                    None if step.is_none() => return None,
                    None => continue,
                    dash => return dash,
                }
            };
            if !pen.is_in_subpath {
                self.begin_subpath(pen);
            }
            if let Some(run) = self.run(pen.step) {
                if let Some(dash) = self.along(pen, &run) {
                    return Some(dash);
                }
                pen.last = pen.step;
            }
            (pen.step, pen.chord, pen.done) = (pen.step + 1, 0, 0);
            if matches!(step, Step::Close(..))
                && let Some(dash) = self.end_subpath(pen, pen.step)
            {
                return Some(dash);
            }
        }
    }

    fn begin_subpath(&self, pen: &mut Pen<'d>) {
        (pen.pattern, pen.open, pen.last, pen.is_in_subpath) = (self.start, None, 0, true);
        (pen.chord, pen.done) = (0, 0);
    }

    /// What is left of a dash, or a dot where nothing had a length.
    fn end_subpath(&self, pen: &mut Pen<'d>, end: u32) -> Option<Dash> {
        let is_over = core::mem::replace(&mut pen.is_in_subpath, false);
        let before = end.checked_sub(1).filter(|_| is_over)?;
        if pen.last == 0 {
            let step = self.curves.step(before);
            let place = Place { step: before, chord: 0, at: step.end(), normal: Unit::RIGHT.turned() };
            let is_dot = pen.pattern.is_dash() && self.cap != Cap::Butt && !matches!(step, Step::Move(_));
            return is_dot.then_some(Dash { from: place, to: place });
        }
        let run = self.run(pen.last)?;
        let chord = run.chords().saturating_sub(1);
        let to = Place { step: pen.last, chord, at: run.to, normal: run.normals[1] };
        let from = pen.open.take()?;
        (from.at != to.at || from.step != to.step).then_some(Dash { from, to })
    }

    /// To the end of a dash that is on this step, if there is one.
    fn along(&self, pen: &mut Pen<'d>, run: &Run) -> Option<Dash> {
        let mut from = run.point(pen.chord, false);
        while pen.chord < run.chords() {
            let to = run.point(pen.chord + 1, false);
            let length = length_q16(Vector::between(from, to));
            let place = |done: u64| Place {
                step: pen.step,
                chord: pen.chord,
                at: between(from, to, done, length),
                normal: normal(run, pen.chord, done, length),
            };
            if pen.pattern.is_dash() && pen.open.is_none() {
                pen.open = Some(place(pen.done));
            }
            while pen.pattern.left <= length - pen.done {
                pen.done += pen.pattern.left;
                let dash = pen.open.take().map(|from| Dash { from, to: place(pen.done) });
                pen.pattern.advance();
                if pen.pattern.is_dash() {
                    pen.open = Some(place(pen.done));
                }
                let is_drawn = |dash: &Dash| dash.from.at != dash.to.at || self.cap != Cap::Butt;
                if let Some(dash) = dash.filter(is_drawn) {
                    pen.last = pen.step;
                    return Some(dash);
                }
            }
            pen.pattern.left -= length - pen.done;
            (pen.chord, pen.done, from) = (pen.chord + 1, 0, to);
        }
        None
    }
}

/// Across a line, or the curve itself, not its chord.
fn normal(run: &Run, chord: u32, done: u64, length: u64) -> Unit {
    let Some((curve, ..)) = run.curve else { return run.normals[0] };
    if chord == 0 && done == 0 {
        return run.normals[0];
    }
    let part = u32::try_from((done << 16) / length.max(1)).unwrap_or(0);
    Unit::along(curve.direction(chord, part)).map_or_else(|| run.chord(chord, false).0, Unit::turned)
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
