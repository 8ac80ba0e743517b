//! Wu's anti-aliased line: the two pixels of a column that the line passes between share one pixel's intensity.
//!
//! In the first octant, with `k = dy / dx`, a word `D` of n = 16 bits holds the fraction of y. `d = floor(2^n k + 1/2)` is
//! added in each column; a carry out of the word is a step to the next row. The upper m = 8 bits are an intensity:
//!
//! ```text
//!    y      255 - (D >> 8)        no test but for the carry, no multiplication, no division but
//!    y + 1         D >> 8         the first
//! ```
//!
//! The line is symmetric, so that each `D` serves for two columns, one from either end. From one end alone, the rounding
//! of `d` adds up to dx/2^17 of a pixel, and the last pixel is not quite the end.
//!
//! Intensities fall with the distance along y, not with that from the line: a diagonal is thinner by 29 % than a
//! horizontal one, where exact areas of a line one pixel wide are not. Between whole pixels, the first and the last pixel
//! are whole, too, where a line that ends at their centres has half of them.

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::line::{
        by_transformation::{Octant, Transformed},
        display::{display, display_pixel, passed, steps_within},
    },
};

/// `D` and how far it has carried.
#[derive(Debug, Clone, Copy)]
struct Word {
    d: u16,
    fraction: u16,
    rows: i32,
}

impl Word {
    /// After `k` columns.
    fn after(d: u16, k: u32) -> Self {
        let sum = u64::from(d) * u64::from(k);
        Self { d, fraction: sum as u16, rows: (sum >> 16) as i32 }
    }

    #[inline(always)]
    fn step(&mut self) {
        let (fraction, carry) = self.fraction.overflowing_add(self.d);
        self.fraction = fraction;
        self.rows = self.rows.wrapping_add(carry.into());
    }

    /// The upper bits: what the second pixel gets.
    #[inline(always)]
    fn intensity(self) -> u8 {
        self.fraction.to_be_bytes()[0]
    }
}

/// `floor(2^16 dy / dx + 1/2)`, for 0 <= dy < dx.
fn slope(dx: i32, dy: i32) -> u16 {
    let (dx, dy) = (i64::from(dx.max(1)), i64::from(dy.max(0)));
    // What rounds up to 2^16 is more than 2^17 pixels long, and one row short in all of them.
    u16::try_from(((dy << 17) + dx) / (2 * dx)).unwrap_or(u16::MAX)
}

/// Which columns take their `D` from which end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ends {
    /// From the nearer one, as published.
    Both,
    /// From the start.
    Start,
}

/// Draws between whole pixels in the first octant, 0 <= y2 - y1 <= x2 - x1.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [[x0, y0], [x1, y1]]: [[i32; 2]; 2],
    from: Ends,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (dx, dy) = (x1.wrapping_sub(x0), y1.wrapping_sub(y0));
    let last = dx.max(0);
    if dx == dy {
        // Horizontal, vertical and diagonal lines are apart in most implementations: 2^16 is no word of 16 bits.
        for k in steps_within(x0, false, last, &clip.columns) {
            display_pixel(x0.wrapping_add_unsigned(k), y0.wrapping_add_unsigned(k), clip, sink)?;
        }
        return Ok(());
    }
    let d = slope(dx, dy);
    let from_start = match from {
        Ends::Both => last / 2,
        Ends::Start => last,
    };
    let visible = steps_within(x0, false, from_start, &clip.columns);
    let mut word = Word::after(d, visible.start);
    for k in visible {
        let (x, y) = (x0.wrapping_add_unsigned(k), y0.wrapping_add(word.rows));
        pair(x, [y, y.wrapping_add(1)], word, clip, sink)?;
        word.step();
    }
    // The columns that are left, as seen from the end.
    let visible = steps_within(x1, true, last - from_start - 1, &clip.columns);
    let mut word = Word::after(d, visible.start);
    for k in visible {
        let (x, y) = (x1.wrapping_sub_unsigned(k), y1.wrapping_sub(word.rows));
        pair(x, [y, y.wrapping_sub(1)], word, clip, sink)?;
        word.step();
    }
    Ok(())
}

#[inline(always)]
fn pair<S: FragmentSink>(
    x: i32,
    [first, second]: [i32; 2],
    word: Word,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let intensity = word.intensity();
    display(Fragment::covered(x, first, 255 - intensity), clip, sink)?;
    display(Fragment::covered(x, second, intensity), clip, sink)
}

/// Draws between points that need not be whole pixels, in any direction; whole numbers are pixel centres.
///
/// As the method is usually found: y in `f32`, and of the first and the last column only the share that the line has
/// there. A line of less than a column draws that column twice.
///
/// # Errors
///
/// The sink's.
pub fn between_pixels<S: FragmentSink>(
    [[x0, y0], [x1, y1]]: [[f32; 2]; 2],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let steep = (y1 - y0).abs() > (x1 - x0).abs();
    if steep {
        let transposed = PixelRect { rows: clip.columns.clone(), columns: clip.rows.clone() };
        let mut sink = Transformed::new(Octant { transpose: true, ..Octant::FIRST }, sink);
        flat([[y0, x0], [y1, x1]], &transposed, &mut sink)
    } else {
        flat([[x0, y0], [x1, y1]], clip, sink)
    }
}

fn flat<S: FragmentSink>([start, end]: [[f32; 2]; 2], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [[x0, y0], [x1, y1]] = if start[0] > end[0] { [end, start] } else { [start, end] };
    let gradient = if x1 == x0 { 1.0 } else { (y1 - y0) / (x1 - x0) };
    let fraction = |value: f32| value - libm::floorf(value);
    let first = libm::floorf(x0 + 0.5);
    let first_y = y0 + gradient * (first - x0);
    share(first as i32, first_y, 1.0 - fraction(x0 + 0.5), clip, sink)?;
    let last = libm::floorf(x1 + 0.5);
    let last_y = y1 + gradient * (last - x1);
    share(last as i32, last_y, fraction(x1 + 0.5), clip, sink)?;
    let (first, last) = (first as i32, last as i32);
    let columns = last.wrapping_sub(first);
    let visible = steps_within(first, false, columns.saturating_sub(1), &clip.columns);
    let visible = visible.start.max(1)..visible.end;
    let passed = passed(visible.start);
    let mut y = first_y + gradient * passed as f32;
    for k in passed..visible.end {
        if k >= visible.start {
            share(first.wrapping_add_unsigned(k), y, 1.0, clip, sink)?;
        }
        y += gradient;
    }
    Ok(())
}

/// The two pixels that a line of some intensity passes between.
#[inline(always)]
fn share<S: FragmentSink>(x: i32, y: f32, intensity: f32, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let row = libm::floorf(y);
    let below = y - row;
    let coverage = |share: f32| (255.0 * share * intensity + 0.5) as u8;
    display(Fragment::covered(x, row as i32, coverage(1.0 - below)), clip, sink)?;
    display(Fragment::covered(x, (row as i32).wrapping_add(1), coverage(below)), clip, sink)
}
