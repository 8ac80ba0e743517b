//! What the firmware draws, and the host: each picture by this crate and by embedded-graphics, on any draw target.

#![cfg_attr(target_os = "none", no_std)]
#![allow(missing_docs, reason = "a program")]

#[cfg(target_os = "none")]
pub mod board;
pub mod dashboard;
#[path = "../../../../benches/scenes/mod.rs"]
mod scenes;
#[cfg(not(target_os = "none"))]
pub mod simulator;

use dashboard::Dashboard;
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self as eg, PrimitiveStyle},
};
use scenes::{PixelPoint, circles, lines, triangles};
use spanfill::{AntiAlias, Circle, Fill, Line, Over, Polygon, Triangle, Vertex, eg::Style};

/// The program that gives a function a display: the one on the board, or a simulated one whose picture goes to a file.
#[macro_export]
macro_rules! main {
    ($draw:ident) => {
        #[cfg(target_os = "none")]
        use panic_halt as _;

        #[cfg(target_os = "none")]
        #[rp2040_hal::entry]
        fn main() -> ! {
            $crate::board::run(|lcd| {
                let _ = $draw(lcd);
            })
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            $crate::simulator::run(env!("CARGO_BIN_NAME"), |lcd| {
                $draw(lcd).expect("a simulated display takes everything");
            });
        }
    };
}

pub const SCREEN: Size = Size::new(320, 240);
pub const BACKGROUND: Rgb565 = Rgb565::BLACK;
const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

/// How many of each shape: large ones take an emulator long.
fn count(px: i32) -> usize {
    if px < 100 { 16 } else { 4 }
}

/// A picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Picture {
    Triangles(i32),
    Circles(i32),
    ThinLines(i32),
    ThickLines(i32),
    Star,
    SmoothTriangles(i32),
    SmoothCircles(i32),
    SmoothLines(i32),
    SmoothStar,
    Dashboard,
}

impl Picture {
    pub const ALL: [Self; 18] = [
        Self::Triangles(10),
        Self::Triangles(50),
        Self::Triangles(200),
        Self::Circles(5),
        Self::Circles(20),
        Self::Circles(100),
        Self::ThinLines(50),
        Self::ThinLines(200),
        Self::ThickLines(50),
        Self::ThickLines(200),
        Self::Star,
        Self::SmoothTriangles(50),
        Self::SmoothTriangles(200),
        Self::SmoothCircles(20),
        Self::SmoothCircles(100),
        Self::SmoothLines(200),
        Self::SmoothStar,
        Self::Dashboard,
    ];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Triangles(10) => "triangles-10",
            Self::Triangles(50) => "triangles-50",
            Self::Triangles(_) => "triangles-200",
            Self::Circles(5) => "circles-5",
            Self::Circles(20) => "circles-20",
            Self::Circles(_) => "circles-100",
            Self::ThinLines(50) => "thin-lines-50",
            Self::ThinLines(_) => "thin-lines-200",
            Self::ThickLines(50) => "thick-lines-50",
            Self::ThickLines(_) => "thick-lines-200",
            Self::Star => "star",
            Self::SmoothTriangles(50) => "smooth-triangles-50",
            Self::SmoothTriangles(_) => "smooth-triangles-200",
            Self::SmoothCircles(20) => "smooth-circles-20",
            Self::SmoothCircles(_) => "smooth-circles-100",
            Self::SmoothLines(_) => "smooth-lines-200",
            Self::SmoothStar => "smooth-star",
            Self::Dashboard => "dashboard",
        }
    }

    /// By this crate. What is smooth is blended over the background: the same on a display and in memory.
    pub fn draw<D: DrawTarget<Color = Rgb565>>(self, target: &mut D, dashboard: &Dashboard) -> Result<(), D::Error> {
        let over = Over(BACKGROUND);
        match self {
            Self::Triangles(px) => {
                in_boxes(px).try_for_each(|[a, b, c]| Triangle::new(a, b, c).filled(COLOUR).draw(target))
            }
            Self::SmoothTriangles(px) => {
                in_boxes(px).try_for_each(|[a, b, c]| Triangle::new(a, b, c).antialiased(COLOUR, over).draw(target))
            }
            Self::Circles(px) => {
                circles(px).take(count(px)).try_for_each(|centre| round(centre, px).filled(COLOUR).draw(target))
            }
            Self::SmoothCircles(px) => circles(px)
                .take(count(px))
                .try_for_each(|centre| round(centre, px).antialiased(COLOUR, over).draw(target)),
            Self::ThinLines(px) => between(px).try_for_each(|[a, b]| Line::new(a, b).filled(COLOUR).draw(target)),
            Self::SmoothLines(px) => {
                between(px).try_for_each(|[a, b]| Line::new(a, b).antialiased(COLOUR, over).draw(target))
            }
            Self::ThickLines(px) => between(px)
                .try_for_each(|[a, b]| eg::Line::new(a, b).into_styled(Style::with_stroke(COLOUR, 3)).draw(target)),
            Self::Star => {
                let star = star();
                match Polygon::new(&star).with_capacity::<8>() {
                    Ok(star) => star.filled(COLOUR).draw(target),
                    Err(_) => Ok(()),
                }
            }
            Self::SmoothStar => {
                let star = star();
                match Polygon::new(&star).coverage_with::<16>() {
                    Ok(star) => star.antialiased(COLOUR, over).draw(target),
                    Err(_) => Ok(()),
                }
            }
            Self::Dashboard => dashboard::draw(target, dashboard),
        }
    }

    /// By embedded-graphics, what it has of it: `None` is nothing.
    pub fn draw_by_embedded_graphics<D: DrawTarget<Color = Rgb565>>(
        self,
        target: &mut D,
        dashboard: &Dashboard,
    ) -> Option<Result<(), D::Error>> {
        let filled = PrimitiveStyle::with_fill(COLOUR);
        let stroke = |width| PrimitiveStyle::with_stroke(COLOUR, width);
        let mut lines =
            |px, width| between(px).try_for_each(|[a, b]| eg::Line::new(a, b).into_styled(stroke(width)).draw(target));
        Some(match self {
            Self::ThinLines(px) => lines(px, 1),
            Self::ThickLines(px) => lines(px, 3),
            Self::Triangles(px) => {
                in_boxes(px).try_for_each(|[a, b, c]| eg::Triangle::new(a, b, c).into_styled(filled).draw(target))
            }
            Self::Circles(px) => circles(px).take(count(px)).try_for_each(|[x, y]| {
                let top_left = Point::new(x - px, y - px);
                eg::Circle::new(top_left, 2 * px.unsigned_abs()).into_styled(filled).draw(target)
            }),
            Self::Dashboard => dashboard::draw_by_embedded_graphics(target, dashboard),
            _ => return None,
        })
    }
}

fn pixel([x, y]: PixelPoint) -> Point {
    Point::new(x, y)
}

fn in_boxes(px: i32) -> impl Iterator<Item = [Point; 3]> {
    triangles(px).take(count(px)).map(|corners| corners.map(pixel))
}

fn between(px: i32) -> impl Iterator<Item = [Point; 2]> {
    lines(px).take(count(px)).map(|ends| ends.map(pixel))
}

fn round([x, y]: PixelPoint, radius: i32) -> Circle {
    Circle::new(Vertex::new(x, y), radius)
}

fn star() -> [Vertex; 5] {
    scenes::STAR.map(|[x, y]| Vertex::from_bits(x, y))
}
