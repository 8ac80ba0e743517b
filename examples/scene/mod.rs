//! One scene for a grey display of 128 x 64 pixels: an instrument panel. The firmware draws it on the board's OLED, the
//! host on a simulated display, and the two pictures are the same in every pixel.
//!
//! It has every shape of the crate, both fill rules, holes of both kinds, sub-pixel positions, and shapes that are
//! partly off the display.

use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::Gray4,
};
use spanfill::{Circle, Fill, FillRule, Line, Polygon, Scratch, Triangle, Vertex, edges_for};

/// The display that the scene is made for.
#[allow(dead_code, reason = "the panel's driver knows its own size")]
pub(crate) const SIZE: Size = Size::new(128, 64);

/// Draws the scene.
///
/// # Errors
///
/// Whatever the display cannot do.
pub(crate) fn draw<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    draw_rays(display)?;
    draw_dividers(display)?;
    draw_gears(display)?;
    draw_stars(display)?;
    draw_dial(display)
}

/// A fan of triangles around a point beyond the bottom right corner. They share their edges: there is neither a gap
/// nor a double pixel between two of them.
fn draw_rays<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    let sun = Vertex::from_bits(131 * 256 + 77, 67 * 256 + 180);
    for ray in 0..16 {
        let [left, right] = [ray, ray + 1].map(|side| polar(sun, 43 * 256, 270 + side * 90 / 16));
        let grey = if ray % 2 == 0 { 4 } else { 7 };
        Triangle::new(sun, left, right).filled(Gray4::new(grey)).draw(display)?;
    }
    Ok(())
}

fn draw_dividers<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    // From pixel to pixel, both included.
    Line::new(Point::new(65, 0), Point::new(65, 63)).filled(Gray4::new(3)).draw(display)?;
    Line::new(Point::new(127, 38), Point::new(65, 38)).filled(Gray4::new(3)).draw(display)
}

const BIG_GEAR_CENTRE: Vertex = Vertex::from_bits(84 * 256 + 140, 18 * 256 + 180);
const BIG_GEAR_TEETH: [Vertex; 40] = gear(BIG_GEAR_CENTRE, 17 * 256, 13 * 256 + 128, 2);
const BIG_GEAR_HOLE: [Vertex; 20] = circle(BIG_GEAR_CENTRE, 7 * 256);

/// Even-odd: a contour inside another one is a hole, whichever way round it goes.
const BIG_GEAR: Polygon<'static> =
    Polygon::with_contours(&[&BIG_GEAR_TEETH, &BIG_GEAR_HOLE]).fill_rule(FillRule::EvenOdd);

const SMALL_GEAR_CENTRE: Vertex = Vertex::from_bits(113 * 256 + 26, 10 * 256 + 60);
const SMALL_GEAR_TEETH: [Vertex; 32] = gear(SMALL_GEAR_CENTRE, 13 * 256 + 128, 10 * 256, 13);
const SMALL_GEAR_HOLE: [Vertex; 20] = reversed(circle(SMALL_GEAR_CENTRE, 5 * 256));

/// Non-zero: a hole goes round the other way.
const SMALL_GEAR: Polygon<'static> = Polygon::with_contours(&[&SMALL_GEAR_TEETH, &SMALL_GEAR_HOLE]);

fn draw_gears<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    let small = SMALL_GEAR.with_capacity::<{ SMALL_GEAR.active_edges() }>().expect("the capacity is what it needs");
    small.filled(Gray4::new(8)).draw(display)?;
    let big = BIG_GEAR.with_capacity::<{ BIG_GEAR.active_edges() }>().expect("the capacity is what it needs");
    big.filled(Gray4::new(12)).draw(display)?;
    Circle::from_bits(BIG_GEAR_CENTRE, 3 * 256 + 100).filled(Gray4::new(6)).draw(display)
}

const HOLLOW_STAR_OUTLINE: [Vertex; 5] = star(Vertex::from_bits(78 * 256 + 30, 52 * 256 + 128), 12 * 256 + 200);

/// The pentagon in the middle is inside twice: even-odd leaves it out.
const HOLLOW_STAR: Polygon<'static> = Polygon::new(&HOLLOW_STAR_OUTLINE).fill_rule(FillRule::EvenOdd);

const SOLID_STAR_OUTLINE: [Vertex; 5] = star(Vertex::from_bits(101 * 256 + 200, 49 * 256 + 70), 9 * 256 + 128);

/// Non-zero fills it all.
const SOLID_STAR: Polygon<'static> = Polygon::new(&SOLID_STAR_OUTLINE);

/// Stars drawn without lifting the pen, with one scratch that is large enough for either.
fn draw_stars<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    let mut scratch = Scratch::<{ edges_for(&[HOLLOW_STAR, SOLID_STAR]) }>::new();
    for (star, grey) in [(HOLLOW_STAR, 11), (SOLID_STAR, 15)] {
        let star = star.within(&mut scratch).expect("the scratch is what the larger one needs");
        star.filled(Gray4::new(grey)).draw(display)?;
    }
    Ok(())
}

const DIAL_CENTRE: Vertex = Vertex::from_bits(32 * 256, 34 * 256 + 128);

/// The scale goes from south-west by north to south-east.
const SCALE_START: i32 = 225;
const SCALE_TICKS: i32 = 18;
const DEGREES_A_TICK: i32 = 15;

const WARNING_OUTLINE: [Vertex; 10] = warning_sector();
const WARNING: Polygon<'static> = Polygon::new(&WARNING_OUTLINE);

fn draw_dial<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), D::Error> {
    // Larger than the display is high: its lowest rows are cut off.
    Circle::from_bits(DIAL_CENTRE, 30 * 256 + 128).filled(Gray4::new(6)).draw(display)?;
    Circle::from_bits(DIAL_CENTRE, 28 * 256 + 128).filled(Gray4::new(1)).draw(display)?;

    let warning = WARNING.with_capacity::<{ WARNING.active_edges() }>().expect("the capacity is what it needs");
    warning.filled(Gray4::new(5)).draw(display)?;

    for tick in 0..=SCALE_TICKS {
        let (length, grey) = if tick % 3 == 0 { (6 * 256, 14) } else { (2 * 256, 9) };
        let [outer, inner] =
            [27 * 256, 27 * 256 - length].map(|radius| polar(DIAL_CENTRE, radius, SCALE_START + tick * DEGREES_A_TICK));
        Line::new(outer, inner).filled(Gray4::new(grey)).draw(display)?;
    }

    const NEEDLE: i32 = 37;
    Triangle::new(
        polar(DIAL_CENTRE, 24 * 256, NEEDLE),
        polar(DIAL_CENTRE, 7 * 256, NEEDLE + 155),
        polar(DIAL_CENTRE, 7 * 256, NEEDLE + 205),
    )
    .filled(Gray4::new(15))
    .draw(display)?;
    Circle::from_bits(DIAL_CENTRE, 4 * 256 + 64).filled(Gray4::new(10)).draw(display)?;
    Circle::from_bits(DIAL_CENTRE, 256 + 128).filled(Gray4::new(0)).draw(display)
}

// --- Outlines, made at compile time -----------------------------------------------------------------------------------

/// The last 60 degrees of the scale, as a band.
const fn warning_sector() -> [Vertex; 10] {
    let mut outline = [DIAL_CENTRE; 10];
    let mut i = 0;
    while i < 5 {
        let angle = SCALE_START + SCALE_TICKS * DEGREES_A_TICK - 15 * i as i32;
        outline[i] = polar(DIAL_CENTRE, 27 * 256, angle);
        outline[9 - i] = polar(DIAL_CENTRE, 22 * 256, angle);
        i += 1;
    }
    outline
}

/// A gear wheel with a tooth for every four vertices, turned by some degrees.
const fn gear<const N: usize>(centre: Vertex, tip: i32, root: i32, turn: i32) -> [Vertex; N] {
    let mut outline = [centre; N];
    let mut i = 0;
    while i < N {
        let radius = if i % 4 < 2 { tip } else { root };
        // A tooth is narrower at its tip.
        let lean = [3, -3, 0, 0][i % 4];
        outline[i] = polar(centre, radius, turn + lean + (i * 360 / N) as i32);
        i += 1;
    }
    outline
}

const fn star(centre: Vertex, radius: i32) -> [Vertex; 5] {
    let mut outline = [centre; 5];
    let mut i = 0;
    while i < 5 {
        outline[i] = polar(centre, radius, 144 * i as i32);
        i += 1;
    }
    outline
}

const fn circle<const N: usize>(centre: Vertex, radius: i32) -> [Vertex; N] {
    let mut outline = [centre; N];
    let mut i = 0;
    while i < N {
        outline[i] = polar(centre, radius, (i * 360 / N) as i32);
        i += 1;
    }
    outline
}

const fn reversed<const N: usize>(mut outline: [Vertex; N]) -> [Vertex; N] {
    let mut i = 0;
    while i < N / 2 {
        outline.swap(i, N - 1 - i);
        i += 1;
    }
    outline
}

/// The point at this distance from the centre, in 1/256 pixel, and at this angle: degrees from north, clockwise.
const fn polar(centre: Vertex, radius: i32, degrees: i32) -> Vertex {
    Vertex::from_bits(
        centre.x.to_bits() + ((radius * sin_q14(degrees)) >> 14),
        centre.y.to_bits() - ((radius * sin_q14(degrees + 90)) >> 14),
    )
}

/// 2^14 sin, by the formula of Bhaskara I: 4 a (180 - a) / (40500 - a (180 - a)) is off by less than 0.0017, that is
/// by a twentieth of a pixel on the dial's rim. Integers only, so that board, host and compiler agree on each vertex.
const fn sin_q14(degrees: i32) -> i32 {
    let angle = degrees.rem_euclid(180);
    let parabola = angle * (180 - angle);
    let sine = (parabola << 16) / (40500 - parabola);
    if degrees.rem_euclid(360) < 180 { sine } else { -sine }
}
