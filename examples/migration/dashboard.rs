//! A small dashboard of all nine primitives.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, Ellipse, Line, Polyline, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle, RoundedRectangle,
        Sector, StyledDrawable, Triangle,
    },
};
use spanfill::{
    Over,
    eg::{Blended, Style},
};

pub(crate) const SIZE: Size = Size::new(104, 96);
pub(crate) const BACKGROUND: Rgb565 = Rgb565::new(2, 5, 4);

const PANEL: Rgb565 = Rgb565::new(5, 11, 7);
const LINES: Rgb565 = Rgb565::new(13, 28, 15);
const LIGHT: Rgb565 = Rgb565::new(28, 58, 28);
const GREEN: Rgb565 = Rgb565::new(6, 48, 14);
const AMBER: Rgb565 = Rgb565::new(30, 42, 4);
const RED: Rgb565 = Rgb565::new(28, 14, 8);
const BLUE: Rgb565 = Rgb565::new(8, 34, 30);

/// Whose style draws it.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Kind {
    EmbeddedGraphics,
    Aliased,
    AntiAliased,
}

/// What any of the three styles can be drawn in.
trait Any:
    StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
    + StyledDrawable<Style<Rgb565>, Color = Rgb565, Output = ()>
    + StyledDrawable<Style<Rgb565, Blended<Over<Rgb565>>>, Color = Rgb565, Output = ()>
{
}

impl<T> Any for T where
    T: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
        + StyledDrawable<Style<Rgb565>, Color = Rgb565, Output = ()>
        + StyledDrawable<Style<Rgb565, Blended<Over<Rgb565>>>, Color = Rgb565, Output = ()>
{
}

/// Draws primitives in one of the styles.
struct Pen<'d, D> {
    kind: Kind,
    target: &'d mut D,
}

impl<D: DrawTarget<Color = Rgb565>> Pen<'_, D> {
    /// `behind` is what an anti-aliased edge is blended over.
    fn draw(&mut self, primitive: impl Any, style: PrimitiveStyle<Rgb565>, behind: Rgb565) -> Result<(), D::Error> {
        match self.kind {
            Kind::EmbeddedGraphics => primitive.draw_styled(&style, self.target),
            Kind::Aliased => primitive.draw_styled(&Style::from(style), self.target),
            Kind::AntiAliased => primitive.draw_styled(&Style::from(style).antialiased(Over(behind)), self.target),
        }
    }
}

/// Draws the dashboard.
pub(crate) fn draw<D: DrawTarget<Color = Rgb565>>(kind: Kind, target: &mut D) -> Result<(), D::Error> {
    let mut pen = Pen { kind, target };
    let fill = PrimitiveStyle::with_fill;
    let stroke = PrimitiveStyle::with_stroke;
    let both = |fill, stroke, width| {
        PrimitiveStyleBuilder::new().fill_color(fill).stroke_color(stroke).stroke_width(width).build()
    };

    // A gauge.
    let panel =
        RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(2, 2), Size::new(58, 50)), Size::new(8, 8));
    pen.draw(panel, both(PANEL, LINES, 1), BACKGROUND)?;
    let gauge = Circle::with_center(Point::new(30, 30), 42);
    pen.draw(Arc::from_circle(gauge, 150.0.deg(), 240.0.deg()), stroke(LINES, 5), PANEL)?;
    pen.draw(Arc::from_circle(gauge, 150.0.deg(), 155.0.deg()), stroke(GREEN, 5), PANEL)?;
    pen.draw(Line::new(Point::new(30, 30), Point::new(40, 17)), stroke(LIGHT, 3), PANEL)?;
    pen.draw(Circle::with_center(Point::new(30, 30), 9), both(RED, LIGHT, 2), PANEL)?;

    // Shares.
    let panel =
        RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(63, 2), Size::new(39, 50)), Size::new(8, 8));
    pen.draw(panel, both(PANEL, LINES, 1), BACKGROUND)?;
    let pie = Circle::with_center(Point::new(80, 19), 27);
    pen.draw(Sector::from_circle(pie, 100.0.deg(), 255.0.deg()), fill(BLUE), PANEL)?;
    let pulled = pie.translate(Point::new(4, 3));
    pen.draw(Sector::from_circle(pulled, 0.0.deg(), 75.0.deg()), both(AMBER, LIGHT, 1), PANEL)?;
    pen.draw(Ellipse::with_center(Point::new(73, 43), Size::new(15, 9)), fill(GREEN), PANEL)?;
    pen.draw(Ellipse::with_center(Point::new(91, 43), Size::new(15, 9)), both(PANEL, GREEN, 2), PANEL)?;

    // A chart.
    pen.draw(Rectangle::new(Point::new(2, 55), Size::new(72, 39)), both(PANEL, LINES, 1), BACKGROUND)?;
    for y in [64, 74, 84] {
        pen.draw(Line::new(Point::new(3, y), Point::new(72, y)), stroke(LINES, 1), PANEL)?;
    }
    let thin = [(6, 88), (16, 84), (25, 86), (36, 72), (45, 77), (57, 61), (69, 66)].map(|(x, y)| Point::new(x, y));
    let thick = [(6, 80), (18, 66), (28, 70), (40, 88), (52, 82), (69, 87)].map(|(x, y)| Point::new(x, y));
    pen.draw(Polyline::new(&thin), stroke(BLUE, 1), PANEL)?;
    pen.draw(Polyline::new(&thick), stroke(AMBER, 3), PANEL)?;

    // Signs.
    let sign = Triangle::new(Point::new(89, 56), Point::new(77, 76), Point::new(101, 76));
    pen.draw(sign, both(AMBER, RED, 2), BACKGROUND)?;
    pen.draw(Line::new(Point::new(89, 63), Point::new(89, 69)), stroke(PANEL, 2), AMBER)?;
    pen.draw(Rectangle::new(Point::new(88, 71), Size::new(2, 2)), fill(PANEL), AMBER)?;
    pen.draw(Triangle::new(Point::new(78, 80), Point::new(88, 87), Point::new(78, 94)), fill(GREEN), BACKGROUND)?;
    pen.draw(Triangle::new(Point::new(91, 80), Point::new(101, 83), Point::new(94, 94)), stroke(LIGHT, 1), BACKGROUND)
}
