//! Outline by midpoint lines, filled in between: "Use Midpoint Algorithm for edges and fill in?"
//!
//! Source: the lecture notes "Triangles" (barycentric coordinates); the line from the notes "Rasterization", after
//! Bresenham, *Algorithm for computer control of a digital plotter*, 1965, and Pitteway, *Algorithm for drawing ellipses
//! or hyperbolae with a digital plotter*, 1967.
//!
//! ```text
//! d = 2 dy - dx      d <= 0: E,  d += 2 dy        a row is filled from the leftmost pixel of the lines that
//!                    d >  0: NE, d += 2 (dy - dx) pass through it to the rightmost
//! ```
//!
//! Lines join pixels, so vertices are whole pixels: a triangle moves in steps of a pixel. A line has the pixels
//! *nearest* to it, half of which have their centre on the far side: the triangle is too large by half a pixel all
//! around, and neighbours share all the pixels of their edge. Triangles without an area are drawn, too.
//!
//! The derivation has `d < 0` where the code has `d <= 0`: where the line passes exactly between two pixels.

use crate::{Fragment, FragmentSink, PixelRect};

/// A midpoint line, row by row: the run of its pixels on each.
#[derive(Debug, Clone, Copy)]
struct MidpointLine {
    x: i32,
    step: i32,
    /// Steps along x and along y; what is left of the longer.
    dx: i32,
    dy: i32,
    steps: i32,
    d: i32,
}

impl MidpointLine {
    /// Downwards; pixels within 2^23, so that twice a difference fits.
    #[inline]
    fn new((x0, y0): (i32, i32), (x1, y1): (i32, i32)) -> Self {
        let (dx, dy) = ((x1 - x0).abs(), y1 - y0);
        Self { x: x0, step: (x1 - x0).signum(), dx, dy, steps: dx.max(dy), d: 2 * dx.min(dy) - dx.max(dy) }
    }

    /// The leftmost and the rightmost pixel of the next row.
    #[inline]
    fn row(&mut self) -> (i32, i32) {
        let first = self.x;
        if self.dy >= self.dx {
            self.d += if self.d <= 0 {
                2 * self.dx
            } else {
                self.x += self.step;
                2 * (self.dx - self.dy)
            };
            return (first, first);
        }
        let mut last = first;
        while self.steps > 0 {
            self.steps -= 1;
            self.x += self.step;
            if self.d > 0 {
                self.d += 2 * (self.dy - self.dx);
                break;
            }
            self.d += 2 * self.dy;
            last = self.x;
        }
        (first.min(last), first.max(last))
    }
}

/// Fills the triangle of three vertices in 1/256 px, each of which becomes the pixel that holds it.
///
/// Costs a step for every pixel of the outline, those off the screen too: at most 2^24 an edge.
///
/// # Errors
///
/// The sink's.
pub fn midpoint_outline<S: FragmentSink>(v: &[[i32; 2]; 3], clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let mut pixels = v.map(|[x, y]| (x >> 8, y >> 8));
    pixels.sort_unstable_by_key(|(_, y)| *y);
    let [top, middle, bottom] = pixels;
    let mut long = MidpointLine::new(top, bottom);
    let mut upper = MidpointLine::new(top, middle);
    let mut lower = MidpointLine::new(middle, bottom);
    for y in top.1..=bottom.1 {
        if y >= clip.rows.end {
            break;
        }
        let (mut left, mut right) = long.row();
        let mut take = |(first, last): (i32, i32)| {
            left = left.min(first);
            right = right.max(last);
        };
        if y <= middle.1 {
            take(upper.row());
        }
        if y >= middle.1 {
            take(lower.row());
        }
        if y < clip.rows.start {
            continue;
        }
        for x in left.max(clip.columns.start)..right.saturating_add(1).min(clip.columns.end) {
            sink.visit(x, y);
            sink.fragment(Fragment::pixel(x, y))?;
        }
    }
    Ok(())
}
