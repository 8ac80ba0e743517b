//! A line's samples, counted by the line that meets them: Bresenham's line in a picture n times larger.
//!
//! ```text
//!    | . . . | . . . |
//!    | . . . | . # # |      n = 3: in a column of pixels the line meets n subpixels, one in each column of those:
//!    | . # # | # . . |      2/3 and nothing in the first, 1/3 and 2/3 in the second
//!    | # . . | . . . |
//!    +-------+-------+
//! ```
//!
//! Integers alone, and no scratch. But the intensity goes by the longer axis: a diagonal line, which is longer by 41 %,
//! gets no more light than a level one.

use crate::{
    Fragment, FragmentSink, PixelRect, Vertex,
    methods::{
        antialias::Side,
        line::{
            directly::{self, Ties},
            display::display,
        },
    },
};

/// Counts subpixels, which come along the line.
#[derive(Debug)]
struct Counter<'s, S> {
    side: i32,
    is_x_major: bool,
    clip: &'s PixelRect,
    sink: &'s mut S,
    /// The pixels of one step of the longer axis: at most two of them, as a line is at most a diagonal there.
    pixels: [Option<([i32; 2], u32)>; 2],
}

impl<S: FragmentSink> Counter<'_, S> {
    fn flush(&mut self) -> Result<(), S::Error> {
        for ([x, y], count) in core::mem::take(&mut self.pixels).into_iter().flatten() {
            let side = self.side.unsigned_abs();
            let coverage = (255 * count + side / 2) / side;
            display(Fragment::covered(x, y, coverage.min(255) as u8), self.clip, self.sink)?;
        }
        Ok(())
    }
}

impl<S: FragmentSink> FragmentSink for Counter<'_, S> {
    type Error = S::Error;

    fn fragment(&mut self, Fragment { x, y, .. }: Fragment) -> Result<(), S::Error> {
        let pixel = [x, y].map(|sample| sample.div_euclid(self.side));
        let major = |pixel: [i32; 2]| if self.is_x_major { pixel[0] } else { pixel[1] };
        if matches!(self.pixels[0], Some((before, _)) if major(before) != major(pixel)) {
            self.flush()?;
        }
        for slot in &mut self.pixels {
            match slot {
                Some((there, count)) if *there == pixel => {
                    *count += 1;
                    return Ok(());
                }
                Some(_) => {}
                None => {
                    *slot = Some((pixel, 1));
                    return Ok(());
                }
            }
        }
        Ok(())
    }
}

/// Draws a line between vertices in 1/256 pixel.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(ends: [Vertex; 2], side: Side, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
    let n = i32::from(side.get());
    // The subpixels that hold the ends: |bits| n / 256 < 2^28.
    let [start, end] =
        ends.map(|vertex| [vertex.x, vertex.y].map(|at| ((i64::from(at.to_bits()) * i64::from(n)) >> 8) as i32));
    let larger = |range: &core::ops::Range<i32>| range.start.saturating_mul(n)..range.end.saturating_mul(n);
    let samples = PixelRect { rows: larger(&clip.rows), columns: larger(&clip.columns) };
    let is_x_major = start[0].abs_diff(end[0]) >= start[1].abs_diff(end[1]);
    let mut counter = Counter { side: n, is_x_major, clip, sink, pixels: [None; 2] };
    directly::line([start, end], Ties::DownAndRight, &samples, &mut counter)?;
    counter.flush()
}
