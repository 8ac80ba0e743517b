//! A line's samples, counted by the rectangle that holds them: one pixel wide around the line, square at its ends.
//!
//! With `d` the line's direction and `p` a sample as seen from its start, exactly:
//!
//! ```text
//!     0 <= p . d <= |d|^2            beside the line, and not beyond its ends
//!     4 (p x d)^2 <= 256^2 |d|^2     at most half a pixel from it
//! ```

use crate::{
    Fragment, FragmentSink, PixelRect, Vertex,
    methods::{antialias::Side, line::display::display},
};

/// Draws a line between vertices in 1/256 pixel; one without length is nothing.
///
/// # Errors
///
/// The sink's.
pub fn line<S: FragmentSink>(
    [start, end]: [Vertex; 2],
    side: Side,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let [(ax, ay), (bx, by)] = [start, end].map(|v| (i64::from(v.x.to_bits()), i64::from(v.y.to_bits())));
    let (dx, dy) = (bx - ax, by - ay);
    let square = i128::from(dx) * i128::from(dx) + i128::from(dy) * i128::from(dy);
    if square == 0 {
        return Ok(());
    }
    let n = i64::from(side.get());
    let (step, whole) = (256 / n, (n * n) as u32);
    // Pixels less than a pixel beyond the ends, either way.
    let range = |a: i64, b: i64, clip: &core::ops::Range<i32>| {
        let (low, high) = (((a.min(b) - 128) >> 8) as i32, (((a.max(b) + 128) >> 8) + 1) as i32);
        low.max(clip.start)..high.min(clip.end)
    };
    let (rows, columns) = (range(ay, by, &clip.rows), range(ax, bx, &clip.columns));
    for row in rows {
        for column in columns.clone() {
            sink.visit(column, row);
            let (px, py) = (256 * i64::from(column) - ax, 256 * i64::from(row) - ay);
            let cross = |x: i64, y: i64| i128::from(x) * i128::from(dy) - i128::from(y) * i128::from(dx);
            // No sample is within half a pixel if the centre is not within two.
            let reach = 512 * (i128::from(dx.abs()) + i128::from(dy.abs()));
            if cross(px + 128, py + 128).abs() > reach {
                continue;
            }
            let mut count = 0;
            for i in 0..n {
                for j in 0..n {
                    let (x, y) = (px + j * step + step / 2, py + i * step + step / 2);
                    let along = i128::from(x) * i128::from(dx) + i128::from(y) * i128::from(dy);
                    let across = cross(x, y);
                    // |across| <= 2^10 (|dx| + |dy|) here, so that its square stays below 2^90.
                    count += u32::from((0..=square).contains(&along) && 4 * across * across <= 65536 * square);
                }
            }
            let coverage = (255 * count + whole / 2) / whole;
            display(Fragment::covered(column, row, coverage.min(255) as u8), clip, sink)?;
        }
    }
    Ok(())
}
