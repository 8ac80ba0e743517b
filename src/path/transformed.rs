//! Outlines turned, squeezed, skewed and moved once they are made.

use crate::{
    outline::{FinePoint, FineRect, Outline, Vertices, WindingRule},
    path::Transform,
};

/// An outline whose vertices are transformed when they are asked for: a stroke that is squeezed with its path, as SVG has
/// it.
///
/// Each vertex is rounded once, to 1/4096 pixel; factors in 1/65536 are off by at most 1/131 pixel for what is 1000 pixels
/// away from the origin. Curves have been made lines of by then: let the outline be as large as it will be on the
/// screen, or larger.
///
/// # Cost
///
/// Four multiplications a vertex.
///
/// # Examples
///
/// ```
/// use spanfill::{FinePoint, Outline as _, Stroke, StrokeStyle, Transform, Transformed, path};
///
/// // A cross of two lines of 8 pixels, half as high: 8 pixels across and 4 down.
/// let cross = Stroke::new(path!("M-20 0H20M0-40V40"), StrokeStyle::pixels(8));
/// let squeezed = Transformed::new(cross, Transform::scaled(1 << 16, 1 << 15));
/// assert_eq!(squeezed.count(), cross.count());
/// assert!(squeezed.extent().high.y <= FinePoint::whole(0, 37).y);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Transformed<O> {
    outline: O,
    transform: Transform,
}

impl<O> Transformed<O> {
    /// The outline, transformed.
    #[inline]
    pub const fn new(outline: O, transform: Transform) -> Self {
        Self { outline, transform }
    }
}

impl<O: Outline> Outline for Transformed<O> {
    fn with_vertices<R>(&self, with: impl FnOnce(&dyn Vertices) -> R) -> R {
        let transform = self.transform;
        self.outline.with_vertices(|vertices| with(&Moved { vertices, transform, is_mirrored: transform.mirrors() }))
    }

    fn extent(&self) -> FineRect {
        let FineRect { low, high } = self.outline.extent();
        let mut extent = FineRect::EMPTY;
        if low.x <= high.x && low.y <= high.y {
            let corner = FinePoint::from_bits;
            for corner in [low, high, corner(low.x, high.y), corner(high.x, low.y)] {
                extent.add(self.transform.apply(corner));
            }
        }
        // Inner points may be rounded the other way.
        extent.grown(1)
    }

    fn winding_rule(&self) -> WindingRule {
        self.outline.winding_rule()
    }
}

/// The vertices of a mirrored outline are gone along the other way, so that it goes around what it did.
struct Moved<'v> {
    vertices: &'v dyn Vertices,
    transform: Transform,
    is_mirrored: bool,
}

impl Vertices for Moved<'_> {
    fn contours(&self) -> u32 {
        self.vertices.contours()
    }

    fn first(&self, contour: u32) -> Option<u32> {
        self.vertices.first(contour)
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        self.vertices.next(contour, index, is_forward != self.is_mirrored)
    }

    fn vertex(&self, contour: u32, index: u32) -> FinePoint {
        self.transform.apply(self.vertices.vertex(contour, index))
    }
}
