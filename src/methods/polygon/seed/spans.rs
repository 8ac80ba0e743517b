//! Span by span: Smith's seeds, and Heckbert's shadows.

use core::ops::Range;

use super::{Canvas, Touch};
use crate::{fragment::FragmentSink, methods::polygon::Failure};

/// A row to look at, next to a span that is filled. A seed is one of one pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    pub(super) y: i32,
    pub(super) start: i32,
    pub(super) end: i32,
    /// From the span to the row.
    pub(super) dy: i32,
}

impl Entry {
    /// What to make a stack of.
    pub const EMPTY: Self = Self { y: 0, start: 0, end: 0, dy: 0 };
}

/// A stack of entries that says when it is full.
pub(super) struct Stack<'s> {
    entries: &'s mut [Entry],
    length: usize,
}

impl<'s> Stack<'s> {
    pub(super) fn new(entries: &'s mut [Entry]) -> Self {
        Self { entries, length: 0 }
    }

    /// Whether there was room.
    pub(super) fn push(&mut self, entry: Entry) -> bool {
        let Some(slot) = self.entries.get_mut(self.length) else { return false };
        *slot = entry;
        self.length += 1;
        true
    }

    pub(super) fn pop(&mut self) -> Option<Entry> {
        self.length = self.length.checked_sub(1)?;
        self.entries.get(self.length).copied()
    }
}

/// What a stack of any use has to hold: no bound is known that is not one for all runs.
fn check<E>(canvas: &Canvas<'_>, stack: &[Entry]) -> Result<(), Failure<E>> {
    let (needed, available) = (4 * canvas.open_runs() + 2, stack.len());
    if available < needed { Err(Failure::TooLittleScratch { needed, available }) } else { Ok(()) }
}

/// Fills the run of open pixels around one.
pub(super) fn fill_run<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    x: i32,
    y: i32,
    sink: &mut S,
) -> Result<Range<i32>, S::Error> {
    let (mut start, mut end) = (x, x);
    while canvas.look(end, y, sink) {
        canvas.fill(end, y, sink)?;
        end = end.wrapping_add(1);
    }
    while canvas.look(start.wrapping_sub(1), y, sink) {
        start = start.wrapping_sub(1);
        canvas.fill(start, y, sink)?;
    }
    Ok(start..end)
}

/// Smith 1979: take a seed, fill its run, then look for runs above and below it, and leave a seed for each.
///
/// # Errors
///
/// When the stack has fewer than four entries for each run of open pixels; the sink's.
///
/// # Cost
///
/// Each run is looked at from every run next to it, the one it was found from included.
pub fn by_seeds<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    [x, y]: [i32; 2],
    stack: &mut [Entry],
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    check(canvas, stack)?;
    canvas.send(sink).map_err(Failure::Sink)?;
    let mut stack = Stack::new(stack);
    stack.push(Entry { y, start: x, end: x, dy: 0 });
    while let Some(Entry { start: x, y, .. }) = stack.pop() {
        if !canvas.look(x, y, sink) {
            continue;
        }
        let run = fill_run(canvas, x, y, sink).map_err(Failure::Sink)?;
        for y in [y.wrapping_sub(1), y.wrapping_add(1)] {
            let mut was_open = false;
            for x in run.clone() {
                let is_open = canvas.look(x, y, sink);
                if is_open && !was_open {
                    stack.push(Entry { y, start: x, end: x, dy: 0 });
                }
                was_open = is_open;
            }
        }
    }
    Ok(())
}

/// Heckbert 1990: a span casts a shadow on the next row; where a run there sticks out, it casts one back.
///
/// By corners, a shadow is a pixel wider to both sides.
///
/// # Errors
///
/// When the stack has fewer than four entries for each run of open pixels; the sink's.
///
/// # Cost
///
/// Hardly a pixel is read twice.
pub fn by_spans<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    seed: [i32; 2],
    touch: Touch,
    stack: &mut [Entry],
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    check(canvas, stack)?;
    canvas.send(sink).map_err(Failure::Sink)?;
    let mut stack = Stack::new(stack);
    start(canvas, seed, &mut stack, sink).map_err(Failure::Sink)?;
    while let Some(entry) = stack.pop() {
        cast(canvas, entry, touch, &mut stack, sink).map_err(Failure::Sink)?;
    }
    Ok(())
}

/// Fills the seed's own run. Whether no entry was dropped.
pub(super) fn start<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    [x, y]: [i32; 2],
    stack: &mut Stack<'_>,
    sink: &mut S,
) -> Result<bool, S::Error> {
    if !canvas.look(x, y, sink) {
        return Ok(true);
    }
    let Range { start, end } = fill_run(canvas, x, y, sink)?;
    let up = stack.push(Entry { y: y.wrapping_sub(1), start, end, dy: -1 });
    let down = stack.push(Entry { y: y.wrapping_add(1), start, end, dy: 1 });
    Ok(up && down)
}

/// Fills the runs in a shadow. Whether no entry was dropped.
pub(super) fn cast<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    Entry { y, start, end, dy }: Entry,
    touch: Touch,
    stack: &mut Stack<'_>,
    sink: &mut S,
) -> Result<bool, S::Error> {
    let wider = i32::from(touch == Touch::Corners);
    let shadow = start.saturating_sub(wider)..end.saturating_add(wider);
    let (mut x, mut all) = (shadow.start, true);
    while x < shadow.end {
        if !canvas.look(x, y, sink) {
            x = x.wrapping_add(1);
            continue;
        }
        let run = fill_run(canvas, x, y, sink)?;
        x = run.end;
        let back = dy.wrapping_neg();
        all &= stack.push(Entry { y: y.wrapping_add(dy), start: run.start, end: run.end, dy });
        if run.start < start {
            all &= stack.push(Entry { y: y.wrapping_add(back), start: run.start, end: start, dy: back });
        }
        if run.end > end {
            all &= stack.push(Entry { y: y.wrapping_add(back), start: end, end: run.end, dy: back });
        }
    }
    Ok(all)
}
