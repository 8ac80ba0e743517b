//! Seed fill in bounded memory: everything that can be reached from a pixel without leaving its colour.
//!
//! [`spans`] does it with as many entries of a stack as the caller has, run by run. What a full stack cannot remember,
//! [`walk`] fills on the spot, pixel by pixel, without any memory.

mod region;
mod spans;
mod walk;

pub use region::{Connectivity, FillRegion, SeedFillError};
pub use spans::FillSegment;

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, image::GetPixel};

use region::OnTarget;

/// Fills what can be reached from a seed: the region of neighbours of the same colour.
///
/// The seed is a pixel, in whole pixels; any is legal, and one outside of the target fills nothing. Each pixel of the
/// region is filled once, in no particular order, and nothing else is.
///
/// ```text
///     . . . . . . .          . . . . . . .
///     . # # # # . .          . # # # # . .
///     . # . . # # .          . # o o # # .      s the seed, o what is filled:
///     . # . s . # .    ->    . # o o o # .      the region's neighbours by sides
///     . . # # # . .          . . # # # . .
/// ```
///
/// The stack is the caller's, and may have any size. With more entries, less time: when it is full, what it has no
/// room for is filled at once by a walk along the region's boundary, which needs no memory. The pixels are the same,
/// down to a stack without an entry. Nothing but the seed's own colour is ever looked for, so that it makes no
/// difference where the fill's colour was there before, and two colours are enough. Where both colours are the same
/// there is nothing to do.
///
/// # Errors
///
/// [`SeedFillError::Target`] passes the target's error on, at once. [`SeedFillError::Unreadable`] says that a pixel
/// still had its old colour after it was filled: without that check, there would be no end.
///
/// # Cost
///
/// 16 bytes an entry; a region whose rows are single runs needs three or four. By spans, each pixel is read some
/// three times, a run is written by one `fill_solid`. By a walk, each pixel costs some ten readings and is written by
/// itself, and an island within the region costs a walk around it and one around whatever else the boundary leads
/// past.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{
///     framebuffer::{Framebuffer, buffer_size},
///     image::GetPixel,
///     pixelcolor::{BinaryColor, raw::LittleEndian},
///     prelude::*,
/// };
/// use spanfill::{Circle, FillSegment, SeedFill, prelude::*};
///
/// let mut frame = Framebuffer::<BinaryColor, _, LittleEndian, 40, 40, { buffer_size::<BinaryColor>(40, 40) }>::new();
/// Circle::new(Point::new(20, 20), 15).filled(BinaryColor::On).draw(&mut frame)?;
/// Circle::new(Point::new(20, 20), 8).filled(BinaryColor::Off).draw(&mut frame)?;
///
/// let mut stack = [FillSegment::EMPTY; 8];
/// SeedFill::new(Point::new(20, 20)).draw(BinaryColor::On, &mut frame, &mut stack)?;
/// assert_eq!(frame.pixel(Point::new(20, 14)), Some(BinaryColor::On));
/// assert_eq!(frame.pixel(Point::new(2, 2)), Some(BinaryColor::Off));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SeedFill {
    seed: Point,
    connectivity: Connectivity,
}

impl SeedFill {
    /// From a pixel to its neighbours by sides.
    #[inline]
    pub const fn new(seed: Point) -> Self {
        Self { seed, connectivity: Connectivity::Four }
    }

    /// The same with another idea of a neighbour.
    #[inline]
    pub const fn connectivity(self, connectivity: Connectivity) -> Self {
        Self { connectivity, ..self }
    }

    /// Fills in one colour on a target that can be read.
    ///
    /// # Errors
    ///
    /// The target's, and [`SeedFillError::Unreadable`] where it does not show what was drawn.
    pub fn draw<D>(
        &self,
        colour: <D as DrawTarget>::Color,
        target: &mut D,
        stack: &mut [FillSegment],
    ) -> Result<(), SeedFillError<D::Error>>
    where
        D: DrawTarget + GetPixel<Color = <D as DrawTarget>::Color>,
    {
        match OnTarget::new(target, self.seed, colour) {
            Some(mut region) => self.fill(&mut region, stack),
            None => Ok(()),
        }
    }

    /// Fills on anything that can tell which pixels are still to be filled.
    ///
    /// # Errors
    ///
    /// The region's, and [`SeedFillError::Unreadable`] where a pixel is still open after it was filled.
    pub fn fill<R: FillRegion>(
        &self,
        region: &mut R,
        stack: &mut [FillSegment],
    ) -> Result<(), SeedFillError<R::Error>> {
        spans::fill(region, self.seed, self.connectivity, stack)
    }
}
