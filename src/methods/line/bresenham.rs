//! Bresenham's line in the first octant: the sign of an integer says whether to go east or north-east.
//!
//! For 0 <= dy <= dx, with `s` and `n` the distances of the line at `x + 1` from the rows `y` and `y + 1`:
//!
//! ```text
//!      y+1  +---NE        d = dx (s - n) = 2 dy x - 2 dx y + const
//!           | n/          d0 = 2 dy - dx
//!           | / s         E:  d += 2 dy
//!      y   P/---E         NE: d += 2 (dy - dx)
//! ```
//!
//! `d < 0` is E in the derivation, `d <= 0` in the code that follows it; `d = 0` is a line exactly between both. `d` takes
//! 32 bits up to lines of 2^30 pixels, and wraps beyond.

use crate::{
    FragmentSink, PixelRect,
    methods::line::display::{display_pixel, passed, steps_within},
};

/// Where the line goes that passes exactly between two pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum East {
    /// `if d <= 0`: to E, as printed.
    AtZero,
    /// `if d < 0`: to NE, as derived.
    BelowZero,
}

/// The decision variable and what changes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Decision {
    pub(super) d: i32,
    incr_e: i32,
    incr_ne: i32,
    /// E is where d is below: `d <= 0` is `d < 1`.
    limit: i32,
    dx: i32,
    dy: i32,
}

impl Decision {
    #[inline]
    pub(super) fn new(dx: i32, dy: i32, east: East) -> Self {
        Self {
            d: dy.wrapping_mul(2).wrapping_sub(dx),
            incr_e: dy.wrapping_mul(2),
            incr_ne: dy.wrapping_sub(dx).wrapping_mul(2),
            limit: i32::from(east == East::AtZero),
            dx,
            dy,
        }
    }

    /// One step: whether it goes to NE.
    #[inline(always)]
    pub(super) fn step(&mut self) -> bool {
        let is_north_east = self.d >= self.limit;
        self.d = self.d.wrapping_add(if is_north_east { self.incr_ne } else { self.incr_e });
        is_north_east
    }

    /// `k` steps at once: how many of them go to NE.
    ///
    /// They are as many as `dy k / dx` rounded to the nearest, and all or none where the line is not in the octant.
    pub(super) fn pass(&mut self, k: u32) -> i32 {
        let (dx, dy, k) = (i128::from(self.dx), i128::from(self.dy), i128::from(k));
        if k == 0 || dx <= 0 {
            return 0;
        }
        let rows =
            if self.limit == 0 { (2 * dy * k + dx).div_euclid(2 * dx) } else { -(dx - 2 * dy * k).div_euclid(2 * dx) };
        let rows = rows.clamp(0, k);
        self.d = (2 * dy * (k + 1) - dx - 2 * dx * rows) as i32;
        rows as i32
    }
}

/// Draws from (x1, y1) to the column x2; right for the first octant only, 0 <= y2 - y1 <= x2 - x1.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [[x1, y1], [x2, y2]]: [[i32; 2]; 2],
    east: East,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let dx = x2.wrapping_sub(x1);
    let dy = y2.wrapping_sub(y1);
    let mut decision = Decision::new(dx, dy, east);
    // The first pixel is drawn even if x1 > x2.
    let visible = steps_within(x1, false, dx.max(0), &clip.columns);
    if visible.is_empty() {
        return Ok(());
    }
    let passed = passed(visible.start);
    let mut y = y1.wrapping_add(decision.pass(passed));
    for _ in passed..visible.start {
        y = y.wrapping_add(decision.step().into());
    }
    for k in visible {
        display_pixel(x1.wrapping_add_unsigned(k), y, clip, sink)?;
        y = y.wrapping_add(decision.step().into());
    }
    Ok(())
}
