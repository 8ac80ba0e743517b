//! Pixel by pixel: the recursion, with its stack made explicit.

use super::{Canvas, Touch};
use crate::{fragment::FragmentSink, methods::polygon::Failure};

/// Right, down, left, up; then the corners.
const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];

/// What a call has to remember to return: which of its neighbours it has called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Return(u8);

/// `fill(x, y) { if (open(x, y)) { set(x, y); fill(x + 1, y); fill(x, y + 1); fill(x - 1, y); fill(x, y - 1); } }`
///
/// The pixel that called is the one that the way back leads to, so that a byte is all that a call leaves on the
/// stack. Calls nest as deep as the region has pixels, at worst and in practice: an empty screen is one snake of
/// them.
///
/// # Errors
///
/// When the stack has fewer entries than the canvas has open pixels; the sink's.
///
/// # Cost
///
/// Four or eight readings a pixel.
pub fn by_pixels<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    [mut x, mut y]: [i32; 2],
    touch: Touch,
    stack: &mut [Return],
    sink: &mut S,
) -> Result<(), Failure<S::Error>> {
    let (needed, available) = (canvas.open_pixels(), stack.len());
    if available < needed {
        return Err(Failure::TooLittleScratch { needed, available });
    }
    canvas.send(sink).map_err(Failure::Sink)?;
    if !canvas.look(x, y, sink) {
        return Ok(());
    }
    let neighbours = match touch {
        Touch::Sides => NEIGHBOURS.get(..4).unwrap_or_default(),
        Touch::Corners => &NEIGHBOURS,
    };
    canvas.fill(x, y, sink).map_err(Failure::Sink)?;
    let (mut depth, mut called) = (0, 0);
    loop {
        if let Some((dx, dy)) = neighbours.get(usize::from(called)) {
            let next = (x.wrapping_add(*dx), y.wrapping_add(*dy));
            if canvas.look(next.0, next.1, sink)
                && let Some(entry) = stack.get_mut(depth)
            {
                *entry = Return(called);
                depth += 1;
                (x, y) = next;
                canvas.fill(x, y, sink).map_err(Failure::Sink)?;
                called = 0;
                continue;
            }
            called += 1;
        } else {
            let Some(caller) = depth.checked_sub(1) else { return Ok(()) };
            depth = caller;
            called = stack.get(depth).map_or(u8::MAX, |entry| entry.0);
            let (dx, dy) = neighbours.get(usize::from(called)).copied().unwrap_or_default();
            (x, y) = (x.wrapping_sub(dx), y.wrapping_sub(dy));
            called = called.saturating_add(1);
        }
    }
}
