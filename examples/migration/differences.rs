//! How many pixels of each primitive differ from embedded-graphics'.

use std::{collections::HashMap, convert::Infallible};

use embedded_graphics::{
    Pixel,
    pixelcolor::BinaryColor,
    prelude::*,
    primitives::{
        Arc, Circle, Ellipse, Line, Polyline, PrimitiveStyle, Rectangle, RoundedRectangle, Sector, StyledDrawable,
        Triangle,
    },
};
use spanfill::eg::Style;

/// The pixels that are drawn.
#[derive(Default)]
struct Drawn(HashMap<Point, BinaryColor>);

impl Dimensions for Drawn {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::new_equal(-500), Size::new_equal(1000))
    }
}

impl DrawTarget for Drawn {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.0.extend(pixels.into_iter().map(|Pixel(point, colour)| (point, colour)));
        Ok(())
    }
}

/// The same primitive in many sizes and places, filled or with a stroke of 1 and of 4 pixels.
const SIZES: u32 = 40;

fn row<P>(name: &str, primitive: impl Fn(u32) -> P)
where
    P: StyledDrawable<PrimitiveStyle<BinaryColor>, Color = BinaryColor>
        + StyledDrawable<Style<BinaryColor>, Color = BinaryColor>,
{
    let styles = [
        PrimitiveStyle::with_fill(BinaryColor::On),
        PrimitiveStyle::with_stroke(BinaryColor::On, 1),
        PrimitiveStyle::with_stroke(BinaryColor::On, 4),
    ];
    let cells = styles.map(|style| {
        let (mut drawn, mut differing) = (0, 0);
        for size in 1..=SIZES {
            let (mut theirs, mut ours) = (Drawn::default(), Drawn::default());
            let Ok(_) = primitive(size).draw_styled(&style, &mut theirs);
            let Ok(_) = primitive(size).draw_styled(&Style::from(style), &mut ours);
            drawn += theirs.0.len();
            differing += theirs.0.keys().filter(|point| !ours.0.contains_key(*point)).count();
            differing += ours.0.keys().filter(|point| !theirs.0.contains_key(*point)).count();
        }
        format!("{differing} of {drawn}")
    });
    println!("{name:18} {:>16} {:>16} {:>16}", cells[0], cells[1], cells[2]);
}

/// Prints the table.
pub(crate) fn print() {
    println!("{:18} {:>16} {:>16} {:>16}", "pixels that differ", "filled", "stroke 1", "stroke 4");
    let point = |size: u32, x: i32, y: i32| {
        let size = size as i32;
        Point::new(size * x / 10 + 3, size * y / 7 - 2)
    };
    let start = |size: u32| (size as f32 * 90.0).deg();
    row("Rectangle", |size| Rectangle::new(Point::new(2, -3), Size::new(size, 41 - size)));
    row("Circle", |size| Circle::new(Point::new(2, -3), size));
    row("Ellipse", |size| Ellipse::new(Point::new(2, -3), Size::new(size + 8, 50 - size)));
    row("RoundedRectangle", |size| {
        let rectangle = Rectangle::new(Point::new(2, -3), Size::new(50, 30));
        RoundedRectangle::with_equal_corners(rectangle, Size::new(size / 2, size / 3))
    });
    row("Arc", |size| Arc::new(Point::new(2, -3), 60, start(size), (9.0 * size as f32).deg()));
    row("Sector", |size| Sector::new(Point::new(2, -3), 60, start(size), (9.0 * size as f32).deg()));
    row("Line", |size| Line::new(point(size, 3, 4), point(40 - size.min(40), -20, 9)));
    row("Polyline", |size| Polyline::new(&POINTS).translate(point(size, 1, 1)));
    row("Triangle", |size| Triangle::new(point(size, 0, 0), point(size, 13, 4), point(size, -5, 9)));
}

const POINTS: [Point; 5] =
    [Point::new(0, 0), Point::new(30, 11), Point::new(37, -8), Point::new(60, 20), Point::new(51, 44)];
