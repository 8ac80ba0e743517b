//! Parts of targets that can be read.

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    primitives::{PointsIter, Rectangle},
};

/// A target seen through a window, or from another place, that can be read where the target can: in place of
/// embedded-graphics' `clipped`, `cropped` and `translated`, which cannot, and so not be blended by
/// [`ReadBack`](crate::ReadBack).
///
/// ```text
///      target                    clipped           cropped           translated
///      0 - - - - - - - -         0 - - - - -        - - - -          - - - - -
///      |   .-------.             | .-------.       0-------.         | 0
///      |   | area  |             | |       |       |       |         |    moved
///      |   '-------'             | '-------'       '-------'         |
/// ```
///
/// # Cost
///
/// Two additions a call; pixels one by one and colours in a row are looked at one by one where they may lie outside.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{
///     framebuffer::{Framebuffer, buffer_size},
///     image::GetPixel,
///     pixelcolor::{Gray8, raw::BigEndian},
///     prelude::*,
///     primitives::Rectangle,
/// };
/// use spanfill::{Circle, ReadBack, View, prelude::*};
///
/// let mut frame = Framebuffer::<Gray8, _, BigEndian, 16, 16, { buffer_size::<Gray8>(16, 16) }>::new();
/// let mut window = View::cropped(&mut frame, &Rectangle::new(Point::new(8, 8), Size::new(8, 4)));
/// let dot = Circle::new(Point::zero(), 5).antialiased(Gray8::WHITE, ReadBack);
/// dot.opacity(100).draw_on(&mut window)?;
/// dot.opacity(100).draw_on(&mut window)?;
/// assert_eq!(frame.pixel(Point::new(8, 8)), Some(Gray8::new(161)));
/// assert_eq!(frame.pixel(Point::new(8, 12)), Some(Gray8::new(0)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct View<'t, T> {
    target: &'t mut T,
    /// What can be seen, in the target's coordinates.
    area: Rectangle,
    /// Where the view's origin is on the target.
    origin: Point,
}

impl<'t, T: DrawTarget> View<'t, T> {
    /// What of the target lies in `area`, where it is.
    pub fn clipped(target: &'t mut T, area: &Rectangle) -> Self {
        let area = target.bounding_box().intersection(area);
        Self { target, area, origin: Point::zero() }
    }

    /// What of the target lies in `area`, with the corner of that as the origin. Nothing is drawn outside, which
    /// embedded-graphics' `cropped` leaves to its user.
    pub fn cropped(target: &'t mut T, area: &Rectangle) -> Self {
        let area = target.bounding_box().intersection(area);
        let origin = area.top_left;
        Self { target, area, origin }
    }

    /// All of the target, moved by `offset`.
    pub fn translated(target: &'t mut T, offset: Point) -> Self {
        let area = target.bounding_box();
        Self { target, area, origin: offset }
    }
}

/// Moved, as far as there are coordinates.
fn moved(point: Point, by: Point) -> Point {
    Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y))
}

impl<T> View<'_, T> {
    /// On the target.
    fn place(&self, area: &Rectangle) -> Rectangle {
        Rectangle { top_left: moved(area.top_left, self.origin), size: area.size }
    }
}

impl<T> Dimensions for View<'_, T> {
    fn bounding_box(&self) -> Rectangle {
        let Point { x, y } = self.area.top_left;
        let top_left = Point::new(x.saturating_sub(self.origin.x), y.saturating_sub(self.origin.y));
        Rectangle { top_left, size: self.area.size }
    }
}

impl<T: GetPixel> GetPixel for View<'_, T> {
    type Color = T::Color;

    #[inline]
    fn pixel(&self, point: Point) -> Option<T::Color> {
        let place = moved(point, self.origin);
        if self.area.contains(place) { self.target.pixel(place) } else { None }
    }
}

impl<T: DrawTarget> DrawTarget for View<'_, T> {
    type Color = T::Color;
    type Error = T::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<T::Color>>>(&mut self, pixels: I) -> Result<(), T::Error> {
        let (area, origin) = (self.area, self.origin);
        let placed = pixels.into_iter().map(|Pixel(point, colour)| Pixel(moved(point, origin), colour));
        self.target.draw_iter(placed.filter(|Pixel(point, _)| area.contains(*point)))
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, colour: T::Color) -> Result<(), T::Error> {
        let visible = self.place(area).intersection(&self.area);
        if visible.is_zero_sized() { Ok(()) } else { self.target.fill_solid(&visible, colour) }
    }

    fn fill_contiguous<I: IntoIterator<Item = T::Color>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), T::Error> {
        let place = self.place(area);
        let visible = place.intersection(&self.area);
        if visible == place {
            return self.target.fill_contiguous(&place, colours);
        }
        let pixels = place.points().zip(colours);
        let seen = pixels.filter(|(point, _)| visible.contains(*point)).map(|(_, colour)| colour);
        if visible.is_zero_sized() { Ok(()) } else { self.target.fill_contiguous(&visible, seen) }
    }
}
