//! What the plug-in once got wrong, with the right values.

use std::f64::consts::PI;

use embedded_graphics::{
    geometry::Angle,
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Gray8},
    prelude::*,
    primitives::{
        Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector, StrokeAlignment, StyledDrawable,
        Triangle,
    },
};
use spanfill::{Over, eg::Style};

fn blended(style: Style<Gray8>) -> Style<Gray8, spanfill::eg::Blended<Over<Gray8>>> {
    style.antialiased(Over(Gray8::BLACK))
}

fn filled() -> Style<Gray8, spanfill::eg::Blended<Over<Gray8>>> {
    blended(Style::with_fill(Gray8::WHITE))
}

fn stroked(width: u32) -> Style<Gray8, spanfill::eg::Blended<Over<Gray8>>> {
    blended(Style::with_stroke(Gray8::WHITE, width))
}

/// What is drawn of 64 x 64 pixels, white on black: coverage.
fn coverage<P>(primitive: &P, style: &Style<Gray8, spanfill::eg::Blended<Over<Gray8>>>) -> Vec<u8>
where
    P: StyledDrawable<Style<Gray8, spanfill::eg::Blended<Over<Gray8>>>, Color = Gray8, Output = ()>,
{
    let mut display = MockDisplay::new();
    let Ok(()) = primitive.draw_styled(style, &mut display);
    let pixels = display.bounding_box().points();
    pixels.map(|point| display.get_pixel(point).map_or(0, |colour| colour.luma())).collect()
}

fn at(coverage: &[u8], x: usize, y: usize) -> u8 {
    coverage[64 * y + x]
}

fn area(coverage: &[u8]) -> f64 {
    coverage.iter().map(|&coverage| f64::from(coverage)).sum::<f64>() / 255.0
}

#[test]
fn blended_sectors_are_as_large_as_their_angle_and_on_one_side_of_the_centre() {
    for degrees in [0.0, 0.5, 1.0, 3.0, 6.0_f32] {
        let sector = Sector::new(Point::new(1, 1), 61, Angle::from_degrees(200.0), Angle::from_degrees(degrees));
        let drawn = coverage(&sector, &filled());
        let exact = PI * 30.5 * 30.5 * f64::from(degrees) / 360.0;
        assert!((area(&drawn) - exact).abs() < 0.2, "{degrees}: {} not {exact}", area(&drawn));
        // 200 degrees point left and up from the centre at (31.5, 31.5).
        let beyond: u32 = (0..64)
            .flat_map(|y| (0..64).map(move |x| (x, y)))
            .filter(|&(x, y)| x > 32 || y > 32)
            .map(|(x, y)| u32::from(at(&drawn, x, y)))
            .sum();
        assert_eq!(beyond, 0, "{degrees}");
    }
}

#[test]
fn an_unblended_sector_of_no_angle_is_nothing() {
    let mut display = MockDisplay::new();
    let sector = Sector::new(Point::new(1, 1), 61, Angle::from_degrees(200.0), Angle::zero());
    sector.draw_styled(&Style::with_fill(BinaryColor::On), &mut display).unwrap();
    assert_eq!(display.affected_area().size, Size::zero());
}

#[test]
fn eight_blended_sectors_are_a_circle() {
    let mut sum = vec![0_u32; 64 * 64];
    for part in 0..8_u8 {
        let start = Angle::from_degrees(f32::from(part) * 45.0);
        let drawn = coverage(&Sector::new(Point::new(2, 2), 60, start, Angle::from_degrees(45.0)), &filled());
        sum.iter_mut().zip(drawn).for_each(|(sum, coverage)| *sum += u32::from(coverage));
    }
    // Rounded once each, and the rays go to 1/256 pixel: at most eight share a pixel, in the middle.
    assert!(sum.iter().all(|&sum| sum <= 260), "{:?}", sum.iter().max());
    let area = sum.iter().map(|&sum| f64::from(sum)).sum::<f64>() / 255.0;
    assert!((area - PI * 900.0).abs() < 2.0, "{area}");
}

#[test]
fn blended_lines_of_even_width_lie_evenly_about_their_middle_both_ways() {
    let ends = [Point::new(10, 20), Point::new(40, 20)];
    for (start, end) in [(ends[0], ends[1]), (ends[1], ends[0])] {
        let drawn = coverage(&Line::new(start, end), &stroked(4));
        let column: Vec<u8> = (17..24).map(|y| at(&drawn, 25, y)).collect();
        assert_eq!(column, [0, 128, 255, 255, 255, 128, 0], "{start:?}");
    }
    for width in [2, 3, 4, 6] {
        let (a, b) = (Point::new(8, 9), Point::new(51, 40));
        let there = coverage(&Line::new(a, b), &stroked(width));
        let back = coverage(&Line::new(b, a), &stroked(width));
        let worst = there.iter().zip(&back).map(|(a, b)| a.abs_diff(*b)).max();
        // Corners are rounded to 1/256 pixel, and may be on a tie.
        assert!(worst <= Some(1), "{width}: {worst:?}");
        // The same turned by half a turn about the middle of the line, which is that of a pixel's corner in x.
        let turned = (0..64 * 64).map(|index| (index % 64, index / 64)).filter(|&(x, y)| x < 60 && y < 50);
        let worst = turned.map(|(x, y)| at(&there, x, y).abs_diff(at(&there, 59 - x, 49 - y))).max();
        assert!(worst <= Some(1), "{width}: {worst:?}");
    }
}

#[test]
fn a_blended_polyline_there_and_back_is_as_the_line() {
    for width in [1, 3] {
        let (a, b) = (Point::new(4, 7), Point::new(47, 31));
        let line = coverage(&Line::new(a, b), &stroked(width));
        let drawn = coverage(&Polyline::new(&[a, b, a]), &stroked(width));
        // But at the turn, where the line's end is half a pixel further.
        let worst = (0..64 * 64)
            .map(|index| (index % 64, index / 64))
            .filter(|&(x, _)| (6..44).contains(&x))
            .map(|(x, y)| at(&line, x, y).abs_diff(at(&drawn, x, y)))
            .max();
        assert!(worst <= Some(1), "{width}: {worst:?}");
    }
}

#[test]
fn what_overlaps_in_a_blended_polyline_is_covered_once() {
    // A corner of 45 degrees: its area by hand, of the union.
    let points = [Point::new(10, 10), Point::new(40, 10), Point::new(10, 40)];
    let drawn = coverage(&Polyline::new(&points), &stroked(8));
    let inside = at(&drawn, 34, 13);
    assert_eq!(inside, 255);
    for y in 0..64 {
        for x in 0..64 {
            // Above the first segment and left of both ends there is nothing.
            if y < 6 || x < 6 {
                assert_eq!(at(&drawn, x, y), 0, "{x} {y}");
            }
        }
    }
    // The edge of the second segment inside the first one: no line of full coverage through half covered pixels.
    let row: Vec<u8> = (12..30).map(|x| at(&drawn, x, 14)).collect();
    assert_eq!(row, [128; 18], "the lower edge of the first segment, at y 14.5");
}

#[test]
fn blended_triangles_have_strokes_evenly_about_their_sides() {
    let triangle = Triangle::new(Point::new(10, 10), Point::new(50, 10), Point::new(10, 50));
    let drawn = coverage(&triangle, &stroked(4));
    let column: Vec<u8> = (7..14).map(|y| at(&drawn, 25, y)).collect();
    // The inner half is what the inner triangle leaves, and both are rounded.
    assert!([127, 128].contains(&column[5]), "{column:?}");
    assert_eq!(column[..5], [0, 128, 255, 255, 255]);
    assert_eq!(column[6], 0);
}

/// Counts what a display behind a bus would need an address window for.
struct Windows {
    size: Size,
    windows: usize,
    largest: u32,
    pixels: Vec<Gray8>,
}

impl OriginDimensions for Windows {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Windows {
    type Color = Gray8;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, colour) in pixels {
            self.windows += 1;
            self.pixels[(y * self.size.width.cast_signed() + x) as usize] = colour;
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Gray8>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Self::Error> {
        let before = self.windows;
        self.draw_iter(area.points().zip(colours).map(|(point, colour)| Pixel(point, colour)))?;
        self.windows = before + 1;
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Gray8) -> Result<(), Self::Error> {
        self.largest = self.largest.max(area.size.width * area.size.height);
        self.fill_contiguous(area, core::iter::repeat(colour))
    }
}

fn windows_for<S>(button: &RoundedRectangle, style: &S) -> Windows
where
    RoundedRectangle: StyledDrawable<S, Color = Gray8, Output = ()>,
{
    let size = Size::new(224, 52);
    let pixels = vec![Gray8::BLACK; 224 * 52];
    let mut target = Windows { size, windows: 0, largest: 0, pixels };
    let Ok(()) = button.draw_styled(style, &mut target);
    target
}

#[test]
fn the_inside_of_a_rounded_button_is_one_fill() {
    let button = Rectangle::new(Point::new(2, 2), Size::new(220, 48));
    for radius in [3, 8, 16] {
        let button = RoundedRectangle::with_equal_corners(button, Size::new_equal(radius));
        for (fill, stroke) in [(true, 2), (true, 0), (false, 3)] {
            let mut style = Style::with_stroke(Gray8::WHITE, stroke);
            let mut builder = PrimitiveStyleBuilder::new().stroke_color(Gray8::WHITE).stroke_width(stroke);
            if fill {
                style.fill_color = Some(Gray8::new(100));
                builder = builder.fill_color(Gray8::new(100));
            }
            if stroke == 0 {
                style.stroke_color = None;
            }
            let blended = windows_for(&button, &blended(style));
            let theirs = windows_for(&button, &builder.build());
            // Each of the four corners has at most six runs a row: partial, stroke, partial, fill.
            let rows = usize::try_from(radius + stroke).unwrap();
            assert!(blended.windows <= 7 + 4 * 6 * rows, "{radius} {stroke}: {} windows", blended.windows);
            if fill {
                assert!(
                    blended.largest > 200 * (44 - 2 * radius),
                    "{radius} {stroke}: the largest has {}",
                    blended.largest
                );
            }
            // Where no pixel is covered in part, the same; nowhere is anything left out.
            let differing = blended.pixels.iter().zip(&theirs.pixels).filter(|(a, b)| a != b).count();
            assert!(differing <= 4 * 4 * rows, "{radius} {stroke}: {differing} differ");
            let unblended = windows_for(&button, &style);
            assert!(unblended.windows <= theirs.windows, "{} and {}", unblended.windows, theirs.windows);
            println!(
                "{radius} {stroke}: {} blended, {} unblended, {} theirs",
                blended.windows, unblended.windows, theirs.windows
            );
        }
    }
}

/// The pen is a square, as it is at width 1, and as a line's ends are.
#[test]
fn a_point_repeated_is_as_wide_as_it_is_high() {
    let point = Point::new(20, 30);
    for width in 1..=8 {
        let (before, after) = (width / 2, width - width / 2);
        let square = (20 - before..20 + after, 30 - before..30 + after);
        let inside = |x: i32, y: i32| square.0.contains(&x) && square.1.contains(&y);
        let style = Style::with_stroke(BinaryColor::On, width.cast_unsigned());
        for points in [&[point; 2][..], &[point; 5]] {
            let mut display = MockDisplay::new();
            display.set_allow_overdraw(true);
            Polyline::new(points).draw_styled(&style, &mut display).unwrap();
            for Point { x, y } in display.bounding_box().points() {
                let is_on = display.get_pixel(Point::new(x, y)) == Some(BinaryColor::On);
                assert_eq!(is_on, inside(x, y), "{width}: ({x}, {y})");
            }
            // Blended, in the middle of the pixel, whatever the width.
            let drawn = coverage(&Polyline::new(points), &stroked(width.cast_unsigned()));
            let part = |at: usize, middle: f64| {
                let half = f64::from(width) / 2.0;
                let (low, high) = (middle - half, middle + half);
                ((at as f64 + 1.0).min(high) - (at as f64).max(low)).max(0.0)
            };
            assert!(drawn == coverage(&Line::new(point, point), &stroked(width.cast_unsigned())), "{width}");
            for (index, &found) in drawn.iter().enumerate() {
                let exact = 255.0 * part(index % 64, 20.5) * part(index / 64, 30.5);
                assert!((f64::from(found) - exact).abs() <= 0.6, "{width}: {found} not {exact} at {index}");
            }
        }
    }
}

/// A quarter of a circle has its sides between pixels, and so has a stroke of an even width.
#[test]
fn blended_sectors_have_their_strokes_about_their_sides() {
    let quarter = Sector::new(Point::new(1, 1), 60, Angle::zero(), Angle::from_degrees(90.0));
    // Across each ray, far from both of its ends.
    for (width, alignment, above, below) in [
        (4, StrokeAlignment::Center, 2, 2),
        (2, StrokeAlignment::Center, 1, 1),
        (3, StrokeAlignment::Inside, 0, 3),
        (3, StrokeAlignment::Outside, 3, 0),
    ] {
        let mut style = Style::with_stroke(Gray8::WHITE, width);
        style.stroke_alignment = alignment;
        let drawn = coverage(&quarter, &blended(style));
        // The centre is at the corner of four pixels, (31, 31).
        let expected = |at: i32| if (31 - above..31 + below).contains(&at) { 255 } else { 0 };
        for across in 22..40_i32 {
            let index = usize::try_from(across).unwrap();
            assert_eq!(at(&drawn, 46, index), expected(across), "{width} {alignment:?}: row {across}");
            assert_eq!(at(&drawn, index, 46), expected(across), "{width} {alignment:?}: column {across}");
        }
    }
}
