//! Best times of whole pictures, the variants taking turns: see [`timing`](crate::timing) for why.

use std::{fmt, time::Duration};

use crate::{gallery::painters::Painter, timing::timed};

/// A turn is at least so long.
const LEAST_TURN: Duration = Duration::from_micros(500);

/// So many turns everybody has, however long they take.
const LEAST_TURNS: u32 = 3;

/// One variant's part of each round.
pub(crate) struct Turn {
    painter: Box<dyn Painter>,
    /// Pictures in a turn.
    pictures: u32,
    turns: u32,
    spent: Duration,
    budget: Duration,
    /// One picture, in the best turn so far.
    best: f64,
}

impl Turn {
    /// Who has used up the budget has no more turns.
    pub(crate) fn new(mut painter: Box<dyn Painter>, budget: Duration) -> Self {
        // It was painted before, by which memory has been asked for.
        let picture = timed(|| painter.paint());
        let pictures = (LEAST_TURN.as_secs_f64() / picture.as_secs_f64().max(1e-9)).ceil().max(1.0) as u32;
        Self { painter, pictures, turns: 0, spent: Duration::ZERO, budget, best: f64::INFINITY }
    }

    pub(crate) fn take(&mut self) {
        if self.turns >= LEAST_TURNS && self.spent >= self.budget {
            return;
        }
        // Others have used the caches in between.
        if self.pictures > 1 {
            self.painter.paint();
        }
        let time = timed(|| (0..self.pictures).for_each(|_| self.painter.paint()));
        self.turns += 1;
        self.spent += time;
        self.best = self.best.min(time.as_secs_f64() / f64::from(self.pictures));
    }

    /// Nanoseconds a picture, in the best turn so far.
    pub(crate) fn best_ns(&self) -> f64 {
        self.best * 1e9
    }
}

impl fmt::Debug for Turn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Turn").field("turns", &self.turns).field("best", &self.best).finish_non_exhaustive()
    }
}
