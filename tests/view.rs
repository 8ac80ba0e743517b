//! Views that can be read show what embedded-graphics' own adapters show.

use embedded_graphics::{
    image::GetPixel, mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, primitives::Rectangle,
};
use spanfill::View;

/// A few calls of every kind, some of it outside.
fn draw<D: DrawTarget<Color = Gray8>>(target: &mut D) -> Result<Rectangle, D::Error> {
    target.fill_solid(&Rectangle::new(Point::new(-3, -2), Size::new(12, 7)), Gray8::new(50))?;
    let area = Rectangle::new(Point::new(4, 3), Size::new(7, 5));
    target.fill_contiguous(&area, (0..35).map(|level| Gray8::new(level + 100)))?;
    target.draw_iter((-5..20).map(|place| Pixel(Point::new(place, place / 2), Gray8::new(7))))?;
    Ok(target.bounding_box())
}

fn display() -> MockDisplay<Gray8> {
    let mut display = MockDisplay::new();
    display.set_allow_overdraw(true);
    display.set_allow_out_of_bounds_drawing(true);
    display
}

#[test]
fn views_are_what_the_adapters_are() {
    let areas = [(2, 1, 6, 5), (0, 0, 64, 64), (60, 60, 10, 10), (-4, -4, 9, 9), (100, 3, 4, 4)];
    for (x, y, width, height) in areas {
        let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let (mut a, mut b) = (display(), display());
        assert_eq!(draw(&mut View::clipped(&mut a, &area)), draw(&mut b.clipped(&area)));
        a.assert_eq(&b);
        let (mut a, mut b) = (display(), display());
        // embedded-graphics' `cropped` alone lets what lies outside be drawn.
        assert_eq!(draw(&mut View::cropped(&mut a, &area)), draw(&mut b.clipped(&area).cropped(&area)));
        a.assert_eq(&b);
        let offset = Point::new(x, y);
        let (mut a, mut b) = (display(), display());
        let view = draw(&mut View::translated(&mut a, offset)).unwrap();
        assert_eq!(view, draw(&mut b.translated(offset)).unwrap());
        // A mock display lets `translated` draw outside; the view does not.
        a.assert_eq(&b);
    }
}

struct Readable(MockDisplay<Gray8>);

impl Dimensions for Readable {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl DrawTarget for Readable {
    type Color = Gray8;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        self.0.draw_iter(pixels)
    }
}

impl GetPixel for Readable {
    type Color = Gray8;

    fn pixel(&self, point: Point) -> Option<Gray8> {
        self.0.get_pixel(point)
    }
}

#[test]
fn views_read_what_they_drew_and_nothing_outside() {
    let area = Rectangle::new(Point::new(10, 20), Size::new(5, 4));
    let mut target = Readable(display());
    let Ok(_) = draw(&mut target);
    let there = |target: &Readable, x, y| target.pixel(Point::new(x, y));
    let (inside, beside) = (there(&target, 10, 5), there(&target, 3, 2));
    assert!(inside.is_some() && beside.is_some());
    let mut view = View::translated(&mut target, Point::new(2, 1));
    assert_eq!((view.pixel(Point::new(8, 4)), view.pixel(Point::new(1, 1))), (inside, beside));
    let Ok(()) = view.fill_solid(&Rectangle::new(Point::new(8, 19), Size::new(9, 9)), Gray8::new(33));
    let view = View::cropped(&mut target, &area);
    assert_eq!(view.pixel(Point::zero()), Some(Gray8::new(33)));
    assert_eq!(view.pixel(Point::new(5, 0)), None);
    let view = View::clipped(&mut target, &area);
    assert_eq!(view.pixel(Point::new(10, 20)), Some(Gray8::new(33)));
    assert_eq!(view.pixel(Point::new(9, 20)), None);
}
