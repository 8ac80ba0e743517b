//! Best times, the variants taking turns.
//!
//! Every round gives each variant of each scene a turn. What is taken is the thread's time, and not the clock's, as
//! others use the machine, too; what they do to the caches slows some turns down and never speeds one up, so the best of
//! many is the closest to the truth. And as everyone has a turn in each round, a slow minute is slow for all.
//!
//! A turn is short, so that some are not interrupted. Shapes that together take longer than a turn are timed in parts,
//! each of which has its own best time: the slower library would otherwise be interrupted in every turn.

use std::{ops::Range, time::Duration};

use cpu_time::ThreadTime;

use crate::drawing::Drawing;

/// One variant's part of each round.
#[derive(Debug)]
pub(crate) struct Turns {
    drawing: Box<dyn Drawing>,
    parts: Vec<Part>,
}

/// Shapes that are timed together: whole batches, of a library that wants them.
#[derive(Debug)]
struct Part {
    shapes: Range<usize>,
    /// How often they are drawn in a turn.
    passes: u32,
    /// One pass, in the best turn so far.
    best: f64,
}

impl Turns {
    /// Each about as long as `turn`, as far as can be told now; shapes that take longer have one for themselves.
    pub(crate) fn new(mut drawing: Box<dyn Drawing>, turn: Duration) -> Self {
        let shapes = drawing.shapes();
        drawing.draw(0..shapes);
        let pass = timed(|| drawing.draw(0..shapes)).as_secs_f64();
        let turns_a_pass = pass / turn.as_secs_f64().max(1e-9);
        // The casts round towards zero, and saturate.
        let part = (shapes as f64 / turns_a_pass).ceil().clamp(1.0, shapes as f64) as usize;
        let part = part.next_multiple_of(drawing.batch());
        let passes = (1.0 / turns_a_pass).ceil().max(1.0) as u32;
        let starts = (0..shapes).step_by(part);
        let parts =
            starts.map(|start| Part { shapes: start..shapes.min(start + part), passes, best: f64::INFINITY }).collect();
        Self { drawing, parts }
    }

    /// One turn for each part. Others have used the caches in between, so the last part warms them for the first.
    pub(crate) fn take(&mut self) {
        if let Some(last) = self.parts.last() {
            self.drawing.draw(last.shapes.clone());
        }
        for Part { shapes, passes, best } in &mut self.parts {
            let time = timed(|| (0..*passes).for_each(|_| self.drawing.draw(shapes.clone())));
            *best = best.min(time.as_secs_f64() / f64::from(*passes));
        }
    }

    /// Nanoseconds a shape, in the best turns so far.
    pub(crate) fn best_ns(&self) -> f64 {
        let pass: f64 = self.parts.iter().map(|part| part.best).sum();
        pass * 1e9 / self.drawing.shapes() as f64
    }
}

/// The processor's time for this thread alone: what others do in between does not count.
pub(crate) fn timed(work: impl FnOnce()) -> Duration {
    let start = ThreadTime::now();
    work();
    start.elapsed()
}
