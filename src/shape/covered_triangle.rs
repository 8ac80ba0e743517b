//! Anti-aliased triangle: between its long edge and the two short ones.

use crate::{
    PixelRect, Vertex,
    coverage::{CoverageSink, Straight, StraightSide, WideChain, send, send_straight},
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
        if is_narrow(a) && is_narrow(b) && is_narrow(c) {
            let side = narrow_side_of(a, b, c);
            if side == 0 {
                return Ok(());
            }
            let long = StraightSide { edge: edge(a, c), next: None };
            let short = if a.y == b.y {
                StraightSide { edge: edge(b, c), next: None }
            } else {
                StraightSide { edge: edge(a, b), next: (b.y != c.y).then(|| edge(b, c)) }
            };
            let (left, right) = if side > 0 { (long, short) } else { (short, long) };
            send_straight(left, right, rows, &pixels.columns, &columns, sink)
        } else {
            let side = side_of(a, b, c);
            if side == 0 {
                return Ok(());
            }
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

/// An edge in the narrow zone.
#[inline(always)]
fn edge(top: Vertex, bottom: Vertex) -> Straight<SUBPIXEL_BITS> {
    let end = |vertex: Vertex| (i64::from(vertex.x.to_bits()) << (32 - SUBPIXEL_BITS), vertex.y.to_bits());
    let dx = bottom.x.to_bits() - top.x.to_bits();
    Straight::new(end(top), end(bottom), dx, (bottom.y.to_bits() - top.y.to_bits()).cast_unsigned())
}

/// As [`side_of`], in the narrow zone: differences are at most 2^22.
#[inline(always)]
fn narrow_side_of(a: Vertex, b: Vertex, c: Vertex) -> i32 {
    let difference = |from: Vertex, to: Vertex| {
        (i64::from(to.x.to_bits() - from.x.to_bits()), i64::from(to.y.to_bits() - from.y.to_bits()))
    };
    let ((bx, by), (cx, cy)) = (difference(a, b), difference(a, c));
    let cross = bx * cy - cx * by;
    i32::from(cross > 0) - i32::from(cross < 0)
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
