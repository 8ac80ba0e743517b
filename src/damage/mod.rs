//! Which parts of the screen have changed.

use core::{mem::replace, ops::Range};

use embedded_graphics_core::{
    geometry::{Dimensions, Point, Size},
    primitives::Rectangle,
};
use heapless::Vec;

use crate::{PixelRect, span::visible};

/// The parts of a screen that have to be drawn and sent again: at most `N` rectangles, which together hold all that was added.
///
/// What is added is cut to the screen. It is merged with a rectangle where both together are not larger than both apart, and a
/// window's worth of pixels; when all `N` are taken, the two are merged that grow least by it. Nothing is ever forgotten.
///
/// ```text
///   added        . . . . .        two kept             . . . . .
///   N = 2        . # # . .                             . # # . .
///                . # # . .                             . # # . .
///                . . . . .                             . . . . .
///                . # . . #        the nearest two      . # # # #
///                . # . # #        become one           . # # # #
/// ```
///
/// # Cost
///
/// 16 bytes a rectangle. Adding compares with each, and with all pairs when full.
///
/// # Examples
///
/// A needle that moves: where it was and where it is now.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*};
/// use spanfill::{Bands, Damage, Line, MsbFirst, Rows, prelude::*};
///
/// let screen = Size::new(64, 64);
/// let mut bands = Bands::<Gray8, Rows<MsbFirst>, _, 1>::new([[0; 320]], screen, Gray8::BLACK)?;
/// let mut damage = Damage::<4>::new(screen);
/// let needle = |tip| Line::new(Point::new(32, 32), tip).filled(Gray8::WHITE);
/// damage.add(&needle(Point::new(32, 12)));
/// damage.add(&needle(Point::new(36, 12)));
///
/// let mut pixels = 0;
/// let mut display = MockDisplay::<Gray8>::new();
/// damage.redraw(|area| {
///     bands.draw_area(
///         area,
///         |band| needle(Point::new(36, 12)).draw_on(band),
///         |band| {
///             pixels += band.units().len();
///             band.show(&mut display)
///         },
///     )
/// }).unwrap();
/// assert!(damage.is_empty());
/// assert!(pixels < 64 * 64 / 25);
/// # Ok::<(), spanfill::FramebufferError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Damage<const N: usize> {
    screen: Size,
    areas: Vec<Rectangle, N>,
}

/// So many pixels more cost less than another address window: 11 bytes on the usual controllers.
const WINDOW_PX: i64 = 6;

impl<const N: usize> Damage<N> {
    /// Nothing has changed yet on a screen of this size.
    #[inline]
    pub const fn new(screen: Size) -> Self {
        const { assert!(N > 0, "nothing can be kept in no rectangles") }
        Self { screen, areas: Vec::new() }
    }

    /// Everything has changed: as it is when a display has just been switched on.
    pub fn add_all(&mut self) {
        self.areas.clear();
        self.add(&Rectangle::new(Point::zero(), self.screen));
    }

    /// What lies in the bounding box of something has changed: a rectangle, a shape, a text.
    pub fn add(&mut self, changed: &impl Dimensions) {
        let changed = PixelRect::from(changed.bounding_box());
        let screen = PixelRect::from(Rectangle::new(Point::zero(), self.screen));
        let Some((rows, columns)) = visible(&changed, &screen) else { return };
        let mut area = Rectangle::from(PixelRect { rows, columns });
        // What has grown may now touch others.
        while let Some(index) = self.areas.iter().position(|other| growth(&area, other) <= WINDOW_PX) {
            area = self.take_out(index).map_or(area, |other| both(&area, &other));
        }
        if let Err(area) = self.areas.push(area) {
            let merged = self.merge_nearest(area);
            // There is one less now.
            self.add(&merged);
        }
    }

    /// Takes out what has to be merged so that `area` and all others have room: the two that grow least, as one.
    fn merge_nearest(&mut self, area: Rectangle) -> Rectangle {
        let mut least = i64::MAX;
        let mut nearest = (0, None);
        for (index, one) in self.areas.iter().enumerate() {
            let with_new = growth(one, &area);
            if with_new < least {
                (least, nearest) = (with_new, (index, None));
            }
            for (offset, other) in self.areas.iter().skip(index + 1).enumerate() {
                let together = growth(one, other);
                if together < least {
                    (least, nearest) = (together, (index, Some(index + 1 + offset)));
                }
            }
        }
        let (one, other) = nearest;
        // The later one first: it moves none before it.
        let other = other.and_then(|other| self.take_out(other));
        let one = self.take_out(one);
        match (one, other) {
            (Some(one), Some(other)) => {
                // Two have gone: there is room for the new one.
                self.areas.push(area).unwrap_or_default();
                both(&one, &other)
            }
            (Some(one), None) => both(&one, &area),
            (None, _) => area,
        }
    }

    /// Takes an area out; the last one takes its place.
    fn take_out(&mut self, index: usize) -> Option<Rectangle> {
        let last = self.areas.pop()?;
        Some(self.areas.get_mut(index).map_or(last, |place| replace(place, last)))
    }

    /// Whether there is nothing to be drawn.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.areas.is_empty()
    }

    /// What is to be drawn.
    #[inline]
    pub fn areas(&self) -> &[Rectangle] {
        &self.areas
    }

    /// Draws each area by `draw`, and takes out those that have been drawn.
    ///
    /// # Errors
    ///
    /// The first that `draw` meets; the area that it met it on stays, and those after it.
    pub fn redraw<E>(&mut self, mut draw: impl FnMut(&Rectangle) -> Result<(), E>) -> Result<(), E> {
        while let Some(area) = self.areas.last() {
            draw(area)?;
            self.areas.pop();
        }
        Ok(())
    }

    /// The same by an `async` function; dropped half way, it keeps what has not been drawn whole.
    ///
    /// # Errors
    ///
    /// As of [`redraw`](Self::redraw).
    pub async fn redraw_async<E>(&mut self, mut draw: impl AsyncFnMut(&Rectangle) -> Result<(), E>) -> Result<(), E> {
        while let Some(area) = self.areas.last() {
            draw(area).await?;
            self.areas.pop();
        }
        Ok(())
    }
}

/// The least rectangle around two.
fn both(one: &Rectangle, other: &Rectangle) -> Rectangle {
    let (one, other) = (PixelRect::from(*one), PixelRect::from(*other));
    let around = |one: Range<i32>, other: Range<i32>| one.start.min(other.start)..one.end.max(other.end);
    PixelRect { rows: around(one.rows, other.rows), columns: around(one.columns, other.columns) }.into()
}

/// How many pixels both together have more than both apart. Sides have at most 32 bits, and what is inside the screen adds up to
/// no more than an `i32` can tell: below 2^62.
fn growth(one: &Rectangle, other: &Rectangle) -> i64 {
    let pixels = |area: &Rectangle| (u64::from(area.size.width) * u64::from(area.size.height)).cast_signed();
    pixels(&both(one, other)).saturating_sub(pixels(one)).saturating_sub(pixels(other))
}
