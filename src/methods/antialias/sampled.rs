//! Samples, a line of them at a time: where each edge changes the winding number, and what lies between.
//!
//! ```text
//!    edge        edge
//!      \          /
//!   . . \. . . . / . . .       samples on a line: +1 at the first to the right of one edge,
//!    0 0 +1 0 0 0 -1 0 0       -1 at that of the other; added up, inside is what is not 0
//! ```

use core::mem;

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::antialias::{Error, Outline, outline::width},
};

/// The most samples that a line has in a pixel.
pub const MOST: usize = 16;

/// Scratch for one column of pixels. 68 bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleColumn {
    /// Changes of the winding number at the samples of a line.
    changes: [i32; MOST],
    /// The weights of the samples inside.
    count: u32,
}

impl SampleColumn {
    /// Unused scratch.
    pub const EMPTY: Self = Self { changes: [0; MOST], count: 0 };
}

/// A line of samples of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleLine<'a> {
    /// How far it lies below the pixel's top, in 1/256 pixel.
    pub y: i64,
    /// How far the first sample lies from the pixel's left, in 1/256 pixel.
    pub x: i64,
    /// What each counts for; they are equally far apart from pixel to pixel. 1, 2, 4, 8 or 16.
    pub weights: &'a [u8],
}

/// Draws by the share of samples that are inside, of `lines` to a pixel.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    lines: &[SampleLine<'_>],
    columns: &mut [SampleColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    let pixels = outline.pixels(clip);
    let width = width(&pixels);
    Error::check(width, columns.len())?;
    let columns = columns.get_mut(..width).unwrap_or_default();
    let whole: u32 = lines.iter().flat_map(|line| line.weights).copied().map(u32::from).sum();
    for row in pixels.rows {
        columns.fill(SampleColumn::EMPTY);
        for line in lines {
            add_line(outline, row, line, pixels.columns.start, columns);
        }
        for (column, x) in columns.iter().zip(pixels.columns.start..) {
            sink.visit(x, row);
            if column.count > 0 {
                let coverage = (255 * column.count + whole / 2) / whole.max(1);
                sink.fragment(Fragment::covered(x, row, coverage.min(255) as u8)).map_err(Error::Sink)?;
            }
        }
    }
    Ok(())
}

fn add_line(outline: &Outline<'_>, row: i32, line: &SampleLine<'_>, left: i32, columns: &mut [SampleColumn]) {
    let side = line.weights.len().clamp(1, MOST);
    let y = 256 * i64::from(row) + line.y;
    let first = 256 * i64::from(left) + line.x;
    let step = 256 / i64::try_from(side).unwrap_or(1);
    let mut any = false;
    for edge in outline.edges() {
        let Some(sample) = edge.crossing(y, first, step) else { continue };
        let sample = usize::try_from(sample.max(0)).unwrap_or(usize::MAX);
        let changes = columns.get_mut(sample / side).and_then(|column| column.changes.get_mut(sample % side));
        if let Some(change) = changes {
            *change = change.wrapping_add(edge.winding);
            any = true;
        }
    }
    if !any {
        return;
    }
    let mut winding = 0_i32;
    for SampleColumn { changes, count } in columns {
        for (change, weight) in changes.iter_mut().zip(line.weights) {
            winding = winding.wrapping_add(mem::take(change));
            if outline.is_inside(winding) {
                *count += u32::from(*weight);
            }
        }
    }
}
