//! Colours that vary are the same bits in every clip, band and tile: packed and exact Gouraud colours, gradients, rounded
//! and dithered, on targets that are sent pixels and on those that have rows.

mod memory;
mod oracle;

use embedded_graphics::{
    image::GetPixel as _,
    pixelcolor::{Bgr555, Bgr565, Gray4, Rgb555, Rgb565},
    prelude::*,
    primitives::Rectangle,
};
use memory::Memory;
use oracle::{Rng, cases, for_each_case, random};
use spanfill::{
    ConicalGradient, Gouraud, InPlace, LinearGradient, Paint, Painting as _, PixelRect, PixelRows, RadialGradient,
    Spread, Stop, Stops, Triangle, Vertex,
};

/// Cuts a range in pieces: now and then in the very first or last pixel.
fn cuts(rng: &mut Rng, start: i32, length: u32) -> Vec<(i32, u32)> {
    let mut at: Vec<_> = (0..rng.int(0..=4)).map(|_| rng.int(1..=i64::from(length.max(2)) - 1) as u32).collect();
    at.extend([0, length]);
    at.sort_unstable();
    at.dedup();
    at.windows(2).map(|two| (start + two[0] as i32, two[1] - two[0])).collect()
}

/// A way to draw.
type Draw<'d, C> = &'d dyn Fn(&mut Memory<C>);

/// Draws on the whole of an area and on its parts: bands, tiles, and a window in its middle.
fn check<C: PixelColor>(rng: &mut Rng, area: Rectangle, background: C, draws: &[Draw<'_, C>]) -> Result<(), String> {
    let [mut whole, mut parts] = [(); 2].map(|()| Memory::new(area, |_| background));
    let Some(draw) = draws.first() else { return Ok(()) };
    draw(&mut whole);
    for (which, draw) in draws.iter().enumerate() {
        for tiled in [false, true] {
            let Rectangle { top_left, size } = area;
            for (y, height) in cuts(rng, top_left.y, size.height) {
                let columns = if tiled { cuts(rng, top_left.x, size.width) } else { vec![(top_left.x, size.width)] };
                for (x, width) in columns {
                    let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
                    let mut part = Memory::new(area, |_| background);
                    draw(&mut part);
                    for row in area.rows() {
                        let start = Point::new(x, row);
                        let pixels = part.row_from(start).expect("inside");
                        parts.row_from(start).expect("inside")[..width as usize].copy_from_slice(pixels);
                    }
                }
            }
            if whole != parts {
                let first = area.points().find(|point| whole.pixel(*point) != parts.pixel(*point));
                return Err(format!("way {which}, tiled {tiled}: {first:?} of {area:?}"));
            }
        }
    }
    Ok(())
}

/// A triangle and a window onto it: of any kind, or one that is wider than the 256 columns of a packed word.
fn some_triangle(rng: &mut Rng) -> (Triangle, Rectangle) {
    if rng.one_in(2) {
        let (triangle, PixelRect { rows, columns }) = random::triangle(rng);
        let side = |range: &std::ops::Range<i32>| range.len().clamp(1, 400) as u32;
        let size = Size::new(side(&columns), side(&rows));
        return (triangle, Rectangle::new(Point::new(columns.start, rows.start), size));
    }
    let left = rng.pick(&[-4, 250, -300, 8_388_000]);
    let mut vertex = || {
        Vertex::from_bits(
            (left + rng.int(-20..=700)).saturating_mul(256).clamp(i32::MIN.into(), i32::MAX.into()) as i32,
            rng.int(-999..=24 * 256) as i32,
        )
    };
    let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
    (triangle, Rectangle::new(Point::new(left as i32, -2), Size::new(560, 20)))
}

#[test]
fn gouraud_colours_are_the_same_in_every_clip() {
    for_each_case(0x7A21, cases(1_500), |rng| {
        let (triangle, area) = some_triangle(rng);
        let red = [(); 3].map(|()| rng.int(0..=31) as u8);
        let green = [(); 3].map(|()| rng.int(0..=63) as u8);
        let all = [0, 1, 2].map(|vertex| Rgb565::new(red[vertex], green[vertex], red[2 - vertex] / 2));
        macro_rules! packed {
            ($($colour:ident)+) => {
                $({
                    let gouraud = Gouraud::packed(triangle, all.map($colour::from));
                    check(rng, area, $colour::BLACK, &[
                        &|target| { let Ok(()) = gouraud.draw(target); },
                        &|target| { let Ok(()) = gouraud.draw_on(target); },
                    ])
                    .map_err(|error| format!("{error}, {gouraud:?}"))?;
                })+
            };
        }
        packed!(Rgb565 Bgr565 Rgb555 Bgr555);
        let gouraud = Gouraud::new(triangle, all);
        let painted = triangle.painted(gouraud.paint());
        let blended = painted.antialiased(InPlace);
        check(
            rng,
            area,
            Rgb565::BLACK,
            &[
                &|target| {
                    let Ok(()) = gouraud.draw(target);
                },
                &|target| {
                    let Ok(()) = gouraud.draw_on(target);
                },
                &|target| {
                    let Ok(()) = painted.draw(target);
                },
                &|target| painted.draw_on(target),
            ],
        )
        .and_then(|()| {
            check(
                rng,
                area,
                Rgb565::BLACK,
                &[&|target| {
                    let Ok(()) = blended.draw_on(target);
                }],
            )
        })
        .map_err(|error| format!("{error}, {gouraud:?}"))?;
        Ok(1)
    });
}

fn check_paint(rng: &mut Rng, triangle: Triangle, area: Rectangle, paint: impl Paint<Gray4>) -> Result<(), String> {
    let painted = triangle.painted(&paint);
    let blended = triangle.painted(&paint).antialiased(InPlace);
    check(
        rng,
        area,
        Gray4::BLACK,
        &[
            &|target| {
                let Ok(()) = painted.draw(target);
            },
            &|target| painted.draw_on(target),
        ],
    )?;
    check(
        rng,
        area,
        Gray4::BLACK,
        &[&|target| {
            let Ok(()) = blended.draw_on(target);
        }],
    )
}

/// Also gradients so steep that a step that is off by the least there is would be seen.
#[test]
fn gradients_are_the_same_in_every_clip() {
    for_each_case(0x7A22, cases(1_500), |rng| {
        let (triangle, area) = some_triangle(rng);
        let stops = [0, 1, 2, 3].map(|index| Stop::new(index << 14, Gray4::new(rng.int(0..=15) as u8)));
        let spread = rng.pick(&[Spread::Pad, Spread::Repeat, Spread::Reflect]);
        let stops = Stops::new(&stops, spread).expect("sorted");
        let stops = if rng.one_in(2) { stops.dithered() } else { stops };
        let middle = area.center();
        let mut point = || {
            let bits = rng.int(1..=20);
            Vertex::from_bits(
                middle.x.saturating_mul(256).saturating_add(rng.magnitude(bits) as i32),
                middle.y.saturating_mul(256).saturating_add(rng.magnitude(bits) as i32),
            )
        };
        let (start, end, other, focus) = (point(), point(), point(), point());
        let radius = start.x.saturating_sub(end.x).saturating_abs();
        let case = format!("{triangle:?} {start:?} {end:?} {other:?} {focus:?} {stops:?}");
        let ellipse = RadialGradient::elliptical(start, [end, other], stops);
        check_paint(rng, triangle, area, LinearGradient::new(start, end, stops))
            .and_then(|()| check_paint(rng, triangle, area, RadialGradient::new(start, radius, stops)))
            .and_then(|()| check_paint(rng, triangle, area, ellipse))
            .and_then(|()| check_paint(rng, triangle, area, ellipse.with_focus(focus, 9000)))
            .and_then(|()| check_paint(rng, triangle, area, ConicalGradient::new(start, 777, stops)))
            .map_err(|error| format!("{error}: {case}"))?;
        Ok(1)
    });
}
