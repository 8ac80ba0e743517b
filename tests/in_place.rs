//! Blending in a target's memory, eight pixels at a time: the pixels are those that are mixed one by one.

mod memory;

use embedded_graphics::{
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888, raw::RawData,
    },
    prelude::*,
    primitives::Rectangle,
};
use memory::Memory;
use spanfill::{
    Blend, Circle, Cover, FillRule, InPlace, Line, Linear, Mix, Polygon, ReadBack, Triangle, Vertex, prelude::*,
};

/// Colours that differ in all their bits.
fn raw(number: u32) -> u32 {
    number.wrapping_mul(0x9E37_79B9).rotate_left(13) ^ number
}

/// Every alpha in every lane, over many backdrops.
#[test]
fn eight_colours_are_mixed_as_each_by_itself() {
    macro_rules! check {
        ($($colour:ident)+) => {
            $({
                let colour = |number: u32| $colour::from(<$colour as PixelColor>::Raw::from_u32(raw(number)));
                for (top, bottom) in (0..40).flat_map(|top| (0..40).map(move |bottom| (top, 1000 + 8 * bottom))) {
                    let top = colour(top);
                    let backdrops: [$colour; 8] = std::array::from_fn(|lane| colour(bottom + lane as u32));
                    for alpha in 0..=255_u8 {
                        let alphas: [u8; 8] = std::array::from_fn(|lane| alpha.wrapping_add(37 * (lane % 5) as u8));
                        let mut mixed = backdrops;
                        top.over_eight(&mut mixed, &alphas);
                        let expected: [$colour; 8] =
                            std::array::from_fn(|lane| top.over(backdrops[lane], alphas[lane]));
                        assert_eq!(mixed, expected, "{top:?} over {backdrops:?} by {alphas:?}");
                    }
                }
            })+
        };
    }
    check!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888 Gray2 Gray4 Gray8 BinaryColor);
}

fn check_alike(shape: &(impl Cover + Clone), area: Rectangle, opacity: u8) -> bool {
    let before = Memory::new(area, |index| Rgb565::from(<Rgb565 as PixelColor>::Raw::from_u32(raw(index))));
    macro_rules! drawn {
        ($blend:expr) => {{
            let mut memory = before.clone();
            let drawn = shape.clone().antialiased(Rgb565::new(29, 11, 3), $blend).opacity(opacity);
            let Ok(()) = drawn.draw_on(&mut memory);
            memory
        }};
    }
    let in_place = drawn!(InPlace);
    assert!(in_place == drawn!(ReadBack), "{area:?}, opacity {opacity}: {:?}", shape.touched());
    let in_light = drawn!(Linear(InPlace));
    assert!(in_light == drawn!(Linear(ReadBack)), "in light: {area:?}, opacity {opacity}: {:?}", shape.touched());
    in_place != before
}

/// Where a clip cuts a shape, where fewer than eight pixels are left of a row, and where the target is that narrow itself.
#[test]
fn a_shape_in_memory_is_the_one_that_is_read_back() {
    let mut seen = 0;
    for width in [1, 2, 3, 5, 7, 8, 9, 12, 16, 17, 31, 64] {
        for (left, top) in [(0, 0), (-3, 5), (40, -20)] {
            let area = Rectangle::new(Point::new(left, top), Size::new(width, 24));
            for step in 0..60 {
                let at = |x: i32, y: i32| Vertex::from_bits((left * 256) + x, (top * 256) + y);
                let far = 97 * step;
                let triangle = Triangle::new(at(far - 900, -300), at(2 * far, 2000 + far), at(300, 7000 - far));
                let thin = Triangle::new(at(far, 10), at(far + 300, 5900), at(far + 500, 5000));
                let circle = Circle::new(at(far, 3000), spanfill::I24F8::from_bits(100 + 43 * step));
                let line = Line::new(at(far - 500, 100), at(4000 - far, 6000));
                let outline = [at(far, 0), at(900, 5000), at(9000, 300 + far), at(-far, 2000), at(3000, 6100 - far)];
                for opacity in [255, 128, 3] {
                    for rule in [FillRule::NonZero, FillRule::EvenOdd] {
                        let star = Polygon::new(&outline).fill_rule(rule).coverage_with::<8>();
                        seen += usize::from(check_alike(&star.expect("it has five edges"), area, opacity));
                    }
                    seen += usize::from(check_alike(&triangle, area, opacity));
                    seen += usize::from(check_alike(&thin, area, opacity));
                    seen += usize::from(check_alike(&circle, area, opacity));
                    seen += usize::from(check_alike(&line, area, opacity));
                }
            }
        }
    }
    assert!(seen > 10_000, "only {seen} shapes were seen");
}

/// Positions are rounded, of thin lines as far as 2^-16 pixel, and an edge on the right border counts to the column after it:
/// nothing of that may get lost.
#[test]
fn edges_on_the_borders_are_not_lost() {
    const WIDTH: i32 = 12;
    let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 40));
    for (top, height) in (0..64).flat_map(|top| (1..40).map(move |rows| (4 * top, 255 * rows))) {
        for (from, to) in [(0, 0), (0, 1), (1, 0), (2, 0), (0, 5), (40, 0), (0, 300)] {
            for mirror in [false, true] {
                let at = |x: i32, y: i32| Vertex::from_bits(if mirror { 256 * WIDTH - x } else { x }, y);
                let line = Line::new(at(128 + from, 128 + top), at(128 + to, 128 + top + height));
                assert!(check_alike(&line, area, 255));
                let vertices = [at(from, top), at(to, top + height), at(2000, top + height)];
                assert!(check_alike(&Triangle::from_vertices(vertices), area, 255));
            }
        }
    }
}

/// Runs and spans that leave the row are cut, as everywhere.
#[test]
fn what_leaves_the_row_is_cut() {
    let area = Rectangle::new(Point::new(2, 3), Size::new(6, 2));
    let black = Memory::new(area, |_| Gray8::BLACK);
    let mut memory = black.clone();
    let draw = |memory: &mut Memory<Gray8>, x: i32, y: i32| {
        let Ok(()) = InPlace.run(memory, Point::new(x, y), Gray8::WHITE, &[9; 20]);
        let Ok(()) = InPlace.fill(memory, Point::new(x, y), 100, Gray8::WHITE);
    };
    for (x, y) in [(1, 3), (8, 3), (2, 2), (2, 5), (i32::MIN, 3), (i32::MAX, 4)] {
        draw(&mut memory, x, y);
        assert_eq!(memory, black, "({x}, {y}) is outside");
    }
    draw(&mut memory, 5, 4);
    let white = memory.pixels.iter().filter(|pixel| **pixel == Gray8::WHITE).count();
    assert_eq!(white, 3);
}
