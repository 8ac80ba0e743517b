//! Several values in one word.
//!
//! ```text
//!   word = v0 u0 + v1 u1 + v2 u2          with units 2048, 32 and 1: the bits of a colour of 5, 6 and 5
//! ```
//!
//! A step adds the whole units of all at once, and, for each remainder that runs over, its own unit: exact, and four
//! instructions a value. Where every value is in range the word is the colour; on the way, it is right modulo 2^32.

use core::hint::select_unpredictable;

use crate::attribute::{
    plane::{NEAR_COLUMNS, Planes, Step},
    walk::Follow,
    word::Word,
};

/// What one of each value adds to each word.
pub(crate) trait Units<const N: usize, const WORDS: usize> {
    const UNITS: [[u32; WORDS]; N];
}

/// A step of all values.
#[derive(Debug, Clone, Copy)]
struct JoinedStep<W, const N: usize, const WORDS: usize> {
    words: [u32; WORDS],
    rests: [W; N],
}

/// Planes whose values are joined by units.
#[derive(Debug, Clone)]
pub(crate) struct Joined<W: Word, U, const N: usize, const WORDS: usize> {
    planes: Planes<W, N>,
    pub(crate) words: [u32; WORDS],
    lacking: [W; N],
    right: JoinedStep<W, N, WORDS>,
    down: JoinedStep<W, N, WORDS>,
    units: core::marker::PhantomData<U>,
}

#[inline(always)]
fn join<U: Units<N, WORDS>, const N: usize, const WORDS: usize>(values: [i32; N]) -> [u32; WORDS] {
    let mut words = [0_u32; WORDS];
    for (value, units) in values.iter().zip(U::UNITS) {
        for (word, unit) in words.iter_mut().zip(units) {
            *word = word.wrapping_add(value.cast_unsigned().wrapping_mul(unit));
        }
    }
    words
}

impl<W: Word, U: Units<N, WORDS>, const N: usize, const WORDS: usize> Joined<W, U, N, WORDS> {
    #[inline(always)]
    pub(crate) fn new(planes: Planes<W, N>) -> Self {
        let step = |steps: [Step<W>; N]| JoinedStep {
            words: join::<U, N, WORDS>(steps.map(|step| step.whole)),
            rests: steps.map(|step| step.rest),
        };
        let (right, down) = (step(planes.right), step(planes.down));
        let (words, lacking) = Self::start(&planes);
        Self { planes, words, lacking, right, down, units: core::marker::PhantomData }
    }

    #[inline(always)]
    fn start(planes: &Planes<W, N>) -> ([u32; WORDS], [W; N]) {
        (join::<U, N, WORDS>(planes.current.map(|at| at.value)), planes.current.map(|at| at.lacking))
    }

    /// The words from the current centre to the right.
    #[inline(always)]
    pub(crate) fn write<T>(&self, into: &mut [T], mut write: impl FnMut(&mut T, [u32; WORDS])) {
        let (mut words, mut lacking, right, area) = (self.words, self.lacking, self.right, self.planes.area);
        for item in into {
            write(item, words);
            Self::step(&mut words, &mut lacking, &right, area);
        }
    }

    #[inline(always)]
    fn step(words: &mut [u32; WORDS], lacking: &mut [W; N], step: &JoinedStep<W, N, WORDS>, area: W) {
        for (word, whole) in words.iter_mut().zip(step.words) {
            *word = word.wrapping_add(whole);
        }
        for ((lacking, rest), units) in lacking.iter_mut().zip(step.rests).zip(U::UNITS) {
            let (next, carries) = lacking.overflowing_add(rest);
            *lacking = select_unpredictable(carries, next.wrapping_sub(area), next);
            for (word, unit) in words.iter_mut().zip(units) {
                *word = select_unpredictable(carries, word.wrapping_add(unit), *word);
            }
        }
    }

    #[inline(always)]
    fn step_back(words: &mut [u32; WORDS], lacking: &mut [W; N], step: &JoinedStep<W, N, WORDS>, area: W) {
        for (word, whole) in words.iter_mut().zip(step.words) {
            *word = word.wrapping_sub(whole);
        }
        for ((lacking, rest), units) in lacking.iter_mut().zip(step.rests).zip(U::UNITS) {
            let borrows = lacking.wrapping_add(area).less(rest);
            let next = lacking.wrapping_sub(rest);
            *lacking = select_unpredictable(borrows, next.wrapping_add(area), next);
            for (word, unit) in words.iter_mut().zip(units) {
                *word = select_unpredictable(borrows, word.wrapping_sub(unit), *word);
            }
        }
    }
}

impl<W: Word, U: Units<N, WORDS>, const N: usize, const WORDS: usize> Follow for Joined<W, U, N, WORDS> {
    #[inline(never)]
    fn go_to(&mut self, row: i32, column: i32) {
        let columns = column.wrapping_sub(self.planes.column);
        let rows = row.wrapping_sub(self.planes.row);
        (self.planes.row, self.planes.column) = (row, column);
        if !(rows == 1 && columns.wrapping_add(NEAR_COLUMNS).cast_unsigned() <= 2 * NEAR_COLUMNS.cast_unsigned()) {
            if rows != 0 || columns != 0 {
                self.planes.evaluate();
                (self.words, self.lacking) = Self::start(&self.planes);
            }
            return;
        }
        let (mut words, mut lacking, area) = (self.words, self.lacking, self.planes.area);
        Self::step(&mut words, &mut lacking, &self.down, area);
        for _ in 0..columns {
            Self::step(&mut words, &mut lacking, &self.right, area);
        }
        for _ in columns..0 {
            Self::step_back(&mut words, &mut lacking, &self.right, area);
        }
        (self.words, self.lacking) = (words, lacking);
    }
}
