//! Circles too large to be walked: what is seen of them, by an integer root in each visible column and row.

use core::ops::Range;

use crate::{
    FragmentSink, PixelRect,
    methods::circle::octant::{Plot, Style},
};

/// The pixel nearest to `sqrt(r^2 - x^2)`: from r^2 - x^2 = y^2 + y + 1 on it is the next one.
fn nearest(r: i32, x: i64) -> Option<i64> {
    let r = i64::from(r);
    let square = u64::try_from(r * r - x * x).ok()?;
    let root = square.isqrt();
    Some((root + u64::from(square - root * root > root)) as i64)
}

/// Pixels of a range as distances from the centre.
fn distances(range: &Range<i32>, center: i32, r: i32) -> Range<i64> {
    let (center, r) = (i64::from(center), i64::from(r));
    (i64::from(range.start) - center).max(-r)..(i64::from(range.end) - center).min(r + 1)
}

/// Draws the nearest pixels of a circle of any radius.
///
/// # Errors
///
/// The sink's.
pub fn circle<S: FragmentSink>(circle: [i32; 3], style: Style, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let [xc, yc, r] = circle;
    let mut plot = Plot::new(circle, style, clip, sink);
    for x in distances(&clip.columns, xc, r) {
        let Some(y) = nearest(r, x) else { continue };
        match style {
            Style::Filled => plot.column(x as i32, y as i32)?,
            Style::Outline if x.abs() <= y => {
                plot.seen(x, y)?;
                plot.seen(x, -y)?;
            }
            Style::Outline => {}
        }
    }
    if style == Style::Outline {
        for y in distances(&clip.rows, yc, r) {
            let Some(x) = nearest(r, y) else { continue };
            if y.abs() <= x {
                plot.seen(x, y)?;
                plot.seen(-x, y)?;
            }
        }
    }
    Ok(())
}

impl<S: FragmentSink> Plot<'_, S> {
    /// A pixel, unless no `i32` names it.
    fn seen(&mut self, x: i64, y: i64) -> Result<(), S::Error> {
        let [xc, yc] = self.center.map(i64::from);
        match (i32::try_from(xc + x), i32::try_from(yc + y)) {
            (Ok(_), Ok(_)) => self.pixel(x as i32, y as i32),
            _ => Ok(()),
        }
    }
}
