//! A dashboard: a gauge with a needle, a plot, icons, and text by embedded-graphics' fonts.

use embedded_graphics::{
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_6X10, FONT_10X20},
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self as eg, PrimitiveStyle, Rectangle},
    text::{Alignment, Text},
};
use spanfill::{AntiAlias, Bounded, Circle, Line, Over, Triangle, Turn, Vertex};

const PANEL: Rgb565 = Rgb565::new(3, 8, 5);
const FACE: Rgb565 = Rgb565::new(7, 16, 9);
const SCALE: Rgb565 = Rgb565::new(20, 44, 24);
const NEEDLE: Rgb565 = Rgb565::CSS_ORANGE_RED;
const CURVE: Rgb565 = Rgb565::CSS_SPRING_GREEN;
const TEXT: Rgb565 = Rgb565::WHITE;

const HUB: Point = Point::new(100, 120);

/// The plot's samples, from 0 to 59.
const SAMPLES: [i32; 29] = [
    30, 34, 41, 47, 50, 48, 42, 33, 25, 19, 14, 12, 15, 20, 28, 37, 45, 52, 56, 57, 54, 47, 38, 29, 22, 18, 17, 21, 27,
];

/// What is worked out once, and not again for each band: directions need sines, and most microcontrollers have no floating point.
#[derive(Debug, Clone, Copy)]
pub struct Dashboard {
    ticks: [Line; 11],
    needle: Triangle,
}

impl Dashboard {
    /// `value` is from 0 to 100 on the gauge.
    pub fn new(value: i32) -> Self {
        let tick = |index: usize| {
            let turn = turn(10 * index as i32);
            Line::new(around(turn, 0, -66), around(turn, 0, -78))
        };
        Self { ticks: core::array::from_fn(tick), needle: needle_shape(value) }
    }
}

/// Everything.
pub fn draw<D: DrawTarget<Color = Rgb565>>(target: &mut D, dashboard: &Dashboard) -> Result<(), D::Error> {
    backdrop(target)?;
    Circle::new(HUB, 86).antialiased(SCALE, Over(PANEL)).draw(target)?;
    Circle::new(HUB, 82).antialiased(FACE, Over(SCALE)).draw(target)?;
    for tick in &dashboard.ticks {
        tick.antialiased(TEXT, Over(FACE)).draw(target)?;
    }
    dashboard.needle.antialiased(NEEDLE, Over(FACE)).draw(target)?;
    Circle::new(HUB, 9).antialiased(TEXT, Over(FACE)).draw(target)?;
    let points = || SAMPLES.iter().zip(0..).map(|(sample, index)| Point::new(204 + 4 * index, 120 - sample));
    for (from, to) in points().zip(points().skip(1)) {
        Line::new(from, to).antialiased(CURVE, Over(FACE)).draw(target)?;
    }
    for (index, colour) in [Rgb565::CSS_GOLD, Rgb565::CSS_DEEP_SKY_BLUE, Rgb565::CSS_VIOLET].into_iter().enumerate() {
        let x = 220 + 40 * index as i32;
        Circle::new(Point::new(x, 160), 14).antialiased(colour, Over(PANEL)).draw(target)?;
        let icon = Triangle::new(Point::new(x - 6, 167), Point::new(x + 7, 165), Point::new(x, 151));
        icon.antialiased(PANEL, Over(colour)).draw(target)?;
    }
    texts(target)
}

/// The needle: where it is has to be drawn again when the value changes.
pub fn needle_shape(value: i32) -> Triangle {
    let turn = turn(value);
    let corner = |x, y| around(turn, x, y);
    Triangle::new(corner(0, -62), corner(5, 10), corner(-5, 10))
}

/// The same by embedded-graphics: the same shapes, without anti-aliasing.
pub fn draw_by_embedded_graphics<D: DrawTarget<Color = Rgb565>>(
    target: &mut D,
    dashboard: &Dashboard,
) -> Result<(), D::Error> {
    let round = |centre: Point, radius: i32, colour| {
        let top_left = centre - Point::new(radius, radius);
        eg::Circle::new(top_left, 2 * radius as u32 + 1).into_styled(PrimitiveStyle::with_fill(colour))
    };
    backdrop(target)?;
    round(HUB, 86, SCALE).draw(target)?;
    round(HUB, 82, FACE).draw(target)?;
    let thin = |colour| PrimitiveStyle::with_stroke(colour, 1);
    for Line { start, end } in dashboard.ticks {
        eg::Line::new(pixel(start), pixel(end)).into_styled(thin(TEXT)).draw(target)?;
    }
    let [a, b, c] = dashboard.needle.vertices.map(pixel);
    eg::Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_fill(NEEDLE)).draw(target)?;
    round(HUB, 9, TEXT).draw(target)?;
    let points = || SAMPLES.iter().zip(0..).map(|(sample, index)| Point::new(204 + 4 * index, 120 - sample));
    for (from, to) in points().zip(points().skip(1)) {
        eg::Line::new(from, to).into_styled(thin(CURVE)).draw(target)?;
    }
    for (index, colour) in [Rgb565::CSS_GOLD, Rgb565::CSS_DEEP_SKY_BLUE, Rgb565::CSS_VIOLET].into_iter().enumerate() {
        let x = 220 + 40 * index as i32;
        round(Point::new(x, 160), 14, colour).draw(target)?;
        eg::Triangle::new(Point::new(x - 6, 167), Point::new(x + 7, 165), Point::new(x, 151))
            .into_styled(PrimitiveStyle::with_fill(PANEL))
            .draw(target)?;
    }
    texts(target)
}

fn backdrop<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
    target.fill_solid(&Rectangle::new(Point::zero(), Size::new(320, 240)), PANEL)?;
    target.fill_solid(&Rectangle::new(Point::new(200, 56), Size::new(116, 70)), FACE)
}

fn texts<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
    let large = MonoTextStyle::new(&FONT_10X20, TEXT);
    let small = MonoTextStyle::new(&FONT_6X10, SCALE);
    // embedded-graphics draws every pixel of a text, even where no row of it is on a band.
    let mut draw = |text: Text<'_, MonoTextStyle<'_, Rgb565>>| Bounded::new(text).draw(target).map(|_| ());
    draw(Text::with_alignment("Engine 2", Point::new(160, 22), large, Alignment::Center))?;
    draw(Text::with_alignment("rpm x 100", Point::new(100, 226), small, Alignment::Center))?;
    draw(Text::new("oil pressure", Point::new(204, 52), small))?;
    draw(Text::new("pump  fan  lamp", Point::new(210, 190), small))
}

/// The gauge spans 270 degrees.
fn turn(value: i32) -> Turn {
    Turn::from_degrees((value - 50) as f32 * 2.7)
}

fn around(turn: Turn, x: i32, y: i32) -> Vertex {
    let centre = Vertex::from(HUB);
    turn.about(
        centre,
        Vertex { x: centre.x + spanfill::I24F8::from_num(x), y: centre.y + spanfill::I24F8::from_num(y) },
    )
}

/// The pixel that holds a vertex.
fn pixel(vertex: Vertex) -> Point {
    Point::new(vertex.x.to_num::<i32>(), vertex.y.to_num::<i32>())
}
