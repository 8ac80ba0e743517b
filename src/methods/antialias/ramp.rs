//! A ramp of the distance: a pixel is covered by 1/2 and the signed distance of its centre from the nearest edge.
//!
//! ```text
//!    outside              inside          coverage = 1/2 + distance, from 0 to 1:
//!      0     .25   .5   .75    1          right for an edge that is level or upright, off by up to 4 %
//!            --- edge ---                 for a diagonal one, by half at corners
//! ```
//!
//! One root for each pixel that the outline is near.

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::{
        antialias::{
            Error, Outline,
            outline::{Edge, width},
        },
        line::gupta_sproull::Root,
    },
};

/// Scratch for one column of pixels. 8 bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RampColumn {
    /// The square of the distance to the nearest edge, in pixels.
    nearest: f32,
    /// The change of the winding number between centres.
    change: i32,
}

impl RampColumn {
    /// Unused scratch.
    pub const EMPTY: Self = Self { nearest: f32::INFINITY, change: 0 };
}

/// Draws an outline by the distance of pixel centres from it.
///
/// # Errors
///
/// Fewer columns of scratch than of visible pixels in the outline's bounding box and one around it; the sink's.
pub fn draw<S: FragmentSink>(
    outline: &Outline<'_>,
    root: Root,
    columns: &mut [RampColumn],
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), Error<S::Error>> {
    let wider = |start: i32, end: i32| start.saturating_sub(1)..end.saturating_add(1);
    let beyond =
        PixelRect { rows: wider(clip.rows.start, clip.rows.end), columns: wider(clip.columns.start, clip.columns.end) };
    let near = outline.pixels(&beyond);
    if width(&near) == 0 {
        return Ok(());
    }
    let within = |start: i32, end: i32, clip: &core::ops::Range<i32>| {
        start.saturating_sub(1).max(clip.start)..end.saturating_add(1).min(clip.end)
    };
    let pixels = PixelRect {
        rows: within(near.rows.start, near.rows.end, &clip.rows),
        columns: within(near.columns.start, near.columns.end, &clip.columns),
    };
    let width = width(&pixels);
    Error::check(width, columns.len())?;
    let columns = columns.get_mut(..width).unwrap_or_default();
    for row in pixels.rows {
        columns.fill(RampColumn::EMPTY);
        for edge in outline.edges() {
            add_edge(&edge, row, pixels.columns.start, columns);
        }
        let mut winding = 0_i32;
        for (column, x) in columns.iter().zip(pixels.columns.start..) {
            sink.visit(x, row);
            winding = winding.wrapping_add(column.change);
            let inside = outline.is_inside(winding);
            let coverage = if column.nearest < 0.25 {
                let distance = root.sqrt(column.nearest);
                let signed = if inside { distance } else { -distance };
                (255.0 * (0.5 + signed) + 0.5) as u8
            } else {
                255 * u8::from(inside)
            };
            if coverage > 0 {
                sink.fragment(Fragment::covered(x, row, coverage)).map_err(Error::Sink)?;
            }
        }
    }
    Ok(())
}

fn add_edge(edge: &Edge, row: i32, left: i32, columns: &mut [RampColumn]) {
    let y = 256 * i64::from(row) + 128;
    let first = 256 * i64::from(left) + 128;
    if let Some(column) = edge.crossing(y, first, 256)
        && let Some(column) = usize::try_from(column.max(0)).ok().and_then(|column| columns.get_mut(column))
    {
        column.change = column.change.wrapping_add(edge.winding);
    }
    // Only what is less than half a pixel above or below.
    let (above, below) = (y - 128, y + 128);
    if edge.bottom.y < above || below < edge.top.y {
        return;
    }
    let ends = match edge.within(above, below) {
        Some([a, b]) => [a[0].min(b[0]), a[0].max(b[0])],
        None => [edge.top.x.min(edge.bottom.x) as f64, edge.top.x.max(edge.bottom.x) as f64],
    };
    let column = |x: f64| ((x - first as f64) / 256.0).clamp(-1.0, columns.len() as f64);
    let range = (column(ends[0] - 256.0).max(0.0)) as usize..(column(ends[1] + 256.0) + 1.0) as usize;
    let length = range.len();
    let start = range.start;
    // In pixels, relative to the centre of column 0.
    let pixels = |bits: i64| bits as f32 / 256.0;
    let (ax, ay) = (pixels(edge.top.x - first), pixels(edge.top.y - y));
    let (dx, dy) = (pixels(edge.bottom.x - edge.top.x), pixels(edge.bottom.y - edge.top.y));
    let square = dx * dx + dy * dy;
    for (column, index) in columns.iter_mut().zip(0_u32..).skip(start).take(length) {
        let (px, py) = (index as f32 - ax, -ay);
        let along = if square > 0.0 { ((px * dx + py * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        let (rx, ry) = (px - along * dx, py - along * dy);
        column.nearest = column.nearest.min(rx * rx + ry * ry);
    }
}
