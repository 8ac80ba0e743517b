//! Filled ellipse, turned by any angle: every centre inside, by comparing squares.
//!
//! With half axes `u` and `v`, a point `(x, y)` from the centre is inside where
//!
//! ```text
//!     (x vy - y vx)^2 + (y ux - x uy)^2 < D^2,     D = ux vy - uy vx,
//!     H x^2 - 2 B x y + A y^2 < D^2,               H = uy^2 + vy^2, B = ux uy + vx vy, A = ux^2 + vx^2,
//! ```
//!
//! so a row `y` has the columns within `D sqrt(H - y^2) / H` of `B y / H`. Those are worked out to within a unit, and
//! then the first inequality decides of the pixels at both ends.

use core::ops::Range;

use fixed::types::I24F8;

use crate::{
    Angle, PixelRect, Vertex,
    outline::{Curve, Curves, FinePoint, Step, Vector, shift_half_even},
    path::Transform,
    primitive::rows::{TURN, centre_of, centres, root_below, send_rows, shape_by_rows},
    span::RowSink,
};

/// A filled ellipse with its centre and radii in 1/256 pixel, turned by an angle.
///
/// Radii of zero or less draw nothing; 131072 pixels are the most. Half axes are rounded to 1/4096 pixel once they are
/// turned; of that ellipse, a pixel belongs to it when its centre lies inside, exactly.
///
/// ```text
///     . . # # .
///     . # # # #
///     # # + # #      radii 3 and 2, turned by -30 degrees
///     # # # # .
///     . # # . .
/// ```
///
/// # Cost
///
/// A root and two divisions of 128 bits a row.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Angle, Ellipse, Vertex, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let ellipse = Ellipse::new(Vertex::pixel(2, 2), Vertex::new(3, 2)).turned(Angle::degrees(-30));
/// ellipse.filled(BinaryColor::On).draw(&mut display)?;
/// display.assert_pattern(&["  ###", " ####", "#####", "#### ", "###  "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ellipse {
    /// The centre.
    pub center: Vertex,
    /// Half the lengths of its axes.
    pub radii: Vertex,
    /// By how much it is turned.
    pub rotation: Angle,
}

/// In 1/256 pixel.
const MOST_RADIUS: i32 = 1 << 25;

/// The numbers of the module's inequalities, in 1/4096 pixel.
#[derive(Debug, Clone, Copy)]
struct Form {
    u: Vector,
    v: Vector,
    h: i128,
    b: i128,
    d: i128,
    center: Vector,
}

impl Form {
    fn is_inside(&self, column: i32, y: i64) -> bool {
        let x = 16 * centre_of(column) - self.center.x;
        // Half axes below 2^30; x and y reach no further than twice that where it is asked.
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        let (p, q) = (product(x, self.v.y) - product(y, self.v.x), product(y, self.u.x) - product(x, self.u.y));
        p * p + q * q < self.d * self.d
    }

    fn columns(&self, row: i32) -> Range<i32> {
        let y = 16 * centre_of(row) - self.center.y;
        let rest = self.h - i128::from(y) * i128::from(y);
        if rest <= 0 {
            return 0..0;
        }
        // `rest` is at most 2^60.
        let root = (rest << 60).cast_unsigned().isqrt().cast_signed();
        // Positive: the height's square.
        let half = (self.d.abs() * root).checked_div(self.h).unwrap_or(0) >> 30;
        let middle = (self.b * i128::from(y)).checked_div_euclid(self.h).unwrap_or(0);
        let position = |offset: i128| {
            let x = i64::try_from(middle + offset).unwrap_or(0) + self.center.x;
            // In 1/256 pixel, outwards by less than two of them.
            if offset < 0 { (x >> 4) - 1 } else { (x >> 4) + 2 }
        };
        let Range { mut start, mut end } = centres(position(-half - 1)..position(half + 1));
        while start < end && !self.is_inside(start, y) {
            start += 1;
        }
        while start < end && !self.is_inside(end - 1, y) {
            end -= 1;
        }
        start..end
    }
}

impl Ellipse {
    /// An upright ellipse.
    #[inline]
    pub const fn new(center: Vertex, radii: Vertex) -> Self {
        Self { center, radii, rotation: Angle::ZERO }
    }

    /// The same, turned further about its centre.
    #[inline]
    #[must_use]
    pub fn turned(self, angle: Angle) -> Self {
        Self { rotation: self.rotation + angle, ..self }
    }

    fn fine_radii(&self) -> FinePoint {
        let fine = |radius: I24F8| 16 * radius.to_bits().clamp(0, MOST_RADIUS);
        let (x, y) = (fine(self.radii.x), fine(self.radii.y));
        if x == 0 || y == 0 { FinePoint::default() } else { FinePoint::from_bits(x, y) }
    }

    fn form(&self) -> Form {
        let [u, v] = Transform::IDENTITY
            .axes(self.fine_radii(), self.rotation)
            .map(|axis| Vector::new(shift_half_even(axis.x, 8), shift_half_even(axis.y, 8)));
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        Form {
            u,
            v,
            h: product(u.y, u.y) + product(v.y, v.y),
            b: product(u.x, u.y) + product(v.x, v.y),
            d: product(u.x, v.y) - product(u.y, v.x),
            center: Vector::new(16 * i64::from(self.center.x.to_bits()), 16 * i64::from(self.center.y.to_bits())),
        }
    }

    fn pixel_bounds(&self) -> PixelRect {
        let Form { u, v, center, .. } = self.form();
        let pixels = |center: i64, u: i64, v: i64| {
            match root_below(i128::from(u) * i128::from(u) + i128::from(v) * i128::from(v)) {
                // From the first 1/256 pixel after the end of the ellipse to that.
                Some(reach) => centres(((center - reach) >> 4)..((center + reach) >> 4) + 1),
                None => 0..0,
            }
        };
        PixelRect { rows: pixels(center.y, u.y, v.y), columns: pixels(center.x, u.x, v.x) }
    }

    fn send<R: RowSink>(&self, clip: &PixelRect, sink: &mut R) -> Result<(), R::Error> {
        let form = self.form();
        send_rows(&self.pixel_bounds(), clip, sink, |row| [form.columns(row)])
    }
}

shape_by_rows!(Ellipse);

impl Curves for Ellipse {
    fn steps(&self) -> u32 {
        if self.fine_radii().x == 0 { 0 } else { 3 }
    }

    fn step(&self, index: u32) -> Step {
        let center = FinePoint::from_vertex(self.center);
        let axes = Transform::IDENTITY.axes(self.fine_radii(), self.rotation);
        let [u, _] = axes;
        let right = Vector::new(shift_half_even(u.x, 8), shift_half_even(u.y, 8)).from(center);
        match index {
            0 => Step::Move(right),
            1 => Step::Curve(Curve::arc(right, right, center, axes, Angle::ZERO, TURN)),
            _ => Step::Close(right, right),
        }
    }
}
