//! What a `DrawTarget` sees: rectangles of one colour within its bounding box, each pixel once, nothing pixel by pixel;
//! its error is passed on and ends the drawing.

mod oracle;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    mock_display::MockDisplay,
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    },
    prelude::{DrawTargetExt, Drawable as _, RgbColor},
    primitives::Rectangle,
};
use oracle::{Belongs, Grid, Outline, Rng, cases, check_same, for_each_case, random, rect};
use spanfill::{Circle, Fill, FillRule, Line, PixelRect, Polygon, Shape, Triangle, Vertex};

/// A target that takes rectangles only, only within its bounding box, each pixel once; it can be told to fail.
struct Strict {
    bounds: Rectangle,
    pixels: Grid,
    calls: usize,
    fails_at: usize,
}

/// Tells one failure from another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Failure(usize);

impl Strict {
    fn new(window: &PixelRect) -> Self {
        Self {
            bounds: Rectangle::from(window.clone()),
            pixels: Grid::new(window.clone()),
            calls: 0,
            fails_at: usize::MAX,
        }
    }
}

impl Dimensions for Strict {
    fn bounding_box(&self) -> Rectangle {
        self.bounds
    }
}

impl DrawTarget for Strict {
    type Color = Rgb565;
    type Error = Failure;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _pixels: I) -> Result<(), Failure> {
        panic!("a solid shape was drawn pixel by pixel");
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        _area: &Rectangle,
        _colors: I,
    ) -> Result<(), Failure> {
        panic!("a solid shape was drawn as an image");
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Failure> {
        assert_eq!(color, Rgb565::RED);
        assert!(!area.is_zero_sized(), "{area:?} is empty");
        if self.calls == self.fails_at {
            return Err(Failure(self.calls));
        }
        self.calls += 1;
        // `add` panics outside the bounding box.
        let PixelRect { rows, columns } = PixelRect::from(*area);
        for row in rows {
            self.pixels.add(row, &columns);
        }
        Ok(())
    }
}

/// Draws on a window as a display, and holds the display against the rule.
fn check_drawn<S: Shape + Belongs + Clone>(shape: &S, window: &PixelRect) -> u64 {
    let expected = Grid::of_rule(shape, window);
    let mut target = Strict::new(window);
    shape.clone().filled(Rgb565::RED).draw(&mut target).unwrap();
    check_same(&target.pixels, &expected, || shape.code());
    // The same again on a display that fails after some of the rectangles.
    for fails_at in [0, target.calls / 2, target.calls.saturating_sub(1)] {
        if fails_at < target.calls {
            let mut failing = Strict { fails_at, ..Strict::new(window) };
            assert_eq!(shape.clone().filled(Rgb565::RED).draw(&mut failing), Err(Failure(fails_at)));
            assert_eq!(failing.calls, fails_at, "drawn on after the error: {}", shape.code());
        }
    }
    // What is drawn lies in what the drawable says of itself.
    let bounds = PixelRect::from(shape.clone().filled(Rgb565::RED).bounding_box());
    for row in window.rows.clone() {
        for column in window.columns.clone() {
            let inside = bounds.rows.contains(&row) && bounds.columns.contains(&column);
            assert!(
                expected.count(column, row) == 0 || inside,
                "({column}, {row}) outside {bounds:?}: {}",
                shape.code()
            );
        }
    }
    expected.is_mixed().into()
}

#[test]
fn displays_anywhere_get_what_the_rule_says() {
    let count = cases(50_000);
    let mixed = for_each_case(80, count, |rng| {
        let (triangle, window) = random::triangle(rng);
        let mut mixed = check_drawn(&triangle, &window);
        let (line, window) = random::line(rng);
        mixed += check_drawn(&line, &window);
        let (circle, window) = random::circle(rng);
        mixed += check_drawn(&circle, &window);
        let (outline, window) = random::outline(rng);
        mixed += check_drawn(&outline, &window);
        Ok(mixed)
    });
    assert!(mixed > 2 * count, "only {mixed} of {} displays showed an outline", 4 * count);
}

/// One of each shape, a few pixels large, around (8, 8).
fn shapes() -> (Triangle, Line, Circle, Outline) {
    let corners = [Point::new(2, 3), Point::new(13, 5), Point::new(6, 14)];
    (
        Triangle::new(corners[0], corners[1], corners[2]),
        Line::new(corners[0], corners[2]),
        Circle::new(Point::new(8, 8), 5.5),
        Outline::of(&corners.map(Vertex::from), FillRule::EvenOdd),
    )
}

#[test]
fn an_empty_display_gets_nothing() {
    let (triangle, line, circle, outline) = shapes();
    for window in [rect(8..8, 0..16), rect(0..16, 8..8), rect(8..8, 8..8)] {
        let mut target = Strict::new(&window);
        triangle.filled(Rgb565::RED).draw(&mut target).unwrap();
        line.filled(Rgb565::RED).draw(&mut target).unwrap();
        circle.filled(Rgb565::RED).draw(&mut target).unwrap();
        outline.clone().filled(Rgb565::RED).draw(&mut target).unwrap();
        assert_eq!(target.calls, 0);
    }
}

#[test]
fn a_shape_off_the_display_is_no_error_and_draws_nothing() {
    let (triangle, line, circle, outline) = shapes();
    for window in [rect(-40..0, 0..16), rect(0..16, 20..60), rect(i32::MAX - 9..i32::MAX, 0..16)] {
        let mut target = Strict { fails_at: 0, ..Strict::new(&window) };
        triangle.filled(Rgb565::RED).draw(&mut target).unwrap();
        line.filled(Rgb565::RED).draw(&mut target).unwrap();
        circle.filled(Rgb565::RED).draw(&mut target).unwrap();
        outline.clone().filled(Rgb565::RED).draw(&mut target).unwrap();
    }
}

#[test]
fn equal_rows_reach_the_display_as_one_rectangle() {
    let mut target = Strict::new(&rect(0..16, 0..16));
    let square = [Point::new(2, 3), Point::new(13, 3), Point::new(13, 14), Point::new(2, 14)].map(Vertex::from);
    Outline::of(&square, FillRule::NonZero).filled(Rgb565::RED).draw(&mut target).unwrap();
    assert_eq!((target.calls, target.pixels.covered()), (1, 121));

    // A vertical line is one rectangle, and so is a horizontal one.
    for end in [Point::new(3, 12), Point::new(12, 3)] {
        let mut target = Strict::new(&rect(0..16, 0..16));
        Line::new(Point::new(3, 3), end).filled(Rgb565::RED).draw(&mut target).unwrap();
        assert_eq!((target.calls, target.pixels.covered()), (1, 10));
    }
}

/// A target whose bounding box reaches to the ends of what a `Rectangle` can say.
struct Endless(Rectangle);

impl Dimensions for Endless {
    fn bounding_box(&self) -> Rectangle {
        self.0
    }
}

impl DrawTarget for Endless {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, _pixels: I) -> Result<(), Self::Error> {
        panic!("a solid shape was drawn pixel by pixel");
    }

    fn fill_solid(&mut self, area: &Rectangle, _color: BinaryColor) -> Result<(), Self::Error> {
        let bounds = Rectangle::new(Point::new(2, 3), Size::new(12, 12));
        assert_eq!(bounds.intersection(area), *area, "outside the shape");
        Ok(())
    }
}

#[test]
fn a_display_of_any_size_can_be_drawn_on() {
    let (triangle, line, circle, outline) = shapes();
    let all = Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(u32::MAX, u32::MAX));
    let right = Rectangle::new(Point::new(3, i32::MIN), Size::new(u32::MAX, u32::MAX));
    for bounds in [all, right, Rectangle::new(Point::zero(), Size::new(u32::MAX, u32::MAX))] {
        let mut target = Endless(bounds);
        let Ok(()) = triangle.filled(BinaryColor::On).draw(&mut target);
        let Ok(()) = line.filled(BinaryColor::On).draw(&mut target);
        let Ok(()) = circle.filled(BinaryColor::On).draw(&mut target);
        let Ok(()) = outline.clone().filled(BinaryColor::On).draw(&mut target);
    }
}

#[test]
fn bounding_boxes_of_shapes_at_the_ends_of_the_range_can_be_asked_for() {
    let (low, high) = (Vertex::from_bits(i32::MIN, i32::MIN), Vertex::from_bits(i32::MAX, i32::MAX));
    let across = Vertex::from_bits(i32::MAX, i32::MIN);
    let line = Line::new(low, high).filled(BinaryColor::On).bounding_box();
    let triangle = Triangle::new(low, high, across).filled(BinaryColor::On).bounding_box();
    let circle = Circle::from_bits(high, i32::MAX).filled(BinaryColor::On).bounding_box();
    for bounds in [line, triangle] {
        assert!(bounds.contains(Point::new(-(1 << 23), -(1 << 23))));
        assert!(bounds.contains(Point::new((1 << 23) - 1, (1 << 23) - 1)));
    }
    assert!(circle.contains(Point::new((1 << 24) - 2, (1 << 23) - 1)));
    assert!(circle.contains(Point::new(1, (1 << 23) - 1)));
}

#[test]
fn drawables_without_pixels_have_an_empty_bounding_box_or_draw_nothing_in_it() {
    let mut target = Strict::new(&rect(0..16, 0..16));
    let nothing = Circle::new(Point::new(8, 8), -3).filled(Rgb565::RED);
    nothing.draw(&mut target).unwrap();
    let polygon = Polygon::new(&[]).with_capacity::<0>().unwrap().filled(Rgb565::RED);
    polygon.draw(&mut target).unwrap();
    assert_eq!(target.calls, 0);
    assert!(nothing.bounding_box().is_zero_sized() && polygon.bounding_box().is_zero_sized());
}

#[test]
fn a_mock_display_shows_the_picture() {
    let mut display = MockDisplay::new();
    Circle::new(Point::new(3, 3), 3.1).filled(BinaryColor::On).draw(&mut display).unwrap();
    display.assert_pattern(&[
        "   #   ", //
        " ##### ", " ##### ", "#######", " ##### ", " ##### ", "   #   ",
    ]);
}

#[test]
fn what_is_off_a_mock_display_is_never_sent() {
    // The display panics on every pixel outside its 64 x 64 and on every pixel drawn twice.
    let mut rng = Rng::new(81, 0);
    for _ in 0..2000 {
        let mut display = MockDisplay::new();
        let mut point = || Point::new(rng.int(-100..=160) as i32, rng.int(-100..=160) as i32);
        Triangle::new(point(), point(), point()).filled(Gray8::new(7)).draw(&mut display).unwrap();
    }
}

#[test]
fn adapters_of_embedded_graphics_can_be_drawn_on() {
    let (triangle, ..) = shapes();
    let mut display = MockDisplay::<BinaryColor>::new();
    triangle.filled(BinaryColor::On).draw(&mut display.translated(Point::new(5, -2))).unwrap();
    let mut expected = MockDisplay::<BinaryColor>::new();
    let moved = [Point::new(7, 1), Point::new(18, 3), Point::new(11, 12)];
    Triangle::new(moved[0], moved[1], moved[2]).filled(BinaryColor::On).draw(&mut expected).unwrap();
    display.assert_eq(&expected);

    // A window whose origin is not that of the display, and which cuts the triangle.
    let mut clipped = MockDisplay::<BinaryColor>::new();
    let area = Rectangle::new(Point::new(4, 4), Size::new(5, 5));
    triangle.filled(BinaryColor::On).draw(&mut clipped.clipped(&area)).unwrap();
    assert_eq!(clipped.affected_area(), area);
}

/// Keeps the colours it is sent; `MockDisplay` does not know all of them.
struct Colours<C>(Vec<C>);

impl<C> Dimensions for Colours<C> {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::zero(), Size::new(8, 8))
    }
}

impl<C: PixelColor> DrawTarget for Colours<C> {
    type Color = C;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        self.0.extend(pixels.into_iter().map(|Pixel(_, color)| color));
        Ok(())
    }
}

/// Draws two pixels of a colour, and reads them back.
fn colour_comes_back<C: PixelColor + std::fmt::Debug>(color: C) {
    let mut target = Colours(Vec::new());
    let Ok(()) = Line::new(Point::new(3, 4), Point::new(4, 5)).filled(color).draw(&mut target);
    assert_eq!(target.0, [color; 2]);
}

#[test]
fn every_colour_of_embedded_graphics_can_be_drawn() {
    colour_comes_back(BinaryColor::On);
    colour_comes_back(Gray2::new(2));
    colour_comes_back(Gray4::new(9));
    colour_comes_back(Gray8::new(200));
    colour_comes_back(Rgb555::GREEN);
    colour_comes_back(Bgr555::BLUE);
    colour_comes_back(Rgb565::CYAN);
    colour_comes_back(Bgr565::MAGENTA);
    colour_comes_back(Rgb666::YELLOW);
    colour_comes_back(Bgr666::WHITE);
    colour_comes_back(Rgb888::RED);
    colour_comes_back(Bgr888::GREEN);
}
