//! How long a method takes for the shapes of a scene.

use std::{hint::black_box, time::Instant};

use crate::{
    measure::{Entry, Suite},
    variants::Frame,
};

/// How long a measurement should take, in seconds; the shortest of so many counts.
const LENGTH: f64 = 0.002;
const MEASUREMENTS: usize = 4;

/// Draws on one frame, time and again.
#[derive(Debug)]
pub(crate) struct Clock(Box<Frame>);

impl Clock {
    pub(crate) fn new() -> Self {
        Self(Box::new(Frame::new()))
    }

    /// Nanoseconds for all shapes of a scene, each once.
    pub(crate) fn nanoseconds(&mut self, suite: &Suite, entry: &Entry, scene: usize) -> f64 {
        let first = self.seconds(suite, entry, scene, 1);
        let times = (LENGTH / first.max(1e-9)).clamp(1.0, 10_000.0) as u32;
        let measurements = if first > 0.02 { 1 } else { MEASUREMENTS };
        let shortest = (0..measurements).map(|_| self.seconds(suite, entry, scene, times)).fold(first, f64::min);
        shortest * 1e9
    }

    fn seconds(&mut self, suite: &Suite, entry: &Entry, scene: usize, times: u32) -> f64 {
        let start = Instant::now();
        for _ in 0..times {
            for shape in 0..suite.scenes[scene].1 {
                suite.time(entry, scene, black_box(shape), &mut self.0);
            }
        }
        black_box(&mut self.0);
        start.elapsed().as_secs_f64() / f64::from(times)
    }
}
