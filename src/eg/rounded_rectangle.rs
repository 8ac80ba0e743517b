//! Rounded rectangles: rows between the ellipses of four corners.

use core::ops::Range;

use embedded_graphics::primitives::{CornerRadii, RoundedRectangle};
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Size};

use crate::outline::Vector;

use super::{
    boxes::Boxes,
    curve::Curve,
    layers::Layers,
    outline::{Chords, Outline, radius, with_outlines},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    rows::draw_rows,
    styled::Boxed,
};

/// A box with four corners cut off: clockwise from the top left, each with a width and a height.
#[derive(Debug, Clone, Copy)]
struct Rounded {
    pixels: PixelBox,
    radii: [(i64, i64); 4],
}

impl Rounded {
    /// In a box that is moved out by so many pixels, or in by less than none: the radii change by as much, and then are
    /// made to fit.
    fn new(primitive: &RoundedRectangle, pixels: PixelBox, moved: i64) -> Self {
        let CornerRadii { top_left, top_right, bottom_right, bottom_left } = primitive.corners;
        let moved = |radius: u32| (i64::from(radius) + moved).clamp(0, u32::MAX.into());
        let corner = |Size { width, height }: Size| (moved(width), moved(height));
        Self { pixels, radii: [top_left, top_right, bottom_right, bottom_left].map(corner) }.confined()
    }

    /// Of the outline of the stroke, and of what it leaves to fill.
    fn both(primitive: &RoundedRectangle, boxes: &Boxes, stroke: &Stroke) -> [Self; 2] {
        let inner = Self::new(primitive, boxes.inner, -stroke.inside());
        [Self::new(primitive, boxes.outer, stroke.outside()), inner]
    }

    /// Where the radii of a side are together longer than it, all are scaled by what the worst side needs, rounded
    /// down, as embedded-graphics does.
    fn confined(mut self) -> Self {
        let [a, b, c, d] = self.radii;
        let PixelBox { width, height, .. } = self.pixels;
        let sides = [(a.0 + b.0, width), (b.1 + c.1, height), (d.0 + c.0, width), (a.1 + d.1, height)];
        let mut worst = (0, 1);
        for (radii, side) in sides {
            if radii - side > worst.0 - worst.1 && radii > side {
                worst = (radii, side);
            }
        }
        let (radii, side) = worst;
        if radii > 0 {
            // Exact below 2^31 pixels.
            let fitted = |radius: i64| radius.saturating_mul(side) / radii.max(1);
            self.radii = self.radii.map(|(x, y)| (fitted(x), fitted(y)));
        }
        self
    }

    #[inline(never)]
    fn push(&self, outline: &mut Outline, room: usize) {
        if self.pixels.is_empty() {
            return;
        }
        let (columns, rows) = (self.pixels.columns(), self.pixels.rows());
        // Once more: what made one side fit may not be enough for the others.
        for (corner, (x, y)) in (0_u32..).zip(self.confined().radii) {
            // Half the size of the ellipse whose quarter the corner is.
            let radii = Vector::new(radius(2 * x), radius(2 * y));
            let chords = Chords::new(if x == 0 || y == 0 { 0 } else { radii.x.max(radii.y) }, room, 1 << 16);
            let left = if matches!(corner, 0 | 3) { columns.start + x } else { columns.end - x };
            let top = if corner < 2 { rows.start + y } else { rows.end - y };
            // Point 0 is on the right, and the first corner begins on the left.
            let quarter = chords.quarter();
            let first = (corner + 2) * quarter;
            chords.push(outline, Vector::new(256 * left, 256 * top), radii, first..=first + quarter);
        }
    }

    /// The columns and the rows that meet no corner.
    fn straight(&self) -> (Range<i64>, Range<i64>) {
        let [a, b, c, d] = self.confined().radii;
        let (columns, rows) = (self.pixels.columns(), self.pixels.rows());
        let columns = columns.start + a.0.max(d.0)..columns.end - b.0.max(c.0);
        (columns, rows.start + a.1.max(b.1)..rows.end - c.1.max(d.1))
    }
}

/// What lies between the corners, where there are no pixels covered in part, and the corners. None where corners touch, or
/// nothing is inside.
///
/// ```text
///      corner |       | corner
///     --------+       +--------
///       band  | band  |  band      as few rectangles as there are colours, whatever the size;
///     --------+       +--------    only the corners are blended
///      corner |       | corner
/// ```
fn split([outer, inner]: &[Rounded; 2]) -> Option<([PixelBox; 3], [PixelBox; 4])> {
    let both = |a: Range<i64>, b: Range<i64>| a.start.max(b.start)..a.end.min(b.end);
    let (straight, inside) = (outer.straight(), inner.straight());
    let (columns, rows) = (both(straight.0, inside.0), both(straight.1, inside.1));
    if columns.is_empty() || rows.is_empty() || inner.pixels.is_empty() {
        return None;
    }
    let (width, height) = (outer.pixels.columns(), outer.pixels.rows());
    let [left, right] = [width.start..columns.start, columns.end..width.end];
    let [above, below] = [height.start..rows.start, rows.end..height.end];
    let between = |columns: &Range<i64>, rows: &Range<i64>| PixelBox::between(columns.clone(), rows.clone());
    Some((
        [between(&columns, &height), between(&left, &rows), between(&right, &rows)],
        [between(&left, &above), between(&right, &above), between(&left, &below), between(&right, &below)],
    ))
}

/// The rows of a rounded rectangle.
struct Rows {
    shape: Rounded,
    corners: [Curve; 4],
    /// Whether a corner that has no pixel on a row is cut off there. A corner of a column or two has none on the rows
    /// at its end; embedded-graphics cuts it off inside of a stroke, and else does not.
    cuts_empty: bool,
}

impl Rows {
    fn new(shape: Rounded, cuts_empty: bool) -> Self {
        let corners = shape.radii.map(|(width, height)| Curve::new(2 * width, 2 * height));
        Self { shape, corners, cuts_empty }
    }

    fn columns(&mut self, row: i64) -> Range<i64> {
        let (columns, rows) = (self.shape.pixels.columns(), self.shape.pixels.rows());
        if !rows.contains(&row) {
            return 0..0;
        }
        let (above, below) = (row - rows.start, rows.end - 1 - row);
        let [a, b, c, d] = self.shape.radii;
        let [top_left, top_right, bottom_right, bottom_left] = &mut self.corners;
        // How much the corners cut off one end of the row.
        let cut = |upper: (&mut Curve, (i64, i64)), lower: (&mut Curve, (i64, i64))| {
            let (rows, (curve, (width, height))) = if above < upper.1.1 {
                (above, upper)
            } else if below < lower.1.1 {
                (below, lower)
            } else {
                return 0;
            };
            // The middle of the ellipse lies between two rows and two columns.
            match curve.reach(2 * (height - rows) - 1) {
                Some(reach) => width - (reach + 1) / 2,
                None if self.cuts_empty => width,
                None => 0,
            }
        };
        let start = columns.start + cut((top_left, a), (bottom_left, d));
        start..columns.end - cut((top_right, b), (bottom_right, c))
    }
}

impl Boxed for RoundedRectangle {
    fn pixels(&self) -> PixelBox {
        PixelBox::new(self.rectangle.top_left, self.rectangle.size)
    }

    fn draw_pixels<D: DrawTarget>(&self, boxes: &Boxes, paint: &Paint<D::Color>, to: &mut D) -> Result<(), D::Error> {
        let [outer, inner] = Rounded::both(self, boxes, &paint.sides);
        let (mut outline, mut filled) = (Rows::new(outer, false), Rows::new(inner, paint.stroke.is_some()));
        draw_rows(&boxes.outer, to, |row, parts| {
            parts.add_ring(paint, outline.columns(row), filled.columns(row));
        })
    }

    fn draw_layers<L: Layers>(&self, boxes: &Boxes, stroke: &Stroke, layers: &mut L) -> Result<(), L::Error> {
        let mut both = Rounded::both(self, boxes, stroke);
        if !layers.has_stroke() {
            both[0] = both[1];
        }
        let [outer, inner] = &both;
        let split = split(&both).filter(|_| layers.is_opaque());
        if let Some((bands, _)) = &split {
            let boxes = Boxes { outer: outer.pixels, inner: inner.pixels };
            bands.iter().try_for_each(|band| layers.draw_whole(&boxes, band))?;
        }
        with_outlines(
            layers.has_stroke(),
            |outline, room, is_outer| if is_outer { outer.push(outline, room) } else { inner.push(outline, room) },
            |outer, inner| match &split {
                Some((_, corners)) => {
                    corners.iter().try_for_each(|corner| layers.draw_tiles(&corner.rectangle().into(), &outer, &inner))
                }
                None => layers.draw(&outer, &inner),
            },
        )
    }
}
