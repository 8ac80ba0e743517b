//! Rounded rectangles: rows between the ellipses of four corners.

use core::ops::Range;

use embedded_graphics::primitives::{CornerRadii, RoundedRectangle};
use embedded_graphics_core::{draw_target::DrawTarget, geometry::Size, primitives::Rectangle};

use crate::{Blend, Mix};

use super::{
    Blended,
    curve::Curve,
    outline::{Chords, Layer, Outline, draw_outlines, draw_outlines_in, push_arc, radius},
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
    rectangle::fill_box,
    rows::draw_rows,
    styled::Primitive,
};

/// A box with four corners cut off: clockwise from the top left, each with a width and a height.
#[derive(Debug, Clone, Copy)]
struct Rounded {
    pixels: PixelBox,
    radii: [(i64, i64); 4],
}

impl Rounded {
    /// Moved out by `pixels`, or in by less than none: the radii change by as much, and then are made to fit.
    fn new(primitive: &RoundedRectangle, pixels: i64) -> Self {
        let CornerRadii { top_left, top_right, bottom_right, bottom_left } = primitive.corners;
        let radii = [top_left, top_right, bottom_right, bottom_left].map(|Size { width, height }| {
            let moved = |radius: u32| (i64::from(radius) + pixels).clamp(0, u32::MAX.into());
            (moved(width), moved(height))
        });
        let Rectangle { top_left, size } = primitive.rectangle;
        Self { pixels: PixelBox::new(top_left, size).offset(pixels), radii }.confined()
    }

    /// Where the radii of a side are together longer than it, all are scaled by what the worst side needs, rounded
    /// down, as embedded-graphics does.
    fn confined(mut self) -> Self {
        let [top_left, top_right, bottom_right, bottom_left] = self.radii;
        let PixelBox { width, height, .. } = self.pixels;
        let sides = [
            (top_left.0 + top_right.0, width),
            (top_right.1 + bottom_right.1, height),
            (bottom_left.0 + bottom_right.0, width),
            (top_left.1 + bottom_left.1, height),
        ];
        let mut worst = (0, 1, 1);
        for (radii, side) in sides {
            if radii - side > worst.0 {
                worst = (radii - side, radii, side);
            }
        }
        let (overlap, radii, side) = worst;
        if overlap > 0 {
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
        let PixelBox { left, top, width, height } = self.pixels;
        let edges = (256 * left, 256 * top, 256 * (left + width), 256 * (top + height));
        // Once more: what made one side fit may not be enough for the others.
        for (corner, (x, y)) in (0_i32..).zip(self.confined().radii) {
            // Half the size of the ellipse whose quarter the corner is.
            let radii = (radius(2 * x), radius(2 * y));
            let chords = Chords::new(if x == 0 || y == 0 { 0 } else { radii.0.max(radii.1) }, room.saturating_sub(12));
            let center = (
                if matches!(corner, 0 | 3) { edges.0 + radii.0 } else { edges.2 - radii.0 },
                if corner < 2 { edges.1 + radii.1 } else { edges.3 - radii.1 },
            );
            let quarter = chords.count() / 4;
            // Point 0 is on the right, and the first corner begins on the left.
            let first = (corner + 2) * quarter;
            push_arc(outline, center, radii, chords, first..=first + quarter);
        }
    }
}

/// What lies between the corners, where there are no pixels covered in part: columns from side to side, and rows.
///
/// ```text
///      corner | columns | corner
///     --------+---------+--------
///       rows  |         |  rows       as few rectangles as there are colours, whatever the size;
///     --------+---------+--------     only the corners are blended
///      corner |         | corner
/// ```
struct Cross {
    columns: Range<i64>,
    rows: Range<i64>,
}

impl Cross {
    /// None where corners touch, or nothing is inside.
    fn between(outer: &Rounded, inner: &Rounded) -> Option<Self> {
        if inner.pixels.is_empty() {
            return None;
        }
        let straight = |rounded: &Rounded| {
            let PixelBox { left, top, width, height } = rounded.pixels;
            let [a, b, c, d] = rounded.confined().radii;
            (left + a.0.max(d.0)..left + width - b.0.max(c.0), top + a.1.max(b.1)..top + height - c.1.max(d.1))
        };
        let (outer, inner) = (straight(outer), straight(inner));
        let both = |a: Range<i64>, b: Range<i64>| a.start.max(b.start)..a.end.min(b.end);
        let (columns, rows) = (both(outer.0, inner.0), both(outer.1, inner.1));
        (!columns.is_empty() && !rows.is_empty()).then_some(Self { columns, rows })
    }

    fn draw<D: DrawTarget>(
        &self,
        outer: &PixelBox,
        inner: &PixelBox,
        paint: &Paint<D::Color>,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let mut draw = |columns: Range<i64>, rows: Range<i64>, colour: Option<D::Color>| match colour {
            Some(colour) if !columns.is_empty() && !rows.is_empty() => {
                let (width, height) = (columns.end - columns.start, rows.end - rows.start);
                fill_box(&PixelBox { left: columns.start, top: rows.start, width, height }, colour, target)
            }
            _ => Ok(()),
        };
        let Self { columns, rows } = self;
        let (outer_end, inner_end) = (outer.top + outer.height, inner.top + inner.height);
        draw(columns.clone(), outer.top..inner.top, paint.stroke)?;
        draw(columns.clone(), inner.top..rows.start, paint.fill)?;
        draw(outer.left..inner.left, rows.clone(), paint.stroke)?;
        draw(inner.columns(), rows.clone(), paint.fill)?;
        draw(inner.columns().end..outer.columns().end, rows.clone(), paint.stroke)?;
        draw(columns.clone(), rows.end..inner_end, paint.fill)?;
        draw(columns.clone(), inner_end..outer_end, paint.stroke)
    }

    fn corners(&self, outer: &PixelBox) -> [PixelBox; 4] {
        let PixelBox { left, top, width, height } = *outer;
        let (right, bottom) = (left + width, top + height);
        let pixels = |left: i64, right: i64, top: i64, bottom: i64| PixelBox {
            left,
            top,
            width: right - left,
            height: bottom - top,
        };
        let (columns, rows) = (&self.columns, &self.rows);
        [
            pixels(left, columns.start, top, rows.start),
            pixels(columns.end, right, top, rows.start),
            pixels(left, columns.start, rows.end, bottom),
            pixels(columns.end, right, rows.end, bottom),
        ]
    }
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
        let PixelBox { top, height, .. } = self.shape.pixels;
        if !self.shape.pixels.has_row(row) {
            return 0..0;
        }
        let columns = self.shape.pixels.columns();
        let [top_left, top_right, bottom_right, bottom_left] = &mut self.corners;
        let [a, b, c, d] = self.shape.radii;
        let (above, below) = (row - top, top + height - 1 - row);
        let cuts_empty = self.cuts_empty;
        let cut = |(left, width): (Option<i64>, i64)| left.unwrap_or(if cuts_empty { width } else { 0 });
        let left = cut(side(above, below, (top_left, a), (bottom_left, d)));
        let right = cut(side(above, below, (top_right, b), (bottom_right, c)));
        columns.start + left..columns.end - right
    }
}

/// How much the corners cut off one end of a row, which has so many rows above it and below it; none when the corner
/// has no pixel there. And the width of the corner.
fn side(
    above: i64,
    below: i64,
    upper: (&mut Curve, (i64, i64)),
    lower: (&mut Curve, (i64, i64)),
) -> (Option<i64>, i64) {
    let (rows, (curve, (width, height))) = if above < upper.1.1 {
        (above, upper)
    } else if below < lower.1.1 {
        (below, lower)
    } else {
        return (Some(0), 0);
    };
    // The middle of the ellipse lies between two rows and two columns.
    let cut = curve.reach(2 * (height - rows) - 1).map(|reach| width - (reach + 1) / 2);
    (if width == 0 { Some(0) } else { cut }, width)
}

impl Primitive for RoundedRectangle {
    #[inline(never)]
    fn draw_aliased<D: DrawTarget>(&self, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        let outer = Rounded::new(self, paint.sides.outside());
        let mut outline = Rows::new(outer, false);
        let mut filled = Rows::new(Rounded::new(self, -paint.sides.inside()), paint.stroke.is_some());
        draw_rows(&outer.pixels, paint, target, |row, parts| {
            parts.add_ring(outline.columns(row), filled.columns(row));
        })
    }

    fn draw_blended<D: DrawTarget, B: Blend<D>>(
        &self,
        paint: &Paint<D::Color>,
        blended: &Blended<B>,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D::Color: Mix,
    {
        let outer = Rounded::new(self, paint.sides.outside());
        let inner = Rounded::new(self, -paint.sides.inside());
        if !outer.pixels.can_be_blended() {
            return self.draw_aliased(paint, target);
        }
        let outer = if paint.stroke.is_some() { outer } else { inner };
        let push = |outline: &mut Outline, room: usize, layer: Layer| {
            let rounded = if layer == Layer::Outer { &outer } else { &inner };
            rounded.push(outline, room);
        };
        match Cross::between(&outer, &inner).filter(|_| blended.opacity == 255) {
            Some(cross) => {
                cross.draw(&outer.pixels, &inner.pixels, paint, target)?;
                draw_outlines_in(paint, blended, target, &cross.corners(&outer.pixels), push)
            }
            None => draw_outlines(paint, blended, target, &outer.pixels, push),
        }
    }

    fn styled_box(&self, stroke: &Stroke, _is_blended: bool) -> Rectangle {
        PixelBox::new(self.rectangle.top_left, self.rectangle.size).offset(stroke.outside()).rectangle()
    }
}
