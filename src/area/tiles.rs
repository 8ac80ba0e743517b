//! The tiles that the plane is cut into where outlines reach farther than positions do.

use core::ops::Range;

use crate::{PixelRect, area::source::FINE_BITS};

/// How far a vertex may be from where drawing starts, without tiles: 8192 pixels, in 2^-16 pixel.
pub(super) const REACH: u64 = 1 << (13 + FINE_BITS);

/// The side of a tile, in pixels.
pub(super) const TILE: i32 = 1 << 12;

/// Whether no vertex is farther than that from any of the pixels.
pub(super) fn is_near(touched: &PixelRect) -> bool {
    let length = |range: &Range<i32>| i64::from(range.end).abs_diff(i64::from(range.start)) << FINE_BITS;
    length(&touched.rows) <= REACH && length(&touched.columns) <= REACH
}

/// Calls with the corner of each tile that has a part in some rows and columns, the corner of that part and its size, until
/// that returns `false`.
pub(super) fn for_each_tile(
    rows: &Range<i32>,
    columns: &Range<i32>,
    mut send: impl FnMut((i32, i32), (i32, i32), (i32, i32)) -> bool,
) {
    let mut y = rows.start;
    while y < rows.end {
        let tile_y = y & -TILE;
        let bottom = rows.end.min(tile_y.saturating_add(TILE));
        let mut x = columns.start;
        while x < columns.end {
            let tile_x = x & -TILE;
            let right = columns.end.min(tile_x.saturating_add(TILE));
            if !send((tile_x, tile_y), (x, y), (right - x, bottom - y)) {
                return;
            }
            x = right;
        }
        y = bottom;
    }
}
