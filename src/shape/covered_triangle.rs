//! Anti-aliased triangle: between its long edge and the two short ones.

use crate::{
    PixelRect, Vertex,
    coverage::{Chain, CoverageSink, Slope, WideChain, send},
    edge::Descent,
    geometry::{by_height, is_narrow, touched},
    limits::SUBPIXEL_BITS,
    shape::{Cover, Triangle},
    span::clip_range,
};

impl Cover for Triangle {
    #[inline]
    fn touched(&self) -> PixelRect {
        touched(self.vertices.iter())
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let pixels = self.touched();
        let rows = clip_range(&pixels.rows, &clip.rows);
        let columns = clip_range(&pixels.columns, &clip.columns);
        if rows.is_empty() || columns.is_empty() {
            return Ok(());
        }
        let [a, b, c] = self.vertices;
        let (a, b) = by_height(a, b);
        let (b, c) = by_height(b, c);
        let (a, b) = by_height(a, b);
        let side = side_of(a, b, c);
        if side == 0 {
            return Ok(());
        }
        if is_narrow(a) && is_narrow(b) && is_narrow(c) {
            let edge =
                |top: Vertex, bottom: Vertex| (Slope::narrow(Descent::between(top, bottom), 0), bottom.y.to_bits());
            let mut long = Chain::<SUBPIXEL_BITS>::new(a.y.to_bits(), edge(a, c), None);
            let mut short = if a.y == b.y {
                Chain::new(a.y.to_bits(), edge(b, c), None)
            } else {
                Chain::new(a.y.to_bits(), edge(a, b), (b.y != c.y).then(|| edge(b, c)))
            };
            long.skip_to(rows.start);
            short.skip_to(rows.start);
            let (left, right) = if side > 0 { (long, short) } else { (short, long) };
            send(left, right, rows, &columns, sink)
        } else {
            let mut long = WideChain::new((a, c), None);
            let mut short =
                if a.y == b.y { WideChain::new((b, c), None) } else { WideChain::new((a, b), Some((b, c))) };
            long.skip_to(rows.start);
            short.skip_to(rows.start);
            let (left, right) = if side > 0 { (long, short) } else { (short, long) };
            send(left, right, rows, &columns, sink)
        }
    }
}

/// 1 where `b` lies to the right of the edge from `a` down to `c`, -1 to its left, 0 where there is no area.
fn side_of(a: Vertex, b: Vertex, c: Vertex) -> i32 {
    let difference = |from: Vertex, to: Vertex| {
        let across = i64::from(to.x.to_bits()) - i64::from(from.x.to_bits());
        (i128::from(across), i128::from(i64::from(to.y.to_bits()) - i64::from(from.y.to_bits())))
    };
    let ((bx, by), (cx, cy)) = (difference(a, b), difference(a, c));
    match (bx * cy).cmp(&(cx * by)) {
        core::cmp::Ordering::Less => -1,
        core::cmp::Ordering::Equal => 0,
        core::cmp::Ordering::Greater => 1,
    }
}
