//! Rectangle with round corners.

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    Angle, PixelRect, Vertex,
    outline::{Curve, Curves, FinePoint, Step, Vector},
    primitive::{
        rectangle::Rectangle,
        rows::{TURN, centre_of, centres, root_below, send_rows, shape_by_rows},
    },
    span::RowSink,
};

/// A rectangle whose corners are quarters of ellipses.
///
/// Radii are in 1/256 pixel, of each corner along x and y, clockwise from the upper left; negative ones are none.
/// Where those of one side are together longer than the side, all are reduced by the same factor, as CSS has it. A
/// pixel belongs to it when its centre does: as for [`Rectangle`], and in the corners as for an ellipse, exactly.
///
/// ```text
///     . # # # # #
///     # # # # # #      radii 2, 0, 2, 0
///     # # # # # #
///     # # # # # .
/// ```
///
/// # Cost
///
/// In the rows of its corners, a square root for each, and a division of 128 bits for those that are not round.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{I24F8, Rectangle, RoundedRectangle, Vertex, prelude::*};
///
/// let button = Rectangle::new(Vertex::new(0, 0), Vertex::new(7, 4));
/// let mut display = MockDisplay::new();
/// RoundedRectangle::new(button, I24F8::lit("2")).filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&[" ##### ", "#######", "#######", " ##### "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct RoundedRectangle {
    /// Its sides.
    pub rectangle: Rectangle,
    /// Along x and y, of the upper left, upper right, lower right and lower left corner.
    pub radii: [Vertex; 4],
}

/// One corner: where its ellipse is, in 1/256 pixel.
#[derive(Debug, Clone, Copy)]
struct Corner {
    center: (i64, i64),
    radii: (i64, i64),
}

impl Corner {
    /// How far from the ellipse's centre the row reaches; none on or beyond its end.
    fn reach(&self, row_centre: i64) -> Option<i64> {
        let (rx, ry) = self.radii;
        let dy = row_centre - self.center.1;
        if rx == ry {
            return root_below(i128::from(rx - dy) * i128::from(rx + dy));
        }
        // m^2 ry^2 < rx^2 (ry^2 - dy^2), below 2^126.
        let rest = i128::from(rx) * i128::from(rx) * (i128::from(ry - dy) * i128::from(ry + dy));
        let ry_square = (i128::from(ry) * i128::from(ry)).max(1);
        root_below(1 + (rest - 1).div_euclid(ry_square))
    }
}

impl RoundedRectangle {
    /// All corners with the same radius.
    pub const fn new(rectangle: Rectangle, radius: I24F8) -> Self {
        Self { rectangle, radii: [Vertex { x: radius, y: radius }; 4] }
    }

    /// In 1/256 pixel, upper left, upper right, lower right, lower left.
    fn corners(&self) -> [Corner; 4] {
        let Rectangle { low, high } = self.rectangle;
        let [left, top, right, bottom] = [low.x, low.y, high.x, high.y].map(|side| i64::from(side.to_bits()));
        let (width, height) = ((right - left).max(0), (bottom - top).max(0));
        let mut radii = self.radii.map(|radii| [radii.x, radii.y].map(|radius| i64::from(radius.to_bits()).max(0)));
        let [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = radii;
        // The smallest of length / sum, at most 1.
        let (mut length, mut sum) = (1, 1);
        for (side, together) in [(width, ax + bx), (height, by + cy), (width, cx + dx), (height, dy + ay)] {
            // Products below 2^66.
            if i128::from(side) * i128::from(sum) < i128::from(length) * i128::from(together) {
                (length, sum) = (side, together);
            }
        }
        if length < sum {
            for radius in radii.iter_mut().flatten() {
                let reduced = i128::from(*radius) * i128::from(length) / i128::from(sum.max(1));
                *radius = i64::try_from(reduced).unwrap_or(*radius);
            }
        }
        let [a, b, c, d] = radii;
        let corner = |[rx, ry]: [i64; 2], x: i64, y: i64| Corner { center: (x, y), radii: (rx, ry) };
        [
            corner(a, left + a[0], top + a[1]),
            corner(b, right - b[0], top + b[1]),
            corner(c, right - c[0], bottom - c[1]),
            corner(d, left + d[0], bottom - d[1]),
        ]
    }

    fn pixel_bounds(&self) -> PixelRect {
        crate::shape::Shape::bounds(&self.rectangle)
    }

    fn columns(&self, corners: &[Corner; 4], row: i32) -> Range<i32> {
        let y = centre_of(row);
        let [upper_left, upper_right, lower_right, lower_left] = corners;
        // The first column on the left, and the one after the last on the right, of whichever corner the row is in.
        let side = |upper: &Corner, lower: &Corner, straight: i64, sign: i64| {
            let corner = if y < upper.center.1 {
                upper
            } else if y > lower.center.1 {
                lower
            } else {
                return straight;
            };
            let past = i64::from(sign > 0);
            match corner.reach(y) {
                Some(reach) => corner.center.0 + sign * reach + past,
                None => corner.center.0,
            }
        };
        let [left, right] = [self.rectangle.low.x, self.rectangle.high.x].map(|side| i64::from(side.to_bits()));
        let left = side(upper_left, lower_left, left, -1);
        let right = side(upper_right, lower_right, right, 1);
        centres(left..right)
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        let corners = self.corners();
        send_rows(&self.pixel_bounds(), clip, sink, |row| [self.columns(&corners, row)])
    }
}

shape_by_rows!(RoundedRectangle);

impl Curves for RoundedRectangle {
    /// A move; a corner of two steps, three times with a side behind it; and a close.
    fn steps(&self) -> u32 {
        13
    }

    fn step(&self, index: u32) -> Step {
        let fine = |x: i64, y: i64| FinePoint::clamped(x * 16, y * 16);
        let corners = self.corners();
        // From (sx, sy) of the ellipse a quarter clockwise.
        let starts = [(-1, 0), (0, -1), (1, 0), (0, 1)];
        let corner = |number: u32| {
            let number = number as usize % 4;
            let Some((&Corner { center: (x, y), radii: (rx, ry) }, &(sx, sy))) =
                corners.get(number).zip(starts.get(number))
            else {
                return (FinePoint::default(), FinePoint::default(), Step::Move(FinePoint::default()));
            };
            let (from, to) = (fine(x + sx * rx, y + sy * ry), fine(x - sy * rx, y + sx * ry));
            let first = if rx > 0 && ry > 0 {
                let axes = [Vector::new(rx << 12, 0), Vector::new(0, ry << 12)];
                let start = Angle::from_bits((index.saturating_sub(1) / 3 + 2) << 30);
                Step::Curve(Curve::arc(from, to, fine(x, y), axes, start, TURN / 4))
            } else {
                Step::Line(from, fine(x + (sx - sy) * rx, y + (sy + sx) * ry))
            };
            (from, to, first)
        };
        let Some(after) = index.checked_sub(1) else { return Step::Move(corner(0).0) };
        let (_, to, first) = corner(after / 3);
        match after % 3 {
            0 => first,
            1 => Step::Line(first.end(), to),
            _ if after < 11 => Step::Line(to, corner(after / 3 + 1).0),
            _ => Step::Close(to, corner(0).0),
        }
    }
}
