//! Signed areas, accumulated: each edge adds the area to its right in the pixels it crosses, by the sign of its direction,
//! and a sum from left to right is the coverage.
//!
//! ```text
//!            |\  |             what the edge adds to the pixels of its row, of height h:
//!         ___| \_|___          areas to its right, a0 and a1, and h in all that follow;
//!            |a0\|a1 | h       kept as changes from pixel to pixel: a0, a1 - a0, h - a1
//! ```
//!
//! In `f32` that is font-rs'; in integers, with heights rounded down where an edge passes from pixel to pixel, FreeType's.
//! Exact where the outline does not overlap itself, but for rounding. Where it does, areas of both signs cancel, and
//! areas of one sign count twice: only the sum is known to the fill rule.

use crate::{
    FillRule, Fragment, FragmentSink, PixelRect,
    methods::antialias::{
        Error, Outline,
        outline::{Edge, ruled, width},
    },
};

/// Scratch for one column of pixels. 12 bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaColumn {
    /// The change of the coverage, 1 a pixel.
    change: f32,
    /// The signed heights of edges in the pixel, in 1/256.
    cover: i32,
    /// Twice the area to the left of them.
    area: i32,
}

impl AreaColumn {
    /// Unused scratch.
    pub const EMPTY: Self = Self { change: 0.0, cover: 0, area: 0 };
}

/// In which numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Numbers {
    /// `f32`, a change a pixel.
    F32,
    /// Integers, height and area a pixel.
    Integers,
}

/// Draws an outline by accumulated areas.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    numbers: Numbers,
    columns: &mut [AreaColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    let pixels = outline.pixels(clip);
    let width = width(&pixels);
    Error::check(width, columns.len())?;
    let columns = columns.get_mut(..width).unwrap_or_default();
    for row in pixels.rows {
        columns.fill(AreaColumn::EMPTY);
        for edge in outline.edges() {
            match numbers {
                Numbers::F32 => add(&edge, row, pixels.columns.start, columns),
                Numbers::Integers => add_integers(&edge, row, pixels.columns.start, columns),
            }
        }
        let (mut sum, mut cover) = (0.0_f32, 0_i32);
        for (column, x) in columns.iter().zip(pixels.columns.start..) {
            sink.visit(x, row);
            let coverage = match numbers {
                Numbers::F32 => {
                    sum += column.change;
                    (255.0 * ruled(f64::from(sum), outline.fill_rule) + 0.5) as u8
                }
                Numbers::Integers => {
                    cover = cover.wrapping_add(column.cover);
                    shade(cover.wrapping_mul(512).wrapping_sub(column.area), outline.fill_rule)
                }
            };
            if coverage > 0 {
                sink.fragment(Fragment::covered(x, row, coverage)).map_err(Error::Sink)?;
            }
        }
    }
    Ok(())
}

/// Twice the area in 1/256 x 1/256, of 2^17 a pixel, in 255ths: 256 shades, of which the last two are one.
fn shade(twice_area: i32, fill_rule: FillRule) -> u8 {
    let shade = (twice_area >> 9).unsigned_abs();
    let shade = match fill_rule {
        FillRule::NonZero => shade,
        FillRule::EvenOdd if shade & 511 > 256 => 512 - (shade & 511),
        FillRule::EvenOdd => shade & 511,
    };
    shade.min(255) as u8
}

fn add(edge: &Edge, row: i32, left: i32, columns: &mut [AreaColumn]) {
    let top = 256 * i64::from(row);
    let Some([[xa, ya], [xb, yb]]) = edge.within(top, top + 256) else { return };
    let pixel = |x: f64| ((x - 256.0 * f64::from(left)) / 256.0) as f32;
    let height = edge.winding as f32 * ((yb - ya) / 256.0) as f32;
    let (from, to) = (pixel(xa.min(xb)), pixel(xa.max(xb)));
    let last = columns.len() as f32;
    // What is left of the clip counts in its first pixel, what is right of it nowhere.
    let first_column = libm::floorf(from).clamp(0.0, last) as usize;
    let end_column = (libm::floorf(to) + 1.0).clamp(0.0, last) as usize;
    let share = |to_x: f32| if to > from { height * ((to_x - from) / (to - from)).clamp(0.0, 1.0) } else { height };
    let (mut before, mut covered) = (0.0, if from < 0.0 { share(0.0) } else { 0.0 });
    let mut pieces = columns.iter_mut().zip(0_u32..).skip(first_column);
    for (column, index) in pieces.by_ref().take(end_column.saturating_sub(first_column)) {
        let (x0, x1) = (from.max(index as f32), to.min(index as f32 + 1.0));
        let so_far = if to < index as f32 + 1.0 { height } else { share(x1) };
        let area = covered + (so_far - covered) * (1.0 - ((x0 + x1) / 2.0 - index as f32));
        column.change += area - before;
        (before, covered) = (area, so_far);
    }
    if let Some((column, _)) = pieces.next() {
        column.change += height - before;
    }
}

fn add_integers(edge: &Edge, row: i32, left: i32, columns: &mut [AreaColumn]) {
    let top = 256 * i64::from(row);
    let Some([[xa, ya], [xb, yb]]) = edge.within(top, top + 256) else { return };
    let (origin, end) = (256 * i64::from(left), i64::try_from(256 * columns.len()).unwrap_or(i64::MAX));
    let column_of = |x: f64| (libm::floor(x) as i64).saturating_sub(origin);
    // From left to right: the area does not know which way the edge goes.
    let (from, to) = if xa <= xb { (column_of(xa), column_of(xb)) } else { (column_of(xb), column_of(xa)) };
    let height = (yb - ya) as i64;
    let mut add = |x0: i64, x1: i64, heights: i64| {
        let column = usize::try_from(x0.max(0) >> 8).unwrap_or(usize::MAX);
        if let Some(column) = columns.get_mut(column) {
            let signed = edge.winding * heights as i32;
            column.cover = column.cover.wrapping_add(signed);
            let within = |x: i64| (x - ((x0.max(0) >> 8) << 8)).clamp(0, 256) as i32;
            column.area = column.area.wrapping_add(signed.wrapping_mul(within(x0) + within(x1)));
        }
    };
    let (mut x, mut done) = (from, 0);
    while x < end {
        let next = if x < 0 { 0 } else { (x | 255) + 1 };
        if to < next || to == from {
            add(x, to, height - done);
            return;
        }
        let so_far = i128::from(next - from) * i128::from(height) / i128::from(to - from);
        let so_far = so_far as i64;
        add(x, next, so_far - done);
        (x, done) = (next, so_far);
    }
}
