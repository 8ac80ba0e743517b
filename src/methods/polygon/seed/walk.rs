//! A stack of few entries that drops nothing: the crate's own [`SeedFill`].

use core::{cell::Cell, ops::Range};

use embedded_graphics_core::geometry::Point;

use super::{Canvas, Touch};
use crate::{
    fragment::FragmentSink,
    geometry::PixelRect,
    seed_fill::{Connectivity, FillRegion, FillSegment, SeedFill, SeedFillError},
};

/// The crate's seed fill on a canvas.
///
/// # Errors
///
/// The sink's.
///
/// # Cost
///
/// That of Heckbert's fill while the stack has room; where it has none, some ten readings a pixel.
pub fn by_spans_with_walk<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    [x, y]: [i32; 2],
    touch: Touch,
    stack: &mut [FillSegment],
    sink: &mut S,
) -> Result<(), S::Error> {
    canvas.send(sink)?;
    let connectivity = match touch {
        Touch::Sides => Connectivity::Four,
        Touch::Corners => Connectivity::Eight,
    };
    let mut region = Seen { canvas, sink: Cell::new(Some(sink)) };
    match SeedFill::new(Point::new(x, y)).connectivity(connectivity).fill(&mut region, stack) {
        Err(SeedFillError::Target(error)) => Err(error),
        // A canvas shows what is closed.
        Ok(()) | Err(SeedFillError::Unreadable { .. }) => Ok(()),
    }
}

/// A canvas whose readings are counted.
struct Seen<'c, 'w, 's, S> {
    canvas: &'c mut Canvas<'w>,
    /// Taken while it is told something.
    sink: Cell<Option<&'s mut S>>,
}

impl<S: FragmentSink> FillRegion for Seen<'_, '_, '_, S> {
    type Error = S::Error;

    fn bounds(&self) -> PixelRect {
        self.canvas.clip.clone()
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        if let Some(sink) = self.sink.take() {
            sink.visit(x, y);
            self.sink.set(Some(sink));
        }
        self.canvas.is_open(x, y)
    }

    fn fill(&mut self, row: i32, columns: Range<i32>) -> Result<(), S::Error> {
        let Some(sink) = self.sink.get_mut() else { return Ok(()) };
        columns.into_iter().try_for_each(|x| self.canvas.fill(x, row, *sink))
    }
}
