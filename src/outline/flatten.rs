//! The inside of lines and curves as closed contours.
//!
//! A contour has the number of the move that it begins with, or of the close that it follows. A vertex has that of its
//! line or curve, from there, and of its chord.

use crate::{
    contours::FillRule,
    outline::{
        Curves, FinePoint, FineRect, INDEX_BITS, KEPT_VERTICES, Kept, Outline, Step, Vertices, WindingRule, hull,
    },
};

/// The inside of a path: every subpath a contour, closed or not.
#[derive(Debug)]
pub struct Flattened<'c, C> {
    pub(crate) curves: &'c C,
    pub(crate) fill_rule: FillRule,
}

impl<C> Flattened<'_, C> {
    /// The same by another rule.
    #[inline]
    #[must_use]
    pub const fn fill_rule(self, fill_rule: FillRule) -> Self {
        Self { fill_rule, ..self }
    }
}

impl<C> Clone for Flattened<'_, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Flattened<'_, C> {}

impl<C: Curves> Outline for Flattened<'_, C> {
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R {
        with(&Chords::new(self.curves))
    }

    fn extent(&self) -> FineRect {
        hull(self.curves)
    }

    fn chains_at_most(&self) -> Option<usize> {
        self.curves.chains_at_most(None)
    }

    fn winding_rule(&self) -> WindingRule {
        WindingRule::with_mask(self.fill_rule.mask())
    }
}

/// How many chords the curves have at most; 0 where there are none.
pub(crate) fn most_chords(curves: &dyn Curves) -> u32 {
    let chords = |index| if let Step::Curve(curve) = curves.step(index) { curve.chords() } else { 0 };
    (0..curves.steps()).map(chords).max().unwrap_or(0)
}

/// See the module.
struct Chords<'c> {
    curves: &'c dyn Curves,
    chord_bits: u32,
    kept: Kept<Step, 4>,
    vertices: Kept<FinePoint, KEPT_VERTICES>,
}

impl<'c> Chords<'c> {
    fn new(curves: &'c dyn Curves) -> Self {
        let chord_bits = u32::BITS - most_chords(curves).saturating_sub(1).leading_zeros();
        let nothing = Step::Move(FinePoint::default());
        Self { curves, chord_bits, kept: Kept::new(nothing), vertices: Kept::new(FinePoint::default()) }
    }

    #[inline]
    fn step(&self, index: u32) -> Option<Step> {
        (index < self.curves.steps()).then(|| self.kept.get(index.into(), || self.curves.step(index)))
    }

    /// A step of the contour's subpath that has vertices.
    #[inline]
    fn body(&self, index: u32) -> Option<Step> {
        self.step(index).filter(|step| matches!(step, Step::Line(..) | Step::Curve(_)))
    }

    /// Subpaths of more steps than an index has room for end early.
    #[inline]
    fn index(&self, step: u32, chord: u32) -> Option<u32> {
        (step >> (INDEX_BITS - self.chord_bits) == 0).then_some(step << self.chord_bits | chord)
    }
}

const fn chords(step: &Step) -> u32 {
    match step {
        Step::Curve(curve) => curve.chords(),
        _ => 1,
    }
}

impl Vertices for Chords<'_> {
    fn contours(&self) -> u32 {
        self.curves.steps()
    }

    fn first(&self, contour: u32) -> Option<u32> {
        self.body(contour + 1)?;
        match self.step(contour)? {
            Step::Move(_) | Step::Close(..) => Some(0),
            _ => None,
        }
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        let (step, chord) = (index >> self.chord_bits, index & ((1 << self.chord_bits) - 1));
        if is_forward {
            let is_within = step > 0 && self.body(contour + step).is_some_and(|step| chord + 1 < chords(&step));
            if is_within {
                return index + 1;
            }
            let next = self.body(contour + step + 1).and_then(|_| self.index(step + 1, 0));
            return next.unwrap_or(0);
        }
        if chord > 0 {
            return index - 1;
        }
        let mut last = step;
        if step == 0 {
            while self.body(contour + last + 1).is_some() && self.index(last + 1, 0).is_some() {
                last += 1;
            }
        } else {
            last -= 1;
        }
        match self.body(contour + last) {
            Some(step) if last > 0 => self.index(last, chords(&step) - 1).unwrap_or(0),
            _ => 0,
        }
    }

    fn vertex(&self, contour: u32, index: u32) -> FinePoint {
        let (step, chord) = (index >> self.chord_bits, index & ((1 << self.chord_bits) - 1));
        match self.step(contour + step) {
            Some(Step::Curve(curve)) if step > 0 => {
                let number = u64::from(contour) << 32 | u64::from(index);
                self.vertices.get(number, || curve.point(chord + 1))
            }
            Some(step) => step.end(),
            None => FinePoint::default(),
        }
    }
}
