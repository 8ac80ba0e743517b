//! What a path is made of.

use crate::{
    Angle,
    outline::{Curve, FinePoint},
    path::{Transform, arc::Ends},
};

/// One element of a [`Path`](crate::Path): each starts where the one before it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Element {
    /// Starts a subpath.
    Move(FinePoint),
    /// A straight line to there.
    Line(FinePoint),
    /// A quadratic Bézier curve: its control point and its end.
    Quadratic(FinePoint, FinePoint),
    /// A cubic Bézier curve: its control points and its end.
    Cubic(FinePoint, FinePoint, FinePoint),
    /// An arc of an ellipse.
    Arc(ArcTo),
    /// Joins the subpath to its start.
    Close,
}

/// An arc of an ellipse, by its centre.
///
/// It starts where the element before it ended, which should be where the ellipse says: what little rounding leaves
/// between them is in the first chord.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ArcTo {
    /// The ellipse's centre.
    pub center: FinePoint,
    /// Half the lengths of its axes.
    pub radii: FinePoint,
    /// By how much its first axis is turned from the right.
    pub rotation: Angle,
    /// Where it starts, as an angle on the circle that the ellipse is stretched from.
    pub start: Angle,
    /// How far it goes: less than a turn.
    pub sweep: Angle,
    /// Whether it goes clockwise, as angles grow.
    pub is_clockwise: bool,
    /// Its end.
    pub to: FinePoint,
}

// What `Path` says of it.
const _: () = assert!(size_of::<Element>() == 40);

impl Element {
    /// An arc as SVG describes it: from one point to another, by its radii, by how much its axes are turned, and which
    /// of four arcs it is. Radii that are too small are enlarged; without one, or without a distance, it is a line.
    ///
    /// ```text
    ///        .--- large, clockwise
    ///      /      \
    ///     |        |         the two ellipses through both points, and the two arcs
    ///    from -.-- to        of each
    ///          `--- small, clockwise
    /// ```
    ///
    /// The centre of a half circle depends on its ends very much: where they are not exact to start with, as for
    /// numbers in a file, scale them before they are rounded, as [`path!`](crate::path!) does.
    pub const fn arc(
        from: FinePoint,
        radii: FinePoint,
        rotation: Angle,
        is_large: bool,
        is_clockwise: bool,
        to: FinePoint,
    ) -> Self {
        const fn wide(point: FinePoint) -> [i64; 2] {
            [(point.x as i64) << 20, (point.y as i64) << 20]
        }
        Ends { from: wide(from), to: wide(to), radii: wide(radii), rotation, is_large, is_clockwise }.element()
    }
}

impl ArcTo {
    pub(crate) const fn curve(&self, from: FinePoint, transform: &Transform) -> Curve {
        let axes = transform.axes(self.radii, self.rotation);
        let sweep = self.sweep.to_bits() as i64;
        let sweep = if self.is_clockwise { sweep } else { -sweep };
        Curve::arc(from, transform.apply(self.to), transform.apply(self.center), axes, self.start, sweep)
    }
}
