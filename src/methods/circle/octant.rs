//! What becomes of the pixels of an octant: mirrored, as an outline, or as the spans between two of them.
//!
//! Filled, a point (x, y) of the octant 0 <= x <= y is the two rows `yc +- x`, from `-y` to `y`; and where y goes down in
//! the next step, the two rows `yc +- y`, from `-x` to `x`. So each row comes once.
//!
//! ```text
//!      - # # # -      rows yc +- y, when y changes
//!    # # # # # # #
//!    # # # + # # #    rows yc +- x, at once
//!    # # # # # # #
//!      - # # # -
//! ```

use crate::{FragmentSink, PixelRect, methods::line::display::display_pixel};

/// The largest radius that is walked from the top.
pub const LONGEST_WALK: i32 = 1 << 16;

/// What is drawn of a circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Style {
    /// Its outline.
    Outline,
    /// All within the outline, with it.
    Filled,
}

/// Takes the points of an octant.
#[derive(Debug)]
pub(super) struct Plot<'a, S> {
    pub(super) center: [i32; 2],
    pub(super) style: Style,
    clip: &'a PixelRect,
    sink: &'a mut S,
    /// The point before, when filled.
    last: Option<[i32; 2]>,
}

impl<'a, S: FragmentSink> Plot<'a, S> {
    pub(super) fn new([xc, yc, _]: [i32; 3], style: Style, clip: &'a PixelRect, sink: &'a mut S) -> Self {
        Self { center: [xc, yc], style, clip, sink, last: None }
    }

    pub(super) fn pixel(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        let [xc, yc] = self.center;
        display_pixel(xc.wrapping_add(x), yc.wrapping_add(y), self.clip, self.sink)
    }

    /// The row `y` from `-x` to `x`, as far as it is seen.
    pub(super) fn row(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        let [xc, yc] = self.center;
        let row = yc.wrapping_add(y);
        if x < 0 || !self.clip.rows.contains(&row) {
            return Ok(());
        }
        let (first, last) = (xc.saturating_sub(x), xc.saturating_add(x));
        let columns = first.max(self.clip.columns.start)..last.saturating_add(1).min(self.clip.columns.end);
        for column in columns {
            display_pixel(column, row, self.clip, self.sink)?;
        }
        Ok(())
    }

    /// The column `x` from `-y` to `y`.
    pub(super) fn column(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        let [xc, yc] = self.center;
        let column = xc.wrapping_add(x);
        if y < 0 || !self.clip.columns.contains(&column) {
            return Ok(());
        }
        let (first, last) = (yc.saturating_sub(y), yc.saturating_add(y));
        let rows = first.max(self.clip.rows.start)..last.saturating_add(1).min(self.clip.rows.end);
        for row in rows {
            display_pixel(column, row, self.clip, self.sink)?;
        }
        Ok(())
    }

    /// The four points that lie on the axes: `DisplayPixel(xc, yc + r)` and so on.
    pub(super) fn axes(&mut self, r: i32) -> Result<(), S::Error> {
        match self.style {
            Style::Outline => {
                self.pixel(0, r)?;
                self.pixel(0, r.wrapping_neg())?;
                self.pixel(r, 0)?;
                self.pixel(r.wrapping_neg(), 0)
            }
            Style::Filled => self.eight(0, r),
        }
    }

    /// Four points by 4-way symmetry.
    pub(super) fn four(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        self.pixel(x, y)?;
        self.pixel(x, y.wrapping_neg())?;
        self.pixel(x.wrapping_neg(), y)?;
        self.pixel(x.wrapping_neg(), y.wrapping_neg())
    }

    /// `DisplayCirclePoints`: eight points by 8-way symmetry, or the rows that they end.
    pub(super) fn eight(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        match self.style {
            Style::Outline => {
                self.four(x, y)?;
                self.four(y, x)
            }
            // Beyond the diagonal there is nothing that the other octant does not know.
            Style::Filled if x > y => Ok(()),
            Style::Filled => {
                if let Some([last_x, last_y]) = self.last
                    && y < last_y
                {
                    self.rows(last_x, last_y)?;
                }
                self.last = Some([x, y]);
                self.rows(y, x)
            }
        }
    }

    /// The rows `y` and `-y`.
    fn rows(&mut self, x: i32, y: i32) -> Result<(), S::Error> {
        self.row(x, y)?;
        if y == 0 { Ok(()) } else { self.row(x, y.wrapping_neg()) }
    }

    /// The rows of the last y, unless they are rows of x, too.
    pub(super) fn finish(mut self) -> Result<(), S::Error> {
        match self.last {
            Some([x, y]) if y > x => self.rows(x, y),
            _ => Ok(()),
        }
    }
}
