//! Bresenham 1965: the octant chooses two movements of the plotter, the decision variable one of them in each step.
//!
//! With `da` and `db` the larger and the smaller of |dx| and |dy|, `m1` the movement along the longer axis and `m2` the
//! diagonal one:
//!
//! ```text
//!        m2  m1  m2
//!          \ | /           nabla = 2 db - da
//!      m1 -- P -- m1       nabla < 0:   m1, nabla += 2 db
//!          / | \           otherwise:   m2, nabla += 2 db - 2 da
//!        m2  m1  m2
//! ```
//!
//! The paper's rule gives a line that passes exactly between two pixels to the one farther along, so that a line and the
//! same line drawn backwards differ. Given to the lower or right one whatever the direction, all lines are those of the
//! crate.

use crate::{
    FragmentSink, PixelRect,
    methods::line::{
        bresenham::{Decision, East},
        display::{display_pixel, passed, steps_within},
    },
};

/// Where the line goes that passes exactly between two pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ties {
    /// By the diagonal movement, as published.
    Diagonal,
    /// To the lower one, or the right one.
    DownAndRight,
}

/// Draws from `start` to `end`, in any direction.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [[x1, y1], [x2, y2]]: [[i32; 2]; 2],
    ties: Ties,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (dx, dy) = (x2.wrapping_sub(x1), y2.wrapping_sub(y1));
    let is_x_major = dx.unsigned_abs() >= dy.unsigned_abs();
    let (along_x, along_y) = (dx.signum(), dy.signum());
    let (da, db) = if is_x_major { (dx, dy) } else { (dy, dx) };
    // The movements m1 and m2.
    let (m1_x, m1_y) = if is_x_major { (along_x, 0) } else { (0, along_y) };
    let east = match ties {
        Ties::DownAndRight if db < 0 => East::AtZero,
        Ties::DownAndRight | Ties::Diagonal => East::BelowZero,
    };
    let visible = if is_x_major {
        steps_within(x1, dx < 0, dx.saturating_abs(), &clip.columns)
    } else {
        steps_within(y1, dy < 0, dy.saturating_abs(), &clip.rows)
    };
    if visible.is_empty() {
        return Ok(());
    }
    let mut nabla = Decision::new(da.wrapping_abs(), db.wrapping_abs(), east);
    let passed = passed(visible.start);
    let diagonal = nabla.pass(passed);
    // Along the longer axis by `passed`, along the other by `diagonal`.
    let moved = |sign: i32, by_longer: bool| {
        let by = if by_longer { passed.cast_signed() } else { diagonal };
        sign.wrapping_mul(by)
    };
    let mut x = x1.wrapping_add(moved(along_x, is_x_major));
    let mut y = y1.wrapping_add(moved(along_y, !is_x_major));
    for step in passed..visible.end {
        if step >= visible.start {
            display_pixel(x, y, clip, sink)?;
        }
        let is_m2 = nabla.step();
        x = x.wrapping_add(if is_m2 { along_x } else { m1_x });
        y = y.wrapping_add(if is_m2 { along_y } else { m1_y });
    }
    Ok(())
}
