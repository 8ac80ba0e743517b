//! The area of each pixel that the outline passes through, cut by the pixel, by itself.
//!
//! By Green's theorem the area within a pixel is a sum over the edges, each with the area to its right:
//!
//! ```text
//!     +----/----+
//!     |   /#####|        x < left:  height * width
//!     |  /######|        between:   height * (right - middle)
//!     +-/-------+        x > right: 0
//! ```
//!
//! No error is handed from pixel to pixel; each pixel on the outline looks at all edges. As everywhere where areas are
//! added up, that is the area of an outline that does not overlap itself.

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::antialias::{
        Error, Outline,
        outline::{Edge, ruled, width},
    },
};

/// Scratch for one column of pixels. 8 bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ExactColumn {
    /// Whether an edge passes through the pixel.
    is_on_outline: bool,
    /// Signed heights of edges that lie to the left from here on, in 1/256.
    change: i32,
}

impl ExactColumn {
    /// Unused scratch.
    pub const EMPTY: Self = Self { is_on_outline: false, change: 0 };
}

/// In which numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Numbers {
    /// `f32`.
    F32,
    /// `f64`.
    F64,
}

impl Numbers {
    /// A number, rounded to these.
    fn of(self, value: f64) -> f64 {
        match self {
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }
}

/// Draws an outline by the area of each pixel in it.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    numbers: Numbers,
    columns: &mut [ExactColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    let pixels = outline.pixels(clip);
    let width = width(&pixels);
    Error::check(width, columns.len())?;
    let columns = columns.get_mut(..width).unwrap_or_default();
    for row in pixels.rows {
        columns.fill(ExactColumn::EMPTY);
        for edge in outline.edges() {
            mark(&edge, row, pixels.columns.start, columns);
        }
        let mut heights = 0_i32;
        for (column, x) in columns.iter().zip(pixels.columns.start..) {
            sink.visit(x, row);
            heights = heights.wrapping_add(column.change);
            let area = if column.is_on_outline {
                let areas = outline.edges().map(|edge| area_to_the_right(&edge, x, row, numbers));
                areas.fold(0.0, |sum, area| numbers.of(sum + area))
            } else {
                f64::from(heights) / 256.0
            };
            let coverage = (255.0 * ruled(area, outline.fill_rule) + 0.5) as u8;
            if coverage > 0 {
                sink.fragment(Fragment::covered(x, row, coverage)).map_err(Error::Sink)?;
            }
        }
    }
    Ok(())
}

/// Where an edge is in a row, and from where on it is to the left.
fn mark(edge: &Edge, row: i32, left: i32, columns: &mut [ExactColumn]) {
    let top = 256 * i64::from(row);
    let Some([[xa, ya], [xb, yb]]) = edge.within(top, top + 256) else { return };
    let last = columns.len() as f64;
    let column_of = |x: f64| libm::floor((x - 256.0 * f64::from(left)) / 256.0).clamp(-1.0, last);
    let (first, end) = (column_of(xa.min(xb)).max(0.0) as usize, (column_of(xa.max(xb)) + 1.0) as usize);
    for column in columns.iter_mut().skip(first).take(end.saturating_sub(first)) {
        column.is_on_outline = true;
    }
    if let Some(column) = columns.get_mut(end) {
        column.change = column.change.wrapping_add(edge.winding * (yb - ya) as i32);
    }
}

/// Of pixel (x, y), 1 a pixel, with the sign of the edge.
fn area_to_the_right(edge: &Edge, x: i32, y: i32, numbers: Numbers) -> f64 {
    let top = 256 * i64::from(y);
    let Some([[xa, ya], [xb, yb]]) = edge.within(top, top + 256) else { return 0.0 };
    let of = |value: f64| numbers.of(value);
    let pixel = |at: f64| of(at / 256.0 - f64::from(x));
    let (from, to) = (pixel(xa.min(xb)), pixel(xa.max(xb)));
    let height = of((yb - ya) / 256.0) * f64::from(edge.winding);
    if from >= 1.0 {
        return 0.0;
    }
    if to <= 0.0 {
        return height;
    }
    let middle = of((from.max(0.0) + to.min(1.0)) / 2.0);
    if to - from <= 0.0 {
        return of(height * (1.0 - middle));
    }
    let run = of(to - from);
    let (left, right) = (of((-from).max(0.0) / run), of((to - 1.0).max(0.0) / run));
    of(height * of(left + of((1.0 - left - right) * (1.0 - middle))))
}
