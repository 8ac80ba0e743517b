//! Instructions, counted by the core's own timer on a machine where each takes the same time.

use core::hint::black_box;

use cortex_m::peripheral::{SYST, syst::SystClkSource};

/// Counts instructions by the core's timer.
pub(crate) struct InstructionCounter {
    /// Runs down, 24 bits, one tick for some instructions: how many depends on the board's clock.
    timer: SYST,
    instructions_per_tick: u32,
}

impl InstructionCounter {
    /// Starts the timer and finds out what a tick is.
    pub(crate) fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(TIMER_RANGE - 1);
        timer.clear_current();
        timer.enable_counter();
        let instructions_per_tick = calibrate(&mut timer);
        Self { timer, instructions_per_tick }
    }

    /// The instructions of `work` on all items, without those of the loop over them.
    ///
    /// Panics when they are more than the timer can count.
    #[allow(dead_code, reason = "`methods` has work that the timer cannot count")]
    pub(crate) fn count<T>(&mut self, items: &[T], work: impl FnMut(&T)) -> u32 {
        self.try_count(items, work).expect("no more work than the timer can count")
    }

    /// The same, or nothing when they are more than the timer can count: some 670 millions.
    pub(crate) fn try_count<T>(&mut self, items: &[T], mut work: impl FnMut(&T)) -> Option<u32> {
        let with_work = try_ticks(&mut self.timer, || items.iter().for_each(|item| work(black_box(item))))?;
        let without = ticks(&mut self.timer, || {
            for item in items {
                black_box(item);
            }
        });
        Some((with_work - without) * self.instructions_per_tick)
    }
}

const TIMER_RANGE: u32 = 1 << 24;

fn ticks(timer: &mut SYST, work: impl FnOnce()) -> u32 {
    try_ticks(timer, work).expect("no more work than the timer can count")
}

fn try_ticks(timer: &mut SYST, work: impl FnOnce()) -> Option<u32> {
    timer.clear_current();
    let start = SYST::get_current();
    work();
    let end = SYST::get_current();
    (!timer.has_wrapped()).then(|| start.wrapping_sub(end) % TIMER_RANGE)
}

/// The instructions of one tick, by drawing on what is known for certain: a thousand `nop`s are a thousand.
fn calibrate(timer: &mut SYST) -> u32 {
    const REPETITIONS: u32 = 1000;
    // The same loop and the same call with twice the work: the difference is the work.
    let mut ticks_of_a_million =
        || ticks_of_calls(timer, two_thousand_nops, REPETITIONS) - ticks_of_calls(timer, thousand_nops, REPETITIONS);

    let ticks = ticks_of_a_million();
    assert_eq!(ticks_of_a_million(), ticks, "each run takes another time: start QEMU with -icount shift=0");
    (1000 * REPETITIONS + ticks / 2) / ticks
}

/// One copy of the loop, whatever it calls.
#[inline(never)]
fn ticks_of_calls(timer: &mut SYST, work: fn(), times: u32) -> u32 {
    ticks(timer, || (0..times).for_each(|_| black_box(work)()))
}

macro_rules! ten_times {
    ($statement:stmt) => {
        $statement $statement $statement $statement $statement $statement $statement $statement $statement $statement
    };
}

#[inline(never)]
fn thousand_nops() {
    ten_times!(ten_times!(ten_times!(cortex_m::asm::nop())));
}

#[inline(never)]
fn two_thousand_nops() {
    ten_times!(ten_times!(ten_times!(cortex_m::asm::nop())));
    ten_times!(ten_times!(ten_times!(cortex_m::asm::nop())));
}
